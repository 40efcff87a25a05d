// The course of a proof: easy questions together, then each open one with two searches side by side - the engines on
// the exact system, and a search for witnesses on the accelerated one, in which time passes in long scans.
#include "analysis/proof/prover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <random>
#include <set>
#include <thread>
#include <utility>

#include "analysis/portfolio/portfolio.hpp"
#include "analysis/proof/asked_goals.hpp"
#include "analysis/proof/exact_run.hpp"
#include "analysis/proof/exploration.hpp"
#include "analysis/proof/guided_runs.hpp"
#include "analysis/proof/hidden_code.hpp"
#include "analysis/proof/proof_networks.hpp"
#include "analysis/proof/proof_side.hpp"
#include "analysis/proof/proof_watch.hpp"
#include "analysis/proof/witness_minimal.hpp"

namespace rungproof {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int shallowDepth = 12;         ///< scans of a short accelerated run
constexpr double shallowSeconds = 0.25;  ///< for all of them
constexpr double engineSeconds = 2;      ///< for runs of the engine, which count their scans, on a busy machine
constexpr std::uint64_t fewInstructions = 200'000;  ///< of its runs before any proof is tried
constexpr double exploringSeconds = 0.4;            ///< for all questions that are open after the quick ones
constexpr double quickSeconds = 0.5;                ///< for each question while all are looked at together
constexpr int fillings = 16;                   ///< of inputs that a question does not mention, tried to confirm a run
constexpr double minimiseSeconds = 0.25;       ///< for making a witness smaller
constexpr std::uint64_t minimisedScans = 200;  ///< longer witnesses wait for a timer; they stay as they were found
constexpr double premiseSeconds = 5;           ///< for a question that a verdict is checked with
constexpr std::size_t writtenReals = 200;      ///< REAL operations of a question that are written out as bits
constexpr double freeRealShare = 0.25;         ///< of a question's time, before REAL operations are written out

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

class Session {
 public:
  Session(const Program& program, const PropertySet& set, const ProverOptions& options)
      : program_(program),
        set_(set),
        options_(options),
        goals_(askedGoals(set)),
        watch_(options.cancel, options.memory) {
    for (const Property& property : set.properties) {
      if (!property.isGoal()) assumptions_.push_back(property);
    }
  }

