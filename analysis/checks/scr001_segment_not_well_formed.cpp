// SCR001: LSCR without SCRE and the reverse, END or a second LSCR inside a segment, SCRT outside, SCRT to a step
// without a segment. A step bit that contacts read is a dummy step of a convergence and needs no segment
// (001:5865-5872). Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <unordered_set>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkFault(FindingSink& sink, const FlowFault& fault) {
  const std::string text = Facts::text(*fault.instruction);
  const Span span = fault.instruction->span;
  switch (fault.problem) {
    case FlowProblem::LscrWithoutScre:
      sink.report(span, fmt::format("{} has no SCRE", text)).help = "end the segment by SCRE (error 0096, 001:14001)";
      break;
    case FlowProblem::ScreWithoutLscr:
      sink.report(span, fmt::format("{} ends no segment", text)).help =
          "begin the segment by LSCR (error 0095, 001:14000)";
      break;
    case FlowProblem::LscrInsideSegment:
      sink.report(span, fmt::format("{} stands inside another segment", text)).help =
          "end the segment before by SCRE; segments do not nest";
      break;
    case FlowProblem::ScrtOutsideSegment:
      sink.report(span, fmt::format("{} stands outside any segment", text)).help =
          "transitions and CSCRE belong between LSCR and SCRE (error 0095)";
      break;
    case FlowProblem::EndInsideSegment:
      sink.report(span, "END stands inside a segment").help = "put END outside the segments (001:5819; error 0096)";
      break;
    default: break;
  }
}

void checkScr001(const Facts& facts, FindingSink& sink) {
  std::unordered_set<std::uint32_t> segments;
  for (const InstructionPlace& place : facts.placesOf([](const Desc& desc) { return desc.control == Control::Lscr; })) {
    const Instruction& instruction = *place.instruction;
    if (instruction.desc->control != Control::Lscr || instruction.operands.empty()) continue;
    segments.insert(bitKey(Area::S, instruction.operands[0].offset, instruction.operands[0].bit));
  }
  for (const Flow& flow : facts.plan().flows) {
    if (facts.hasUnreadCode(*flow.pou)) continue;  // what is missing may stand in a line that could not be read
    for (const FlowFault& fault : flow.faults) checkFault(sink, fault);
    if (facts.hasHiddenCode()) continue;
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      if (instruction.desc->control != Control::Scrt || instruction.operands.empty() ||
          instruction.operands[0].kind != OperandKind::Direct)
        continue;
      const Operand& target = instruction.operands[0];
      if (segments.contains(bitKey(Area::S, target.offset, target.bit))) continue;
      const std::uint32_t cell = facts.index().cells().cell(Area::S, target.offset, 0);
      const bool isDummy = cell != facts.index().cells().size() && target.bit < 8 &&
                           (facts.readers(cell, target.bit) > 0 || facts.index().isReadAtLarge(cell));
      if (isDummy) continue;
      Finding& finding =
          sink.report(instruction.span, fmt::format("{} goes to a step that has no segment", Facts::text(instruction)));
      finding.refused = false;  // the step bit is set, and nothing follows
      finding.address = toString(target);
      finding.help = fmt::format("add the segment LSCR {}, or correct the number", toString(target));
    }
  }
}

}  // namespace

extern constexpr Rule scr001_segment_not_well_formed = {
    .id = "SCR001",
    .title = "SCR segment not well formed",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "LSCR without SCRE, SCRE without LSCR, a segment or END inside a segment, SCRT or CSCRE outside, SCRT to a "
        "step that has no segment",
    .why = "the download is refused with error 0095 or 0096, or the sequence ends in nothing",
    .manual = "001:5819, 001:5830, 001:14000-14001",
    .bad = "Network 1\nLD SM0.1\nS S0.0, 1\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD I0.0\nSCRT S0.1\nNetwork 4\nSCRE\n",
    .good =
        "Network 1\nLD SM0.1\nS S0.0, 1\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD I0.0\nSCRT S0.1\nNetwork 4\nSCRE\n"
        "Network 5\nLSCR S0.1\nNetwork 6\nLD I0.1\nSCRT S0.0\nNetwork 7\nSCRE\n",
    .peers = "Omron STEP-SNXT; ironplc P0008 (no initial step)",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkScr001,
};

}  // namespace rungproof
