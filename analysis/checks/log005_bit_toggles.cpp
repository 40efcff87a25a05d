// LOG005: a bit that is assigned from its own inverse without an edge, so that it changes in every scan. A single
// inverted contact is certain; with more contacts in series it toggles while they hold, which the prover confirms.
// Tested by its examples, tests/rules/output_rules_test.cpp and tests/rules/step7_data_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

enum class Toggle { No, While, Always };

bool isContactOn(const Instruction& instruction, const Operand& bit) {
  const bool isContact = statementRole(instruction) != StatementRole::Other ||
                         instruction.desc->execution == Execution::Stack;  // of either family
  if (!isContact || instruction.operands.empty()) return false;
  const Operand& o = instruction.operands[0];
  return o.kind == OperandKind::Direct && o.area == bit.area && o.offset == bit.offset && o.bit == bit.bit &&
         o.width == Width::Bit;
}

/// The rung in front of the coil at step `at`: contacts in series only, one of them the inverse of the coil's bit.
Toggle rungOf(const Flow& flow, std::uint32_t at, const Operand& bit) {
  bool hasOwn = false, isPlain = true;
  const std::uint32_t network = flow.steps[at].network;
  while (at > 0 && flow.steps[at - 1].network == network) {
    const Instruction& instruction = *flow.steps[--at].instruction;
    const Role role = roleOf(instruction);
    if (role != Role::Load && role != Role::And) return Toggle::No;
    const bool isNegated = invertsImage(*instruction.desc);
    if (isContactOn(instruction, bit)) {
      if (!isNegated) return Toggle::No;
      hasOwn = true;
    } else {
      const Condition known = instruction.operands.empty() || instruction.desc->execution != Execution::Stack
                                  ? Condition{0}
                                  : conditionOf(instruction.operands[0], isNegated, {});
      if ((known & condition::Pulse) != 0) return Toggle::No;
      if ((known & condition::Always) == 0) isPlain = false;
    }
    if (role == Role::Load) break;
  }
  return !hasOwn ? Toggle::No : isPlain ? Toggle::Always : Toggle::While;
}

/// S7-300/400: AN of a bit alone in front of = of the same bit. With more scans in the string it would be for the
/// prover, which is not asked.
void checkStrings(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    if (facts.calls().isStartUpOnly(block)) return;
    const LogicStates states = logicStates(flow);
    for (std::uint32_t at = 1; at < flow.steps.size(); ++at) {
      const Instruction& assign = *flow.steps[at].instruction;
      const Instruction& scan = *flow.steps[at - 1].instruction;
      if (statementRole(assign) != StatementRole::Assign || !facts.execution().at(assign.id).isReachable) continue;
      const std::optional<LogicState>& before = states[at - 1];
      const bool isFirst = before && before->firstCheck == mayBe0 && before->depth == 0;
      const StatementRole role = statementRole(scan);
      const bool isScan = role == StatementRole::AndScan || role == StatementRole::OrScan;
      if (!isFirst || !isScan || !scanJoin(scan).negated) continue;
      const Operand& bit = assign.operands[0];
      if (bit.kind != OperandKind::Direct || bit.area == Area::L || !isContactOn(scan, bit)) continue;
      const std::uint32_t cell = facts.index().cells().cell(bit.area, bit.offset, block);
      if (cell == facts.index().cells().size() || facts.writers(cell, bit.bit) != 1) continue;
      Finding& finding = sink.report(
          assign.span,
          fmt::format("{} is assigned from its own inverse: it changes whenever this runs", facts.name(bit)));
      finding.address = toString(bit);
      finding.confirmation = Confirmation::NotNeeded;
      finding.help = "put the condition and FP in front, so that it changes once per press";
    }
  });
}

void checkLog005(const Facts& facts, FindingSink& sink) {
  if (facts.form() == StatementForm::Accumulators) return checkStrings(facts, sink);
  for (const InstructionPlace& place : facts.placesOf(isPlainCoil)) {
    const Instruction& instruction = *place.instruction;
    if (!isPlainCoil(*instruction.desc) || facts.isUnread(instruction.id) || instruction.operands.empty() ||
        instruction.operands[0].kind != OperandKind::Direct)
      continue;
    const Operand& bit = instruction.operands[0];
    const std::uint32_t cell = facts.index().cells().cell(bit.area, bit.offset, place.block);
    if (cell == facts.index().cells().size() || bit.bit > 7 || facts.writers(cell, bit.bit) != 1) continue;
    const Toggle toggle = rungOf(facts.plan().flows[place.block], place.step, bit);
    if (toggle == Toggle::No) continue;
    Finding& finding =
        sink.report(instruction.span,
                    fmt::format("{} is assigned from its own inverse{}: it changes in every scan", facts.name(bit),
                                toggle == Toggle::Always ? "" : " while the other contacts hold"));
    finding.address = toString(bit);
    if (toggle == Toggle::Always) finding.confirmation = Confirmation::NotNeeded;
    finding.help = "put EU in front, so that it changes once per press";
  }
}

void askLog005(Asking& asking) {
  if (asking.encoding().plan().form() == StatementForm::Accumulators) return;
  Graph& graph = asking.graph();
  for (const Instruction* coil : asking.executed()) {
    if (!isPlainCoil(*coil->desc) || coil->operands[0].kind != OperandKind::Direct || coil->operands[0].area == Area::L)
      continue;
    const Operand& bit = coil->operands[0];
    if (std::ranges::none_of(asking.rungOf(*coil), [&](const Instruction* c) { return isContactOf(*c, bit, true); }))
      continue;
    const Place place = memoryPlace(bit.area, bit.offset, Width::Bit, bit.bit);
    const Graph::Bool changes = graph.lxor({asking.encoding().atStart(place)}, {asking.encoding().atEnd(place)});
    const std::string name = toString(bit);
    const Graph::Bool before{asking.askedProperties().before("change of " + name, changes.node)};
    asking.ask({.name = fmt::format("{} changes in two scans in a row", name),
                .message = fmt::format("{} changes in every scan", name),
                .address = name,
                .place = coil,
                .bad = graph.land(changes, before).node});
  }
}

}  // namespace

extern constexpr Rule log005_bit_toggles = {
    .id = "LOG005",
    .title = "Bit toggles every scan",
    .severity = Severity::Note,
    .needs = Needs::FlowThenSolver,
    .detects = "a bit assigned from its own inverse on a path without an edge",
    .why = "a lamp flickers at scan rate, a motor contactor chatters",
    .manual = "001:2777, 001:2741, 002:2697-2714",
    .bad = "Network 1\nLDN M0.0\n= M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n",
    .good =
        "Network 1\nLD I0.0\nEU\nLPS\nAN M0.0\n= M0.1\nLPP\nA M0.0\n= M0.2\nNetwork 2\nLD M0.1\nS M0.0, 1\nNetwork "
        "3\nLD M0.2\nR M0.0, 1\n",
    .falsePositives = "a scan clock on purpose: SM0.6 of the S7-200 is one already",
    .check = checkLog005,
    .ask = {.in = asked::Lint, .turn = 62, .cost = 4, .onlySettles = true, .program = askLog005},
};

}  // namespace rungproof
