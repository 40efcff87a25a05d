// OUT005: S or R with a count above 1 reaches bits that other networks drive. A reset of a row of latched bits is
// normal; a coil inside the row, or a set over bits with their own logic, is not. Resets in the first scan only are
// initialisation, and a reset that runs behind all coils of its row switches off in general. One finding names all the
// bits that are driven elsewhere. Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/bit_ranges.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/scan_order.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostDrivers = 8;

/// An instruction of another network that drives the bit on its own, against the block.
const Instruction* driver(const Facts& facts, std::uint32_t key, const Instruction& block) {
  const Network* home = &facts.networkOf(block.id);
  const bool sets = isSet(roleOf(block));
  int looked = 0;
  for (const std::uint32_t i : facts.bits().at(key)) {
    const Access& access = facts.access(i);
    const Instruction& instruction = facts.instruction(access.instruction);
    if (++looked > 16) return nullptr;
    if (&instruction == &block || &facts.networkOf(instruction.id) == home) continue;
    if (isCoil(roleOf(instruction)) && (sets || !runsBefore(facts, instruction.id, block.id))) return &instruction;
    const bool isLatch = isSet(roleOf(instruction)) || isReset(roleOf(instruction));
    if (sets && isLatch && access.count == 1) return &instruction;
  }
  return nullptr;
}

void checkBlock(const Facts& facts, FindingSink& sink, const Instruction& block, const Access& access) {
  const std::uint32_t cell = facts.cellOf(access);
  if (cell == facts.index().cells().size() || access.area == Area::L) return;
  const std::uint32_t start = cell * 8 + access.bit;
  BitRow row{access.area};
  std::vector<const Instruction*> drivers;
  for (std::uint32_t k = 0; k < access.count && start + k < facts.bits().size(); ++k) {
    const Instruction* other = driver(facts, start + k, block);
    if (other == nullptr) continue;
    row.bits.push_back(bitPosition(access.area, access.offset, access.bit) + k);
    if (std::find(drivers.begin(), drivers.end(), other) == drivers.end()) drivers.push_back(other);
  }
  // The first bit alone is the one that the operand names: no slip of the count.
  if (row.empty() || row.bits.back() == bitPosition(access.area, access.offset, access.bit)) return;
  const std::string others = drivers.size() == 1 ? Facts::text(*drivers.front())
                                                 : fmt::format("{} and {} other{}", Facts::text(*drivers.front()),
                                                               drivers.size() - 1, drivers.size() == 2 ? "" : "s");
  Finding& finding = sink.report(block.span, fmt::format("{} covers {}, which {} {}", Facts::text(block), row.text(),
                                                         others, drivers.size() == 1 ? "drives" : "drive"));
  finding.address = row.first();
  for (std::size_t i = 0; i < std::min(drivers.size(), mostDrivers); ++i) {
    finding.related.push_back(
        {drivers[i]->span, fmt::format("{} is driven here", toString(drivers[i]->operands.front()))});
  }
  finding.help =
      fmt::format("the count reaches from {} over {} bits; check it", toString(block.operands[0]), access.count);
}

void checkOut005(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return isSet(desc.role) || isReset(desc.role); })) {
    const Instruction& instruction = *place.instruction;
    if ((facts.conditionOf(instruction.id) & condition::FirstScan) != 0 || facts.isUnread(instruction.id)) continue;
    for (const Access& access : facts.accesses().of(instruction.id)) {
      if (access.write && access.width == Width::Bit && !access.byNumber() && access.count >= 2 && access.bit <= 7)
        checkBlock(facts, sink, instruction, access);
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
        "a general switch-off over outputs that coils drive later in the scan: put it behind all of them, where it is "
        "no finding, or into their conditions",
    .peers = "SA0028 (nearest)",
    .dialects = dialect::S7200,
    .check = checkOut005,
};

}  // namespace rungproof
