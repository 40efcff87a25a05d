// STK002: a network uses a stack level that it did not load. A called block starts with 1 on the stack (001:6765),
// LSCR and NEXT put a value there themselves; these are no findings. The run is analysis/stack_depth.
// Tested by its examples and tests/rules/stack_depth_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkStk002(const Facts& facts, FindingSink& sink) {
  for (const StackFault& fault : facts.stack().faults()) {
    if (fault.kind != StackFaultKind::FromBelow) continue;
    const std::string text = Facts::text(*fault.instruction);
    if (fault.other == nullptr) {
      Finding& finding =
          sink.report(fault.instruction->span, fmt::format("{} uses a stack level that nothing has loaded", text));
      finding.help = "begin the network with a load such as LD";
      continue;
    }
    if (facts.isUnread(fault.other->id)) continue;  // the unread line may have taken it
    Finding& finding =
        sink.report(fault.instruction->span,
                    fmt::format("{} uses a value that its network did not load; it comes from {} in network {}", text,
                                Facts::text(*fault.other), facts.networkOf(fault.other->id).number));
    finding.related.push_back({fault.other->span, "the value on the stack was made here"});
    finding.help =
        "begin the network with a load such as LD SM0.0; if the network is meant to go on where the other ended, join "
        "the two";
  }
}

}  // namespace

extern constexpr Rule stk002_value_from_below = {
    .id = "STK002",
    .title = "Value taken from below",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a contact, coil, box or stack operation in a network that did not load its operand itself, so that the value "
        "comes from an earlier "
        "network",
    .why = "legal in STL, where a network is only a divider, and almost always a missing LD",
    .manual = "001:2232, 001:6765",
    .bad = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nA I0.1\n= Q0.1\n",
    .good = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n",
    .falsePositives = "a rung that was cut into two networks on purpose",
    .dialects = dialect::S7200,
    .ofLists = true,
    .check = checkStk002,
};

}  // namespace rungproof
