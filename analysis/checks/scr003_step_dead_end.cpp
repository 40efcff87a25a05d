// SCR003: a step that nothing activates, or that nothing ends. Whether the conditions can come true is the prover's.
// Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Who changes the step bit.
struct StepHands {
  bool sets = false;
  bool resets = false;
};

StepHands handsOf(const Facts& facts, std::uint32_t key) {
  StepHands hands;
  const std::uint32_t cell = key / 8;
  if (facts.index().isWrittenAtLarge(cell) || facts.isExternal(cell)) return {true, true};
  for (const std::uint32_t i : facts.index().at(cell)) {
    const Access& access = facts.access(i);
    if (!access.write) continue;
    if (access.width != Width::Bit) {
      hands = {true, true};
      continue;
    }
    const std::uint32_t from = access.offset * 8 + access.bit, at = facts.index().cells().offsetOf(cell) * 8 + key % 8;
    if (at < from || at >= from + access.count) continue;
    const Instruction& instruction = facts.instruction(access.instruction);
    const Role role = roleOf(instruction);
    if (isSet(role))
      hands.sets = true;
    else if (isReset(role))
      hands.resets = true;
    else if (instruction.desc->control == Control::Scrt)
      (access.operand == impliedOperand ? hands.resets : hands.sets) = true;
    else
      hands = {true, true};
  }
  return hands;
}

void checkScr003(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode()) return;
  for (const InstructionPlace& place : facts.placesOf([](const Desc& desc) { return desc.control == Control::Lscr; })) {
    const Instruction& instruction = *place.instruction;
    if (instruction.desc->control != Control::Lscr || instruction.operands.empty()) continue;
    const Operand& bit = instruction.operands[0];
    const std::uint32_t cell = bit.kind == OperandKind::Direct ? facts.index().cells().cell(Area::S, bit.offset, 0)
                                                               : facts.index().cells().size();
    if (cell == facts.index().cells().size() || bit.bit > 7) continue;
    const StepHands hands = handsOf(facts, cell * 8 + bit.bit);
    const std::string name = facts.name(bit);
    if (!hands.sets) {
      Finding& finding = sink.report(
          instruction.span, fmt::format("nothing activates step {}: no SCRT leads to it and no S sets it", name));
      finding.address = toString(bit);
      finding.confirmation = Confirmation::NotNeeded;
      finding.help = "add the transition that leads here; a first step is set in the first scan by S";
    } else if (!hands.resets) {
      Finding& finding = sink.report(instruction.span,
                                     fmt::format("step {} is never left: it has no SCRT and nothing resets it", name));
      finding.address = toString(bit);
      finding.confirmation = Confirmation::NotNeeded;
      finding.help = "add the transition to the next step";
    }
  }
}

enum StepAspect : int { StepEntered, StepLeft };

void askScr003(Asking& asking) {
  Graph& graph = asking.graph();
  for (const Flow& flow : asking.encoding().plan().flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& head = *step.instruction;
      if (head.desc->control != Control::Lscr || head.operands.empty() ||
          head.operands[0].kind != OperandKind::Direct || asking.runsOf(head) == nullptr)
        continue;
      const Operand& bit = head.operands[0];
      const Place place = memoryPlace(bit.area, bit.offset, Width::Bit, bit.bit);
      const std::string name = toString(bit);
      const Graph::Bool now{asking.encoding().atEnd(place)}, before{asking.encoding().atStart(place)};
      asking.ask({.name = fmt::format("step {} can be active", name),
                  .message = fmt::format("no reachable state activates step {}", name),
                  .address = name,
                  .place = &head,
                  .bad = now.node,
                  .aspect = StepEntered});
      asking.ask({.name = fmt::format("step {} can be left", name),
                  .message = fmt::format("once active, step {} is never left in any reachable state", name),
                  .address = name,
                  .place = &head,
                  .bad = graph.land(before, graph.lnot(now)).node,
                  .aspect = StepLeft});
    }
  }
}

constexpr Explanation scr003Explained[] = {{"SCR003", Where::SameAddress, StepEntered, StepLeft}};

}  // namespace

extern constexpr Rule scr003_step_dead_end = {
    .id = "SCR003",
    .title = "Step never entered or never left",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects = "a step that nothing activates, or that has no way out",
    .why = "the sequence hangs, or a part of it never runs",
    .manual = "001:5803-5841",
    .bad =
        "Network 1\nLD SM0.1\nS S0.0, 1\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD I0.0\nSCRT S0.1\nNetwork 4\nSCRE\n"
        "Network 5\nLSCR S0.1\nNetwork 6\nLD SM0.0\n= Q0.0\nNetwork 7\nSCRE\n",
    .good =
        "Network 1\nLD SM0.1\nS S0.0, 1\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD I0.0\nSCRT S0.1\nNetwork 4\nSCRE\n"
        "Network 5\nLSCR S0.1\nNetwork 6\nLD I0.1\nSCRT S0.0\nNetwork 7\nSCRE\n",
    .falsePositives = "a last step in which the machine is meant to stay",
    .peers = "Frama-PLC E4.3 (transition constant)",
    .dialects = dialect::S7200,
    .check = checkScr003,
    .ask = {.in = asked::Lint, .turn = 80, .cost = 3, .wantsYes = true, .program = askScr003},
    .tell = {.advice = "look at the conditions of the transitions"},
    .explainedBy = scr003Explained,
};

}  // namespace rungproof
