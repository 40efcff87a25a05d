// Workers take the question that has had the least time, and of its engines that are not at work the one with the
// least weighted time. Slices double. Engines that find what they find early get a share that shrinks as they go on.
#include "analysis/portfolio/race.hpp"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

struct EngineKind {
  Technique technique;
  std::string_view name;
  std::unique_ptr<Engine> (*make)(const BitSystem&, const EngineOptions&);
  double weight;                                ///< share of time relative to the others
  double patience = schedule::tirelessSeconds;  ///< s, after which that share shrinks
  double wait = 0;                              ///< s that count as used at first: who settles most begins
};
constexpr std::array engineKinds = {
    EngineKind{Technique::Explicit, "explicit search", makeExhaustive, schedule::exhaustiveWeight,
               schedule::runPatience},
    EngineKind{Technique::Ic3, "IC3", makeIc3, schedule::ic3Weight},
    EngineKind{Technique::Bmc, "BMC", makeBmc, schedule::bmcWeight, schedule::tirelessSeconds, schedule::bmcWait},
    EngineKind{Technique::LongSimulation, "simulation", makeSimulation, schedule::simulationWeight,
               schedule::runPatience, schedule::seekerWait},
    EngineKind{Technique::HeldInputs, "held inputs", makeHeldInputs, schedule::heldInputsWeight, schedule::runPatience,
               schedule::seekerWait},
    EngineKind{Technique::KInduction, "k-induction", makeKInduction, schedule::kInductionWeight, schedule::runPatience,
               schedule::seekerWait},
    EngineKind{Technique::WordIc3, "IC3 on words", nullptr, schedule::wordsWeight}};
constexpr std::size_t onWords = engineKinds.size() - 1;  ///< made by the caller

}  // namespace

class Race::Workers {
 public:
  Workers(std::vector<RaceQuestion> questions, const RaceOptions& options)
      : questions_(std::move(questions)), options_(options), contests_(questions_.size()) {}

  void run(const RaceRun& run) {
    run_ = run;
    line_.clear();
    open_ = 0;
    for (std::size_t q = 0; q < contests_.size(); ++q) begin(q);
    std::vector<std::thread> threads;
    for (int i = 1; i < options_.jobs; ++i) threads.emplace_back([this] { workOn(); });
    workOn();
    for (std::thread& thread : threads) thread.join();
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    if (options_.log == nullptr) return;
    for (const Contest& contest : contests_) {
      for (std::size_t e = 0; e < engineKinds.size(); ++e) {
        const Runner& runner = contest.runners[e];
        const double used = runner.used - runner.usedBefore;
        if (used > 0) options_.log->add(engineKinds[e].technique, {1, runner.hasWon ? 1U : 0U, used});
      }
    }
  }
  std::vector<RaceQuestion>& questions() { return questions_; }

 private:
  struct Runner {
    Engine* engine = nullptr;  ///< made when first run, unless the caller has made it
    std::unique_ptr<Engine> own;
    double used = 0;
    double usedBefore = 0;  ///< this run
    double slice = schedule::firstSlice;
    bool working = false;
    bool takesPart = true;
    bool ended = false;
    bool hasWon = false;  ///< the answer is this engine's
  };

  /// Of the engine whose turn it is.
  struct Place {
    double rank;
    std::size_t engine;
  };

  struct Contest {
    std::array<Runner, engineKinds.size()> runners;
    std::atomic<bool> cancel = false;
    double used = 0;  ///< by finished slices
    double most = 0;  ///< engine seconds, of all runs
    int workers = 0;
    bool done = false;
    std::optional<Place> place{};  ///< in the line of those that wait for a worker
  };

  void begin(std::size_t q) {
    Contest& contest = contests_[q];
    contest.cancel = false;
    contest.most = run_.seconds * std::max(options_.jobs, 1) * questions_[q].share;
    contest.runners[onWords].engine = questions_[q].words;
    for (std::size_t e = 0; e < engineKinds.size(); ++e) {
      Runner& runner = contest.runners[e];
      runner.usedBefore = runner.used;
      const Technique technique = engineKinds[e].technique;
      runner.takesPart = run_.techniques.has(technique) && questions_[q].techniques.has(technique) &&
                         (e != onWords || runner.engine != nullptr);
    }
    contest.done =
        questions_[q].verdict.answer != Answer::Unknown || contest.used >= contest.most || haveAllEnded(contest);
    contest.place.reset();
    open_ += contest.done ? 0 : 1;
    lineUp(q);
  }
  void end(Contest& contest) {
    open_ -= contest.done ? 0 : 1;
    contest.done = contest.cancel = true;
  }
  static bool haveAllEnded(const Contest& contest) {
    return std::ranges::all_of(contest.runners,
                               [](const Runner& r) { return !r.takesPart || (r.ended && !r.working); });
  }

  struct Task {
    std::size_t question, engine;
  };

  /// Questions with fewer workers and less time first, then engines with less weighted time.
  static std::optional<Place> placeOf(const Contest& contest) {
    std::optional<Place> best;
    for (std::size_t e = 0; e < engineKinds.size(); ++e) {
      const Runner& runner = contest.runners[e];
      if (runner.working || runner.ended || !runner.takesPart) continue;
      const double tired = 1 + runner.used / engineKinds[e].patience;
      const double own = (runner.used + engineKinds[e].wait) * tired / engineKinds[e].weight;
      const double rank = contest.workers * 1e6 + contest.used * 1e3 + own;
      if (!best || rank < best->rank) best = Place{rank, e};
    }
    return best;
  }

