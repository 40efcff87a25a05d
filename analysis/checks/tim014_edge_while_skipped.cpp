// TIM014: EU or ED, FP or FN in code that is left out in some scans. The detector remembers the value of its last run,
// not of the last scan: a change that comes while the code is left out is seen late, or not at all. One finding for
// each jump, step or block, at its first detector. Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/skipped_code.hpp"
#include "analysis/rule.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

bool isEdgeDetector(const Instruction& instruction) {
  return isEdge(roleOf(instruction)) || statementRole(instruction) == StatementRole::Edge;
}

void checkTim014(const Facts& facts, FindingSink& sink) {
  for (const SkippedCode& edges : skippedCode(facts, isEdgeDetector)) {
    const std::string more =
        edges.count == 1 ? std::string() : fmt::format(", with {} other detectors", edges.count - 1);
    Finding& finding = sink.report(
        edges.first->span,
        fmt::format("{} compares with its last run, so an edge is lost or seen late while it is left out{}: {}",
                    edges.first->desc->stl, more, causeText(facts, edges)));
    if (edges.cause != nullptr)
      finding.related.push_back({edges.cause->span, "this decides whether the detector runs"});
    finding.help = "detect the edge where every scan comes by, keep it in a bit, and use the bit here";
  }
}

/// A jump or a return that never comes to pass.
constexpr Explanation tim014Explained[] = {{"LOG001", Where::RelatedPlace, powerReaches}};

}  // namespace

extern constexpr Rule tim014_edge_while_skipped = {
    .id = "TIM014",
    .title = "Edge detector that may be skipped",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects =
        "EU, ED, FP or FN inside a range that a jump may skip, in a subroutine called on a condition, behind a "
        "conditional "
        "return, or in an SCR segment",
    .why =
        "the detector compares with the value of its last run: what changes while it is left out counts as an edge "
        "later, or never",
    .manual = "001:2763, 001:5782, 001:6735",
    .bad =
        "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.1\nEU\nS Q0.0, 1\nNetwork 3\nLBL 1\nNetwork 4\nLD I0.2\nR Q0.0, "
        "1\n",
    .good =
        "Network 1\nLD I0.1\nEU\n= M0.0\nNetwork 2\nLD I0.0\nJMP 1\nNetwork 3\nLD M0.0\nS Q0.0, 1\nNetwork 4\nLBL "
        "1\nNetwork 5\nLD I0.2\nR Q0.0, 1\n",
    .falsePositives = "signals that do not change while the code is left out",
    .peers = "none has it",
    .check = checkTim014,
    .explainedBy = tim014Explained,
};

}  // namespace rungproof
