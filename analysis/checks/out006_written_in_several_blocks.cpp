// OUT006: one place of memory written in two blocks. Writes in the first scan only are initialisation; a flag that an
// interrupt routine sets and another block resets (or the reverse) is a handshake; both are no findings.
// Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include <unordered_set>

#include "analysis/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool counts(const Facts& facts, const Access& access) {
  if (!access.write || access.maybe || access.operand == impliedOperand || access.isBox) return false;
  if (access.area != Area::Q && access.area != Area::V && access.area != Area::M && access.area != Area::AQ)
    return false;
  const Execution execution = facts.instruction(access.instruction).desc->execution;
  if (execution == Execution::Control && facts.instruction(access.instruction).desc->control != Control::Call)
    return false;
  return (facts.conditionOf(access.instruction) & condition::FirstScan) == 0;
}

bool isInterrupt(const Facts& facts, const Access& access) {
  return facts.pouOf(access.instruction).kind == PouKind::Interrupt;
}

bool isHandshake(const Facts& facts, const Access& a, const Access& b) {
  if (isInterrupt(facts, a) == isInterrupt(facts, b) || a.width != Width::Bit || b.width != Width::Bit) return false;
  const Kind x = kindOf(facts.instruction(a.instruction)), y = kindOf(facts.instruction(b.instruction));
  return (isSet(x) && isReset(y)) || (isReset(x) && isSet(y));
}

bool bitsMeet(const Access& a, const Access& b, std::uint32_t offset) {
  const auto covers = [&](const Access& access, unsigned bit) {
    if (access.width != Width::Bit) return true;
    const std::uint32_t from = access.offset * 8 + access.bit, at = offset * 8 + bit;
    return at >= from && at < from + access.count;
  };
  for (unsigned bit = 0; bit < 8; ++bit) {
    if (covers(a, bit) && covers(b, bit)) return true;
  }
  return false;
}

void checkOut006(const Facts& facts, FindingSink& sink) {
  std::unordered_set<std::uint64_t> seen;
  const CellMap& cells = facts.index().cells();
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const Access* first = nullptr;
    for (const std::uint32_t i : facts.index().at(cell)) {
      const Access& access = facts.access(i);
      if (!counts(facts, access)) continue;
      if (first == nullptr) {
        first = &access;
        continue;
      }
      if (facts.blockOf(first->instruction) == facts.blockOf(access.instruction)) continue;
      if (!bitsMeet(*first, access, cells.offsetOf(cell)) || isHandshake(facts, *first, access)) continue;
      const std::uint64_t key =
          static_cast<std::uint64_t>(first->instruction) << 32 | facts.blockOf(access.instruction);
      if (!seen.insert(key).second) continue;
      const Instruction& instruction = facts.instruction(access.instruction);
      const std::string place = toString(instruction.operands[access.operand]);
      const std::string_view when = isInterrupt(facts, *first) != isInterrupt(facts, access)
                                        ? "; the interrupt can come at any point of the scan"
                                        : "";
      Finding& finding =
          sink.report(instruction.operands[access.operand].span,
                      fmt::format("{} is written in {} and in {}{}", facts.name(instruction.operands[access.operand]),
                                  facts.pouOf(first->instruction).name, facts.pouOf(access.instruction).name, when));
      finding.address = place;
      finding.related.push_back({facts.instruction(first->instruction).span,
                                 fmt::format("{} writes it here", facts.pouOf(first->instruction).name)});
      finding.help = "let one block own the place, and give the others a request bit";
    }
  }
}

}  // namespace

extern constexpr Rule out006_written_in_several_blocks = {
    .id = "OUT006",
    .title = "Written from several places of the program",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "one bit or word written in two blocks, or in a block of the scan and in an interrupt routine",
    .why = "the order of the calls decides which value stays, and interrupts come anywhere in the scan",
    .manual = "001:2084, 001:5434-5440",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nCALL SBR0\nNetwork 2\nLD I0.1\n= "
        "Q0.0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.2\n= Q0.0\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nCALL SBR0\nNetwork 2\nLD I0.1\nO M0.0\n= "
        "Q0.0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.2\n= M0.0\nEND_SUBROUTINE_BLOCK\n",
    .falsePositives = "blocks of which only one is called, such as one for each operating mode",
    .peers = "SA0006; CP10; CP26; Frama-PLC common outputs of two tasks",
    .check = checkOut006,
};

}  // namespace rungproof
