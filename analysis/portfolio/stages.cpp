// Order of work: all questions together by simulation and plain induction; those left, cluster by cluster, by mined
// invariants and short inductions under them; those left by the race on their cones. What was found on bits is turned
// into runs and certificates in words.
#include "analysis/portfolio/stages.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "analysis/bits/bit_cone.hpp"
#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/clusters.hpp"
#include "analysis/portfolio/cone_race.hpp"
#include "analysis/portfolio/invariants.hpp"
#include "analysis/portfolio/invariants_bounds.hpp"
#include "analysis/portfolio/invariants_covers.hpp"
#include "analysis/portfolio/invariants_gates.hpp"
#include "analysis/portfolio/invariants_groups.hpp"
#include "analysis/portfolio/invariants_sums.hpp"
#include "analysis/portfolio/invariants_timers.hpp"
#include "analysis/portfolio/invariants_values.hpp"
#include "analysis/portfolio/invariants_words.hpp"
#include "analysis/portfolio/shared_search.hpp"
#include "analysis/portfolio/state_truths.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

class Stages {
 public:
  Stages(const TransitionSystem& system, const Questions& questions, const PortfolioOptions& options)
      : system_(system), options_(options), open_(questions), answers_(system.questions.size()) {}

  std::vector<QuestionAnswer> run() {
    try {
      answer();
    } catch (const OutOfBudget&) {  // what is open stays open
      leaveRace();
      blast_.reset();
    }
    return std::move(answers_);
  }

 private:
  void answer() {
    if (options_.effort == Effort::Together || options_.effort == Effort::Full) answerTogether();
    std::vector<Questions> clusters;
    if (options_.effort != Effort::Together) clusters = clustersOf(system_, open_);
    const bool isMinedOnly = options_.effort == Effort::Mined;
    for (const Questions& cluster : clusters) {
      open_ = cluster;
      begin({});
      beginWithCandidates();
      if (options_.check) mine();
      searchTogether(schedule::shortInduction, false);
      if (!open_.empty() && options_.check && !isMinedOnly) runBeforeBounds();
      if (options_.check) searchUnderBounds();
      if (isMinedOnly) continue;
      const double each = isQuick() ? std::min(options_.seconds, schedule::quickRaceSeconds) : options_.seconds;
      if (!open_.empty()) raceApart(options_.techniques, each);
    }
  }
  /// Whether each open question has its own time later.
  bool isQuick() const { return options_.effort < Effort::Full; }

  /// Bounds prove and show nothing: what waits for a timer and is wrong is often found by a moment's random runs.
  void runBeforeBounds() {
    Techniques runs = options_.techniques;
    runs.keepOnly({Technique::LongSimulation});
    if (!runs.has(Technique::LongSimulation) || !options_.techniques.has(Technique::Bounds)) return;
    raceBriefly(runs, schedule::runsBeforeBounds);
  }
  void raceBriefly(const Techniques& techniques, double seconds) {
    briefly_ += seconds;
    raceApart(techniques, std::min(options_.seconds, briefly_));
    std::erase_if(open_, [&](std::size_t q) { return answers_[q].answer != Answer::Unknown; });
  }

  /// Each scope looks for more bounds than the one before it: where that has not come to an end, none will. What few
  /// bounds leave open may rest on words with few values. Before many bounds are looked for, the engines have a moment
  /// under those that there are.
  void searchUnderBounds() {
    tried_.clear();
    areBoundsUnfinished_ = false;
    for (const BoundScope scope :
         {BoundScope::Chain, BoundScope::Few, BoundScope::Stops, BoundScope::All, BoundScope::Pending}) {
      if (scope == BoundScope::Stops && listValues()) searchTogether(schedule::shortInduction, false);
      if (open_.empty() || areBoundsUnfinished_) return;
      if (scope > BoundScope::Few && options_.effort == Effort::Mined) return;
      if (scope == BoundScope::All) raceBriefly(options_.techniques, schedule::raceBeforeBounds);
      if (open_.empty()) return;
      if (mineDifferences(scope)) searchTogether(schedule::shortInduction, false);
    }
  }

