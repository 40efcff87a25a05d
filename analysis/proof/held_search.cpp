// Runs of held inputs for a question of a rule, before engines race for it: cheap, and what is still open by then
// waits for a long count more often than not. The engine repeats the run before it counts.
// Covered by tests/prover/rule_budget_test.cpp.
#include "analysis/proof/question_search.hpp"

namespace rungproof {

/// A run of held inputs alone: what a rule asks and nothing else has found waits for a long count more often than not.
std::optional<QuestionSearch::Found> QuestionSearch::heldRun(std::size_t question, const TransitionSystem& system) {
  std::atomic<bool> cancel{false};
  const ProofWatch::Guard guard(watch_, cancel);
  PortfolioOptions options = portfolio(std::min(left(), schedule::ruleHeldSeconds), deadline_, &cancel);
  options.techniques.keepOnly({Technique::HeldInputs});
  if (!options.techniques.has(Technique::HeldInputs)) return std::nullopt;
  QuestionAnswer answer = answerQuestions(system, options)[0];
  if (answer.answer != Answer::Violated) return std::nullopt;
  std::optional<Witness> witness = confirmed(question, *answer.trace);
  if (!witness) return std::nullopt;
  return Found{std::move(answer), std::move(witness)};
}

}  // namespace rungproof
