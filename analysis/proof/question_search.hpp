// QuestionSearch: finds an answer for every question of a proof run, declared or built in: first all together, quickly;
// then one by one, with two searches side by side - the engines on the exact system, and a search for witnesses on the
// accelerated one, in which time passes in long scans. A run counts once the engine has repeated it.
// Covered by tests/prover and tests/corpus.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "analysis/portfolio/portfolio.hpp"
#include "analysis/proof/as_written.hpp"
#include "analysis/proof/proof_watch.hpp"
#include "analysis/proof/prover.hpp"
#include "analysis/proof/question_system.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/witness/exploration.hpp"

namespace rungproof {

inline std::chrono::steady_clock::duration inSeconds(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
}

inline double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class QuestionSearch {
 public:
  using Clock = std::chrono::steady_clock;
  /// An answer, and the run that shows it if it is Violated and the engine repeats it.
  using Found = std::pair<QuestionAnswer, std::optional<Witness>>;
  /// What a question may take.
  struct Time {
    Clock::time_point deadline;
    double processor;       ///< s of the processor for each search
    bool isOfMany = false;  ///< one of hundreds that a rule asks: one core, and no bounds a second time
  };

  QuestionSearch(const Program& program, const PropertySet& set, const ProverOptions& options);

  /// Encodes the program; throws EncodingStopped if that takes longer than `deadline`, or if the run is stopped. Where
  /// it takes long the engine makes runs of its own meanwhile.
  void encode(Clock::time_point deadline);
  /// What those runs have shown, by goal.
  const std::map<std::size_t, Witness>& early() const { return early_; }
  /// The encoded program. Questions are the goals, then the built-in checks (question_system.hpp).
  QuestionSystem& exact() { return *exact_; }
  /// What is asked about declared properties: they themselves, their premises, whether any run meets the assumptions.
  const std::vector<Property>& goals() const { return goals_; }
  const std::vector<Property>& assumptions() const { return assumptions_; }
  /// By Instruction::id: what is not encoded, since it has no effect on any question. May be empty.
  const std::vector<bool>& leftOut() const { return isLeftOut_; }

  /// Looks at all questions together: what takes milliseconds; then short runs in which time passes in long scans, so
  /// that what a timer brings about costs the same whatever its preset; then half a second for what is left.
  void answerQuickly(Clock::time_point deadline);
  /// What answerQuickly() has found.
  const QuestionAnswer& quick(std::size_t question) const { return quick_[question]; }
  /// Whether that is an answer without further work: a proof, or a run that the engine has made.
  bool isSettled(std::size_t question) const {
    return quick_[question].answer == Answer::Proved || found_.contains(question);
  }
  /// The answer to a question, searched for if it is still open.
  Found answer(std::size_t question, const Time& time);
  /// The same for a goal that another verdict rests on, in the time that is left for that one.
  Answer supporting(std::size_t goal, double seconds);
  /// Whether a scan can occur that the encoding does not follow to its end.
  bool mayLeaveOut(double seconds);

  /// Whether the answer rests on the question's system with REAL operations written out.
  bool isWrittenOut(std::size_t question) const { return written_.contains(question); }
  /// The certificate of a proved question as SMT-LIB 2, about the program as it is written if `answer` was judged so;
  /// empty if the form of the program decides the question, so that there is nothing to be solved.
  std::string certificate(std::size_t question, const QuestionAnswer& answer);

  /// What of the decisions that led the encoding does not hold, in which case nothing that was proved counts, or was
  /// not shown; empty if all do, or if there is no such encoding.
  struct WrongDecisions {
    bool areRefuted = false;
    std::string text{};
  };
  WrongDecisions wrongDecisions();

  /// Whether the question at hand may take more time.
  bool mayGoOn() const { return left() > 0 && !watch_.isStopped(); }
  /// Seconds that are left for the question at hand.
  double left() const { return std::chrono::duration<double>(deadline_ - Clock::now()).count(); }
  const ProofWatch& watch() const { return watch_; }
  TechniqueUses techniques() const { return log_.uses(); }

 private:
  class EarlyRuns;
  class OwnRuns;
  EncoderOptions encoding(bool relaxed) const;
  std::vector<bool> outsideConeOfGoals() const;
  PortfolioOptions portfolio(double each, Clock::time_point deadline, const std::atomic<bool>* cancel);
  std::vector<CheckResult> judge(const std::vector<Claim>& claims, const CheckLimits& limits);
  AsWritten* asWritten();
  std::vector<QuestionAnswer> ask(const TransitionSystem& system, double each, Clock::time_point deadline);
  bool restsOnReals(std::size_t question) const;
  bool isDeclared(std::size_t question) const { return question < declared_; }

  template <class Wanted>
  std::vector<std::size_t> openQuestions(Wanted&& wanted) const;
  void answerOpen(const Questions& open, const PortfolioOptions& options);
  template <class Wanted, class Watched>
  void searchOnEngine(Wanted&& wanted, std::uint64_t instructions, Watched&& isWatched);
  bool searchShallow(std::size_t question);
  void explore(Clock::time_point deadline, double seconds);
  void takeExplored();
  void show(std::size_t question, Witness witness, const char* method);

  std::vector<Node> estimatesOf(std::size_t question);
  bool searchWithoutEstimates(std::size_t question, QuestionAnswer& answer, std::optional<Witness>& witness);
  void askWithoutEstimates(std::size_t question, const std::vector<Node>& estimates, const TransitionSystem& system);
  std::vector<QuestionAnswer> answeredTogether(const TransitionSystem& system, const Questions& alike);
  std::vector<QuestionAnswer> runsOf(const TransitionSystem& system, const Questions& alike);
  Found search(std::size_t question, Answer known);
  Found race(std::size_t question);
  std::optional<Found> heldRun(std::size_t question, const TransitionSystem& system);
  QuestionSystem* relaxedSide();
  std::optional<Witness> replayed(QuestionSystem& side, const TransitionSystem& system, std::size_t question,
                                  const WordTrace& trace);
  std::optional<Witness> replayedCheck(const TransitionSystem& system, std::size_t question, const WordTrace& trace);
  std::optional<Witness> confirmed(std::size_t question, const WordTrace& trace);

  const Program& program_;
  const PropertySet& set_;
  const ProverOptions& options_;
  const std::vector<Property> goals_;
  std::vector<Property> assumptions_;
  std::vector<bool> isLeftOut_;  ///< by Instruction::id: outside the cone of influence of all questions
  std::size_t declared_ = 0;     ///< goals that the user has declared; they come first
  ProofWatch watch_;
  TechniqueLog log_;
  Clock::time_point deadline_{};                  ///< of the question at hand
  double processor_ = schedule::tirelessSeconds;  ///< s for each search, of the same
  bool isOfMany_ = false;                         ///< the same is one of hundreds that a rule asks
  std::unique_ptr<QuestionSystem> exact_, relaxed_;
  std::shared_ptr<Trail> trail_;  ///< of exact_
  std::unique_ptr<AsWritten> asWritten_;
  std::set<std::size_t> certifiedWithReals_;  ///< questions whose certificate has REAL operations written out
  std::unique_ptr<Exploration> exploration_;
  std::vector<QuestionAnswer> quick_;
  std::map<std::size_t, Witness> early_;                    ///< by goal: witnesses of runs during the encoding
  std::map<std::size_t, Witness> found_;                    ///< by question: witnesses of answerQuickly()
  std::map<std::size_t, QuestionAnswer> withoutEstimates_;  ///< by question: what holds of runs that use no estimate
  std::set<std::size_t> triedTogether_;                     ///< questions that were asked so with others
  std::set<std::size_t> unconfirmed_;  ///< questions whose run of answerQuickly() the engine does not repeat
  /// The variables that the question replayed last depends on.
  std::optional<std::pair<std::size_t, std::unordered_set<std::uint32_t>>> replayedCone_;
  std::map<std::size_t, TransitionSystem> written_;  ///< by question: its system with REAL operations written out
};

template <class Wanted>
std::vector<std::size_t> QuestionSearch::openQuestions(Wanted&& wanted) const {
  std::vector<std::size_t> open;
  for (std::size_t q = 0; q < quick_.size(); ++q) {
    if (quick_[q].answer == Answer::Unknown && wanted(q)) open.push_back(q);
  }
  return open;
}

}  // namespace rungproof
