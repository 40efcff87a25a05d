// Runs that rest on estimates of what is not modelled exactly: whether there are some without. The conditions that no
// estimate is used keep whole programs in the cone of each question, so that questions with the same ones are asked
// together.
#include "analysis/proof/question_search.hpp"

namespace rungproof {

/// Conditions of the estimates that the question's cone carries, each of which says that its estimate is used.
std::vector<Node> QuestionSearch::estimatesOf(std::size_t question) {
  std::vector<Node> used;
  for (const Approximation* a : exact_->approximationsOf(question, written_.contains(question))) {
    if (a->used != noNode) used.push_back(a->used);
  }
  return used;
}

/// A run that rests on estimates: perhaps there is one without. True: the question was asked so, and need not be asked
/// otherwise.
bool QuestionSearch::searchWithoutEstimates(std::size_t question, QuestionAnswer& answer,
                                            std::optional<Witness>& witness) {
  const bool isWritten = written_.contains(question);
  const std::vector<Node> estimates = estimatesOf(question);
  if (estimates.empty() || !mayGoOn()) return false;
  const auto without = [&](TransitionSystem system) {
    for (const Node used : estimates) system.constraints.push_back(system.graph->make(Op::Not, 1, used));
    return system;
  };
  if (!isWritten && !triedTogether_.contains(question))
    askWithoutEstimates(question, estimates, without(exact_->system()));
  QuestionAnswer found;
  const TransitionSystem system = without(isWritten ? written_.at(question) : exact_->only(question));
  if (const auto known = withoutEstimates_.find(question); !isWritten && known != withoutEstimates_.end())
    found = known->second;
  else if (!isOfMany_ || isWritten)
    found = ask(system, left(), deadline_)[0];
  if (found.answer == Answer::Violated) witness = replayed(*exact_, system, question, *found.trace);
  // One of many has time to be asked once more, not twice.
  const bool isEnough = isOfMany_ || found.answer != Answer::Unknown;
  if (witness) answer = std::move(found);
  return isEnough;
}

/// Together with all others whose run rests on the same estimates and is not repeated.
void QuestionSearch::askWithoutEstimates(std::size_t question, const std::vector<Node>& estimates,
                                         const TransitionSystem& system) {
  Questions alike;
  for (std::size_t q = 0; q < quick_.size(); ++q) {
    const bool isOpen = quick_[q].answer == Answer::Violated && !found_.contains(q) && !written_.contains(q);
    if (!isOpen || triedTogether_.contains(q) || (q != question && estimatesOf(q) != estimates)) continue;
    const bool isKnown = q == question || unconfirmed_.contains(q);
    std::optional<Witness> witness = isKnown ? std::nullopt : confirmed(q, *quick_[q].trace);
    if (witness) {
      found_.emplace(q, std::move(*witness));
      continue;
    }
    unconfirmed_.insert(q);
    alike.push_back(q);
  }
  if (alike.empty()) return;
  std::vector<QuestionAnswer> answers = isOfMany_ ? runsOf(system, alike) : answeredTogether(system, alike);
  const bool isCutOff = !mayGoOn();  // then the next question asks those left again
  for (const std::size_t q : alike) {
    if (answers[q].answer != Answer::Unknown) withoutEstimates_.emplace(q, std::move(answers[q]));
    if (answers[q].answer != Answer::Unknown || !isCutOff) triedTogether_.insert(q);
  }
}

/// Each has its own time behind it.
std::vector<QuestionAnswer> QuestionSearch::answeredTogether(const TransitionSystem& system, const Questions& alike) {
  std::atomic<bool> cancel{false};
  const ProofWatch::Guard guard(watch_, cancel);
  PortfolioOptions together = portfolio(left(), deadline_, &cancel);
  together.effort = Effort::Together;
  return answerQuestions(system, alike, together);
}

/// A run is an answer here and a proof is none: random runs for all, then a short search for each that is left.
std::vector<QuestionAnswer> QuestionSearch::runsOf(const TransitionSystem& system, const Questions& alike) {
  std::atomic<bool> cancel{false};
  const ProofWatch::Guard guard(watch_, cancel);
  PortfolioOptions random = portfolio(left(), deadline_, &cancel), bounded = random;
  random.techniques.keepOnly({Technique::FirstScan, Technique::Simulation});
  std::vector<QuestionAnswer> answers = answerQuestions(system, alike, random);
  Questions open;
  for (const std::size_t q : alike) {
    if (answers[q].answer == Answer::Unknown) open.push_back(q);
  }
  if (open.empty() || !mayGoOn()) return answers;
  bounded.techniques.keepOnly({Technique::FirstScan, Technique::Bmc});
  bounded.seconds = std::min(bounded.seconds, schedule::withoutEstimatesSeconds);
  std::vector<QuestionAnswer> found = answerQuestions(system, open, bounded);
  for (const std::size_t q : open) answers[q] = std::move(found[q]);
  return answers;
}

}  // namespace rungproof
