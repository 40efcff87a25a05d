// Correspondence of states, then outputs.
#include "analysis/equivalence/equivalence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "analysis/encoding/accelerate.hpp"
#include "analysis/equivalence/both_runs.hpp"
#include "analysis/equivalence/comparison_basis.hpp"
#include "analysis/equivalence/equality_proof.hpp"
#include "analysis/equivalence/hidden_blocks.hpp"
#include "analysis/equivalence/pair_exploration.hpp"
#include "analysis/equivalence/plain_run.hpp"
#include "analysis/equivalence/scan_length.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "analysis/proof/proof_watch.hpp"
#include "analysis/proof/question_system.hpp"
#include "analysis/proof/unfollowed_routine.hpp"
#include "analysis/witness/witness.hpp"

namespace rungproof {
namespace {

constexpr double outputSeconds = 1;     ///< for all outputs, whatever NEW's own memory is
constexpr int shallowScans = 10;        ///< of a run that is searched for first
constexpr int longScans = 12;           ///< of a run in which time passes in long scans
constexpr double searchSeconds = 3;     ///< for each of these searches
constexpr double shortShare = 0.25;     ///< of the time that is left, at most
constexpr double earlySeconds = 0.15;   ///< for runs of the engine before anything is encoded
constexpr double earlyShare = 0.1;      ///< of the time, at most
constexpr double exploringSeconds = 5;  ///< for such runs when a short proof has failed
constexpr double exploringShare = 0.4;  ///< of the time that is left, at most

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
    result_.assumptions = assumptionTexts(before_, after_, options_);
    try {
      if (auto early = exploreEarly()) {
        shorten(std::move(*early));
        guardUnread();
        result_.seconds = seconds();
        return std::move(result_);
      }
      ProductOptions options = productOptions(false);
      if (options_.prover.certificates) {
        options.trailBefore = std::make_shared<Trail>();
        options.trailAfter = std::make_shared<Trail>();
      }
      ProgramProduct product(before_, after_, match_, options);
      nameApproximations(product);
      correspond(product, false);
      compareOutputs(product);
      if (std::ranges::any_of(result_.outputs, isEqual)) guardCoverage(product);
      guardUnread();
      if (result_.equality == Equality::Equal && options_.prover.certificates) certify(product, std::move(options));
    } catch (const EncodingStopped&) {
      result_.notes.push_back(watch_.isInterrupted() ? "interrupted before both programs were encoded"
                                                     : "the time was over before both programs were encoded");
    } catch (const std::exception& error) {
      breakOff(error);
    }
    result_.seconds = seconds();
    return std::move(result_);
  }

