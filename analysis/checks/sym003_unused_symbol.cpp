// SYM003: a symbol that nothing uses, by its name or by its address. Tested by tests/rules/address_rules_test.cpp.
#include <fmt/format.h>

#include <unordered_set>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Whether any access touches a byte of the address.
bool addressIsUsed(const Facts& facts, const Operand& address) {
  const AccessIndex& index = facts.index();
  const auto length = static_cast<std::uint32_t>(hasBitAndWord(address.area) ? 1 : bytes(address.width));
  for (std::uint32_t k = 0; k < length; ++k) {
    const std::uint32_t cell = index.cells().cell(address.area, address.offset + k, 0);
    if (cell == index.cells().size()) return true;  // outside the CPU: another mistake
    const bool isBit = address.width == Width::Bit && length == 1 && !hasBitAndWord(address.area);
    if (!isBit) {
      if (!index.at(cell).empty() || index.mayBeRead(cell) || index.mayBeWritten(cell)) return true;
    } else if (facts.readers(cell, address.bit & 7) > 0 || facts.writers(cell, address.bit & 7) > 0 ||
               index.isReadAtLarge(cell) || index.isWrittenAtLarge(cell)) {
      return true;
    }
  }
  return false;
}

void checkSym003(const Facts& facts, FindingSink& sink) {
  if (facts.program().symbols.empty() || facts.hasHiddenCode()) return;
  std::unordered_set<std::string_view> used;
  for (const InstructionPlace& place : facts.instructions()) {
    for (const Operand& operand : place.instruction->operands) {
      if (!operand.text.empty() && operand.kind != OperandKind::Text) used.insert(operand.text);
    }
  }
  for (const Symbol& symbol : facts.program().symbols) {
    if (used.contains(symbol.name) || symbol.address.kind != OperandKind::Direct || symbol.address.area == Area::L)
      continue;
    if (addressIsUsed(facts, symbol.address)) continue;
    Finding& finding =
        sink.report(symbol.span, fmt::format("symbol {} ({}) is never used", symbol.name, toString(symbol.address)));
    finding.address = toString(symbol.address);
    finding.help = "remove the row, or find out which rung forgot it";
  }
}

}  // namespace

extern constexpr Rule sym003_unused_symbol = {
    .id = "SYM003",
    .title = "Unused symbol",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects = "a row of the symbol table whose name and address occur nowhere in the program",
    .why = "a stale row, or a signal that a rung forgot",
    .bad = "Network 1\nLD I0.0\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\n= Q0.1\n",
    .exampleSymbols = "Symbol\tAddress\tComment\nStart\tI0.0\tpush button\nPump\tQ0.1\tmain pump\n",
    .falsePositives = "rows kept for spare points or for an operator panel",
    .peers = "SA0033; CP24; plceye S0001",
    .surplus = true,
    .check = checkSym003,
};

}  // namespace rungproof
