// ARI001: a divisor that is 0 or may be. Divisors that a comparison in the same rung keeps from 0, or that only
// constants other than 0 are moved into, are safe; the rest is the prover's. On an S7-300/400 a comparison before it or
// a look at OV behind it is enough; what is left stays unconfirmed. Tested by its examples,
// tests/rules/data_rules_test.cpp and tests/rules/step7_data_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isDivision(Role role) { return role == Role::Div || role == Role::DivWide; }

bool samePlace(const Operand& a, const Operand& b) {
  return a.kind == b.kind && a.area == b.area && a.offset == b.offset && (a.area == Area::AC || a.width == b.width);
}

/// Whether a comparison in the same network, before the division, has the divisor as an operand.
bool isCompared(const Facts& facts, const InstructionPlace& place, const Operand& divisor) {
  const Flow& flow = facts.plan().flows[place.block];
  for (std::uint32_t at = place.step; at > 0 && flow.steps[at - 1].network == place.network; --at) {
    const Instruction& instruction = *flow.steps[at - 1].instruction;
    if (instruction.desc->execution != Execution::Compare) continue;
    if (std::any_of(instruction.operands.begin(), instruction.operands.end(),
                    [&](const Operand& o) { return samePlace(o, divisor); }))
      return true;
  }
  return false;
}

/// Whether the place is written by nothing but moves of constants other than 0.
bool isNeverZero(const Facts& facts, const Access& divisor) {
  const std::uint32_t cell = facts.cellOf(divisor);
  if (cell == facts.index().cells().size() || divisor.area == Area::AC || facts.index().isWrittenAtLarge(cell) ||
      facts.isExternal(cell))
    return false;
  bool isWritten = false;
  for (const std::uint32_t i : facts.index().at(cell)) {
    const Access& access = facts.access(i);
    if (!access.write) continue;
    const Instruction& move = facts.instruction(access.instruction);
    const bool isMove = roleOf(move) == Role::Move && move.operands.size() == 2;
    if (!isMove || move.operands[0].kind != OperandKind::Constant || move.operands[0].value == 0) return false;
    isWritten = true;
  }
  return isWritten;
}

/// S7-300/400: the divisor is what the last load left in ACCU1.
void checkAccus(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& division = *flow.steps[at].instruction;
      const std::optional<std::uint32_t> bits = divisorBits(division);
      const Instruction* load = bits ? loadsBefore(flow, at).accu1 : nullptr;
      if (load == nullptr || !facts.execution().at(division.id).isReachable) continue;
      const Operand& divisor = load->operands[0];
      if (divisor.kind == OperandKind::Constant) {
        if ((static_cast<std::uint64_t>(divisor.value) & *bits) != 0) continue;
        Finding& finding = sink.report(division.span, fmt::format("{} divides by 0", Facts::text(division)));
        finding.related.push_back({load->span, "the divisor"});
        finding.confirmation = Confirmation::NotNeeded;
        finding.help = "OV, OS, CC1 and CC0 become 1 and no quotient comes";
        continue;
      }
      if (!divisor.isMemory() || isComparedBefore(flow, at, divisor) || asksOverflowBehind(flow, at)) continue;
      Finding& finding = sink.report(
          division.span, fmt::format("{} divides by {}, which may be 0", Facts::text(division), facts.name(divisor)));
      finding.related.push_back({load->span, "the divisor"});
      finding.address = toString(divisor);
      finding.help = "compare the divisor with 0 and jump over the division, or ask OV behind it";
    }
  });
}

void checkAri001(const Facts& facts, FindingSink& sink) {
  if (facts.form() == StatementForm::Accumulators) return checkAccus(facts, sink);
  for (const InstructionPlace& place : facts.placesOf([](const Desc& desc) { return isDivision(desc.role); })) {
    const Instruction& instruction = *place.instruction;
    if (!isDivision(roleOf(instruction)) || instruction.operands.empty()) continue;
    const Operand& divisor = instruction.operands[0];
    if (divisor.kind == OperandKind::Constant) {
      if (divisor.value != 0) continue;
      Finding& finding = sink.report(divisor.span, fmt::format("{} divides by 0", Facts::text(instruction)));
      finding.confirmation = Confirmation::NotNeeded;
      finding.help = "the result is never written and SM1.3 is set (001:4814)";
      continue;
    }
    if (isCompared(facts, place, divisor) || facts.hasUnreadCode()) continue;
    const std::span<const Access> accesses = facts.accesses().of(instruction.id);
    const bool isSafe = std::any_of(accesses.begin(), accesses.end(), [&](const Access& a) {
      return a.operand == 0 && !a.write && !a.viaPointer && isNeverZero(facts, a);
    });
    if (isSafe) continue;
    Finding& finding = sink.report(
        divisor.span, fmt::format("{} divides by {}, which may be 0", Facts::text(instruction), facts.name(divisor)));
    finding.address = toString(divisor);
    finding.help = "compare the divisor with 0 in the same rung, or test SM1.3 behind the division";
  }
}

constexpr Hazard ari001Hazards[] = {Hazard::DivideByZero};

}  // namespace

extern constexpr Rule ari001_division_by_zero = {
    .id = "ARI001",
    .title = "Division by zero",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects = "a divisor that is or can be 0",
    .why =
        "S7-200: SM1.3 is set and the result is not written, the old value goes on being used; S7-300/400: OV and OS "
        "are set and what stands in ACCU1 is no quotient",
    .manual = "001:4814-4827, 002:1563-1578",
    .bad = "Network 1\nLD SM0.0\nMOVW VW0, VW2\n/I VW4, VW2\n",
    .good = "Network 1\nLDW<> VW4, 0\nMOVW VW0, VW2\n/I VW4, VW2\n",
    .falsePositives = "a divisor whose range is known from elsewhere: on an S7-200 the prover drops it",
    .peers = "SA0040",
    .check = checkAri001,
    .ask = {.in = asked::Builtin, .turn = 30, .cost = 1, .hazards = ari001Hazards},
};

}  // namespace rungproof