  /// To be called whenever something about the question has changed. The lock is held.
  void lineUp(std::size_t q) {
    Contest& contest = contests_[q];
    if (contest.place) line_.erase({contest.place->rank, q});
    contest.place = contest.done ? std::nullopt : placeOf(contest);
    if (contest.place) line_.emplace(contest.place->rank, q);
  }

  /// Waits for a task; false when all questions are done, or the time of all is over. The lock is held.
  bool take(std::unique_lock<std::mutex>& lock, Task& task) {
    for (;;) {
      if (Budget(run_.deadline, options_.cancel).isExhausted()) {
        for (Contest& contest : contests_) end(contest);
        return false;
      }
      if (open_ == 0) return false;
      if (!line_.empty()) {
        const std::size_t q = line_.begin()->second;
        task = {q, contests_[q].place->engine};
        return true;
      }
      changed_.wait(lock);
    }
  }

  /// Errors of ours end the race for all; who has asked gets the first of them.
  void workOn() {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      for (Contest& contest : contests_) end(contest);
      changed_.notify_all();
    }
  }

  void work() {
    std::unique_lock<std::mutex> lock(mutex_);
    Task task{};
    while (take(lock, task)) {
      Contest& contest = contests_[task.question];
      Runner& runner = contest.runners[task.engine];
      runner.working = true;
      ++contest.workers;
      lineUp(task.question);
      const double limit = std::min(runner.slice, std::max(contest.most - contest.used, schedule::leastSlice));
      lock.unlock();
      const double begin = Budget::threadSeconds();
      Verdict verdict;
      bool ended = true;
      try {
        if (runner.engine == nullptr) {
          runner.own = engineKinds[task.engine].make(*questions_[task.question].system, engineOptions(task.question));
          runner.engine = runner.own.get();
        }
        verdict = runner.engine->advance(Budget(run_.deadline, &contest.cancel, options_.cancel).slice(limit));
        ended = runner.engine->isExhausted();
      } catch (const std::exception&) {  // an engine that breaks leaves the race; a broken CHECK has said so
        verdict = {};
      }
      const double used = Budget::threadSeconds() - begin;
      lock.lock();
      runner.working = false;
      runner.ended = ended || verdict.answer != Answer::Unknown;  // an engine is not asked again after an answer
      runner.used += used;
      runner.slice = std::min(runner.slice * 2, schedule::longestSlice);
      contest.used += used;
      --contest.workers;
      record(task, verdict);
      lineUp(task.question);
      changed_.notify_all();
    }
    changed_.notify_all();
  }

  EngineOptions engineOptions(std::size_t question) const {
    EngineOptions result;
    if (options_.bound > 0) result.bound = options_.bound;
    result.seed = options_.seed + question;
    result.invariants = questions_[question].invariants;
    return result;
  }

  /// A run that is longer than the bound is no answer.
  bool isAnswer(const Verdict& verdict) const {
    return verdict.answer == Answer::Proved ||
           (verdict.answer == Answer::Violated && (options_.bound == 0 || verdict.depth < options_.bound));
  }

  void record(const Task& task, const Verdict& verdict) {
    Contest& contest = contests_[task.question];
    Verdict& known = questions_[task.question].verdict;
    questions_[task.question].seconds = contest.used;
    if (isAnswer(verdict)) {
      CHECK(known.answer == Answer::Unknown || known.answer == verdict.answer, "two engines disagree about a question");
      const bool better =
          known.answer == Answer::Unknown || (verdict.answer == Answer::Violated && verdict.depth < known.depth);
      if (better) {
        known = verdict;
        for (Runner& runner : contest.runners) runner.hasWon = &runner == &contest.runners[task.engine];
      }
      end(contest);
      return;
    }
    if (known.answer == Answer::Unknown && verdict.answer == Answer::Unknown)
      known.depth = std::max(known.depth, verdict.depth);
    const bool atBound = options_.bound > 0 && known.depth >= options_.bound;
    const bool stopped = Budget(run_.deadline, options_.cancel).isExhausted();
    if (contest.used >= contest.most || haveAllEnded(contest) || stopped || atBound) end(contest);
  }

  std::vector<RaceQuestion> questions_;
  const RaceOptions options_;
  std::deque<Contest> contests_;
  std::set<std::pair<double, std::size_t>> line_;  ///< rank and question: whose turn it is stands first
  std::size_t open_ = 0;                           ///< questions that are not done
  RaceRun run_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::exception_ptr failure_;
};

std::string enginesOf(const Techniques& techniques) {
  constexpr std::array order = {
      Technique::Bmc,        Technique::KInduction, Technique::Ic3,    Technique::LongSimulation,
      Technique::HeldInputs, Technique::Explicit,   Technique::WordIc3};
  std::string names;
  for (const Technique technique : order) {
    if (!techniques.has(technique)) continue;
    names += names.empty() ? "" : ", ";
    names += std::ranges::find(engineKinds, technique, &EngineKind::technique)->name;
  }
  return names;
}

Race::Race(std::vector<RaceQuestion> questions, const RaceOptions& options)
    : workers_(std::make_unique<Workers>(std::move(questions), options)) {}
Race::~Race() = default;

void Race::run(const RaceRun& run) { workers_->run(run); }
std::vector<RaceQuestion>& Race::questions() { return workers_->questions(); }

}  // namespace rungproof
