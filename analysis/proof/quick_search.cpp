// What is asked of all open questions before each has its own time: their surface, all together, runs of the engine,
// few bounds, short runs with long scans, and a quick look at groups of them.
#include "analysis/proof/question_search.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/witness/guided_runs.hpp"

namespace rungproof {

void QuestionSearch::answerQuickly(Clock::time_point deadline) {
  std::atomic<bool> cancel{false};
  const ProofWatch::Guard guard(watch_, cancel);
  PortfolioOptions together = portfolio(std::min(options_.timeout, schedule::quickSeconds), deadline, &cancel);
  together.effort = Effort::Together;
  quick_.resize(exact_->system().questions.size());
  const auto isPremise = [&](std::size_t q) { return !isDeclared(q); };
  const auto none = [](std::size_t) { return false; };
  const bool hasManyPremises = openQuestions(isPremise).size() > schedule::manyPremises;
  if (hasManyPremises) searchOnEngine(isPremise, schedule::premiseInstructions, none);
  PortfolioOptions surface = together;
  surface.effort = Effort::Surface;
  answerOpen(openQuestions([](std::size_t) { return true; }), surface);
  together.techniques.leaveOut(Technique::OneScan);
  const auto searchFewPremises = [&] {
    if (!hasManyPremises) searchOnEngine(isPremise, schedule::fewInstructions, none);
  };
  const bool arePremisesLeft = openQuestions([&](std::size_t q) { return !isPremise(q); }).empty();
  if (arePremisesLeft) {
    searchFewPremises();
    together.techniques.leaveOut(Technique::EqualGates);  // most premises are met: there is nothing to prove
  }
  answerOpen(openQuestions([](std::size_t) { return true; }), together);
  if (!arePremisesLeft) searchFewPremises();
  explore(deadline, schedule::firstExploring);
  PortfolioOptions mined = portfolio(std::min(options_.timeout, schedule::quickSeconds), deadline, &cancel);
  mined.effort = Effort::Mined;
  // Premises are met more often than not: nothing is mined for them.
  const auto waits = [&](std::size_t q) {
    return isDeclared(q) && options_.bound == 0 && exact_->dependsOnTime(exact_->variablesOf(q));
  };
  if (options_.techniques.has(Technique::QuickAccelerated)) answerOpen(openQuestions(waits), mined);
  const Budget shallow = Budget::ofThread(schedule::shallowSeconds, Budget(deadline, &cancel));
  std::vector<std::size_t> open;
  for (std::size_t q = 0; q < quick_.size(); ++q) {
    const bool maySearch = q < goals_.size() && options_.bound == 0 && !shallow.isExhausted();
    if (quick_[q].answer == Answer::Unknown && !(maySearch && searchShallow(q))) open.push_back(q);
  }
  const auto isReached = [&](std::size_t q) { return !isDeclared(q) || goals_[q].kind == PropertyKind::Reach; };
  searchOnEngine(isReached, arePremisesLeft ? GuidedLimits{}.instructions : schedule::someInstructions, waits);
  takeExplored();
  std::erase_if(open, [&](std::size_t q) { return quick_[q].answer != Answer::Unknown; });
  PortfolioOptions apart = portfolio(std::min(options_.timeout, schedule::quickSeconds), deadline, &cancel);
  apart.effort = Effort::Apart;
  answerOpen(open, apart);
  if (!arePremisesLeft) searchOnEngine(isReached, GuidedLimits{}.instructions, waits);
  explore(deadline, schedule::exploringSeconds);
}

/// What the engine finds from state to state for all open goals in so much time; goes on where it stopped.
void QuestionSearch::explore(Clock::time_point deadline, double seconds) {
  const std::vector<std::size_t> open = openQuestions([&](std::size_t q) { return q < goals_.size(); });
  if (open.empty() || options_.bound > 0 || watch_.isStopped()) return;
  if (!options_.techniques.has(Technique::Exploration)) return;
  TechniqueTurn turn(&log_, Technique::Exploration, open.size());
  std::atomic<bool> cancel{false};
  const ProofWatch::Guard guard(watch_, cancel);
  if (!exploration_)
    exploration_ = std::make_unique<Exploration>(program_, runSpaceOf(exact_->askedProperties().encoding()),
                                                 assumptions_, goals_, open, options_.seed);
  else
    for (std::size_t q = 0; q < goals_.size(); ++q) {
      if (quick_[q].answer != Answer::Unknown) exploration_->withdraw(q);
    }
  const double limit = std::min(options_.timeout * schedule::engineShare, seconds);
  exploration_->search(std::min(deadline, Clock::now() + inSeconds(limit)), cancel);
  takeExplored();
  turn.settled(open.size() - openQuestions([&](std::size_t q) { return q < goals_.size(); }).size());
}

/// Runs that the exploration has found for questions that were still open.
void QuestionSearch::takeExplored() {
  for (const auto& [goal, witness] : early_) {
    if (quick_[goal].answer == Answer::Unknown) show(goal, witness, "exploration");
  }
  if (!exploration_) return;
  for (std::size_t q = 0; q < goals_.size(); ++q) {
    if (quick_[q].answer == Answer::Unknown && exploration_->found(q)) show(q, *exploration_->found(q), "exploration");
  }
}

void QuestionSearch::show(std::size_t question, Witness witness, const char* method) {
  quick_[question].answer = Answer::Violated;
  quick_[question].method = method;
  found_.emplace(question, std::move(witness));
}

void QuestionSearch::answerOpen(const Questions& open, const PortfolioOptions& options) {
  if (open.empty()) return;
  std::vector<QuestionAnswer> answers = answerQuestions(exact_->system(), open, options);
  for (const std::size_t q : open) {
    answers[q].seconds += quick_[q].seconds;
    quick_[q] = std::move(answers[q]);
  }
}

/// Runs of the engine for wanted goals that are still open, all together. Others are watched where that is wanted: a
/// run that is long enough for one goal often shows that another does not hold.
template <class Wanted, class Watched>
void QuestionSearch::searchOnEngine(Wanted&& wanted, std::uint64_t instructions, Watched&& isWatched) {
  std::vector<std::size_t> open = openQuestions([&](std::size_t q) { return q < goals_.size() && wanted(q); });
  if (open.empty()) return;
  const std::vector<std::size_t> watched =
      openQuestions([&](std::size_t q) { return q < goals_.size() && !wanted(q) && isWatched(q); });
  open.insert(open.end(), watched.begin(), watched.end());
  std::vector<const Property*> goals;
  for (const std::size_t q : open) goals.push_back(&goals_[q]);
  if (options_.bound > 0 || watch_.isStopped()) return;
  if (!options_.techniques.has(Technique::EngineRuns)) return;
  TechniqueTurn turn(&log_, Technique::EngineRuns, open.size());
  std::vector<std::optional<GuidedRun>> found = guidedRuns(
      program_, exact_->askedProperties().encoding(), assumptions_, goals, options_.seed,
      {std::min(options_.timeout * schedule::engineShare, schedule::engineSeconds), instructions, watched.size()});
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!found[i]) continue;
    // Nobody looks at the run that meets a premise.
    show(open[i], isDeclared(open[i]) ? found[i]->witness() : Witness{}, "engine runs");
    turn.settled();
  }
}

/// A short run of the accelerated system that the engine repeats.
bool QuestionSearch::searchShallow(std::size_t question) {
  const auto start = Clock::now();
  if (!options_.techniques.has(Technique::QuickAccelerated)) return false;
  if (!exact_->dependsOnTime(exact_->variablesOf(question))) return false;
  TechniqueTurn turn(&log_, Technique::QuickAccelerated, 1);
  QuestionSystem* relaxed = relaxedSide();
  if (relaxed == nullptr) return false;
  const TransitionSystem accelerated = relaxed->accelerated(question, options_.time);
  if (const auto trace =
          shallowSearch(accelerated, schedule::shallowDepth, schedule::shallowSeconds * schedule::shallowShare)) {
    if (auto witness = replayed(*relaxed, accelerated, question, *trace)) {
      show(question, std::move(*witness), "accelerated search");
      quick_[question].seconds += secondsSince(start);
      turn.settled();
      return true;
    }
  }
  return false;
}

}  // namespace rungproof
