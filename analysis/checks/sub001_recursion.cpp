// SUB001: a subroutine that reaches itself by a chain of calls. Tested by its examples and
// tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <deque>
#include <unordered_map>
#include <unordered_set>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Shortest chain of blocks from `from` back to `to`, both included.
std::vector<std::uint32_t> chain(const CallGraph& calls, std::uint32_t from, std::uint32_t to) {
  std::unordered_map<std::uint32_t, std::uint32_t> before{{from, from}};
  std::deque<std::uint32_t> open{from};
  while (!open.empty() && !before.contains(to)) {
    const std::uint32_t block = open.front();
    open.pop_front();
    for (const std::uint32_t s : calls.callsIn(block)) {
      const std::uint32_t callee = calls.sites()[s].callee;
      if (callee != noBlock && before.emplace(callee, block).second) open.push_back(callee);
    }
  }
  std::vector<std::uint32_t> path{to};
  while (path.back() != from && before.contains(path.back())) path.push_back(before[path.back()]);
  return {path.rbegin(), path.rend()};
}

void checkSub001(const Facts& facts, FindingSink& sink) {
  const CallGraph& calls = facts.calls();
  std::unordered_set<std::uint32_t> reported;
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    const std::optional<std::uint32_t> site = calls.recursionThrough(block);
    if (!site || reported.contains(block)) continue;
    const CallSite& call = calls.sites()[*site];
    std::string names = facts.program().pous[block].name;
    for (const std::uint32_t b : chain(calls, call.callee, block)) {
      names += " -> " + facts.program().pous[b].name;
      reported.insert(b);
    }
    reported.insert(block);
    Finding& finding = sink.report(call.instruction->span,
                                   fmt::format("{} calls itself: {}", facts.program().pous[block].name, names));
    finding.help = "use a loop; local memory and the levels of nesting are limited";
  }
}

}  // namespace

extern constexpr Rule sub001_recursion = {
    .id = "SUB001",
    .title = "Recursion",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "a subroutine that reaches itself by any chain of calls",
    .why =
        "allowed \"with care\", but each call takes a level of nesting and its own local memory, of which there is "
        "little: eight levels on the S7-200",
    .manual = "001:6744-6746",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nCALL SBR0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\nCALL SBR0\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nCALL SBR0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\n= Q0.1\nEND_SUBROUTINE_BLOCK\n",
    .peers = "SA0160; CP13; ironplc P4005; iec-checker CP13 (direct calls only)",
    .check = checkSub001,
};

}  // namespace rungproof
