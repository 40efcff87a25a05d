// TIM011: a 1 ms timer read at two places of the scan. Tested by its examples.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

void checkReads(const Facts& facts, FindingSink& sink, std::uint32_t number) {
  const std::uint32_t cell = facts.index().cells().cell(Area::T, number, 0);
  if (cell == facts.index().cells().size() || facts.timerBoxes(number).empty()) return;
  const Access* first = nullptr;
  for (const std::uint32_t i : facts.index().at(cell)) {
    const Access& access = facts.access(i);
    if (access.write || facts.pouOf(access.instruction).kind == PouKind::Interrupt) continue;
    if (first == nullptr) {
      first = &access;
      continue;
    }
    if (first->instruction == access.instruction) continue;
    const Instruction& instruction = facts.instruction(access.instruction);
    const Operand& operand = instruction.operands[access.operand];
    Finding& finding = sink.report(
        operand.span,
        fmt::format("{} is a 1 ms timer and read twice in a scan; the two reads may differ", facts.name(operand)));
    finding.address = toString(operand);
    finding.related.push_back({facts.instruction(first->instruction).span, "first read"});
    finding.help = "copy the bit or value once, or use a timer of 10 or 100 ms, which changes at one point of the scan";
    return;
  }
}

void checkTim011(const Facts& facts, FindingSink& sink) {
  for (std::uint32_t number = 0; number < 256; ++number) {
    if (timerResolution(static_cast<int>(number)) == 1) checkReads(facts, sink, number);
  }
}

}  // namespace

extern constexpr Rule tim011_fast_timer_read_twice = {
    .id = "TIM011",
    .title = "1 ms timer read twice in a scan",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects = "two reads of one 1 ms timer in the scan",
    .why = "bit and value of a 1 ms timer change asynchronously, also between two instructions",
    .manual = "001:6607",
    .bad = "Network 1\nLD I0.0\nTON T32, +100\nNetwork 2\nLD T32\n= Q0.0\nNetwork 3\nLDN T32\n= Q0.1\n",
    .good = "Network 1\nLD I0.0\nTON T32, +100\nNetwork 2\nLD T32\n= Q0.0\nNOT\n= Q0.1\n",
    .falsePositives = "reads that need not agree",
    .peers = "CP15 (nearest)",
    .dialects = dialect::S7200,
    .check = checkTim011,
};

}  // namespace rungproof
