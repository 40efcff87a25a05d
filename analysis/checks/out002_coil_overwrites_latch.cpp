// OUT002: = and S or R on one bit: the coil writes 0 as well as 1 in every scan. A reset in the first scan only is
// initialisation and harmless, and a reset of several bits that runs behind the coil is a general switch-off (OUT005).
// Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/scan_order.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// S and R that name the bit as their first, for good.
bool isLatchOf(const Facts& facts, const Access& access, std::uint32_t key) {
  const Instruction& instruction = facts.instruction(access.instruction);
  const Role role = roleOf(instruction);
  const bool isInitial = isReset(role) && ((facts.conditionOf(instruction.id) & condition::FirstScan) != 0 ||
                                           facts.isUnread(instruction.id));
  const bool isFirstBit = access.offset == facts.index().cells().offsetOf(key / 8) && access.bit == key % 8;
  return (isSet(role) || isReset(role)) && isFirstBit && !isInitial;
}

void checkOut002(const Facts& facts, FindingSink& sink) {
  for (std::uint32_t key = 0; key < facts.bits().size(); ++key) {
    const std::span<const std::uint32_t> writers = facts.bits().at(key);
    if (writers.size() < 2) continue;
    const Instruction* coil = nullptr;
    for (const std::uint32_t i : writers) {
      const Access& access = facts.access(i);
      if (access.area == Area::L) break;
      if (facts.calls().isStartUpOnly(facts.blockOf(access.instruction))) continue;  // before the first scan
      if (coil == nullptr && isCoil(roleOf(facts.instruction(access.instruction))))
        coil = &facts.instruction(access.instruction);
    }
    const Instruction* latch = nullptr;
    for (const std::uint32_t i : writers) {
      const Access& access = facts.access(i);
      if (coil == nullptr || latch != nullptr) break;
      const Instruction& instruction = facts.instruction(access.instruction);
      const bool isSwitchOff =
          isReset(roleOf(instruction)) && access.count > 1 && runsBefore(facts, coil->id, instruction.id);
      if (isLatchOf(facts, access, key) && !isSwitchOff) latch = &instruction;
    }
    if (latch == nullptr) continue;
    const std::string bit = facts.bitName(key);
    const bool isCoilLast = !runsBefore(facts, coil->id, latch->id);
    Finding& finding = sink.report(
        coil->span, isCoilLast
                        ? fmt::format("the coil of {} overwrites what {} does to it", bit, Facts::text(*latch))
                        : fmt::format("the coil of {} undoes in the next scan what {} does to it behind the coil", bit,
                                      Facts::text(*latch)));
    finding.address = toString(coil->operands[0]);
    finding.related.push_back({latch->span, fmt::format("{} is latched here", bit)});
    finding.help = "drive the bit either by = or by S and R (001:2821)";
  }
}

}  // namespace

extern constexpr Rule out002_coil_overwrites_latch = {
    .id = "OUT002",
    .title = "Coil overwrites a latch",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "= and S or R on the same bit",
    .why =
        "the coil writes the bit in every scan, 0 as well as 1; the manual says to make sure that no other assignment "
        "overwrites set and reset bits",
    .manual = "001:2821",
    .bad = "Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD I0.1\n= Q0.0\nNetwork 3\nLD I0.2\nR Q0.0, 1\n",
    .good = "Network 1\nLD I0.0\nO I0.1\nS Q0.0, 1\nNetwork 2\nLD I0.2\nR Q0.0, 1\n",
    .falsePositives = "a coil that runs only while the latch is not used, such as in another operating mode",
    .peers = "Rockwell duplicate destructive bit; Omron duplicate outputs",
    .check = checkOut002,
};

}  // namespace rungproof