  void answerTogether() {
    begin({});
    if (!open_.empty()) searchTogether(1, true);
    if (mineSums()) searchTogether(1, false);
    if (minePairsAgain(true)) searchTogether(1, false);
    if (open_.empty() || !options_.check) return;
    begin({});
    if (findGroups()) searchTogether(1, false);
    if (minePairsAgain(false)) searchTogether(1, false);
    if (tieGates()) searchTogether(1, false);
  }
  /// What becomes of the sums that questions ask for is told to the solvers of this stage, and what is kept of them
  /// becomes invariants.
  bool mineSums() {
    if (open_.empty() || !options_.check || !options_.techniques.has(Technique::Sums)) return false;
    const TechniqueTurn turn(options_.log, Technique::Sums, open_.size());
    AskedSums asked = sumsAskedFor(system_, open_);
    if (asked.sums.empty()) return false;
    begin({});
    mined_ = Technique::Sums;
    blast_->add(asked.theorems);
    blast_->add(asked.guesses);
    for (const Node theorem : asked.theorems) blast_->tell(theorem);
    for (const GuideNode& g : asked.guide) {
      blast_->add({g.node});
      blast_->guide(g.node, g.isAfter);
    }
    std::vector<std::vector<Lit>> guesses;
    for (const Node n : asked.guesses) guesses.push_back({blast_->of(n)[0]});
    MiningOptions mining;
    mining.seed = options_.seed;
    mining.pairsOnly = true;
    const Budget limit = budget(schedule::sumSeconds);
    invariants_ = mineInvariants(blast_->bits(), {}, guesses, mining, limit);
    sums_ = std::move(asked.sums);
    return !invariants_.empty();
  }
  bool minePairsAgain(bool askedOnly) {
    if (open_.empty() || !options_.check) return false;
    begin({});
    return minePairs(askedOnly);
  }

  /// Gates that are equal in all reachable states; false if there are none.
  bool tieGates() {
    if (open_.empty() || !options_.techniques.has(Technique::EqualGates)) return false;
    const TechniqueTurn turn(options_.log, Technique::EqualGates, open_.size());
    mined_ = Technique::EqualGates;
    begin(askedAtStart(system_, open_));
    const double seconds = options_.seconds * static_cast<double>(open_.size()) * schedule::correspondenceShare;
    const Budget limit = budget(std::min(seconds, schedule::mostCorrespondence));
    for (const Lit equal : mineEqualGates(blast_->bits(), options_.seed, limit)) invariants_.clauses.push_back({equal});
    return !invariants_.clauses.empty();
  }

  /// Starts a stage: blasts the open questions. Throws OutOfBudget.
  void begin(const std::vector<Node>& truths) {
    leaveRace();
    differences_.clear();
    sums_.clear();
    joinedClauses_.clear();
    invariants_ = {};
    cores_.reset();
    blast_ = std::make_unique<BitBlast>(system_, open_, truths, &whole_);
    stageBegin_ = Budget::Clock::now();
  }
  /// Blasts the open questions with the nodes that candidate invariants speak about.
  void beginWithCandidates() {
    const std::vector<Node> truths = stateTruths(system_, open_, schedule::truthLimit);
    std::vector<NodeClause> guesses;
    if (options_.techniques.has(Technique::WordGuesses)) {
      const TechniqueTurn turn(options_.log, Technique::WordGuesses, open_.size());
      guesses = guessDifferences(system_, *blast_, options_.seed, whole_);
    }
    if (options_.techniques.has(Technique::TimerStates)) {
      const TechniqueTurn turn(options_.log, Technique::TimerStates, open_.size());
      for (NodeClause& clause : guessTimerStates(system_)) {
        if (std::all_of(clause.begin(), clause.end(), [&](Node n) { return isInCone(n); }))
          guesses.push_back(std::move(clause));
      }
    }
    std::vector<Node> nodes = truths;
    for (const NodeClause& clause : guesses) nodes.insert(nodes.end(), clause.begin(), clause.end());
    begin(nodes);
    truths_.clear();
    guesses_.clear();
    for (const Node n : truths) truths_.push_back(blast_->of(n)[0]);
    for (const NodeClause& clause : guesses) {
      std::vector<Lit>& literals = guesses_.emplace_back();
      for (const Node n : clause) literals.push_back(blast_->of(n)[0]);
    }
  }
  bool isInCone(Node n) const {
    const NodeData& node = (*system_.graph)[n];
    return blast_->contains(node.op == Op::Not ? node.child[0] : n);
  }
  Budget budget(double seconds) const { return options_.budget().slice(seconds); }
  Budget::Clock::time_point searchEnd() const {
    const std::chrono::duration<double> rest(options_.left() * schedule::searchShare);
    return options_.deadline ? Budget::Clock::now() + std::chrono::duration_cast<Budget::Clock::duration>(rest)
                             : Budget::Clock::time_point::max();
  }
  double share() const {
    return std::chrono::duration<double>(Budget::Clock::now() - stageBegin_).count() /
           static_cast<double>(std::max<std::size_t>(open_.size(), 1));
  }

