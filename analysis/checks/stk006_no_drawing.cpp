// STK006: a network that exists in STL only: a second rung, a value from another network, LDS, a call with plain bits
// for its power flow inputs (001:6808). The older dialect knows no networks and is left out.
// Tested by its examples and tests/rules/stack_depth_test.cpp.
#include <fmt/format.h>

#include "analysis/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void report(FindingSink& sink, const Instruction& instruction, std::string message, std::string_view help) {
  sink.report(instruction.span, std::move(message)).help = std::string(help);
}

void check(const Facts& facts, FindingSink& sink) {
  if (facts.program().olderDialect) return;
  for (const StackFault& fault : facts.stack().faults()) {
    if (fault.kind != StackFaultKind::SecondRung) continue;
    Finding& finding =
        sink.report(fault.instruction->span,
                    fmt::format("{} belongs to a second rung in this network; LAD and FBD show one circuit per network",
                                Facts::text(*fault.instruction)));
    if (fault.other != nullptr) finding.related.push_back({fault.other->span, "the first rung"});
    finding.help = "begin a new network here";
  }
  for (const InstructionPlace& place : facts.instructions()) {
    if (kindOf(*place.instruction) == Kind::Lds) {
      report(sink, *place.instruction, fmt::format("{} has no picture in LAD or FBD", Facts::text(*place.instruction)),
             "use LPS and LPP");
    }
  }
}

}  // namespace

extern constexpr Rule stk006_no_drawing = {
    .id = "STK006",
    .title = "Cannot be shown as LAD or FBD",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects = "two rungs in one network, or a stack operation that no drawing has",
    .why = "a network of a drawing is one closed circuit; the editor can show such a network as STL only",
    .manual = "001:2230-2232",
    .bad = "Network 1\nLD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\n",
    .good = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n",
    .falsePositives = "programs that are kept as STL on purpose",
    .dialects = dialect::S7200,
    .check = check,
};

}  // namespace rungproof
