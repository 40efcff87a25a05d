// OUT005: S or R with a count above 1 reaches a bit that another network drives. A reset of a row of latched bits is
// normal; a coil inside the row, or a set over bits with their own logic, is not. Resets in the first scan only are
// initialisation. Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// An instruction of another network that drives the bit on its own.
const Instruction* driver(const Facts& facts, std::uint32_t key, const Instruction& block) {
  const Network* home = &facts.networkOf(block.id);
  const bool sets = isSet(kindOf(block));
  int looked = 0;
  for (const std::uint32_t i : facts.bits().at(key)) {
    const Access& access = facts.access(i);
    const Instruction& instruction = facts.instruction(access.instruction);
    if (++looked > 16) return nullptr;
    if (&instruction == &block || &facts.networkOf(instruction.id) == home) continue;
    if (isCoil(kindOf(instruction))) return &instruction;
    const bool isLatch = isSet(kindOf(instruction)) || isReset(kindOf(instruction));
    if (sets && isLatch && access.count == 1) return &instruction;
  }
  return nullptr;
}

void checkOut005(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place : facts.instructions()) {
    const Instruction& instruction = *place.instruction;
    const Kind kind = kindOf(instruction);
    if (!isSet(kind) && !isReset(kind)) continue;
    if ((facts.conditionOf(instruction.id) & condition::FirstScan) != 0) continue;
    for (const Access& access : facts.accesses().of(instruction.id)) {
      if (!access.write || access.width != Width::Bit || access.byNumber() || access.count < 2 || access.bit > 7)
        continue;
      const std::uint32_t cell = facts.cellOf(access);
      if (cell == facts.index().cells().size() || access.area == Area::L) continue;
      for (std::uint32_t k = 1; k < access.count && cell * 8 + access.bit + k < facts.bits().size(); ++k) {
        const std::uint32_t key = cell * 8 + access.bit + k;
        const Instruction* other = driver(facts, key, instruction);
        if (other == nullptr) continue;
        const std::string bit = facts.bitName(key);
        Finding& finding = sink.report(
            instruction.span,
            fmt::format("{} covers {}, which {} drives", Facts::text(instruction), bit, Facts::text(*other)));
        finding.address = toString(instruction.operands[0]);
        finding.related.push_back({other->span, fmt::format("{} is driven here", bit)});
        finding.help = fmt::format("the count reaches from {} over {} bits; check it",
                                   toString(instruction.operands[0]), access.count);
        break;
      }
    }
  }
}

}  // namespace

extern constexpr Rule out005_block_covers_foreign_bit = {
    .id = "OUT005",
    .title = "Block of S/R covers a foreign bit",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "S or R with N above 1 that reaches a bit which other networks drive",
    .why = "the count is easy to mistype: S Q0.0, 8 covers Q0.0 to Q0.7",
    .manual = "001:2789",
    .bad = "Network 1\nLD I0.0\nS Q0.0, 8\nNetwork 2\nLD I0.1\nR Q0.0, 8\nNetwork 3\nLD I0.2\n= Q0.5\n",
    .good = "Network 1\nLD I0.0\nS Q0.0, 4\nNetwork 2\nLD I0.1\nR Q0.0, 4\nNetwork 3\nLD I0.2\n= Q0.5\n",
    .falsePositives =
        "a general switch-off over outputs that coils drive later in the scan: put it behind them, or into their "
        "conditions",
    .peers = "SA0028 (nearest)",
    .check = checkOut005,
};

}  // namespace rungproof