  void searchTogether(int most, bool simulate) {
    const double seconds = options_.seconds * static_cast<double>(open_.size());
    std::vector<int> clean;
    for (const std::size_t q : open_) clean.push_back(answers_[q].depth);
    SharedSearch search(blast_->bits(), options_.seed, clean);
    if (simulate && options_.techniques.has(Technique::Simulation)) {
      TechniqueTurn turn(options_.log, Technique::Simulation, open_.size());
      search.simulate(
          options_.bound > 0 ? std::min(schedule::simulatedScans, options_.bound) : schedule::simulatedScans,
          budget(seconds * schedule::simulationShare));
      turn.settled(open_.size() - search.openCount());
    }
    if (options_.techniques.has(Technique::ShortInduction)) {
      const std::size_t before = search.openCount();
      TechniqueTurn turn(options_.log, Technique::ShortInduction, before);
      const double least = sums_.empty() ? 0 : schedule::sumSeconds;
      search.induce(options_.bound > 0 ? std::min(most, options_.bound - 1) : most, invariants_.clauses,
                    budget(std::max(least, seconds * schedule::inductionShare)));
      turn.settled(before - search.openCount());
    }
    const double each = share();
    open_.clear();
    for (std::size_t i = 0; i < blast_->questions().size(); ++i) {
      const std::size_t q = blast_->questions()[i];
      answers_[q].seconds += each;
      const Verdict& verdict = search.answers()[i].verdict;
      if (verdict.answer == Answer::Unknown) open_.push_back(q);
      take(q, verdict, nullptr);
    }
  }

  /// What truth values of the state say about each other, for all questions at once: interlocks and steps. Often those
  /// that the questions ask for are enough, which are few.
  bool minePairs(bool askedOnly) {
    if (!options_.techniques.has(Technique::StatePairs)) return false;
    const TechniqueTurn turn(options_.log, Technique::StatePairs, open_.size());
    mined_ = Technique::StatePairs;
    std::vector<Lit> truths;
    bool isWhole = true;
    const BitSystem& bits = blast_->bits();
    const std::vector<bool> isAsked = statesAskedFor(system_, open_);
    for (std::uint32_t latch = 0; latch < bits.latches.size(); ++latch) {
      const std::size_t state = blast_->stateBit(latch).state;
      if ((*system_.graph)[system_.states[state].node].width != 1) continue;
      if (askedOnly && !isAsked[state])
        isWhole = false;
      else
        truths.push_back(positive(bits.latches[latch].variable));
    }
    if (truths.size() < 2 || truths.size() > schedule::pairedTruths || (askedOnly && isWhole)) return false;
    MiningOptions mining = takeGroups();
    mining.pairsOnly = true;
    mining.implicationLimit = schedule::pairLimit;
    const double seconds = options_.seconds * static_cast<double>(open_.size());
    const Budget limit = budget(std::min(seconds * schedule::pairsShare, schedule::mostMining));
    Invariants mined = mineInvariants(bits, truths, {}, mining, limit);
    if (!mined.empty()) invariants_ = std::move(mined);
    return !invariants_.empty();
  }

