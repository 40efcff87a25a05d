// SCR004: two ways out at once. Transitions of one step that do not exclude each other, and chains in which two steps
// are active. Only the prover can say. Tested by tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include <map>

#include "analysis/asking/asking.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

using TransitionsOfStep = std::map<std::uint32_t, std::vector<const Instruction*>>;  // by position of the LSCR

/// Steps that transitions join, without a divergence: at most one of them is active at the end of a scan.
void askTogether(Asking& asking, const Flow& flow, const TransitionsOfStep& ofStep) {
  Graph& graph = asking.graph();
  std::map<std::string, std::string> chain;  // by step: one step that stands for its chain
  std::map<std::string, const Instruction*> heads;
  const auto root = [&](std::string step) {
    while (chain.at(step) != step) step = chain.at(step);
    return step;
  };
  for (const auto& [head, transitions] : ofStep) {
    const std::string from = toString(flow.steps[head].instruction->operands[0]);
    heads.emplace(from, flow.steps[head].instruction);
    chain.try_emplace(from, from);
    for (const Instruction* transition : transitions) {
      const std::string to = toString(transition->operands[0]);
      heads.emplace(to, transition);
      chain.try_emplace(to, to);
      chain[root(to)] = root(from);
    }
  }
  std::map<std::string, std::vector<std::string>> chains;
  for (const auto& [step, parent] : chain) chains[root(step)].push_back(step);
  for (const auto& [first, steps] : chains) {
    Graph::Bool some = graph.constant(false), two = some;
    for (const std::string& step : steps) {
      const Operand& bit = heads.at(step)->operands[0];
      if (bit.kind != OperandKind::Direct) continue;
      const Graph::Bool active{asking.encoding().atEnd(memoryPlace(bit.area, bit.offset, Width::Bit, bit.bit))};
      two = graph.lor(two, graph.land(some, active));
      some = graph.lor(some, active);
    }
    const std::string names = fmt::format("{}", fmt::join(steps, ", "));
    asking.ask({.name = fmt::format("two steps of the chain {} are active", names),
                .message = fmt::format(
                    "two steps of the chain {} can be active at the end of a scan, though it has no divergence", names),
                .address = first,
                .place = heads.at(first),
                .bad = asking.askedProperties().atScanEnd(two.node)});
  }
}

/// Transitions of one step behind rungs of their own. One rung that drives two transitions is meant to start both.
void askTransitions(Asking& asking, const Flow& flow) {
  TransitionsOfStep ofStep;
  for (const FlowStep& step : flow.steps) {
    const bool isKnown = step.instruction->desc->control == Control::Scrt && step.partner != noPartner &&
                         !step.instruction->operands.empty() && asking.runsOf(*step.instruction) != nullptr;
    if (isKnown) ofStep[step.partner].push_back(step.instruction);
  }
  bool hasParallel = false, hasDouble = false;
  for (const auto& [head, transitions] : ofStep) {
    for (std::size_t i = 0; i < transitions.size(); ++i) {
      for (std::size_t k = i + 1; k < transitions.size(); ++k) {
        const Instruction &first = *transitions[i], &second = *transitions[k];
        const std::string a = toString(first.operands[0]), b = toString(second.operands[0]);
        const Graph::Bool one = asking.runsOf(first)->on[0], other = asking.runsOf(second)->on[0];
        if (a == b) continue;
        if (one.node == other.node) {
          hasParallel = true;
          continue;
        }
        const std::string from = toString(flow.steps[head].instruction->operands[0]);
        asking.ask(
            {.name = fmt::format("step {} is left to {} and {} at once", from, a, b),
             .message = fmt::format(
                 "the transitions of step {} to {} and to {} can be taken in one scan: both steps are then active",
                 from, a, b),
             .address = b,
             .place = &second,
             .bad = asking.graph().land(one, other).node,
             .other = &first});
        hasDouble = true;
      }
    }
  }
  if (!hasParallel && !hasDouble) askTogether(asking, flow, ofStep);
}

void askScr004(Asking& asking) {
  for (const Flow& flow : asking.encoding().plan().flows) askTransitions(asking, flow);
}

}  // namespace

extern constexpr Rule scr004_two_ways_out = {
    .id = "SCR004",
    .title = "Two ways out at once",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "two transitions of one step, behind rungs of their own, that can be taken in the same scan; in a chain "
        "without a divergence, two steps that are active at the end of a scan",
    .why = "the steps behind both are then active together: two branches run where one was meant",
    .manual = "001:5834, 001:5850-5872",
    .bad =
        "Network 1\nLD SM0.1\nS S0.1, 1\nNetwork 2\nLSCR S0.1\nNetwork 3\nLD I0.0\nSCRT S0.2\nNetwork 4\n"
        "LD I0.1\nSCRT S0.3\nNetwork 5\nSCRE\nNetwork 6\nLSCR S0.2\nNetwork 7\nLD I0.2\nSCRT S0.1\n"
        "Network 8\nSCRE\nNetwork 9\nLSCR S0.3\nNetwork 10\nLD I0.2\nSCRT S0.1\nNetwork 11\nSCRE\n",
    .good =
        "Network 1\nLD SM0.1\nS S0.1, 1\nNetwork 2\nLSCR S0.1\nNetwork 3\nLD I0.0\nSCRT S0.2\nNetwork 4\n"
        "LDN I0.0\nA I0.1\nSCRT S0.3\nNetwork 5\nSCRE\nNetwork 6\nLSCR S0.2\nNetwork 7\nLD I0.2\nSCRT S0.1\n"
        "Network 8\nSCRE\nNetwork 9\nLSCR S0.3\nNetwork 10\nLD I0.2\nSCRT S0.1\nNetwork 11\nSCRE\n",
    .falsePositives = "a divergence that is meant to be parallel: drive both SCRT from one rung",
    .peers = "L7 (nearest)",
    .ask = {.in = asked::Lint, .turn = 81, .cost = 2, .program = askScr004},
    .tell = {.advice = "make the conditions exclude each other"},
};

}  // namespace rungproof
