// ADR010: a place that is read and that nothing writes. Bits count on their own; whatever pointers, block operations,
// the data block or an `external` line may write counts as written. Local memory is SUB005, steps are SCR003.
// Tested by its examples and tests/rules/address_rules_test.cpp.
#include <fmt/format.h>

#include <unordered_set>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isEverWritten(const Facts& facts, const Access& access) {
  const CellMap& cells = facts.index().cells();
  const std::uint32_t start = facts.cellOf(access);
  if (start == cells.size()) return true;  // ADR001 speaks
  for (std::uint32_t k = 0; k < access.certainLength(); ++k) {
    const std::uint32_t cell = start + k;
    if (cell >= cells.size() || facts.index().isWrittenAtLarge(cell) || facts.isExternal(cell)) return true;
    const unsigned low = access.width == Width::Bit ? access.bit : 0,
                   high = access.width == Width::Bit ? access.bit : 7;
    for (unsigned bit = low; bit <= high && bit < 8; ++bit) {
      if (facts.writers(cell, bit) > 0) return true;
    }
  }
  return false;
}

void checkAdr010(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode()) return;
  std::unordered_set<std::uint64_t> seen;
  for (const Access& access : facts.accesses().all()) {
    if (access.write || access.maybe || access.viaPointer || access.operand == impliedOperand || access.bit > 7)
      continue;
    if (!isMemoryArea(access.area)) continue;
    const Instruction& instruction = facts.instruction(access.instruction);
    const Desc& desc = *instruction.desc;
    if (desc.control == Control::Lscr || access.most > access.count) continue;
    const bool isOwn =
        access.operand < desc.operandCount && desc.operands[access.operand].direction == Direction::InOut;
    if (isOwn || isEverWritten(facts, access)) continue;
    const std::uint64_t key = static_cast<std::uint64_t>(facts.cellOf(access)) << 8 |
                              static_cast<std::uint64_t>(access.width) << 4 | access.bit;
    if (!seen.insert(key).second) continue;
    const Operand& operand = instruction.operands[access.operand];
    const std::string place = access.count > 1 ? accessRange(access) : facts.name(operand);
    Finding& finding = sink.report(
        operand.span, fmt::format("{} reads {}, which nothing in the program writes", Facts::text(instruction), place));
    finding.address = toString(operand);
    finding.help = fmt::format("correct the address; if a panel or a network writes it, say so with //@ external {}",
                               toString(operand));
  }
}

}  // namespace

extern constexpr Rule adr010_read_never_written = {
    .id = "ADR010",
    .title = "Read but never written",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a V, M or S address, or the preset of a timer or counter, that is read although nothing writes it and it is "
        "not declared external",
    .why = "it reads 0 after the first start, or an old retentive value; M0 to M13 are not retentive unless configured",
    .manual = "001:1619, 001:1623-1625",
    .bad = "Network 1\nLD M1.0\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\n= M1.0\nNetwork 2\nLD M1.0\n= Q0.0\n",
    .falsePositives =
        "values from an operator panel, a network partner or another tool: declare them with //@ external VB100..VB199",
    .peers = "CP3; Frama-PLC missing inputs",
    .dialects = dialect::S7200,
    .check = checkAdr010,
};

}  // namespace rungproof