  /// Groups of truth values of the state of which at most one holds, for all questions at once; false if there are
  /// none.
  bool findGroups() {
    if (!options_.techniques.has(Technique::Groups)) return false;
    const TechniqueTurn turn(options_.log, Technique::Groups, open_.size());
    mined_ = Technique::Groups;
    const BitSystem& bits = blast_->bits();
    std::vector<Lit> truths;
    for (std::uint32_t latch = 0; latch < bits.latches.size(); ++latch) {
      if (isTruth(latch)) truths.push_back(positive(bits.latches[latch].variable));
    }
    if (truths.size() > schedule::groupedTruths) return false;
    groups_.clear();
    const double seconds = options_.seconds * static_cast<double>(open_.size());
    const Budget limit = budget(std::min(seconds * schedule::pairsShare, schedule::mostMining));
    for (const ExclusiveGroup& group : mineGroups(bits, truths, options_.seed, limit)) {
      std::vector<std::size_t>& states = groups_.emplace_back();
      for (const Lit l : group) states.push_back(blast_->stateBit(bits.position[variableOf(l)]).state);
    }
    takeGroups();
    return !groups_.empty();
  }
  bool isTruth(std::uint32_t latch) const {
    return (*system_.graph)[system_.states[blast_->stateBit(latch).state].node].width == 1;
  }
  /// What is left of the groups in this stage's part of the system is inductive too: its literals depend on nothing
  /// outside, where all may be off.
  MiningOptions takeGroups() {
    MiningOptions mining;
    mining.seed = options_.seed;
    BitSystem& bits = blast_->bits();
    std::map<std::size_t, Lit> literalOf;
    for (std::uint32_t latch = 0; latch < bits.latches.size() && !groups_.empty(); ++latch) {
      if (isTruth(latch)) literalOf.emplace(blast_->stateBit(latch).state, positive(bits.latches[latch].variable));
    }
    for (const std::vector<std::size_t>& states : groups_) {
      ExclusiveGroup group;
      for (const std::size_t state : states) {
        if (const auto found = literalOf.find(state); found != literalOf.end()) group.push_back(found->second);
      }
      if (group.size() < 2) continue;
      mining.known.push_back(atMostOne(bits, group));
      mining.groups.push_back(std::move(group));
    }
    invariants_.clauses.clear();
    for (const Lit known : mining.known) invariants_.clauses.push_back({known});
    return mining;
  }

  void mine() {
    mined_ = Technique::Invariants;
    const double seconds = std::min(options_.seconds * schedule::invariantShare, schedule::mostMining);
    const MiningOptions mining = takeGroups();
    const Budget limit = budget(seconds);
    if (options_.techniques.has(Technique::Invariants)) {
      const TechniqueTurn turn(options_.log, Technique::Invariants, open_.size());
      Invariants mined = mineInvariants(blast_->bits(), truths_, guesses_, mining, limit);
      if (!mined.empty()) invariants_ = std::move(mined);
    }
    if (!options_.techniques.has(Technique::Covers)) return;
    const TechniqueTurn turn(options_.log, Technique::Covers, open_.size());
    for (std::vector<Lit>& clause : mineCovers(blast_->bits(), invariants_, askedLatches(), options_.seed, limit))
      invariants_.clauses.push_back(std::move(clause));
  }

  /// Truth values of the state that the open questions ask for.
  std::vector<std::size_t> askedLatches() const {
    const std::vector<bool> isAsked = statesAskedFor(system_, open_);
    std::vector<std::size_t> latches;
    for (std::size_t latch = 0; latch < blast_->bits().latches.size(); ++latch) {
      const std::size_t state = blast_->stateBit(static_cast<std::uint32_t>(latch)).state;
      if (isAsked[state] && (*system_.graph)[system_.states[state].node].width == 1) latches.push_back(latch);
    }
    return latches;
  }