  ProofRun run(const ProofProgress& progress) {
    ProofRun result;
    result.assumptions = environmentTexts(program_, set_, options_.time);
    const std::size_t declared = declaredCount();
    deadline_ = begin_ + seconds(options_.timeout * static_cast<double>(std::max<std::size_t>(declared, 1)));
    try {
      exact_ = std::make_unique<ProofSide>(program_, set_, goals_, encoding(false), options_.checks);
    } catch (const EncodingStopped&) {
      for (std::size_t i = 0; i < declared; ++i)
        result.results.push_back(open(goals_[i], reasonToStop() + " before the program was encoded"));
      if (options_.checks.builtin) {
        Property checks;
        checks.name = "built-in checks";
        result.results.push_back(open(checks, reasonToStop() + " before the program was encoded"));
      }
      result.isInterrupted = watch_.isInterrupted();
      return result;
    }
    const std::size_t total = declared + exact_->checks().size();
    answerQuickly(begin_ + seconds(options_.timeout * static_cast<double>(std::max<std::size_t>(total, 1))));
    const auto questionOf = [&](std::size_t i) { return i < declared ? i : goals_.size() + (i - declared); };
    std::vector<std::size_t> order(total);
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Those with a run first: who waits for the first bad verdict need not wait for proofs.
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t i) { return quick_[questionOf(i)].answer == Answer::Violated; });
    std::vector<std::optional<ProofResult>> rows(total);
    for (std::size_t done = 0; done < total; ++done) {
      const std::size_t i = order[done];
      const Clock::time_point start = Clock::now();
      // One question may use its own time, and what those before it have left of theirs is not saved up.
      const bool isOfRule = i >= declared && isRuleQuestion(exact_->checks()[i - declared].kind);
      const double most = isOfRule ? std::min(options_.timeout, options_.ruleTimeout) : options_.timeout;
      deadline_ = std::min(start + seconds(most), begin_ + seconds(options_.timeout * static_cast<double>(done + 1)));
      const std::size_t question = questionOf(i);
      ProofResult row;
      if (i < declared)
        row.property = goals_[i];
      else {
        row.builtin = exact_->checks()[i - declared];
        row.property.name = row.builtin->name;
        if (row.builtin->place != nullptr) row.property.span = row.builtin->place->span;
      }
      settle(question, row, result);
      row.seconds = secondsSince(start) + quick_[question].seconds;
      rows[i] = std::move(row);
      if (progress && !progress(*rows[i], done + 1, total)) break;
    }
    for (std::optional<ProofResult>& row : rows) {
      if (row) result.results.push_back(std::move(*row));
    }
    for (const Approximation& approximation : exact_->obligations().approximations()) {
      if (!isWrittenOut(*exact_->system().graph, approximation) || noted_.contains(&approximation))
        result.approximations.push_back(approximationText(program_, approximation));
    }
    result.isInterrupted = watch_.isInterrupted();
    return result;
  }

 private:
  static Clock::duration seconds(double s) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
  }
  double left() const { return std::chrono::duration<double>(deadline_ - Clock::now()).count(); }

  std::string reasonToStop() const {
    return watch_.isInterrupted()   ? "interrupted"
           : watch_.isOutOfMemory() ? "the memory limit was reached"
                                    : "the time was over";
  }
  static ProofResult open(const Property& property, std::string note) {
    ProofResult row;
    row.property = property;
    row.notes.push_back(std::move(note));
    return row;
  }
  EncoderOptions encoding(bool relaxed) const {
    EncoderOptions options = encoderOptionsOf(options_, relaxed);
    options.interruption = [this] {
      if (watch_.isStopped() || Clock::now() >= deadline_) throw EncodingStopped{};
    };
    return options;
  }
  /// Whether REAL operations decide the question that can be written out: engines take them as any value at first.
  bool restsOnReals(std::size_t question) const {
    const std::size_t count = exact_->exactReals(question);
    return count > 0 && count <= writtenReals;
  }
  std::vector<QuestionAnswer> ask(const TransitionSystem& system, double each, Clock::time_point deadline) {
    std::atomic<bool> cancel{false};
    const ProofWatch::Guard guard(watch_, cancel);
    return answerQuestions(system, portfolio(each, deadline, &cancel));
  }

  std::size_t declaredCount() const {
    return static_cast<std::size_t>(
        std::count_if(set_.properties.begin(), set_.properties.end(), [](const Property& p) { return p.isGoal(); }));
  }
  std::optional<std::size_t> goalNamed(const std::string& name) const {
    const auto found = std::find_if(goals_.begin(), goals_.end(), [&](const Property& p) { return p.name == name; });
    if (found == goals_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - goals_.begin());
  }

  PortfolioOptions portfolio(double each, Clock::time_point deadline, const std::atomic<bool>* cancel) const {
    PortfolioOptions options;
    options.seconds = each;
    options.jobs = options_.jobs;
    options.seed = options_.seed;
    options.bound = options_.bound;
    options.cancel = cancel;
    options.deadline = deadline;
    options.memory = options_.memory;
    options.check = options_.evidence;
    return options;
  }

  // ---- All questions ---------------------------------------------------------------------------------

  /// What takes milliseconds for all questions; then short runs in which time passes in long scans, so that what a
  /// timer brings about costs the same whatever its preset; then half a second for what is left.
  void answerQuickly(Clock::time_point deadline) {
    std::atomic<bool> cancel{false};
    const ProofWatch::Guard guard(watch_, cancel);
    PortfolioOptions together = portfolio(std::min(options_.timeout, quickSeconds), deadline, &cancel);
    together.effort = Effort::Together;
    quick_.resize(exact_->system().questions.size());
    searchOnEngine([&](std::size_t q) { return q >= declaredCount(); }, fewInstructions);
    TransitionSystem rest = exact_->system();
    answerOpen(rest, openQuestions([](std::size_t) { return true; }), together);
    const auto start = Clock::now();
    std::vector<std::size_t> open;
    for (std::size_t q = 0; q < quick_.size(); ++q) {
      const bool maySearch = q < goals_.size() && options_.bound == 0 && secondsSince(start) <= shallowSeconds;
      if (quick_[q].answer == Answer::Unknown && !(maySearch && searchShallow(q))) open.push_back(q);
    }
    searchOnEngine([&](std::size_t q) { return q >= declaredCount() || goals_[q].kind == PropertyKind::Reach; },
                   GuidedLimits{}.instructions);
    std::erase_if(open, [&](std::size_t q) { return quick_[q].answer != Answer::Unknown; });
    answerOpen(rest, open, portfolio(std::min(options_.timeout, quickSeconds), deadline, &cancel));
    explore(std::min(deadline, Clock::now() + seconds(std::min(options_.timeout / 10, exploringSeconds))));
  }
  /// What the engine finds from state to state for all open goals.
  void explore(Clock::time_point deadline) {
    const std::vector<std::size_t> open = openQuestions([&](std::size_t q) { return q < goals_.size(); });
    if (open.empty() || options_.bound > 0 || watch_.isStopped()) return;
    std::atomic<bool> cancel{false};
    const ProofWatch::Guard guard(watch_, cancel);
    exploration_ = std::make_unique<Exploration>(program_, exact_->obligations().encoding(), assumptions_, goals_, open,
                                                 options_.seed);
    exploration_->search(deadline, cancel);
    takeExplored();
  }
  /// Runs that the exploration has found for questions that were still open.
  void takeExplored() {
    if (!exploration_) return;
    for (std::size_t q = 0; q < goals_.size(); ++q) {
      if (quick_[q].answer == Answer::Unknown && exploration_->found(q))
        show(q, *exploration_->found(q), "exploration");
    }
  }
  void show(std::size_t question, Witness witness, const char* method) {
    quick_[question].answer = Answer::Violated;
    quick_[question].method = method;
    found_.emplace(question, std::move(witness));
  }
  template <class Wanted>
  std::vector<std::size_t> openQuestions(Wanted&& wanted) const {
    std::vector<std::size_t> open;
    for (std::size_t q = 0; q < quick_.size(); ++q) {
      if (quick_[q].answer == Answer::Unknown && wanted(q)) open.push_back(q);
    }
    return open;
  }
  void answerOpen(TransitionSystem& rest, const std::vector<std::size_t>& open, const PortfolioOptions& options) {
    if (open.empty()) return;
    rest.questions.clear();
    for (const std::size_t q : open) rest.questions.push_back(exact_->system().questions[q]);
    std::vector<QuestionAnswer> answers = answerQuestions(rest, options);
    for (std::size_t i = 0; i < open.size(); ++i) {
      answers[i].seconds += quick_[open[i]].seconds;
      quick_[open[i]] = std::move(answers[i]);
    }
  }
  /// Runs of the engine for wanted goals that are still open, all together.
  template <class Wanted>
  void searchOnEngine(Wanted&& wanted, std::uint64_t instructions) {
    const std::vector<std::size_t> open = openQuestions([&](std::size_t q) { return q < goals_.size() && wanted(q); });
    std::vector<const Property*> goals;
    for (const std::size_t q : open) goals.push_back(&goals_[q]);
    if (options_.bound > 0 || open.empty() || watch_.isStopped()) return;
    std::vector<std::optional<Witness>> found =
        guidedRuns(program_, exact_->obligations().encoding(), assumptions_, goals, options_.seed,
                   {std::min(options_.timeout / 10, engineSeconds), instructions});
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (found[i]) show(open[i], std::move(*found[i]), "engine runs");
    }
  }
  /// A short run of the accelerated system that the engine repeats.
  bool searchShallow(std::size_t question) {
    const auto start = Clock::now();
    if (!exact_->dependsOnTime(exact_->variablesOf(question))) return false;
    ProofSide* relaxed = relaxedSide();
    if (relaxed == nullptr) return false;
    const TransitionSystem accelerated = relaxed->accelerated(question, options_.time.high);
    if (const auto trace = shallowSearch(accelerated, shallowDepth, shallowSeconds / 4)) {
      if (auto witness = replayed(*relaxed, accelerated, question, *trace)) {
        show(question, std::move(*witness), "accelerated search");
        quick_[question].seconds += secondsSince(start);
        return true;
      }
    }
    return false;
  }

  // ---- One question -----------------------------------------------------------------------------------

  void settle(std::size_t question, ProofResult& row, ProofRun& run) {
    QuestionAnswer answer = quick_[question];
    std::optional<Witness> witness;
    if (const auto found = found_.find(question); found != found_.end())
      witness = found->second;
    else if (answer.answer == Answer::Violated)
      witness = confirmed(question, *answer.trace);
    const bool isOpen = !witness && (answer.answer == Answer::Unknown || answer.answer == Answer::Violated);
    watch_.release();
    if (isOpen && left() > 0 && !watch_.isStopped()) std::tie(answer, witness) = search(question, answer.answer);
    if (!witness && answer.answer == Answer::Violated && question < goals_.size() && options_.bound == 0 &&
        !watch_.isStopped() && left() > 0) {
      // A run that rests on values which are not modelled: perhaps the engine finds one with its own.
      std::vector<std::optional<Witness>> found =
          guidedRuns(program_, exact_->obligations().encoding(), assumptions_, {&goals_[question]}, options_.seed,
                     {std::min(left(), options_.timeout / 10)});
      witness = std::move(found[0]);
      if (witness) answer.method = "engine runs";
    }
    row.method = answer.method;
    row.depth = answer.depth;
    row.notes = row.property.remarks;
    const bool wantsYes = row.builtin ? isWanted(row.builtin->kind) : row.property.kind == PropertyKind::Reach;
    if (witness) {
      row.outcome = wantsYes ? Outcome::Reachable : Outcome::Violated;
      if (options_.evidence && question < goals_.size() && witness->scanCount <= minimisedScans &&
          !watch_.isStopped()) {
        const double most = std::clamp(left(), 0.05, minimiseSeconds);
        const std::uint32_t plainMs =
            std::clamp<std::uint32_t>(ReplayScan{}.lengthMs, options_.time.low, options_.time.high);
        witness = minimised(Judge(program_, options_.choices, assumptions_, goals_[question]), std::move(*witness),
                            plainMs, most, options_.seed);
      }
      row.depth = static_cast<int>(std::min<std::uint64_t>(witness->scanCount, 1U << 30));
      row.witness = std::move(witness);
    } else if (answer.answer == Answer::Proved) {
      row.outcome = wantsYes ? Outcome::Unreachable : Outcome::Proved;
      if (options_.certificates && answer.certificate) {
        const auto written = written_.find(question);
        const TransitionSystem& system = written == written_.end() ? exact_->system() : written->second;
        row.certificate =
            certificateText(system, system.questions[written == written_.end() ? question : 0], *answer.certificate);
      }
      checkVacuity(row);
      if (options_.evidence) row.networks = networksOf(question, answer);
    } else if (answer.answer == Answer::Violated) {
      unconfirmed(question, answer, row, run);
    } else {
      row.outcome = answer.depth > 0 && options_.bound > 0 ? Outcome::HoldsToBound : Outcome::Unknown;
      if (options_.bound > 0) row.depth = answer.depth = std::min(answer.depth, options_.bound);
      row.notes.push_back(fmt::format("{} in the first {} scans; {}", wantsYes ? "not reached" : "no violation",
                                      answer.depth,
                                      answer.method.empty() ? "no engine came to work" : "tried " + answer.method));
      if (watch_.isStopped()) row.notes.push_back(reasonToStop());
    }
    noteApproximations(question, row);
    guardInterrupts(row);
    guardLeftOut(row);
    guardHiddenCode(question, row);
  }

  /// Nothing is decided that depends on code which was not read.
  void guardHiddenCode(std::size_t question, ProofResult& row) const {
    const std::vector<std::string> reasons =
        hidden_.reasons(exact_->obligations().encoding(), exact_->variablesOf(question));
    if (reasons.empty()) return;
    row.outcome = Outcome::NotCovered;
    row.witness.reset();
    row.certificate.clear();
    row.notes.insert(row.notes.end(), reasons.begin(), reasons.end());
  }

  /// What is not followed to its end leaves every proof open, unless it cannot occur.
  void guardLeftOut(ProofResult& row) {
    const auto question = exact_->leftOutQuestion();
    if (!question || row.witness) return;
    if (quick_[*question].answer == Answer::Unknown && left() > 0 && !watch_.isStopped()) {
      quick_[*question] = ask(exact_->only(*question), std::min(left(), premiseSeconds), deadline_)[0];
    }
    if (quick_[*question].answer == Answer::Proved) return;
    row.outcome = Outcome::NotCovered;
    row.certificate.clear();
    for (const Approximation& approximation : exact_->obligations().approximations()) {
      if (approximation.leftOut != noNode)
        row.notes.push_back("not followed: " + approximationText(program_, approximation));
    }
  }

  /// Networks that decide the property: a proof without earlier scans depends on the state that its invariant speaks
  /// of.
  std::vector<NetworkName> networksOf(std::size_t question, const QuestionAnswer& answer) {
    std::vector<Operand> read;
    if (question < goals_.size()) {
      for (const Operand* operand : addressesOf(goals_[question])) read.push_back(*operand);
    } else {
      read = exact_->checks()[question - goals_.size()].operands();
    }
    if (!facts_) facts_ = std::make_unique<Facts>(program_, set_.externals);
    std::unordered_set<std::uint32_t> variables;
    if (answer.certificate && answer.certificate->k == 0) {
      std::vector<Node> roots = answer.certificate->invariant;
      roots.push_back(exact_->system().questions[question].bad);
      variables = SmtText(exact_->system()).statesUnder(roots);
    } else {
      variables = exact_->variablesOf(question);
    }
    return networksBehind(*facts_, exact_->obligations().encoding(), read, variables);
  }

  /// A routine that is attached but whose events the encoding does not know leaves every proof open.
  void guardInterrupts(ProofResult& row) const {
    if (row.outcome != Outcome::Proved && row.outcome != Outcome::Unreachable) return;
    const std::optional<std::string> reason = unfollowedRoutine(program_, exact_->obligations().encoding());
    if (!reason) return;
    row.outcome = Outcome::NotCovered;
    row.certificate.clear();
    row.notes.push_back(*reason);
  }

  using Found = std::pair<QuestionAnswer, std::optional<Witness>>;

  /// REAL operations take any value at first, which is enough for many proofs; where it is not, they are written out.
  Found search(std::size_t question, Answer known) {
    if (!restsOnReals(question)) return race(question);
    if (known == Answer::Unknown) {
      const Clock::time_point whole = std::exchange(deadline_, Clock::now() + seconds(left() * freeRealShare));
      Found found = race(question);
      deadline_ = whole;
      if (found.second || found.first.answer == Answer::Proved || left() <= 0 || watch_.isStopped()) return found;
    }
    written_.emplace(question, withExactReals(exact_->only(question), RealScope::All));
    return race(question);
  }

  /// The exact system and the accelerated one at the same time; the first valid result ends both. Witnesses of built-in
  /// checks are followed on the exact graph, which the other search extends: they wait for its end.
  Found race(std::size_t question) {
    const auto written = written_.find(question);
    const bool isWritten = written != written_.end();
    const TransitionSystem exact = isWritten ? written->second : exact_->only(question);
    std::atomic<bool> cancelExact{false}, cancelFast{false};
    const ProofWatch::Guard guardExact(watch_, cancelExact), guardFast(watch_, cancelFast);
    std::optional<Witness> witness;
    std::optional<QuestionAnswer> fastAnswer;
    std::optional<TransitionSystem> accelerated;
    std::thread fast;
    const bool isBounded = options_.bound > 0;  // by scans of the program, which the accelerated system does not count
    ProofSide* relaxed = !isBounded && exact_->dependsOnTime(exact_->variablesOf(question)) ? relaxedSide() : nullptr;
    if (relaxed != nullptr) {
      accelerated = relaxed->accelerated(question, options_.time.high);
      if (isWritten) accelerated = withExactReals(*accelerated, RealScope::All);
      fast = std::thread([&] {
        PortfolioOptions options = portfolio(left(), deadline_, &cancelFast);
        options.jobs = 1;
        options.check = false;
        QuestionAnswer answer = answerQuestions(*accelerated, options)[0];
        if (answer.answer != Answer::Violated) return;
        if (question < goals_.size()) witness = replayed(*relaxed, *accelerated, question, *answer.trace);
        fastAnswer = std::move(answer);
        if (witness || question >= goals_.size()) cancelExact = true;
      });
    }
    std::optional<ExplorationThread> exploring;
    if (exploration_ && question < goals_.size() && !exploration_->found(question)) {
      exploring.emplace(*exploration_, question, deadline_, [&] { cancelExact = cancelFast = true; });
    }
    QuestionAnswer answer = answerQuestions(exact, portfolio(std::max(left(), 0.0), deadline_, &cancelExact))[0];
    if (answer.answer != Answer::Unknown) cancelFast = true;
    if (fast.joinable()) fast.join();
    const bool isExplored = exploring && exploring->end() && !witness;
    takeExplored();
    if (isExplored) witness = exploration_->found(question);
    if (fastAnswer && !witness && question >= goals_.size()) {
      witness = replayed(*relaxed, *accelerated, question, *fastAnswer->trace);
      if (!witness && answer.answer == Answer::Unknown && left() > 0 && !watch_.isStopped())
        answer = ask(exact, left(), deadline_)[0];
    }
    CHECK(!(witness && answer.answer == Answer::Proved), "a proved property has a witness that the engine repeats");
    if (witness) {
      answer.method = isExplored ? "exploration" : "accelerated search";
    } else if (answer.answer == Answer::Violated) {
      witness = confirmed(question, *answer.trace);
    }
    answer.depth = std::max(answer.depth, answer.answer == Answer::Unknown ? quick_[question].depth : answer.depth);
    return {std::move(answer), std::move(witness)};
  }

  /// Nothing if there was no time to encode it.
  ProofSide* relaxedSide() {
    if (relaxed_) return relaxed_.get();
    try {
      relaxed_ = std::make_unique<ProofSide>(program_, set_, goals_, encoding(true), options_.checks);
    } catch (const EncodingStopped&) {
      return nullptr;
    }
    return relaxed_.get();
  }

  /// The run as the engine repeats it, if it shows the same.
  std::optional<Witness> replayed(ProofSide& side, const TransitionSystem& system, std::size_t question,
                                  const WordTrace& trace) {
    EncodedScan& encoding = side.obligations().encoding();
    if (question >= goals_.size()) {
      const ExactQuestion asked(exact_->obligations().encoding(), exact_->system(),
                                exact_->system().questions[question].bad);
      std::optional<ExactRun> run = asked.runOf(system, trace, options_.time);
      std::optional<Witness> witness = run ? asked.witness(program_, options_.choices, *run) : std::nullopt;
      const std::size_t check = question - goals_.size();
      const bool isShownToPeople =
          options_.evidence && check < exact_->checks().size() && !isRuleQuestion(exact_->checks()[check].kind);
      if (!witness || !isShownToPeople || witness->scanCount > minimisedScans || watch_.isStopped()) return witness;
      std::vector<std::vector<bool>> matters;
      if (!asked.dropIdle(*run, matters, minimiseSeconds, options_.seed)) return witness;
      std::optional<Witness> smaller = asked.witness(program_, options_.choices, *run);
      if (smaller) smaller->matters = std::move(matters);
      return smaller ? smaller : witness;
    }
    std::vector<ReplayScan> scans = scansOf(encoding, system, trace, options_.time);
    return Judge(program_, options_.choices, assumptions_, goals_[question])
        .witness(std::move(scans), initialOf(encoding, system, trace));
  }

  /// A run of the exact system. Where the question rests on values that are not modelled exactly, what it does not
  /// mention may decide whether the engine repeats the run: some values of that are tried.
  std::optional<Witness> confirmed(std::size_t question, const WordTrace& trace) {
    std::optional<Witness> witness = replayed(*exact_, exact_->system(), question, trace);
    if (witness || exact_->approximationsOf(question, written_.contains(question)).empty()) return witness;
    std::unordered_set<std::uint32_t> fixed = exact_->variablesOf(question);
    for (const Node n : exact_->obligations().encoding().time().inputs()) fixed.insert(indexOf(n));
    std::mt19937_64 random(options_.seed);
    WordTrace tried = trace;
    for (int attempt = 0; attempt < fillings && !witness && !watch_.isStopped(); ++attempt) {
      fillOtherInputs(exact_->system(), fixed, random, tried);
      witness = replayed(*exact_, exact_->system(), question, tried);
    }
    return witness;
  }

  void unconfirmed(std::size_t question, const QuestionAnswer& answer, ProofResult& row, ProofRun& run) {
    row.outcome = Outcome::Unknown;
    const bool rests = answer.usesFreeReals || !exact_->approximationsOf(question, written_.contains(question)).empty();
    if (rests) {
      row.outcome = Outcome::NotCovered;
      row.notes.push_back(
          "the run that was found rests on values that are not modelled exactly; the engine does not repeat it");
      return;
    }
    run.disagreements.push_back(
        {row.property.name,
         fmt::format("the solver's run of {} scans is not repeated by the engine", answer.depth + 1)});
  }

  /// A property whose premise can never be met, or assumptions that no run meets, prove nothing.
  void checkVacuity(ProofResult& row) {
    if (row.builtin) return;
    if (const auto some = goalNamed(someRun().name); some && quick_[*some].answer == Answer::Proved) {
      row.outcome = Outcome::Vacuous;
      row.notes.push_back("the assumptions contradict each other: no run meets them");
      return;
    }
    const auto premise = goalNamed(row.property.name + " (premise)");
    if (!premise || row.outcome != Outcome::Proved) return;
    Answer answer = quick_[*premise].answer;
    const bool isOpen = answer == Answer::Unknown ||
                        (answer == Answer::Violated && !found_.contains(*premise) && restsOnReals(*premise));
    if (isOpen && left() > 0 && !watch_.isStopped()) {
      const Clock::time_point whole =
          std::exchange(deadline_, std::min(deadline_, Clock::now() + seconds(premiseSeconds)));
      const auto [found, witness] = search(*premise, answer);
      answer = witness ? Answer::Violated : found.answer;
      deadline_ = whole;
    }
    if (answer == Answer::Proved) {
      row.outcome = Outcome::Vacuous;
      row.notes.push_back(fmt::format("the premise '{}' can never be met", goals_[*premise].text));
    } else if (answer == Answer::Unknown) {
      row.notes.push_back(fmt::format("no run was found that meets the premise '{}'", goals_[*premise].text));
    }
  }

  void noteApproximations(std::size_t question, ProofResult& row) {
    for (const Approximation* approximation : exact_->approximationsOf(question, written_.contains(question))) {
      if (row.outcome == Outcome::Unknown) row.outcome = Outcome::NotCovered;
      row.notes.push_back("depends on " + approximationText(program_, *approximation));
      noted_.insert(approximation);
    }
  }

  const Program& program_;
  const PropertySet& set_;
  const ProverOptions& options_;
  HiddenCode hidden_{program_, set_};
  const Clock::time_point begin_ = Clock::now();
  Clock::time_point deadline_ = begin_;  ///< of the question at hand
  std::vector<Property> goals_;
  std::vector<Property> assumptions_;
  ProofWatch watch_;
  std::unique_ptr<ProofSide> exact_;
  std::unique_ptr<ProofSide> relaxed_;
  std::unique_ptr<Exploration> exploration_;
  std::unique_ptr<Facts> facts_;
  std::vector<QuestionAnswer> quick_;
  std::map<std::size_t, Witness> found_;             ///< by question: witnesses of the short search
  std::set<const Approximation*> noted_;             ///< what some result rests on
  std::map<std::size_t, TransitionSystem> written_;  ///< by question: its system with REAL operations written out
};

}  // namespace

EncoderOptions encoderOptionsOf(const ProverOptions& options, bool relaxed) {
  EncoderOptions result;
  result.choices = options.choices;
  result.time = options.time;
  result.time.relaxed = relaxed;
  return result;
}

ProofRun prove(const Program& program, const PropertySet& set, const ProverOptions& options,
               const ProofProgress& progress) {
  return Session(program, set, options).run(progress);
}

}  // namespace rungproof
