// Assumptions as texts, and questions of several outputs.
#include "analysis/equivalence/comparison_basis.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/broken_off.hpp"
#include "analysis/equivalence/device_requests.hpp"
#include "analysis/proof/question_system.hpp"
#include "analysis/unread/unread_code.hpp"

namespace rungproof {

std::vector<std::string> assumptionTexts(const Side& before, const Side& after, const EquivalenceOptions& options) {
  std::vector<std::string> texts;
  for (const Side* side : {&before, &after}) {
    for (const std::string& text :
         environmentTexts(*side->program, side->set, options.prover.time, options.prover.choices)) {
      if (std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
    }
  }
  for (const Property& assumption : options.assumptions) texts.push_back(assumption.text);
  for (const Side* side : {&before, &after}) {
    const bool hasRoutines =
        std::ranges::any_of(side->program->pous, [](const Pou& pou) { return pou.kind == PouKind::Interrupt; });
    if (!hasRoutines) continue;
    texts.push_back(options.interruptsInside ? "interrupts come anywhere in a scan" : "interrupts come between scans");
    break;
  }
  if (sendsMessages(*before.program) || sendsMessages(*after.program))
    texts.emplace_back("what XMT and NETW send is no output, and is not compared");
  if (options.steadyInputs) texts.push_back("physical inputs are steady for the whole scan");
  if (options.latency > 0)
    texts.push_back(fmt::format("NEW in scan k + {0} is compared with OLD in scan k", options.latency));
  if (options.settleMs > 0)
    texts.push_back(fmt::format("outputs may differ for less than {} ms without a break", options.settleMs));
  return texts;
}

std::vector<std::string> reasonsFor(const UnreadCode& unread, const std::optional<Address>& address) {
  if (!address) return unread.reasons();
  ExprNode node;
  node.op = ExprOp::Address;
  node.operand = operandAt(*address);
  Property property;
  property.first.nodes.push_back(node);
  return unread.reasons(property);
}

std::vector<ObservedBit> observedOf(const JoinedSystem& merged, const std::vector<std::size_t>& open) {
  std::vector<ObservedBit> wanted;
  for (const std::size_t i : open) {
    if (i < merged.observed.size()) wanted.push_back(merged.observed[i]);
  }
  return wanted;
}

bool comparesStops(const JoinedSystem& merged, const std::vector<std::size_t>& open) {
  return std::ranges::find(open, merged.observed.size()) != open.end();
}

Node anyOf(Graph& graph, const std::vector<Question>& questions, const std::vector<std::size_t>& open) {
  Graph::Bool any = graph.constant(false);
  for (const std::size_t i : open) any = graph.lor(any, {questions[i].bad});
  return any.node;
}

std::vector<QuestionAnswer> askedApart(const TransitionSystem& system,
                                       const std::function<QuestionAnswer(const TransitionSystem&)>& ask,
                                       const std::function<void(std::size_t, const std::exception&)>& broken) {
  std::vector<QuestionAnswer> answers(system.questions.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    TransitionSystem one = system;
    one.questions = {system.questions[i]};
    try {
      answers[i] = ask(one);
    } catch (const std::exception& error) {
      broken(i, error);
    }
  }
  return answers;
}

std::string defectText(const std::exception& error) { return whyBrokenOff(error) + ", which leaves this open"; }

}  // namespace rungproof