  /// Words with few values; false if there are none.
  bool listValues() {
    if (open_.empty() || !options_.check || !options_.techniques.has(Technique::WordValues)) return false;
    const TechniqueTurn turn(options_.log, Technique::WordValues, open_.size());
    const std::vector<WordValues> found =
        mineWordValues(system_, *blast_, invariants_, options_.seed, budget(schedule::valueSeconds));
    std::vector<Node> nodes;
    for (const WordValues& word : found)
      nodes.push_back(isOneOf(*system_.graph, system_.states[word.state].node, word.values));
    return strengthen(nodes);
  }
  /// Takes clauses (nodes of width 1 over states) to the invariants; false if there are none.
  bool strengthen(const std::vector<Node>& clauses) {
    if (clauses.empty()) return false;
    leaveRace();
    blast_->add(clauses);
    for (const Node n : clauses) {
      const Lit l = blast_->of(n)[0];
      if (l != trueLit) invariants_.clauses.push_back({l});
    }
    cores_.reset();
    blast_->ask(open_);
    return true;
  }

  /// Bounds on differences of words that count together; false if there are none.
  bool mineDifferences(BoundScope scope) {
    if (!options_.techniques.has(Technique::Bounds)) return false;
    const TechniqueTurn turn(options_.log, Technique::Bounds, open_.size());
    const bool isFirst = options_.effort == Effort::Mined;
    const double most = isFirst && scope == BoundScope::Chain   ? schedule::chainBounds
                        : isFirst                               ? schedule::firstBounds
                        : isQuick() && scope >= BoundScope::All ? schedule::quickBounds
                                                                : schedule::mostMining;
    const MinedBounds mined = mineBounds(
        system_, *blast_, invariants_, options_.seed, scope,
        budget(std::min({options_.seconds * schedule::boundShare, most, options_.left() * schedule::miningShare})),
        tried_);
    tried_ = mined.templates;
    // Chains are few words under few conditions; what comes next is of another kind.
    areBoundsUnfinished_ = mined.isUnfinished && scope != BoundScope::Chain;
    differences_.insert(differences_.end(), mined.differences.begin(), mined.differences.end());
    return strengthen(mined.clauses);
  }

  /// `seconds`: for each question, what engines have had on this system before included.
  void raceApart(const Techniques& techniques, double seconds) {
    if (!racing_) racing_ = std::make_unique<ConeRace>(system_, *blast_, invariants_, open_, answers_, options_);
    racing_->run({techniques, seconds, searchEnd()});
    for (Contestant& contestant : racing_->contestants()) {
      QuestionAnswer& answer = answers_[contestant.question];
      if (answer.answer != Answer::Unknown) continue;
      answer.seconds += contestant.seconds / std::max(options_.jobs, 1);
      completeEvidence(contestant.verdict, contestant.words.get(), contestant.cone);
      take(contestant.question, contestant.verdict, &contestant.cone);
    }
  }

  /// What the engine on words has found, on bits: a run of the cone, clauses of the whole system.
  void completeEvidence(Verdict& verdict, WordEngine* words, const BitCone& cone) {
    if (verdict.answer == Answer::Violated && !verdict.trace) {
      const BitTrace whole = blast_->bitTrace(words->trace());
      BitTrace& trace = verdict.trace.emplace();
      for (const std::uint32_t latch : cone.latches) trace.initial.push_back(whole.initial[latch]);
      for (const std::vector<bool>& scan : whole.inputs) {
        std::vector<bool>& inputs = trace.inputs.emplace_back();
        for (const std::uint32_t input : cone.inputs) inputs.push_back(scan[input]);
      }
      CHECK(isViolation(cone.system, trace), "a run of words does not violate the property");
    }
    if (verdict.answer == Answer::Proved && !verdict.certificate) {
      onWholeSystem_ = Certificate{};
      for (const std::vector<Node>& nodes : words->clauses()) {
        blast_->add(nodes);
        std::vector<Lit>& clause = onWholeSystem_->clauses.emplace_back();
        for (const Node n : nodes) clause.push_back(blast_->of(n)[0]);
      }
      verdict.certificate = Certificate{};
    }
  }

