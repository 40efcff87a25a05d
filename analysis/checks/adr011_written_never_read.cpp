// ADR011: a value that is stored and never used. Reads by pointers, block operations, parameters and `external` lines
// count. Outputs and special memory act by themselves and are left out. Tested by tests/rules/address_rules_test.cpp.
#include <fmt/format.h>

#include <unordered_set>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isStorage(Area area) { return isMemoryArea(area) || area == Area::L || hasBitAndWord(area); }

bool isRead(const Facts& facts, const Access& access) {
  const CellMap& cells = facts.index().cells();
  const std::uint32_t start = facts.cellOf(access);
  if (start == cells.size()) return true;  // ADR001 speaks
  for (std::uint32_t k = 0; k < access.certainLength(); ++k) {
    const std::uint32_t cell = start + k;
    if (cell >= cells.size() || facts.index().isReadAtLarge(cell) || facts.isExternal(cell)) return true;
    const bool isBits = access.width == Width::Bit && !access.byNumber();
    const unsigned low = isBits && k == 0 ? access.bit : 0;
    const unsigned high = isBits && k + 1 == access.certainLength() ? (access.bit + access.count - 1U) % 8 : 7;
    for (unsigned bit = low; bit <= high; ++bit) {
      if (facts.readers(cell, bit) > 0) return true;
    }
  }
  return false;
}

/// OUT and IN_OUT parameters of the block are read by its callers.
bool isParameter(const Facts& facts, const Access& access) {
  if (access.area != Area::L) return false;
  for (const LocalVariable& local : facts.pouOf(access.instruction).locals) {
    if (local.section != VarSection::Output && local.section != VarSection::InOut) continue;
    const std::uint32_t end = local.address.offset + static_cast<std::uint32_t>(bytes(local.address.width));
    if (access.offset < end && access.offset + access.certainLength() > local.address.offset) return true;
  }
  return false;
}

/// T32 and T96 may be used by their interrupt events alone (001:5476).
bool hasEvent(const Facts& facts, const Access& access) {
  if (access.area != Area::T || (access.offset != 32 && access.offset != 96)) return false;
  for (const Attachment& a : facts.calls().attachments()) {
    if (a.event == (access.offset == 32 ? 21 : 22)) return true;
  }
  return false;
}

void checkAdr011(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode()) return;
  std::unordered_set<std::uint64_t> seen;
  for (const Access& access : facts.accesses().all()) {
    if (!access.write || access.maybe || access.viaPointer || access.operand == impliedOperand || access.bit > 7)
      continue;
    if (!isStorage(access.area) || (access.byNumber() && !access.isBox)) continue;
    if (access.most > access.count || isParameter(facts, access)) continue;
    // Each output of a library block needs a place, whether the program wants it or not.
    if (facts.contracts().of(facts.instruction(access.instruction)) != nullptr) continue;
    const std::uint64_t key = static_cast<std::uint64_t>(facts.cellOf(access)) << 8 |
                              static_cast<std::uint64_t>(access.isBox ? Width::Bit : access.width) << 4 | access.bit;
    if (!seen.insert(key).second || isRead(facts, access) || hasEvent(facts, access)) continue;
    const Instruction& instruction = facts.instruction(access.instruction);
    const Operand& operand = instruction.operands[access.operand];
    const std::string text =
        access.isBox ? fmt::format("neither the bit nor the value of {} is used anywhere", facts.name(operand))
                     : fmt::format("{} writes {}, which nothing reads", Facts::text(instruction),
                                   access.count > 1 ? accessRange(access) : facts.name(operand));
    Finding& finding = sink.report(operand.span, text);
    finding.address = toString(operand);
    finding.help =
        access.isBox
            ? "remove the box, or correct the number"
            : fmt::format("correct the address or remove the write; if a panel reads it, say so with //@ external {}",
                          toString(operand));
  }
}

}  // namespace

extern constexpr Rule adr011_written_never_read = {
    .id = "ADR011",
    .title = "Written but never read",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects =
        "a V, M, S or L address, a timer or a counter that is written or run although nothing reads it and it is not "
        "declared external",
    .why = "dead memory, and usually the other end of an address that was mistyped",
    .bad = "Network 1\nLD I0.0\n= M5.0\n",
    .good = "Network 1\nLD I0.0\n= M5.0\nNetwork 2\nLD M5.0\n= Q0.0\n",
    .falsePositives = "values for an operator panel or a network partner: declare them with //@ external VB100..VB199",
    .peers = "SA0033; CP24",
    .dialects = dialect::S7200,
    .surplus = true,
    .check = checkAdr011,
};

}  // namespace rungproof
