// OUT004: S without R, or R without S. Coils, moves, block operations, pointers, steps and `external` lines count as
// the other hand; what a start-up sets is meant to stay on. Tested by its examples and
// tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "analysis/flow/bit_ranges.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/pulse_generator.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Who writes each bit, one flag each.
struct LatchHands {
  bool set = false, reset = false, other = false;
};

/// Bytes, words and double words written as a whole clear or set their bits.
bool isWrittenWhole(const Facts& facts, std::uint32_t cell) {
  const std::span<const std::uint32_t> accesses = facts.index().at(cell);
  return std::any_of(accesses.begin(), accesses.end(),
                     [&](std::uint32_t i) { return facts.access(i).write && facts.access(i).width != Width::Bit; });
}

/// By bit; bits that no bit instruction writes stay empty.
std::vector<LatchHands> allHands(const Facts& facts) {
  std::vector<LatchHands> all(facts.bits().size());
  std::vector<bool> isStartUp;
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block)
    isStartUp.push_back(facts.calls().isStartUpOnly(block));
  std::uint32_t cell = ~0U;
  bool isOther = false;
  for (std::uint32_t key = 0; key < all.size(); ++key) {
    const std::span<const std::uint32_t> writers = facts.bits().at(key);
    if (writers.empty()) continue;
    if (key / 8 != cell) {
      cell = key / 8;
      isOther = facts.index().isWrittenAtLarge(cell) || facts.isExternal(cell) || isWrittenWhole(facts, cell);
    }
    LatchHands& hands = all[key];
    hands.other = isOther;
    for (const std::uint32_t i : writers) {
      const std::uint32_t id = facts.access(i).instruction;
      const Role role = facts.roleAt(id);
      if (isSet(role) && !isStartUp[facts.blockOf(id)])
        hands.set = true;
      else if (isReset(role))
        hands.reset = true;
      else
        hands.other = true;
    }
  }
  // A pulse generator drives its output; the networks only clear its image bit (001:4539).
  for (const InstructionPlace& place : facts.placesOf(mayPulse)) {
    const auto output = pulseOutputOf(*place.instruction);
    const std::uint32_t key = output ? 8 * facts.index().cells().cell(Area::Q, 0, 0) + pulseOutputs[*output].point : 0;
    if (output && key < all.size()) all[key].other = true;
  }
  return all;
}

void checkInstruction(const Facts& facts, FindingSink& sink, const Instruction& instruction, const Access& access,
                      const std::vector<LatchHands>& all, std::vector<std::uint8_t>& seen) {
  const bool sets = isSet(roleOf(instruction));
  const std::uint32_t start = facts.cellOf(access) * 8 + access.bit;
  if (facts.cellOf(access) == facts.index().cells().size()) return;
  BitRow lonely{access.area};
  std::uint32_t first = 0;
  for (std::uint32_t k = 0; k < access.count && start + k < facts.bits().size(); ++k) {
    const std::uint32_t key = start + k;
    const LatchHands& hands = all[key];
    const bool isLonely = !hands.other && !(sets ? hands.reset : hands.set);
    if (isLonely && seen[key] == 0) {
      if (lonely.empty()) first = key;
      lonely.bits.push_back(bitPosition(access.area, access.offset, access.bit) + k);
      seen[key] = 1;
    } else if (!isLonely && !sets) {
      return;  // a reset of many bits is meant for those that are set
    }
  }
  if (lonely.empty()) return;
  const bool isOne = lonely.bits.size() == 1;
  const std::string bits = isOne ? facts.bitName(first) + " is" : lonely.text() + " are";
  Finding& finding = sink.report(instruction.span, sets ? fmt::format("{} set but never reset; once on {} on", bits,
                                                                      isOne ? "it stays" : "they stay")
                                                        : fmt::format("{} reset but never set", bits));
  finding.address = lonely.first();
  finding.help = sets ? "add the R that ends it, or use = if the bit should follow its condition"
                      : "correct the address, or remove the reset";
}

void checkOut004(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode()) return;
  const std::vector<LatchHands> all = allHands(facts);
  std::vector<std::uint8_t> seen(all.size(), 0);
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return isSet(desc.role) || isReset(desc.role); })) {
    const Instruction& instruction = *place.instruction;
    const Role role = roleOf(instruction);
    if (!isSet(role) && !isReset(role)) continue;
    for (const Access& access : facts.accesses().of(instruction.id)) {
      const bool isBit = access.write && access.width == Width::Bit && !access.byNumber() && access.bit <= 7;
      if (isBit && access.area != Area::SM && access.area != Area::L && access.most == access.count)
        checkInstruction(facts, sink, instruction, access, all, seen);
    }
  }
}

}  // namespace

extern constexpr Rule out004_latch_with_one_hand = {
    .id = "OUT004",
    .title = "Latch with one hand",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "S on a bit that nothing resets, or R on a bit that nothing sets",
    .why = "the bit stays on for ever, also over STOP when it is retentive",
    .manual = "001:2787-2796",
    .bad = "Network 1\nLD I0.0\nS Q0.0, 1\n",
    .good = "Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD I0.1\nR Q0.0, 1\n",
    .falsePositives = "a fault bit that only an operator panel clears: declare it with //@ external",
    .peers = "TU Automation missing reset",
    .check = checkOut004,
};

}  // namespace rungproof
