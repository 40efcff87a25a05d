// From cheap to costly: simulation, induction and runs of the engine for all questions; then each on its own.
#include "analysis/proof/question_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <random>
#include <thread>

#include "analysis/asking/asked_goals.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/unread/cone_of_influence.hpp"
#include "analysis/witness/guided_runs.hpp"
#include "analysis/witness/question_witness.hpp"
#include "analysis/witness/witness_minimal.hpp"
#include "engine/simulator.hpp"

namespace rungproof {

namespace {

/// Whether a run with all inputs off comes to the end of its first scan.
bool endsAPlainScan(const Program& program, const Choices& choices) {
  SimulatorOptions options;
  options.choices = choices;
  options.engine = EngineKind::Reference;
  Simulator simulator(program, options);
  simulator.scan();
  return simulator.isRunning();
}

}  // namespace

QuestionSearch::QuestionSearch(const Program& program, const PropertySet& set, const ProverOptions& options)
    : program_(program),
      set_(set),
      options_(options),
      goals_(askedGoals(set, !endsAPlainScan(program, options.choices))),
      watch_(options.cancel, options.memory) {
  for (const Property& property : set.properties) {
    if (property.isGoal())
      ++declared_;
    else
      assumptions_.push_back(property);
  }
  if (options.usesCone && !options.checks.any()) isLeftOut_ = outsideConeOfGoals();
}

std::vector<bool> QuestionSearch::outsideConeOfGoals() const {
  std::vector<PlaceRow> asked;
  for (const std::vector<Property>* properties : {&goals_, &assumptions_}) {
    for (const Property& property : *properties) {
      for (const Operand* o : addressesOf(property)) asked.push_back(rowOf(*o));
    }
  }
  return outsideCone(Facts(program_, set_.externals), asked);
}

/// The engine's own runs while the program is being encoded, if that takes long.
class QuestionSearch::EarlyRuns {
 public:
  EarlyRuns(QuestionSearch& search, Clock::time_point deadline)
      : search_(search), thread_([this, deadline] {
          for (int i = 0; i < schedule::earlyPatience && !isEnded_; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          try {
            if (!isEnded_) explore(deadline);
          } catch (const std::exception&) {  // a broken CHECK has said so; each question is asked by itself later
          }
        }) {}
  ~EarlyRuns() {
    isEnded_ = true;
    thread_.join();
  }
  EarlyRuns(const EarlyRuns&) = delete;
  EarlyRuns& operator=(const EarlyRuns&) = delete;

 private:
  void explore(Clock::time_point deadline) {
    const ProofWatch::Guard guard(search_.watch_, isEnded_);
    std::vector<std::size_t> all(search_.goals_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const ProverOptions& options = search_.options_;
    Exploration runs(search_.program_, runSpaceOf(search_.program_, search_.set_, options.choices, options.time),
                     search_.assumptions_, search_.goals_, all, options.seed);
    TechniqueTurn turn(&search_.log_, Technique::EarlyRuns, all.size());
    runs.search(deadline, isEnded_);
    for (const std::size_t goal : all) {
      if (runs.found(goal)) search_.early_.emplace(goal, *runs.found(goal));
    }
    turn.settled(search_.early_.size());
  }

  QuestionSearch& search_;
  std::atomic<bool> isEnded_ = false;
  std::thread thread_;
};

void QuestionSearch::encode(Clock::time_point deadline) {
  deadline_ = deadline;
  std::optional<EarlyRuns> runs;
  if (options_.bound == 0 && !goals_.empty() && options_.techniques.has(Technique::EarlyRuns))
    runs.emplace(*this, deadline);
  EncoderOptions options = encoding(false);
  if (options_.evidence) options.trail = trail_ = options_.planted ? options_.planted : std::make_shared<Trail>();
  exact_ = std::make_unique<QuestionSystem>(program_, set_, goals_, options, options_.checks);
}

/// Nothing if there was no time for it, or it cannot be made.
AsWritten* QuestionSearch::asWritten() {
  if (asWritten_ || !trail_) return asWritten_.get();
  const std::shared_ptr<Trail> trail = std::exchange(trail_, nullptr);
  trail->isFollowed = true;
  EncoderOptions options = encoding(false);
  options.trail = trail;
  try {
    asWritten_ = std::make_unique<AsWritten>(
        *exact_, std::make_unique<QuestionSystem>(program_, set_, goals_, options, options_.checks));
  } catch (const EncodingStopped&) {
    return nullptr;
  } catch (const DecisionsDiverge&) {
    return nullptr;
  }
  return asWritten_.get();
}

/// Against the program as it is written. What simplification knew of REAL operations is shown by writing them out.
std::vector<CheckResult> QuestionSearch::judge(const std::vector<Claim>& claims, const CheckLimits& limits) {
  std::vector<CheckResult> results(claims.size(), CheckResult::Unknown);
  AsWritten* side = asWritten();
  if (side == nullptr) return results;
  const auto check = [&](const std::vector<std::size_t>& which, bool areRealsWritten) {
    std::vector<std::size_t> judged;
    std::optional<CertificateWriter> writer;
    for (const std::size_t i : which) {
      const std::size_t question = claims[i].question->number;
      const std::optional<WordCertificate> certificate =
          side->translated(question, areRealsWritten, *claims[i].certificate, AsWritten::Purpose::Check);
      if (!certificate) continue;
      if (!writer) writer.emplace(side->system(question, areRealsWritten));
      writer->add(side->question(question, areRealsWritten), *certificate);
      judged.push_back(i);
    }
    if (!writer) return;
    const std::vector<CheckResult> found = writer->check(limits);
    for (std::size_t i = 0; i < judged.size(); ++i) results[judged[i]] = found[i];
  };
  std::vector<std::size_t> plain;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (!written_.contains(claims[i].question->number)) plain.push_back(i);
  }
  check(plain, false);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const std::size_t question = claims[i].question->number;
    const bool isWritten = written_.contains(question);
    if (results[i] == CheckResult::Valid || !(isWritten || restsOnReals(question))) continue;
    check({i}, true);
    if (results[i] == CheckResult::Valid && !isWritten) certifiedWithReals_.insert(question);
  }
  return results;
}

QuestionSearch::WrongDecisions QuestionSearch::wrongDecisions() {
  AsWritten* side = options_.evidence ? asWritten() : nullptr;
  if (side == nullptr) return {};
  // What was found before an interruption is worth a short look.
  const bool isStopped = watch_.isStopped();
  std::atomic<bool> cancel{false};
  const ProofWatch::Guard guard(watch_, cancel);
  CheckLimits limits;
  limits.each = schedule::toldSeconds;
  limits.total = isStopped ? schedule::leastCheck : 3 * schedule::toldSeconds;
  limits.memory = options_.memory;
  limits.cancel = isStopped ? nullptr : &cancel;
  const CheckResult result = side->told().check(limits);
  if (result == CheckResult::Valid) return {};
  return side->told().isRefuted()
             ? WrongDecisions{true, fmt::format("the check of what the encoding relies on fails for {}: a defect of "
                                                "rungproof",
                                                side->told().reason())}
             : WrongDecisions{false, fmt::format("what the encoding was told is not shown by the certificate: {}",
                                                 side->told().reason())};
}

/// Of the engine for one goal, when solvers have found a run that it does not repeat.
class QuestionSearch::OwnRuns {
 public:
  OwnRuns(QuestionSearch& search, std::size_t goal) : search_(search), goal_(goal) {}
  /// Goes on where it stopped, for that share of the time of a question.
  std::optional<Witness> search(QuestionAnswer& answer, double share);