  /// What is found out about the system from now on is nothing that its engines know.
  void leaveRace() {
    racing_.reset();
    briefly_ = 0;
  }

  /// Turns a verdict about the cone (nullptr: about the whole bit system) into the answer of question q.
  void take(std::size_t q, const Verdict& verdict, const BitCone* cone) {
    QuestionAnswer& answer = answers_[q];
    answer.answer = verdict.answer;
    answer.depth = verdict.depth;
    answer.method = verdict.method;
    if (verdict.answer == Answer::Violated) {
      std::optional<BitTrace> trace =
          cone == nullptr ? verdict.trace : completeTrace(blast_->bits(), *cone, *verdict.trace);
      CHECK(trace.has_value(), "constraints outside the cone can always be met");
      answer.trace = blast_->wordTrace(*trace);
      answer.usesFreeReals = !blast_->unmodelled().empty();
    }
    if (verdict.answer == Answer::Proved) answer.certificate = wordCertificate(q, *verdict.certificate, cone);
  }

  /// The certificate over the whole bit system, then in words, with the mined invariants it rests on.
  WordCertificate wordCertificate(std::size_t q, const Certificate& given, const BitCone* cone) {
    Certificate whole = cone == nullptr  ? given
                        : onWholeSystem_ ? *std::exchange(onWholeSystem_, std::nullopt)
                                         : onWholeSystem(given, *cone);
    const BitSystem& bits = blast_->bits();
    if (!cores_) cores_ = std::make_unique<InvariantCores>(bits, invariants_.clauses);
    const InvariantCores::Needed needed = cores_->of(blast_->badOf(q), whole, budget(options_.seconds));
    WordCertificate result;
    result.k = given.k;
    result.simplePath = given.simplePath;
    result.isChain = mined_ == Technique::EqualGates || mined_ == Technique::Sums;
    for (const std::vector<Lit>& clause : whole.clauses) result.invariant.push_back(nodeOf(clause));
    result.immediate = result.invariant;
    append(result.invariant, needed.clauses);
    append(result.immediate, needed.immediate);
    std::vector<bool> isUsed(system_.graph->size(), false);
    for (const Node n : coneOf(*system_.graph, result.invariant)) isUsed[indexOf(n)] = true;
    for (const KeptDifference& d : differences_) {
      if (isUsed[indexOf(d.difference)]) result.differences.push_back(d);
    }
    for (const KeptSum& sum : sums_) {
      const std::vector<Node> under = coneOf(*system_.graph, std::vector{sum.sum});
      if (std::ranges::any_of(under, [&](Node n) { return isUsed[indexOf(n)] && !isConstant(n); }))
        result.sums.push_back(sum);
    }
    if (options_.log != nullptr && !needed.clauses.empty())
      options_.log->add(result.differences.empty() ? mined_ : Technique::Bounds, {0, 1, 0});
    if (given.simplePath) {
      const std::size_t count = cone == nullptr ? bits.latches.size() : cone->latches.size();
      for (std::size_t i = 0; i < count; ++i) {
        result.pathBits.push_back(
            blast_->nodeOf(positive(bits.latches[cone == nullptr ? i : cone->latches[i]].variable)));
      }
    }
    return result;
  }

