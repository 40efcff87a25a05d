// LOG004: a bit that an earlier network reads than the one whose coil writes it: the reader sees the value of the scan
// before. One note for each bit. Latches, steps and inputs keep their values by nature and are left out.
// Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// The only coil of the bit, in a block without loops around it, or nullptr.
const Access* onlyCoil(const Facts& facts, std::uint32_t key) {
  const std::span<const std::uint32_t> writers = facts.bits().at(key);
  if (writers.size() != 1 || facts.writers(key / 8, key % 8) != 1 || facts.index().isWrittenAtLarge(key / 8))
    return nullptr;
  const Access& access = facts.access(writers.front());
  const bool isPlain =
      isCoil(roleOf(facts.instruction(access.instruction))) && !facts.execution().at(access.instruction).inLoop;
  return isPlain && (access.area == Area::Q || access.area == Area::M || access.area == Area::V) ? &access : nullptr;
}

void checkLog004(const Facts& facts, FindingSink& sink) {
  if (facts.hasUnreadCode()) return;
  for (std::uint32_t key = 0; key < facts.bits().size(); ++key) {
    if (facts.bits().at(key).empty()) continue;
    const Access* coil = onlyCoil(facts, key);
    if (coil == nullptr) continue;
    const InstructionPlace& home = facts.place(coil->instruction);
    const Access* early = nullptr;
    bool isReadLater = false;
    for (const std::uint32_t i : facts.index().at(key / 8)) {
      const Access& access = facts.access(i);
      if (access.write || access.width != Width::Bit || access.bit != key % 8) continue;
      const InstructionPlace& place = facts.place(access.instruction);
      if (place.block != home.block || place.network > home.network)
        isReadLater = true;
      else if (place.network < home.network && early == nullptr)
        early = &access;
    }
    if (early == nullptr || isReadLater) continue;
    const Instruction& instruction = facts.instruction(early->instruction);
    Finding& finding = sink.report(
        instruction.span,
        fmt::format("{} reads {} before network {} writes it: it sees the value of the scan before",
                    Facts::text(instruction), facts.bitName(key), facts.networkOf(coil->instruction).number));
    finding.address = toString(instruction.operands[early->operand]);
    finding.related.push_back({facts.instruction(coil->instruction).span, "written here"});
    finding.help = "put the network with the coil first if one scan of delay matters";
  }
}

}  // namespace

extern constexpr Rule log004_read_before_written = {
    .id = "LOG004",
    .title = "Read before written in the scan",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects = "a bit with one coil that only earlier networks read",
    .why = "the reader sees the value of the scan before: one scan of delay, and interlocks react late",
    .manual = "001:1240-1242",
    .bad = "Network 1\nLD I0.0\nAN M0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= M0.0\n",
    .good = "Network 1\nLD I0.1\n= M0.0\nNetwork 2\nLD I0.0\nAN M0.0\n= Q0.0\n",
    .falsePositives = "feedback that is meant to come from the scan before",
    .dialects = dialect::S7200,
    .check = checkLog004,
};

}  // namespace rungproof