 private:
  QuestionSearch& search_;
  const std::size_t goal_;
  std::unique_ptr<Exploration> exploration_;
};

QuestionSearch::Found QuestionSearch::answer(std::size_t question, const Time& time) {
  deadline_ = time.deadline;
  processor_ = time.processor;
  isOfMany_ = time.isOfMany;
  QuestionAnswer answer = quick_[question];
  std::optional<Witness> witness;
  if (const auto found = found_.find(question); found != found_.end())
    witness = found->second;
  else if (answer.answer == Answer::Violated && !unconfirmed_.contains(question))
    witness = confirmed(question, *answer.trace);
  watch_.release();
  const auto isUnconfirmed = [&] { return !witness && answer.answer == Answer::Violated; };
  OwnRuns own(*this, question);
  if (isUnconfirmed() && !restsOnReals(question)) witness = own.search(answer, schedule::ownRunsShare);
  const bool isTried = isUnconfirmed() && searchWithoutEstimates(question, answer, witness);
  const bool isOpen = !witness && answer.answer != Answer::Proved;
  if (isOpen && !isTried && mayGoOn()) {
    std::tie(answer, witness) = search(question, answer.answer);
    if (isUnconfirmed()) searchWithoutEstimates(question, answer, witness);
  }
  if (isUnconfirmed()) witness = own.search(answer, schedule::lastOwnRunsShare);
  // A run that shows what is wanted is a verdict; how long it is and what matters in it is for people.
  const bool isForPeople = options_.evidence && witness && question < goals_.size() && !watch_.isStopped() &&
                           (options_.explains || goals_[question].kind != PropertyKind::Reach);
  if (!isForPeople) return {std::move(answer), std::move(witness)};
  const Judge judge(program_, options_.choices, assumptions_, goals_[question]);
  const double seconds = std::clamp(left(), schedule::leastMinimising, schedule::minimiseSeconds);
  if (witness->scanCount <= schedule::minimisedScans) {
    const std::uint32_t plainMs =
        std::clamp<std::uint32_t>(ReplayScan{}.lengthMs, options_.time.low, options_.time.high);
    witness = minimised(judge, std::move(*witness), plainMs, seconds, options_.seed);
  } else if (std::ranges::any_of(witness->scans, [](const ReplayScan& s) { return !s.script.events.empty(); })) {
    witness = withoutIdleEvents(judge, std::move(*witness), seconds);
  }
  return {std::move(answer), std::move(witness)};
}

/// A run that rests on what is not modelled exactly ends no search: the engine's own runs count, whatever is modelled.
std::optional<Witness> QuestionSearch::OwnRuns::search(QuestionAnswer& answer, double share) {
  if (goal_ >= search_.goals_.size() || search_.options_.bound > 0 || !search_.mayGoOn()) return std::nullopt;
  const auto shown = [&](Witness witness, const char* method) {
    answer.method = method;
    return std::optional(std::move(witness));
  };
  if (const auto early = search_.early_.find(goal_); early != search_.early_.end())
    return shown(early->second, "exploration");
  const EncodedScan& encoding = search_.exact_->askedProperties().encoding();
  const double seconds = std::min(search_.left(), search_.options_.timeout * share);
  if (!exploration_) {
    const std::vector<Property>& goals = search_.goals_;
    if (search_.options_.techniques.has(Technique::EngineRuns)) {
      TechniqueTurn turn(&search_.log_, Technique::EngineRuns, 1);
      auto found = guidedRuns(search_.program_, encoding, search_.assumptions_, {&goals[goal_]}, search_.options_.seed,
                              {std::min(seconds, schedule::engineSeconds)});
      if (found[0]) turn.settled();
      if (found[0]) return shown(found[0]->witness(), "engine runs");
    }
    if (!search_.options_.techniques.has(Technique::Exploration)) return std::nullopt;
    exploration_ = std::make_unique<Exploration>(search_.program_, runSpaceOf(encoding), search_.assumptions_, goals,
                                                 std::vector{goal_}, search_.options_.seed);
  }
  TechniqueTurn turn(&search_.log_, Technique::Exploration, 1);
  std::atomic<bool> cancel{false};
  const ProofWatch::Guard guard(search_.watch_, cancel);
  exploration_->search(std::min(search_.deadline_, Clock::now() + inSeconds(seconds)), cancel, goal_);
  const std::optional<Witness>& found = exploration_->found(goal_);
  if (!found) return std::nullopt;
  turn.settled();
  return shown(*found, "exploration");
}

Answer QuestionSearch::supporting(std::size_t goal, double seconds) {
  const Answer known = quick_[goal].answer;
  const bool isOpen =
      known == Answer::Unknown || (known == Answer::Violated && !found_.contains(goal) && restsOnReals(goal));
  if (!isOpen || !mayGoOn()) return known;
  const Clock::time_point whole = std::exchange(deadline_, std::min(deadline_, Clock::now() + inSeconds(seconds)));
  const auto [found, witness] = search(goal, known);
  deadline_ = whole;
  return witness ? Answer::Violated : found.answer;
}

bool QuestionSearch::mayLeaveOut(double seconds) {
  const std::optional<std::size_t> question = exact_->leftOutQuestion();
  if (!question) return false;
  QuestionAnswer& answer = quick_[*question];
  if (answer.answer == Answer::Unknown && mayGoOn())
    answer = ask(exact_->only(*question), std::min(left(), seconds), deadline_)[0];
  return answer.answer != Answer::Proved;
}

std::string QuestionSearch::certificate(std::size_t question, const QuestionAnswer& answer) {
  const bool isWritten = written_.contains(question), hasReals = isWritten || certifiedWithReals_.contains(question);
  const auto leftOut = std::ranges::count(isLeftOut_, true);
  const std::string cone =
      leftOut == 0
          ? ""
          : fmt::format("; without {} instructions of networks that have no effect on the property\n", leftOut);
  if (AsWritten* side = answer.isJudged ? asWritten() : nullptr; side != nullptr) {
    if (side->isDecidedByForm(question)) return {};
    const std::optional<WordCertificate> certificate =
        side->translated(question, hasReals, *answer.certificate, AsWritten::Purpose::Text);
    if (certificate) {
      const std::string own =
          certificateText(side->system(question, hasReals), side->question(question, hasReals), *certificate);
      const std::string notShown = wrongDecisions().text;
      if (!notShown.empty()) return cone + "; " + notShown + '\n' + own;
      const std::string told = side->told().text();
      return cone + (told.empty() ? own : told + "(reset)\n" + own);
    }
  }
  const std::string remark = cone + "; about the program after simplification, which is not checked here\n";
  if (isWritten) {
    const TransitionSystem& system = written_.at(question);
    return remark + certificateText(system, system.questions[0], *answer.certificate);
  }
  return remark + certificateText(exact_->system(), exact_->system().questions[question], *answer.certificate);
}

PortfolioOptions QuestionSearch::portfolio(double each, Clock::time_point deadline, const std::atomic<bool>* cancel) {
  PortfolioOptions options;
  options.seconds = std::min(each, processor_);
  options.jobs = isOfMany_ ? 1 : options_.jobs;
  options.seed = options_.seed;
  options.bound = options_.bound;
  options.cancel = cancel;
  options.deadline = deadline;
  options.memory = options_.memory;
  options.techniques = options_.techniques;
  if (isOfMany_) {  // what these find was looked for with all questions together
    for (const Technique technique : {Technique::Bounds, Technique::EqualGates}) options.techniques.leaveOut(technique);
  }
  if (options_.checks.lint) options.ofMany = goals_.size();
  options.log = &log_;
  options.check = options_.evidence;
  if (options_.evidence)
    options.judge = [this](const std::vector<Claim>& claims, const CheckLimits& limits) {
      return judge(claims, limits);
    };
  return options;
}

EncoderOptions QuestionSearch::encoding(bool relaxed) const {
  EncoderOptions options = encoderOptionsOf(options_, relaxed);
  options.isLeftOut = isLeftOut_;
  options.interruption = [this] {
    if (watch_.isStopped() || Clock::now() >= deadline_) throw EncodingStopped{};
  };
  return options;
}

/// Whether REAL operations decide the question that can be written out: engines take them as any value at first.
bool QuestionSearch::restsOnReals(std::size_t question) const {
  const std::size_t count = exact_->exactReals(question);
  return count > 0 && count <= (question < goals_.size() ? schedule::writtenReals : schedule::writtenForChecks);
}

std::vector<QuestionAnswer> QuestionSearch::ask(const TransitionSystem& system, double each,
                                                Clock::time_point deadline) {
  std::atomic<bool> cancel{false};
  const ProofWatch::Guard guard(watch_, cancel);
  return answerQuestions(system, portfolio(each, deadline, &cancel));
}

/// REAL operations take any value at first, which is enough for many proofs; where it is not, they are written out.
QuestionSearch::Found QuestionSearch::search(std::size_t question, Answer known) {
  if (!restsOnReals(question) || !options_.techniques.has(Technique::ExactReals)) return race(question);
  if (known == Answer::Unknown) {
    const Clock::time_point whole =
        std::exchange(deadline_, Clock::now() + inSeconds(left() * schedule::freeRealShare));
    Found found = race(question);
    deadline_ = whole;
    if (found.second || found.first.answer == Answer::Proved || !mayGoOn()) return found;
  }
  TechniqueTurn turn(&log_, Technique::ExactReals, 1);
  written_.emplace(question, withExactReals(exact_->only(question), RealScope::All));
  Found found = race(question);
  if (found.second || found.first.answer == Answer::Proved) turn.settled();
  return found;
}

namespace {

/// Ends a search in another thread before what it uses goes.
struct Joined {
  std::thread& thread;
  std::atomic<bool>& cancel;
  ~Joined() {
    cancel = true;
    if (thread.joinable()) thread.join();
  }
};

}  // namespace

/// The exact system and the accelerated one at the same time; the first valid result ends both. Witnesses of built-in
/// checks are followed on the exact graph, which the other search extends: they wait for its end.
QuestionSearch::Found QuestionSearch::race(std::size_t question) {
  const auto written = written_.find(question);
  const bool isWritten = written != written_.end();
  const TransitionSystem exact = isWritten ? written->second : exact_->only(question);
  if (isOfMany_) {
    if (std::optional<Found> held = heldRun(question, exact)) return std::move(*held);
  }
  std::atomic<bool> cancelExact{false}, cancelFast{false};
  const ProofWatch::Guard guardExact(watch_, cancelExact), guardFast(watch_, cancelFast);
  std::optional<Witness> witness;
  std::optional<QuestionAnswer> fastAnswer;
  std::optional<TransitionSystem> accelerated;
  std::exception_ptr failure;
  std::thread fast;
  const Joined joined{fast, cancelFast};
  const bool isBounded = options_.bound > 0;  // by scans of the program, which the accelerated system does not count
  const bool mayAccelerate = !isBounded && options_.techniques.has(Technique::Accelerated);
  QuestionSystem* relaxed =
      mayAccelerate && exact_->dependsOnTime(exact_->variablesOf(question)) ? relaxedSide() : nullptr;
  if (relaxed != nullptr) {
    accelerated = relaxed->accelerated(question, options_.time);
    if (isWritten) accelerated = withExactReals(*accelerated, RealScope::All);
    const auto search = [&] {
      PortfolioOptions options = portfolio(left(), deadline_, &cancelFast);
      options.jobs = 1;
      options.check = false;
      // Only runs count here, and the time is short.
      if (isOfMany_)
        options.techniques.keepOnly(
            {Technique::Simulation, Technique::Bmc, Technique::LongSimulation, Technique::HeldInputs});
      options.log = nullptr;
      TechniqueTurn turn(&log_, Technique::Accelerated, 1);
      QuestionAnswer answer = answerQuestions(*accelerated, options)[0];
      if (answer.answer != Answer::Violated) return;
      if (question < goals_.size()) witness = replayed(*relaxed, *accelerated, question, *answer.trace);
      fastAnswer = std::move(answer);
      if (!witness && question < goals_.size()) return;
      turn.settled();
      cancelExact = true;
    };
    fast = std::thread([&, search] {
      try {
        search();
      } catch (...) {
        failure = std::current_exception();
      }
    });
  }
  std::optional<ExplorationThread> exploring;
  if (exploration_ && question < goals_.size() && !exploration_->found(question)) {
    const double pause = std::min(schedule::exploringPause, left() * schedule::exploringPauseShare);
    exploring.emplace(*exploration_, question, deadline_, pause, [&] { cancelExact = cancelFast = true; });
  }
  // For a rule the engines have raced while all were looked at, and as long as they might here.
  const bool hasRaced = isOfMany_ && !isWritten && quick_[question].answer == Answer::Unknown;
  QuestionAnswer answer = hasRaced
                              ? quick_[question]
                              : answerQuestions(exact, portfolio(std::max(left(), 0.0), deadline_, &cancelExact))[0];
  if (answer.answer != Answer::Unknown) cancelFast = true;
  if (fast.joinable()) fast.join();
  if (failure && answer.answer == Answer::Unknown) std::rethrow_exception(failure);
  const bool isExplored = exploring && exploring->end() && !witness;
  takeExplored();
  if (isExplored) witness = exploration_->found(question);
  if (exploring) log_.add(Technique::Exploration, {1, isExplored ? 1U : 0U, exploring->seconds()});
  if (fastAnswer && !witness && question >= goals_.size()) {
    witness = replayed(*relaxed, *accelerated, question, *fastAnswer->trace);
    if (!witness && !hasRaced && answer.answer == Answer::Unknown && mayGoOn())
      answer = ask(exact, left(), deadline_)[0];
  }
  if (witness) {
    answer.method = isExplored ? "exploration" : "accelerated search";
  } else if (answer.answer == Answer::Violated) {
    witness = confirmed(question, *answer.trace);
  }
  answer.depth = std::max(answer.depth, answer.answer == Answer::Unknown ? quick_[question].depth : answer.depth);
  return {std::move(answer), std::move(witness)};
}

/// Nothing if there was no time to encode it.
QuestionSystem* QuestionSearch::relaxedSide() {
  if (relaxed_) return relaxed_.get();
  try {
    relaxed_ = std::make_unique<QuestionSystem>(program_, set_, goals_, encoding(true), options_.checks);
  } catch (const EncodingStopped&) {
    return nullptr;
  }
  return relaxed_.get();
}

/// The run as the engine repeats it, if it shows the same.
std::optional<Witness> QuestionSearch::replayed(QuestionSystem& side, const TransitionSystem& system,
                                                std::size_t question, const WordTrace& trace) {
  if (question >= goals_.size()) return replayedCheck(system, question, trace);
  EncodedScan& encoding = side.askedProperties().encoding();
  std::vector<ReplayScan> scans = scansOf(encoding, system, trace, options_.time);
  return Judge(program_, options_.choices, assumptions_, goals_[question])
      .witness(std::move(scans), initialOf(encoding, system, trace));
}

/// The same for a built-in check, whose nodes the exact graph knows.
std::optional<Witness> QuestionSearch::replayedCheck(const TransitionSystem& system, std::size_t question,
                                                     const WordTrace& trace) {
  if (!replayedCone_ || replayedCone_->first != question)
    replayedCone_.emplace(question, exact_->variablesOf(question));
  const QuestionWitness asked(exact_->askedProperties().encoding(), exact_->system(),
                              exact_->system().questions[question].bad, replayedCone_->second);
  std::optional<ExactRun> run = asked.runOf(system, trace, options_.time);
  if (!run) return std::nullopt;
  const auto kept = options_.explains ? QuestionWitness::Kept::Scans : QuestionWitness::Kept::Length;
  // What is rare and takes long is repeated once for all that it shows.
  std::vector<std::size_t> open;
  std::vector<QuestionWitness::Other> others;
  if (!options_.explains && run->inputs.size() > schedule::minimisedScans)
    open = openQuestions(
        [&](std::size_t q) { return q >= goals_.size() && q != question && q != exact_->leftOutQuestion(); });
  for (const std::size_t q : open) others.push_back({exact_->system().questions[q].bad, exact_->variablesOf(q)});
  std::optional<Witness> witness = asked.witness(program_, options_.choices, *run, kept, others);
  for (std::size_t i = 0; i < open.size() && witness; ++i) {
    if (others[i].witness) show(open[i], std::move(*others[i].witness), "run of another question");
  }
  const std::size_t check = question - goals_.size();
  const bool isShownToPeople = options_.evidence && options_.explains && check < exact_->checks().size() &&
                               isAskedByProve(*exact_->checks()[check].rule);
  if (!witness || !isShownToPeople || witness->scanCount > schedule::minimisedScans || watch_.isStopped())
    return witness;
  std::vector<std::vector<bool>> matters;
  if (!asked.dropIdle(*run, matters, schedule::minimiseSeconds, options_.seed)) return witness;
  std::optional<Witness> smaller = asked.witness(program_, options_.choices, *run);
  if (smaller) smaller->matters = std::move(matters);
  return smaller ? smaller : witness;
}

/// A run of the exact system. Where the question rests on values that are not modelled exactly, what it does not
/// mention may decide whether the engine repeats the run: some values of that are tried.
std::optional<Witness> QuestionSearch::confirmed(std::size_t question, const WordTrace& trace) {
  std::optional<Witness> witness = replayed(*exact_, exact_->system(), question, trace);
  if (witness || exact_->approximationsOf(question, written_.contains(question)).empty()) return witness;
  std::unordered_set<std::uint32_t> fixed = exact_->variablesOf(question);
  for (const Node n : exact_->askedProperties().encoding().time().inputs()) fixed.insert(indexOf(n));
  std::mt19937_64 random(options_.seed);
  WordTrace tried = trace;
  for (int attempt = 0; attempt < schedule::fillings && !witness && !watch_.isStopped(); ++attempt) {
    fillOtherInputs(exact_->system(), fixed, random, tried);
    witness = replayed(*exact_, exact_->system(), question, tried);
  }
  return witness;
}

}  // namespace rungproof
