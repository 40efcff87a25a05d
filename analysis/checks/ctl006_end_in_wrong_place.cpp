// CTL006: END, STOP, returns and block ends in the wrong place. Interrupt routines are INT001, segments SCR001.
// Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

std::string_view kindName(PouKind kind) {
  return kind == PouKind::Main         ? "the main program"
         : kind == PouKind::Subroutine ? "a subroutine"
                                       : "an interrupt routine";
}

/// Where a control instruction belongs, or nothing if it may stand anywhere.
std::optional<PouKind> homeOf(Control control) {
  switch (control) {
    case Control::End:
    case Control::MainEnd: return PouKind::Main;
    case Control::ReturnConditional:
    case Control::Return: return PouKind::Subroutine;
    case Control::InterruptReturnConditional:
    case Control::InterruptReturn: return PouKind::Interrupt;
    default: return std::nullopt;
  }
}

Control endOf(PouKind kind) {
  return kind == PouKind::Main         ? Control::MainEnd
         : kind == PouKind::Subroutine ? Control::Return
                                       : Control::InterruptReturn;
}
std::string_view endName(PouKind kind) {
  return kind == PouKind::Main ? "MEND" : kind == PouKind::Subroutine ? "RET" : "RETI";
}

void checkPlace(const Facts& facts, FindingSink& sink, const InstructionPlace& place) {
  const Instruction& instruction = *place.instruction;
  const Pou& pou = facts.program().pous[place.block];
  const Control control = instruction.desc->control;
  const std::optional<PouKind> home = homeOf(control);
  if (home && *home != pou.kind && !(control == Control::End && pou.kind == PouKind::Interrupt)) {
    Finding& finding =
        sink.report(instruction.span, fmt::format("{} belongs into {}, but {} is {}", instruction.desc->stl,
                                                  kindName(*home), pou.name, kindName(pou.kind)));
    finding.severity = Severity::Error;
    finding.help = pou.kind == PouKind::Subroutine  ? "use CRET in a subroutine (error 0088, 001:13990)"
                   : pou.kind == PouKind::Interrupt ? "use CRETI in an interrupt routine (error 0089, 001:13991)"
                                                    : "use END in the main program (error 0083, 001:13985)";
  }
  if (control == Control::Stop && (facts.stack().at(instruction.id).flow & condition::Always) != 0 &&
      facts.execution().at(instruction.id).isReachable && !facts.execution().at(instruction.id).isSkipped &&
      pou.kind == PouKind::Main) {
    sink.report(instruction.span, "STOP runs in the first scan, whatever the inputs are").help =
        "put the condition for the stop in front of it (001:5691)";
  }
}

/// In the one-text dialect every block ends with its own instruction.
void checkEnds(const Facts& facts, FindingSink& sink) {
  if (!facts.program().olderDialect) return;
  for (const Flow& flow : facts.plan().flows) {
    if (flow.steps.empty()) continue;
    const Instruction& last = *flow.steps.back().instruction;
    if (last.desc->control == endOf(flow.pou->kind)) continue;
    Finding& finding =
        sink.report(last.span, fmt::format("{} does not end with {}", flow.pou->name, endName(flow.pou->kind)));
    finding.help = fmt::format("add {} behind the last instruction of the block (errors 0083, 0088, 0089)",
                               endName(flow.pou->kind));
  }
}

void checkCtl006(const Facts& facts, FindingSink& sink) {
  const auto isControl = [](const Desc& desc) { return desc.control != Control::None; };
  for (const InstructionPlace& place : facts.placesOf(isControl)) checkPlace(facts, sink, place);
  checkEnds(facts, sink);
}

}  // namespace

extern constexpr Rule ctl006_end_in_wrong_place = {
    .id = "CTL006",
    .title = "END, STOP, RET in the wrong place",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "END outside the main program, CRET or CRETI in the wrong kind of block, STOP without a condition, a block of "
        "the older dialect "
        "without its end",
    .why =
        "the download is refused with error 0083, 0088 or 0089; an unconditional STOP ends the run in its first scan",
    .manual = "001:5689, 001:5691, 001:13985-13991",
    .bad = "Network 1\nLD I0.0\nCRET\nNetwork 2\nLD I0.1\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nEND\nNetwork 2\nLD I0.1\n= Q0.0\n",
    .peers = "CP14; CP19 (nearest)",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkCtl006,
};

}  // namespace rungproof