 private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// Seconds.
  double left() const { return std::max(std::min(options_.prover.timeout + more_, until_) - seconds(), 0.0); }

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
    portfolio.techniques = options_.prover.techniques;
    portfolio.check = options_.prover.evidence;
    portfolio.cancel = &cancel;
    portfolio.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                                            std::min(left(), each * static_cast<double>(system.questions.size()))));
    return answerQuestions(withWrittenReals(system, reals_), portfolio);
  }

  ProductOptions productOptions(bool relaxed) {
    ProductOptions options;
    options.encoder = encoderOptionsOf(options_.prover, relaxed);
    options.encoder.time.hasBases = true;      // both sides have one time
    options.encoder.followsContracts = false;  // whether both are asked the same is not compared
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

  void nameApproximations(ProgramProduct& product) {
    for (const auto& [side, askedProperties] :
         {std::pair{&before_, &product.oldSide()}, {&after_, &product.newSide()}}) {
      for (std::string& text : approximationTexts(*side->program, *askedProperties)) {
        if (std::ranges::find(result_.approximations, text) == result_.approximations.end())
          result_.approximations.push_back(std::move(text));
      }
    }
  }

  void correspond(ProgramProduct& product, bool withConditions) {
    const auto remaining = [this] { return watch_.isStopped() ? 0.0 : left(); };
    correspondence_ = findCorrespondence(product, withConditions, asks(), remaining);
  }
  Ask asks() {
    return [this](const TransitionSystem& system, double each, Effort effort) { return ask(system, each, effort); };
  }

  /// Proves the equality once more, of both programs as they are written: that is what the certificates say.
  void certify(const ProgramProduct& product, ProductOptions options) {
    options.trailBefore->isFollowed = options.trailAfter->isFollowed = true;
    more_ = seconds();                // as long again
    reals_ = RealScope::Comparisons;  // the certificates say themselves what is written out
    try {
      ProgramProduct written(before_, after_, match_, options);
      EqualityProof proof(written, product.newStateNames(), correspondence_, asks(), options_.prover.timeout,
                          dependOnDevices_);
      result_.certificates = proof.certificates();
      result_.uncertified = proof.missing();
    } catch (const DecisionsDiverge&) {
      result_.uncertified.emplace_back("both programs");
    } catch (const EncodingStopped&) {
      result_.uncertified.emplace_back("both programs");
    }
  }

  double searchTime() const { return std::min(searchSeconds, left() * shortShare); }

  /// Runs of the engine before anything is encoded: most changes show at once.
  std::optional<EquivalenceRun> exploreEarly() {
    if (options_.oneScan || options_.everyOutput || options_.prover.bound > 0) return std::nullopt;
    return explored(namedOutputs(*before_.program, *after_.program, options_), true,
                    std::min(earlySeconds, left() * earlyShare));
  }
  std::optional<EquivalenceRun> explored(std::vector<ObservedBit> observed, bool comparesStops, double most) {
    std::atomic<bool> cancel{false};
    const ProofWatch::Guard guard(watch_, cancel);
    const BothRuns runs{*before_.program, *after_.program, options_, std::move(observed), comparesStops};
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(most));
    return exploredRun(before_, after_, runs, end, cancel);
  }
  /// A run that differs, or a shorter one if there is one.
  void shorten(EquivalenceRun early) {
    method_ = "runs of both programs";
    until_ = seconds() + searchSeconds;
    // Its immediate reads find 0 whatever the input is.
    const BothRuns runs{*before_.program, *after_.program, options_,
                        namedOutputs(*before_.program, *after_.program, options_), true};
    isExplored_ = runs.judged(stimulusOnly(*before_.program, *after_.program, early)).has_value();
    if (early.scan > 1) {
      try {
        ProgramProduct product(before_, after_, match_, productOptions(false));
        nameApproximations(product);
        const JoinedSystem both = product.merged(std::vector<bool>(product.newStateCount(), false), false);
        listOutputs(both.observed);
        std::vector<std::size_t> all(result_.outputs.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        const auto most = static_cast<int>(std::min<std::uint64_t>(early.scan - 1, shallowScans));
        if (searchShort(product, both, outputQuestions(both), all, most)) method_ = "both programs side by side";
      } catch (const EncodingStopped&) {
        result_.outputs.clear();
      }
    }
    until_ = 1e9;
    if (result_.outputs.empty()) listOutputs(namedOutputs(*before_.program, *after_.program, options_));
    if (!result_.run) take(early);
    conclude({});
  }

  void listOutputs(const std::vector<ObservedBit>& observed) {
    for (const ObservedBit& bit : observed)
      result_.outputs.push_back({bit.name, Equality::Unknown, bit.before, bit.after, bit.pulses});
    result_.outputs.push_back({"RUN", Equality::Unknown, {}, {}, {}});
  }

  void compareOutputs(ProgramProduct& product) {
    const JoinedSystem once = product.merged(correspondence_.isMerged, true, correspondence_.conditions);
    std::vector<Question> questions = outputQuestions(once);
    listOutputs(once.observed);
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
    std::vector<QuestionAnswer> answers, rest;
    try {
      answers = ask(asked, each, effort);
    } catch (const std::exception&) {
      const auto askOne = [&](const TransitionSystem& one) { return ask(one, each, effort)[0]; };
      answers = askedApart(asked, askOne, [&](std::size_t i, const std::exception& error) {
        note(fmt::format("{}: {}", result_.outputs[open[i]].name, defectText(error)));
      });
    }
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

  /// What is decided stays; the rest is open.
  void breakOff(const std::exception& error) {
    note(defectText(error));
    if (result_.run) return conclude({});
    result_.equality = Equality::Unknown;
    for (ObservedVerdict& output : result_.outputs) output.equality = Equality::Unknown;
  }

  /// Both programs with memory of their own: runs that differ first, short ones and those that wait for timers, then
  /// proofs.
  void sideBySide(ProgramProduct& product, std::vector<std::size_t>& open) {
    JoinedSystem both = product.merged(correspondence_.isMerged, false, correspondence_.conditions);
    std::vector<Question> questions = outputQuestions(both);
    method_ = "both programs side by side";
    while (searchShort(product, both, questions, open, shallowScans) || explore(both, open, earlySeconds) ||
           searchLong(open)) {
      if (!goesOn(open)) return;
    }
    bool isAskedAgain = false;
    for (const double each : {std::min(2.0, left()), left()}) {
      if (open.empty() || left() <= 0 || watch_.isStopped()) return;
      while (isAskedAgain && explore(both, open, exploringSeconds)) {
        if (!goesOn(open)) return;
      }
      if (isAskedAgain && hasDropped(product)) {
        correspond(product, true);
        both = product.merged(correspondence_.isMerged, false, correspondence_.conditions);
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
        if (isViolated && isLast) unconfirmed(result_.outputs[open[i]].name, answers[i]);
        depth_ = std::min(depth_, answers[i].depth);
      }
      if (!goesOn(open)) return;
      if (needsReals) reals_ = RealScope::All;
    }
  }

  bool hasDropped(const ProgramProduct& product) const {
    for (std::size_t i = 0; i < correspondence_.isMerged.size(); ++i) {
      if (!correspondence_.isMerged[i] && product.isMergeable(i)) return true;
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
                   const std::vector<std::size_t>& open, int most) {
    TransitionSystem asked = both.system;
    asked.questions = {{"the outputs differ", anyOf(*asked.graph, questions, open)}};
    exclude(asked, both.usesEstimates);
    const auto trace = shallowSearch(asked, most, searchTime());
    return trace && show(product, both, asked, *trace, open);
  }

  bool explore(const JoinedSystem& both, const std::vector<std::size_t>& open, double most) {
    if (options_.prover.bound > 0) return false;
    const auto run =
        explored(observedOf(both, open), comparesStops(both, open), std::min(most, left() * exploringShare));
    if (run) take(*run);
    return run.has_value();
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
    TimeModel& time = relaxed.oldSide().encoding().time();
    accelerate(asked, time.dt(), time.width(), options_.prover.time,
               [&](Node n) { return std::ranges::find(both.timeStates, n) != both.timeStates.end(); });
    const auto trace = shallowSearch(asked, longScans, searchTime());
    return trace && show(relaxed, both, asked, *trace, open);
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
    const BothRuns runs{*before_.program, *after_.program, options_, observedOf(merged, open),
                        comparesStops(merged, open)};
    const auto shown = runs.judged(std::move(run));
    if (!shown) return false;
    auto repeated = runs.judged(stimulusOnly(*before_.program, *after_.program, *shown));
    if (!repeated && isExplored_) return false;  // a run that anyone can repeat is better than a shorter one
    if (!repeated) repeated = runs.judged(without(*shown, isUndefinedRead));
    if (repeated)
      take(runs.plain(*repeated));
    else
      noteUndefined(*shown);
    return repeated.has_value();
  }

  void noteUndefined(const EquivalenceRun& run) {
    undefined_[run.signal].merge(undefinedReads(*before_.program, *after_.program, run));
  }
  /// A run on which an output differs; the first one is shown.
  void take(const EquivalenceRun& run) {
    for (ObservedVerdict& output : result_.outputs) {
      if (output.name == run.signal) output.equality = Equality::Different;
    }
    if (!result_.run) result_.run = run;
  }

  /// A run that the engine does not repeat: it rests on what is not modelled, or the tool is wrong.
  void unconfirmed(const std::string& name, const QuestionAnswer& answer) {
    if (const auto found = undefined_.find(name); found != undefined_.end()) {
      note(fmt::format("{} differs only where the programs find different undefined values: {}", name,
                       fmt::join(found->second, ", ")));
      return;
    }
    const std::vector<std::string>& reasons = result_.approximations;
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
    if (result_.notes.empty())
      note("runs of the engine, bounded search, k-induction and IC3 found neither a run nor a proof");
  }

  static bool isEqual(const ObservedVerdict& output) { return output.equality == Equality::Equal; }

  /// What was not read or not followed to its end leaves equality open.
  void guardCoverage(ProgramProduct& product) {
    dependOnDevices_ = guardRequests(product);
    const std::size_t before = result_.notes.size();
    guardSide(before_, product.oldSide());
    guardSide(after_, product.newSide());
    guardRuns(product);
    if (usesPulses(*before_.program, *after_.program) && (comparesPulseOutputs() || dependOnDevices_) &&
        !product.pulsesCorrespond(correspondence_.isMerged))
      note(
          "what PLS makes of its outputs may differ in a way that is not compared: by profiles, or by constant "
          "levels");
    for (const ExternalSite& site : product.sharedUndefinedReads()) {
      const std::string text =
          "undefined values that both programs read alike are the same: " + undefinedText(*before_.program, site);
      if (std::ranges::find(result_.assumptions, text) == result_.assumptions.end())
        result_.assumptions.push_back(text);
    }
    const LongScans loops = longScansOf(*before_.program, *after_.program, match_);
    for (const std::string& text : loops.ofOne) note(text);
    if (loops.areInBoth)
      result_.assumptions.push_back("the loops that may outlast the watchdog, alike in both programs, do not");
    if (result_.notes.size() == before) return;
    for (ObservedVerdict& output : result_.outputs) {
      if (isEqual(output)) output.equality = Equality::Unknown;
    }
    if (result_.equality == Equality::Equal) result_.equality = Equality::Unknown;
  }
  /// Devices are taken to do the same in both programs, which holds as long as both ask the same of them. Whether some
  /// output that is equal depends on what they do.
  bool guardRequests(ProgramProduct& product) {
    const JoinedSystem both = product.merged(correspondence_.isMerged, false, correspondence_.conditions);
    const std::vector<bool> depends = product.dependsOnDevices(both);
    bool isConcerned = false;
    for (std::size_t i = 0; i < depends.size(); ++i)
      isConcerned = isConcerned || (depends[i] && isEqual(result_.outputs[i]));
    if (!isConcerned) return false;
    bool isSettled = true;
    if (!both.requests.empty()) {
      TransitionSystem system = both.system;
      for (const RequestDifference& request : both.requests)
        system.questions.push_back({"devices are asked for different things", request.differs});
      const double each = left() / static_cast<double>(both.requests.size());
      const std::vector<QuestionAnswer> answers = ask(system, each, Effort::Full);
      for (std::size_t i = 0; i < answers.size(); ++i) {
        if (answers[i].answer == Answer::Proved) continue;
        isSettled = false;
        note(requestText(both.requests[i], *before_.program, *after_.program));
      }
    }
    for (std::size_t i = 0; !isSettled && i < depends.size(); ++i) {
      if (depends[i] && isEqual(result_.outputs[i])) result_.outputs[i].equality = Equality::Unknown;
    }
    if (!isSettled && result_.equality == Equality::Equal) result_.equality = Equality::Unknown;
    return true;
  }
  bool comparesPulseOutputs() const {
    constexpr std::uint32_t pulseOutputs = 2;
    return options_.observed.empty() || std::ranges::any_of(result_.outputs, [](const ObservedVerdict& output) {
             return output.before && output.before->area == Area::Q && output.before->index < pulseOutputs;
           });
  }
  /// Assumptions that no run meets show nothing.
  void guardRuns(ProgramProduct& product) {
    const auto isAssumption = [](const Property& property) { return !property.isGoal(); };
    const bool hasAny = !options_.assumptions.empty() || std::ranges::any_of(before_.set.properties, isAssumption) ||
                        std::ranges::any_of(after_.set.properties, isAssumption);
    if (!hasAny) return;
    TransitionSystem some = product.merged(correspondence_.isMerged, false, correspondence_.conditions).system;
    some.questions = {{"a run that meets the assumptions", some.graph->constant(true).node}};
    if (shallowSearch(some, 1, std::min(searchSeconds, left()))) return;
    const Answer answer = ask(some, left(), Effort::Full)[0].answer;
    if (answer == Answer::Proved) note("the assumptions contradict each other: no run meets them");
    if (answer == Answer::Unknown) note("no run was found that meets the assumptions");
  }
  /// Nothing is decided about an output that unread code may decide, nor beside a block that one program hides.
  void guardUnread() {
    bool isOpen = false;
    const std::vector<std::string> hidden = hiddenInOneOnly(*before_.program, *after_.program);
    for (const std::string& reason : hidden) note(reason);
    for (ObservedVerdict& output : result_.outputs) {
      if (hidden.empty()) break;
      output.equality = Equality::Unknown;
      isOpen = true;
    }
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
  void guardSide(const Side& side, AskedProperties& askedProperties) {
    EncodedScan& encoding = askedProperties.encoding();
    if (const auto reason = unfollowedRoutine(*side.program, encoding)) note(*reason);
    Graph& graph = encoding.graph();
    Graph::Bool leftOut = graph.constant(false);
    for (const Approximation& approximation : askedProperties.approximations()) {
      if (approximation.leftOut != noNode) leftOut = graph.lor(leftOut, {approximation.leftOut});
    }
    if (graph.truth(leftOut) == false) return;
    TransitionSystem system = askedProperties.system();
    system.questions = {{"a scan is not followed to its end", leftOut.node}};
    if (ask(system, left(), Effort::Full)[0].answer == Answer::Proved) return;
    for (const Approximation& approximation : askedProperties.approximations()) {
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
  double more_ = 0;                           ///< seconds beside the time that was given
  double until_ = 1e9;                        ///< seconds since the start, while that is less
  RealScope reals_ = RealScope::Comparisons;  ///< REAL operations that are asked about bit by bit
  Correspondence correspondence_;
  bool isExplored_ = false;  ///< a run of the engine is there already
  const char* method_ = "";
  std::map<std::string, std::set<std::string>> undefined_;  ///< by output: reads without which it does not differ
  bool dependOnDevices_ = false;                            ///< outputs that are equal
  int depth_ = unlimited;
  Equivalence result_;
};

}  // namespace

Equivalence compareBehaviour(const Side& before, const Side& after, const EquivalenceOptions& options) {
  return ProgramComparison(before, after, options).run();
}

}  // namespace rungproof
