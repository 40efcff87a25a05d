// TIM013: edges that never come, and too many of them. Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

void checkTim013(const Facts& facts, FindingSink& sink) {
  const int limit = cpuFeatures(facts.target()).edges;
  int count = 0;
  const Instruction* numbered = nullptr;
  const Instruction* plain = nullptr;
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.role == Role::Eu || desc.role == Role::Ed; })) {
    const Instruction& instruction = *place.instruction;
    const Role role = roleOf(instruction);
    if (role != Role::Eu && role != Role::Ed) continue;
    (instruction.operands.empty() ? plain : numbered) = &instruction;
    if (++count == limit + 1) {
      sink.report(instruction.span, fmt::format("{} is edge number {}; a program has at most {} EU and ED together",
                                                instruction.desc->stl, count, limit))
          .help = "replace edges by a bit that remembers the last value (001:2668)";
    }
    const Condition flow = facts.stack().at(instruction.id).flow;
    const bool isFirst = (facts.conditionOf(instruction.id) & condition::FirstScan) != 0;
    if ((flow & condition::Always) == 0 && !(role == Role::Eu && isFirst)) continue;
    const std::string_view why = isFirst ? "no edge is seen in the first scan, and this value is 1 only there"
                                         : "the value before it is always 1";
    sink.report(instruction.span, fmt::format("{} never gives an edge: {}", instruction.desc->stl, why)).help =
        isFirst ? "leave the edge out: SM0.1 is a pulse of one scan already (001:2763)"
                : "take the edge of the signal that changes";
  }
  if (numbered != nullptr && plain != nullptr) {
    Finding& finding = sink.report(
        plain->span, fmt::format("{} has no number while other edges of the program have one", plain->desc->stl));
    finding.related.push_back({numbered->span, "an edge with a number"});
    finding.help = "number all edges or none (error 0097, 001:14002)";
  }
}

}  // namespace

extern constexpr Rule tim013_edge_lost = {
    .id = "TIM013",
    .title = "Edge that is lost",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "EU behind a condition that is true in the first scan only, EU or ED behind a constant, more than 256 edges, "
        "numbered and unnumbered "
        "edges mixed",
    .why = "no edge is seen in the first scan; a program has 256 edge memories; error 0097",
    .manual = "001:2763, 001:2668, 001:14002",
    .bad = "Network 1\nLD SM0.1\nEU\nS Q0.0, 1\nNetwork 2\nLD I0.0\nR Q0.0, 1\n",
    .good = "Network 1\nLD SM0.1\nS Q0.0, 1\nNetwork 2\nLD I0.0\nR Q0.0, 1\n",
    .dialects = dialect::S7200,
    .check = checkTim013,
};

}  // namespace rungproof