  bool isConstant(Node n) const { return (*system_.graph)[n].op == Op::Constant; }
  Node nodeOf(const std::vector<Lit>& clause) {
    Node n = system_.graph->constantNode(0, 1);
    for (const Lit l : clause) n = system_.graph->make(Op::Or, 1, n, blast_->nodeOf(l));
    return n;
  }
  void append(std::vector<Node>& conditions, const std::vector<std::vector<Lit>>& clauses) {
    if (clauses.size() < schedule::manyClauses) {
      for (const std::vector<Lit>& clause : clauses) conditions.push_back(nodeOf(clause));
      return;
    }
    if (clauses != joinedClauses_) {
      joinedClauses_ = clauses;
      joined_ = join(clauses);
    }
    conditions.insert(conditions.end(), joined_.begin(), joined_.end());
  }
  /// Many clauses as fewer conditions: all "a or b" of one a become "a or all of b". In order, what follows one b is
  /// the same for many a, so that steps which exclude each other take one node a step.
  std::vector<Node> join(const std::vector<std::vector<Lit>>& clauses) {
    std::vector<Node> conditions;
    std::map<Lit, std::set<Lit>> pairs;
    for (const std::vector<Lit>& clause : clauses) {
      if (clause.size() == 2)
        pairs[std::min(clause[0], clause[1])].insert(std::max(clause[0], clause[1]));
      else
        conditions.push_back(nodeOf(clause));
    }
    for (const auto& [first, others] : pairs) {
      Node all = system_.graph->constantNode(1, 1);
      for (auto other = others.rbegin(); other != others.rend(); ++other)
        all = system_.graph->make(Op::And, 1, blast_->nodeOf(*other), all);
      conditions.push_back(system_.graph->make(Op::Or, 1, blast_->nodeOf(first), all));
    }
    return conditions;
  }

  /// Adds the certificate's own gates to the bit system of the stage.
  Certificate onWholeSystem(const Certificate& given, const BitCone& cone) {
    BitSystem& bits = blast_->bits();
    std::vector<Lit> extra;
    std::vector<Lit> back(cone.system.variableCount(), falseLit);
    for (std::size_t i = 0; i < cone.latches.size(); ++i) {
      back[cone.system.latches[i].variable] = positive(bits.latches[cone.latches[i]].variable);
    }
    const auto literal = [&](Lit l) {
      const std::uint32_t v = variableOf(l);
      return (v < back.size() ? back[v] : extra[v - back.size()]) ^ (l & 1U);
    };
    for (const AndGate& gate : given.gates) extra.push_back(bits.addAnd(literal(gate.left), literal(gate.right)));
    Certificate whole;
    whole.k = given.k;
    whole.simplePath = given.simplePath;
    for (const std::vector<Lit>& clause : given.clauses) {
      std::vector<Lit>& translated = whole.clauses.emplace_back();
      for (const Lit l : clause) translated.push_back(literal(l));
    }
    return whole;
  }

  const TransitionSystem& system_;
  const PortfolioOptions options_;
  const Budget whole_ = options_.budget();
  Budget::Clock::time_point stageBegin_{};
  std::unique_ptr<BitBlast> blast_;               ///< of this stage
  std::vector<Lit> truths_;                       ///< literals of blast_
  std::vector<std::vector<Lit>> guesses_;         ///< further candidate invariants, in literals of blast_
  Invariants invariants_;                         ///< of blast_'s system
  Technique mined_ = Technique::StatePairs;       ///< where they come from
  std::vector<std::vector<std::size_t>> groups_;  ///< indices of states; of all stages
  std::unique_ptr<InvariantCores> cores_;         ///< of invariants_
  std::optional<Certificate> onWholeSystem_;      ///< of the verdict at hand, if it was found on words
  std::vector<KeptDifference> differences_;       ///< that bounds among invariants_ speak of
  std::vector<KeptSum> sums_;                     ///< that invariants_ speak of
  std::vector<BoundTemplate> tried_;              ///< what bounds were last looked for in this stage
  bool areBoundsUnfinished_ = false;              ///< the time for them has ended
  std::vector<std::vector<Lit>> joinedClauses_;   ///< of blast_'s system
  std::vector<Node> joined_;                      ///< what they say
  std::unique_ptr<ConeRace> racing_;              ///< about blast_'s system under invariants_
  double briefly_ = 0;                            ///< s for each question that the engines have had there
  Questions open_;                                ///< without answer; in a stage, of those that it is about
  std::vector<QuestionAnswer> answers_;
};

}  // namespace

std::vector<QuestionAnswer> runStages(const TransitionSystem& system, const Questions& questions,
                                      const PortfolioOptions& options) {
  return Stages(system, questions, options).run();
}

}  // namespace rungproof
