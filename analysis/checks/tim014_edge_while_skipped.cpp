// TIM014: EU or ED in code that is left out in some scans. The detector remembers the value of its last run, not of the
// last scan: a change that comes while the code is left out is seen late, or not at all. One finding for each jump,
// step or block, at its first detector. Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include <unordered_map>
#include <vector>

#include "analysis/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

struct SkippedEdges {
  const Instruction* edge;
  const Instruction* cause;  ///< nullptr: the calls of the block
  std::size_t count = 1;
};

std::string skipText(const Facts& facts, const SkippedEdges& group) {
  if (group.cause == nullptr) return fmt::format("{} is not called in every scan", facts.pouOf(group.edge->id).name);
  switch (group.cause->desc->control) {
    case Control::Lscr: return fmt::format("it stands in the step {}", Facts::text(*group.cause));
    case Control::Jump: return fmt::format("{} may skip it", Facts::text(*group.cause));
    default: return fmt::format("{} may end the block before it", Facts::text(*group.cause));
  }
}

void checkTim014(const Facts& facts, FindingSink& sink) {
  std::vector<SkippedEdges> groups;
  std::unordered_map<std::uint64_t, std::size_t> byCause;
  for (const InstructionPlace& place : facts.instructions()) {
    const Instruction& instruction = *place.instruction;
    if (instruction.desc->stl != "EU" && instruction.desc->stl != "ED") continue;
    const Instruction* cause = facts.execution().at(instruction.id).skippedBy;
    if (cause != nullptr && cause->desc->control == Control::For) continue;
    const bool isConditionalBlock = facts.program().pous[place.block].kind == PouKind::Subroutine &&
                                    facts.execution().runs(place.block) == Runs::AtMostOnce;
    if (cause == nullptr && !isConditionalBlock) continue;
    const std::uint64_t key = cause != nullptr ? std::uint64_t{cause->id} : (std::uint64_t{1} << 40) + place.block;
    const auto [found, isNew] = byCause.emplace(key, groups.size());
    if (isNew)
      groups.push_back({&instruction, cause});
    else
      ++groups[found->second].count;
  }
  for (const SkippedEdges& group : groups) {
    const std::string more =
        group.count == 1 ? std::string() : fmt::format(", with {} other detectors", group.count - 1);
    Finding& finding = sink.report(
        group.edge->span,
        fmt::format("{} compares with its last run, so an edge is lost or seen late while it is left out{}: {}",
                    group.edge->desc->stl, more, skipText(facts, group)));
    if (group.cause != nullptr)
      finding.related.push_back({group.cause->span, "this decides whether the detector runs"});
    finding.help = "detect the edge where every scan comes by, keep it in a bit, and use the bit here";
  }
}

}  // namespace

extern constexpr Rule tim014_edge_while_skipped = {
    .id = "TIM014",
    .title = "Edge detector that may be skipped",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects =
        "EU or ED inside a range that a jump may skip, in a subroutine called on a condition, behind a conditional "
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
};

}  // namespace rungproof
