// STK004: a box that takes its inputs from the stack finds too few or too many. Counters take reset or load from the
// top and the count inputs below it. The run is analysis/stack_depth. Tested by tests/rules/stack_depth_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Inputs in the order of the loads.
std::string_view inputsOf(const Instruction& instruction) {
  switch (roleOf(instruction)) {
    case Role::Ctu: return "count up, reset";
    case Role::Ctd: return "count down, load";
    case Role::Ctud: return "count up, count down, reset";
    case Role::Sr: return "set, reset";
    case Role::Rs: return "set, reset";
    default: return "";
  }
}

std::string orderText(const Instruction& instruction) {
  const std::string_view inputs = inputsOf(instruction);
  return inputs.empty() ? "load one level for each input of the box"
                        : fmt::format("load in this order: {} (001:3994-4004)", inputs);
}

void checkStk004(const Facts& facts, FindingSink& sink) {
  for (const StackFault& fault : facts.stack().faults()) {
    if (fault.kind == StackFaultKind::TooFewInputs) {
      Finding& finding =
          sink.report(fault.instruction->span, fmt::format("{} takes {} stack levels, its network loads {}",
                                                           Facts::text(*fault.instruction), fault.needed, fault.found));
      finding.help = orderText(*fault.instruction);
    } else if (fault.kind == StackFaultKind::TooManyInputs) {
      Finding& finding = sink.report(fault.instruction->span,
                                     fmt::format("{} takes {} stack levels, but another unused level lies below them",
                                                 Facts::text(*fault.instruction), fault.needed));
      if (fault.other != nullptr)
        finding.related.push_back(
            {fault.other->span, fmt::format("{} is not an input of the box", Facts::text(*fault.other))});
      finding.help = orderText(*fault.instruction);
      finding.refused = false;  // the box works; the level below is left over
    }
  }
}

}  // namespace

extern constexpr Rule stk004_box_inputs = {
    .id = "STK004",
    .title = "Wrong number of box inputs",
    .severity = Severity::Error,
    .needs = Needs::Flow,
    .detects = "a counter, bistable or similar box fed with too few or too many stack levels",
    .why =
        "CTU and CTD take reset or load from the top of the stack and the count input from the second level; a missing "
        "LD shifts them",
    .manual = "001:3994-4004, 000:3378-3381",
    .bad = "Network 1\nLD I0.0\nCTU C1, +10\n",
    .good = "Network 1\nLD I0.0\nLD I0.1\nCTU C1, +10\n",
    .dialects = dialect::S7200,
    .ofLists = true,
    .refuses = true,
    .check = checkStk004,
};

}  // namespace rungproof
