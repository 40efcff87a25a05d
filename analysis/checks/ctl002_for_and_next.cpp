// CTL002: FOR without NEXT, NEXT without FOR, more than eight loops inside each other. The pairing is ir/flow.
// Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkCtl002(const Facts& facts, FindingSink& sink) {
  for (const Flow& flow : facts.plan().flows) {
    if (facts.hasUnreadCode(*flow.pou)) continue;  // what is missing may stand in a line that could not be read
    for (const FlowFault& fault : flow.faults) {
      const std::string text = Facts::text(*fault.instruction);
      switch (fault.problem) {
        case FlowProblem::ForWithoutNext:
          sink.report(fault.instruction->span, fmt::format("{} has no NEXT in {}", text, flow.pou->name)).help =
              "close the loop (error 0086, 001:13988)";
          break;
        case FlowProblem::NextWithoutFor:
          sink.report(fault.instruction->span, fmt::format("NEXT without FOR in {}", flow.pou->name)).help =
              "add the FOR or remove the NEXT (error 0085, 001:13987)";
          break;
        case FlowProblem::ForTooDeep:
          sink.report(fault.instruction->span,
                      fmt::format("{} is the ninth loop inside each other; eight are allowed", text))
              .help = "move the inner loops into a subroutine (001:5752; error 0093, 001:13999)";
          break;
        default: break;
      }
    }
  }
}

}  // namespace

extern constexpr Rule ctl002_for_and_next = {
    .id = "CTL002",
    .title = "FOR and NEXT do not match",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "FOR without NEXT, NEXT without FOR, loops nested deeper than 8",
    .why = "the download is refused with error 0085, 0086 or 0093",
    .manual = "001:5752, 001:13987-13999",
    .bad = "Network 1\nLD I0.0\nFOR VW0, +1, +10\nNetwork 2\nLD SM0.0\nINCW VW2\n",
    .good = "Network 1\nLD I0.0\nFOR VW0, +1, +10\nNetwork 2\nLD SM0.0\nINCW VW2\nNetwork 3\nNEXT\n",
    .peers = "Omron FOR-NEXT pairs and nesting",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkCtl002,
};

}  // namespace rungproof
