// Correspondence of states, then outputs.
#include "analysis/equivalence/equivalence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <unordered_set>

#include "analysis/encoding/accelerate.hpp"
#include "analysis/equivalence/both_runs.hpp"
#include "analysis/equivalence/equality_proof.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "analysis/proof/hidden_code.hpp"
#include "analysis/proof/proof_side.hpp"
#include "analysis/proof/proof_watch.hpp"
#include "analysis/proof/witness.hpp"

namespace rungproof {

namespace {

constexpr double pairSeconds = 2;            ///< for a pair of states that is not settled at once
constexpr double outputSeconds = 1;          ///< for all outputs, whatever NEW's own memory is
constexpr int shallowScans = 10;             ///< of a run that is searched for first
constexpr int longScans = 12;                ///< of a run in which time passes in long scans
constexpr std::size_t mostConditions = 400;  ///< under which states may correspond
constexpr int pairScans = 8;                 ///< of a run that shows that states do not correspond
constexpr double searchSeconds = 3;          ///< for each of these searches

class ProgramComparison {
 public:
  using Clock = std::chrono::steady_clock;

  ProgramComparison(const Side& before, const Side& after, const EquivalenceOptions& options)
      : before_(before),
        after_(after),
        options_(options),
        match_(matchPrograms(*before.program, *after.program, options.pairs)),
        watch_(options.prover.cancel, options.prover.memory) {}

  Equivalence run() {
    nameAssumptions();
    try {
      ProductOptions options = productOptions(false);
      if (options_.prover.certificates) {
        options.trailBefore = std::make_shared<Trail>();
        options.trailAfter = std::make_shared<Trail>();
      }
      ProgramProduct product(before_, after_, match_, options);
      correspond(product, false);
      compareOutputs(product);
      if (result_.equality == Equality::Equal) guardCoverage(product);
      guardUnread();
      if (result_.equality == Equality::Equal && options_.prover.certificates) certify(product, std::move(options));
    } catch (const EncodingStopped&) {
      result_.notes.push_back(watch_.isInterrupted() ? "interrupted before both programs were encoded"
                                                     : "the time was over before both programs were encoded");
    }
    result_.seconds = seconds();
    return std::move(result_);
  }

 private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double left() const { return std::max(options_.prover.timeout - seconds(), 0.0); }

  std::vector<QuestionAnswer> ask(const TransitionSystem& system, double each, Effort effort) {
    std::atomic<bool> cancel{false};
    const ProofWatch::Guard guard(watch_, cancel);
    PortfolioOptions portfolio;
    portfolio.effort = effort;
    portfolio.seconds = std::min(each, left());
    portfolio.jobs = options_.prover.jobs;
    portfolio.seed = options_.prover.seed;
    portfolio.bound = options_.prover.bound;
    portfolio.memory = options_.prover.memory;
    portfolio.check = options_.prover.evidence;
    portfolio.cancel = &cancel;
    portfolio.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                                            std::min(left(), each * static_cast<double>(system.questions.size()))));
    return answerQuestions(withWrittenReals(system, reals_), portfolio);
  }

  ProductOptions productOptions(bool relaxed) {
    ProductOptions options;
    options.encoder = encoderOptionsOf(options_.prover, relaxed);
    options.encoder.interruptsInside = options_.interruptsInside;
    options.encoder.interruption = [this] {
      if (watch_.isStopped() || left() <= 0) throw EncodingStopped{};
    };
    options.pairs = options_.pairs;
    options.observed = options_.observed;
    options.assumptions = options_.assumptions;
    options.steadyInputs = options_.steadyInputs;
    options.latency = options_.latency;
    options.settleMs = options_.settleMs;
    return options;
  }

