// STK003: LPS, LRD and LPP that do not belong together, and loads that nothing uses. The run is
// analysis/stack_depth. Tested by its examples and tests/rules/stack_depth_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkStk003(const Facts& facts, FindingSink& sink) {
  for (const StackFault& fault : facts.stack().faults()) {
    const std::string text = Facts::text(*fault.instruction);
    switch (fault.kind) {
      case StackFaultKind::LrdWithoutLps:
      case StackFaultKind::LppWithoutLps:
        sink.report(fault.instruction->span, fmt::format("{} without an LPS before it", text)).help =
            "add the LPS where the branch begins, or remove the instruction";
        break;
      case StackFaultKind::LpsNotPopped:
        sink.report(fault.instruction->span,
                    "LPS is not followed by its LPP in this network; the level stays on the stack")
            .help = "end the last branch with LPP instead of LRD";
        break;
      case StackFaultKind::Covered: {
        Finding& finding =
            sink.report(fault.instruction->span,
                        fmt::format("{} finds the value of {} on the stack instead of the one that LPS saved", text,
                                    fault.other == nullptr ? "another load" : Facts::text(*fault.other)));
        if (fault.other != nullptr)
          finding.related.push_back({fault.other->span, "this level was pushed after the LPS and is still there"});
        finding.help = "join the load with ALD or OLD before the branch ends";
        break;
      }
      case StackFaultKind::LoadUnused:
        sink.report(fault.instruction->span, fmt::format("nothing uses the result of {}", text)).help =
            "add the ALD or OLD that joins it, or the coil that it was meant for";
        break;
      default: break;
    }
  }
}

}  // namespace

extern constexpr Rule stk003_branches_unbalanced = {
    .id = "STK003",
    .title = "LPS/LRD/LPP unbalanced",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "LRD or LPP without LPS, LPS never popped at the end of its network, a branch that ends over an unjoined load, "
        "a loaded value that "
        "nothing uses",
    .why = "leftover levels shift every later result",
    .manual = "001:2838-2849",
    .bad = "Network 1\nLD I0.0\nLPS\nA I0.1\n= Q0.0\nLRD\nA I0.2\n= Q0.1\n",
    .good = "Network 1\nLD I0.0\nLPS\nA I0.1\n= Q0.0\nLPP\nA I0.2\n= Q0.1\n",
    .dialects = dialect::S7200,
    .ofLists = true,
    .check = checkStk003,
};

}  // namespace rungproof