  void nameAssumptions() {
    for (const Side* side : {&before_, &after_}) {
      for (const std::string& text : environmentTexts(*side->program, side->set, options_.prover.time)) {
        if (std::ranges::find(result_.assumptions, text) == result_.assumptions.end())
          result_.assumptions.push_back(text);
      }
    }
    for (const Property& assumption : options_.assumptions) result_.assumptions.push_back(assumption.text);
    for (const Side* side : {&before_, &after_}) {
      const bool hasRoutines =
          std::ranges::any_of(side->program->pous, [](const Pou& pou) { return pou.kind == PouKind::Interrupt; });
      if (!hasRoutines) continue;
      result_.assumptions.push_back(options_.interruptsInside ? "interrupts come anywhere in a scan"
                                                              : "interrupts come between scans");
      break;
    }
    if (options_.steadyInputs) result_.assumptions.push_back("physical inputs are steady for the whole scan");
    if (options_.latency > 0)
      result_.assumptions.push_back(
          fmt::format("NEW in scan k + {0} is compared with OLD in scan k", options_.latency));
    if (options_.settleMs > 0)
      result_.assumptions.push_back(
          fmt::format("outputs may differ for less than {} ms without a break", options_.settleMs));
  }

  /// Finds the states of NEW that always hold what their partners hold, whatever NEW's other states are. With
  /// conditions: those that do not may do so wherever some bit of OLD has a value.
  void correspond(ProgramProduct& product, bool withConditions) {
    isMerged_.assign(product.newStateCount(), false);
    conditions_.clear();
    for (std::size_t i = 0; i < isMerged_.size(); ++i) isMerged_[i] = product.isMergeable(i);
    while (!watch_.isStopped() && left() > 0) {
      const JoinedSystem merged = product.merged(isMerged_, true, conditions_);
      TransitionSystem system = merged.system;
      std::vector<std::size_t> open;  // states, then conditions
      const Graph& graph = *system.graph;
      const auto ask1 = [&](std::size_t what, Node differs, const std::string& name) {
        if (differs == noNode || graph.truth({differs}) == false) return;
        open.push_back(what);
        system.questions.push_back({"what stands for " + name + " differs", differs});
      };
      for (std::size_t i = 0; i < isMerged_.size(); ++i) ask1(i, merged.nextDiffers[i], nameOfState(product, i));
      for (std::size_t i = 0; i < conditions_.size(); ++i)
        ask1(isMerged_.size() + i, merged.conditionBreaks[i], conditions_[i].state);
      if (open.empty()) return;
      std::vector<std::size_t> dropped;
      for (const std::size_t i : withConditions ? brokenSoon(system) : brokenOrOpen(system)) dropped.push_back(open[i]);
      if (dropped.empty() && withConditions) {
        for (const std::size_t i : brokenOrOpen(system)) dropped.push_back(open[i]);
      }
      if (dropped.empty()) return;
      drop(product, dropped, withConditions);
    }
    isMerged_.assign(isMerged_.size(), false);  // not settled: nothing is known to correspond
    conditions_.clear();
  }
  /// Questions that a short run answers with yes: all that are so in one run.
  std::vector<std::size_t> brokenSoon(const TransitionSystem& system) const {
    TransitionSystem asked = system;
    std::vector<std::size_t> all(system.questions.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    asked.questions = {{"something differs", anyOf(*asked.graph, system.questions, all)}};
    const auto trace = shallowSearch(asked, pairScans, std::min(pairSeconds, left()));
    return trace ? brokenIn(system, *trace) : std::vector<std::size_t>{};
  }
  static std::vector<std::size_t> brokenIn(const TransitionSystem& system, const WordTrace& trace) {
    std::vector<Node> roots;
    for (const Question& question : system.questions) roots.push_back(question.bad);
    for (const StateVariable& state : system.states) roots.push_back(state.next);
    Evaluator evaluator(*system.graph, roots);
    std::vector<std::uint64_t> now = trace.initial;
    for (const std::vector<std::uint64_t>& scan : trace.inputs) {
      for (std::size_t i = 0; i < now.size(); ++i) evaluator.set(system.states[i].node, now[i]);
      for (std::size_t i = 0; i < scan.size(); ++i) evaluator.set(system.inputs[i], scan[i]);
      evaluator.run();
      for (std::size_t i = 0; i < now.size(); ++i) now[i] = evaluator[system.states[i].next];
    }
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < system.questions.size(); ++i) {
      if (evaluator[system.questions[i].bad] != 0) broken.push_back(i);
    }
    return broken;
  }
  /// Questions that are answered with yes; if there are none, the first one that is not answered with no.
  std::vector<std::size_t> brokenOrOpen(const TransitionSystem& system) {
    const std::vector<QuestionAnswer> answers = ask(system, pairSeconds, Effort::Together);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i].answer == Answer::Violated) found.push_back(i);
    }
    for (std::size_t i = 0; found.empty() && i < answers.size(); ++i) {
      if (answers[i].answer == Answer::Proved) continue;
      TransitionSystem one = system;
      one.questions = {system.questions[i]};
      if (ask(one, pairSeconds, Effort::Full)[0].answer != Answer::Proved) found.push_back(i);
    }
    return found;
  }
  void drop(const ProgramProduct& product, const std::vector<std::size_t>& dropped, bool withConditions) {
    std::vector<PairCondition> kept;
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
      if (std::ranges::find(dropped, isMerged_.size() + i) == dropped.end()) kept.push_back(conditions_[i]);
    }
    conditions_ = std::move(kept);
    const std::vector<std::string> bits = withConditions ? product.oldBitNames() : std::vector<std::string>{};
    for (const std::size_t i : dropped) {
      if (i >= isMerged_.size()) continue;
      isMerged_[i] = false;
      if (conditions_.size() + 2 * bits.size() > mostConditions) continue;
      for (const std::string& bit : bits) {
        for (const bool when : {true, false}) conditions_.push_back({nameOfState(product, i), bit, when});
      }
    }
  }
  static std::string nameOfState(const ProgramProduct& product, std::size_t i) {
    const TransitionSystem& system = product.newSystem();
    return system.graph->variables()[(*system.graph)[system.states[i].node].value].name;
  }

  /// Proves the equality once more, of both programs as they are written: that is what the certificates say.
  void certify(const ProgramProduct& product, ProductOptions options) {
    options.trailBefore->isFollowed = options.trailAfter->isFollowed = true;
    const EqualityProof::Ask asks = [this](const TransitionSystem& system, double each, Effort effort) {
      return ask(system, each, effort);
    };
    try {
      ProgramProduct written(before_, after_, match_, options);
      EqualityProof proof(written, product.newStateNames(), isMerged_, conditions_, asks, left());
      result_.certificates = proof.certificates();
      result_.uncertified = proof.missing();
    } catch (const DecisionsDiverge&) {
      result_.uncertified.emplace_back("both programs");
    } catch (const EncodingStopped&) {
      result_.uncertified.emplace_back("both programs");
    }
  }

  void compareOutputs(ProgramProduct& product) {
    const JoinedSystem once = product.merged(isMerged_, true, conditions_);
    std::vector<Question> questions = outputQuestions(once);
    for (const ObservedBit& bit : once.observed)
      result_.outputs.push_back({bit.name, Equality::Unknown, bit.before, bit.after});
    result_.outputs.push_back({"RUN", Equality::Unknown, {}, {}});
    std::vector<std::size_t> open;
    const Graph& graph = *once.system.graph;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      if (graph.truth({questions[i].bad}) == false)
        result_.outputs[i].equality = Equality::Equal;
      else
        open.push_back(i);
    }
    settle(once.system, questions, open, outputSeconds, Effort::Together);
    method_ = "one scan from memory that corresponds";
    if (!open.empty() && !options_.oneScan) sideBySide(product, open);
    conclude(open);
  }

  /// Asks the open questions; those that are proved are closed.
  std::vector<QuestionAnswer> settle(const TransitionSystem& system, const std::vector<Question>& questions,
                                     std::vector<std::size_t>& open, double each, Effort effort) {
    if (open.empty()) return {};
    TransitionSystem asked = system;
    for (const std::size_t i : open) asked.questions.push_back(questions[i]);
    std::vector<QuestionAnswer> answers = ask(asked, each, effort), rest;
    std::vector<std::size_t> still;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (answers[i].answer == Answer::Proved) {
        result_.outputs[open[i]].equality = Equality::Equal;
        continue;
      }
      still.push_back(open[i]);
      rest.push_back(std::move(answers[i]));
    }
    open = std::move(still);
    return rest;
  }

  /// Both programs with memory of their own: runs that differ first, short ones and those that wait for timers, then
  /// proofs.
  void sideBySide(ProgramProduct& product, std::vector<std::size_t>& open) {
    JoinedSystem both = product.merged(isMerged_, false, conditions_);
    std::vector<Question> questions = outputQuestions(both);
    method_ = "both programs side by side";
    while (searchShort(product, both, questions, open) || searchLong(open)) {
      if (!goesOn(open)) return;
    }
    bool isAskedAgain = false;
    for (const double each : {std::min(2.0, left()), left()}) {
      if (open.empty() || left() <= 0 || watch_.isStopped()) return;
      if (isAskedAgain && hasDropped(product)) {
        correspond(product, true);
        both = product.merged(isMerged_, false, conditions_);
        questions = outputQuestions(both);
      }
      const bool isLast = std::exchange(isAskedAgain, true);
      const std::vector<QuestionAnswer> answers =
          settle(both.system, questions, open, each / static_cast<double>(open.size()), Effort::Full);
      TransitionSystem asked = both.system;
      for (const std::size_t i : open) asked.questions.push_back(questions[i]);
      bool needsReals = false;
      for (std::size_t i = 0; i < open.size(); ++i) {
        if (result_.outputs[open[i]].equality == Equality::Different) continue;
        const bool isViolated = answers[i].answer == Answer::Violated;
        if (isViolated && show(product, both, asked, *answers[i].trace, open)) {
          if (!options_.everyOutput) return;
          continue;
        }
        if (isViolated && answers[i].usesFreeReals && reals_ != RealScope::All && !isLast) {
          needsReals = true;
          continue;
        }
        if (isViolated && both.usesEstimates != noNode && searchExact(product, both, asked.questions[i], open)) {
          if (!options_.everyOutput) return;
          continue;
        }
        if (isViolated && isLast) unconfirmed(product, result_.outputs[open[i]].name, answers[i]);
        depth_ = std::min(depth_, answers[i].depth);
      }
      if (!goesOn(open)) return;
      if (needsReals) reals_ = RealScope::All;
    }
  }

  bool hasDropped(const ProgramProduct& product) const {
    for (std::size_t i = 0; i < isMerged_.size(); ++i) {
      if (!isMerged_[i] && product.isMergeable(i)) return true;
    }
    return false;
  }

  /// Runs without estimates only.
  static void exclude(TransitionSystem& system, Node estimates) {
    if (estimates != noNode) system.constraints.push_back(system.graph->lnot({estimates}).node);
  }
  bool searchExact(ProgramProduct& product, const JoinedSystem& both, const Question& question,
                   const std::vector<std::size_t>& open) {
    TransitionSystem asked = both.system;
    asked.questions = {question};
    exclude(asked, both.usesEstimates);
    const QuestionAnswer answer = ask(asked, searchSeconds, Effort::Full)[0];
    return answer.answer == Answer::Violated && show(product, both, asked, *answer.trace, open);
  }

  bool searchShort(ProgramProduct& product, const JoinedSystem& both, const std::vector<Question>& questions,
                   const std::vector<std::size_t>& open) {
    TransitionSystem asked = both.system;
    asked.questions = {{"the outputs differ", anyOf(*asked.graph, questions, open)}};
    exclude(asked, both.usesEstimates);
    const auto trace = shallowSearch(asked, shallowScans, std::min(searchSeconds, left()));
    return trace && show(product, both, asked, *trace, open);
  }

  /// After a difference: closes the outputs that have their verdict; whether some are left that are to have one.
  bool goesOn(std::vector<std::size_t>& open) const {
    std::erase_if(open, [&](std::size_t i) { return result_.outputs[i].equality == Equality::Different; });
    return (options_.everyOutput || !result_.run) && !open.empty() && left() > 0 && !watch_.isStopped();
  }

  /// In the relaxed encoding a long scan stands for a stretch in which nothing but time passes.
  bool searchLong(const std::vector<std::size_t>& open) {
    std::optional<ProgramProduct> product;
    try {
      product.emplace(before_, after_, match_, productOptions(true));
    } catch (const EncodingStopped&) {
      return false;
    }
    ProgramProduct& relaxed = *product;
    const JoinedSystem both = relaxed.merged(std::vector<bool>(relaxed.newStateCount(), false), false);
    TransitionSystem asked = both.system;
    asked.questions = {{"the outputs differ", anyOf(*asked.graph, outputQuestions(both), open)}};
    exclude(asked, both.usesEstimates);
    const std::unordered_set<std::uint32_t> ofTime = [&] {
      std::unordered_set<std::uint32_t> nodes;
      for (const Node n : both.timeStates) nodes.insert(indexOf(n));
      return nodes;
    }();
    TimeModel& time = relaxed.oldSide().encoding().time();
    accelerate(asked, time.dt(), time.width(), options_.prover.time.high,
               [&](Node n) { return ofTime.contains(indexOf(n)); });
    const auto trace = shallowSearch(asked, longScans, std::min(searchSeconds, left()));
    return trace && show(relaxed, both, asked, *trace, open);
  }

  static Node anyOf(Graph& graph, const std::vector<Question>& questions, const std::vector<std::size_t>& open) {
    Graph::Bool any = graph.constant(false);
    for (const std::size_t i : open) any = graph.lor(any, {questions[i].bad});
    return any.node;
  }

  /// Whether the run, made by the engine on both programs, ends with a difference of an open output.
  bool show(ProgramProduct& product, const JoinedSystem& merged, const TransitionSystem& asked, const WordTrace& trace,
            const std::vector<std::size_t>& open) {
    const TimeRange& range = options_.prover.time;
    EquivalenceRun run;
    const WordTrace left = product.oldTrace(asked, trace), right = product.newTrace(merged, asked, trace);
    run.before = scansOf(product.oldSide().encoding(), product.oldSystem(), left, range);
    run.after = scansOf(product.newSide().encoding(), product.newSystem(), right, range);
    run.initialBefore = initialOf(product.oldSide().encoding(), product.oldSystem(), left);
    run.initialAfter = initialOf(product.newSide().encoding(), product.newSystem(), right);
    std::vector<ObservedBit> wanted;
    for (const std::size_t i : open) {
      if (i < merged.observed.size()) wanted.push_back(merged.observed[i]);
    }
    const bool comparesStops = std::ranges::find(open, merged.observed.size()) != open.end();
    const BothRuns runs{*before_.program, *after_.program, options_, wanted, comparesStops};
    auto shown = runs.judged(std::move(run));
    if (!shown) return false;
    shown = runs.plain(std::move(*shown));
    for (ObservedVerdict& output : result_.outputs) {
      if (output.name == shown->signal) output.equality = Equality::Different;
    }
    if (!result_.run) result_.run = shown;
    return true;
  }

  /// A run that the engine does not repeat: it rests on what is not modelled, or the tool is wrong.
  void unconfirmed(ProgramProduct& product, const std::string& name, const QuestionAnswer& answer) {
    std::vector<std::string> reasons;
    for (const auto& [side, obligations] : {std::pair{&before_, &product.oldSide()}, {&after_, &product.newSide()}}) {
      for (const std::string& text : approximationTexts(*side->program, *obligations)) reasons.push_back(text);
    }
    if (reasons.empty() && !answer.usesFreeReals) {
      result_.disagreements.push_back(
          {name,
           fmt::format("the solver's run of {} scans shows a difference that the engine does not repeat",
                       answer.depth + 1),
           {}});
      return;
    }
    for (const std::string& text : reasons) note(name + " may depend on what is not modelled exactly: " + text);
    if (reasons.empty()) note(name + " depends on REAL operations, which were taken as any value");
  }
  void note(const std::string& text) {
    if (std::ranges::find(result_.notes, text) == result_.notes.end()) result_.notes.push_back(text);
  }

  void conclude(const std::vector<std::size_t>& open) {
    result_.method = method_;
    if (result_.run) {
      result_.equality = Equality::Different;
      return;
    }
    if (open.empty()) {
      result_.equality = Equality::Equal;
      return;
    }
    result_.depth = depth_ == unlimited ? 0 : depth_;
    if (watch_.isInterrupted()) note("interrupted");
    if (left() <= 0) note("the time was over");
  }

  /// What was not read or not followed to its end leaves equality open.
  void guardCoverage(ProgramProduct& product) {
    guardSide(before_, product.oldSide());
    guardSide(after_, product.newSide());
    if (!result_.notes.empty()) result_.equality = Equality::Unknown;
  }
  /// Nothing is decided about an output that unread code may decide.
  void guardUnread() {
    bool isOpen = false;
    for (ObservedVerdict& output : result_.outputs) {
      if (result_.run && output.name != result_.run->signal) continue;
      for (const auto& [side, address] : {std::pair{&before_, output.before}, {&after_, output.after}}) {
        if (side->unread == nullptr || side->unread->empty()) continue;
        for (const std::string& reason : reasonsFor(*side->unread, address)) {
          note(reason);
          output.equality = Equality::Unknown;
          isOpen = true;
        }
      }
    }
    if (!isOpen) return;
    result_.equality = Equality::Unknown;
    result_.run.reset();
  }
  static std::vector<std::string> reasonsFor(const UnreadCode& unread, const std::optional<Address>& address) {
    if (!address) return unread.reasons();
    ExprNode node;
    node.op = ExprOp::Address;
    node.operand = operandAt(*address);
    Property property;
    property.first.nodes.push_back(node);
    return unread.reasons(property);
  }
  void guardSide(const Side& side, Obligations& obligations) {
    EncodedScan& encoding = obligations.encoding();
    if (const auto reason = unfollowedRoutine(*side.program, encoding)) note(*reason);
    Graph& graph = encoding.graph();
    Graph::Bool leftOut = graph.constant(false);
    for (const Approximation& approximation : obligations.approximations()) {
      if (approximation.leftOut != noNode) leftOut = graph.lor(leftOut, {approximation.leftOut});
    }
    if (graph.truth(leftOut) == false) return;
    TransitionSystem system = obligations.system();
    system.questions = {{"a scan is not followed to its end", leftOut.node}};
    if (ask(system, left(), Effort::Full)[0].answer == Answer::Proved) return;
    for (const Approximation& approximation : obligations.approximations()) {
      if (approximation.leftOut != noNode) note("not followed: " + approximationText(*side.program, approximation));
    }
  }

  static constexpr int unlimited = 1 << 30;
  const Side& before_;
  const Side& after_;
  const EquivalenceOptions& options_;
  const ProgramMatch match_;
  const Clock::time_point start_ = Clock::now();
  ProofWatch watch_;
  RealScope reals_ = RealScope::Comparisons;  ///< REAL operations that are asked about bit by bit
  std::vector<bool> isMerged_;
  std::vector<PairCondition> conditions_;
  const char* method_ = "";
  int depth_ = unlimited;
  Equivalence result_;
};

}  // namespace

Equivalence compareBehaviour(const Side& before, const Side& after, const EquivalenceOptions& options) {
  return ProgramComparison(before, after, options).run();
}

}  // namespace rungproof
