// OUT007: a coil in code that is left out in some scans. One finding for each jump, step or block, at its first coil.
// Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include <unordered_map>
#include <vector>

#include "analysis/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

struct Group {
  const Instruction* coil;
  const Instruction* cause;  ///< nullptr: the calls of the block
  std::size_t count = 1;
};

std::string causeText(const Facts& facts, const Group& group) {
  if (group.cause == nullptr) return fmt::format("{} is not called in every scan", facts.pouOf(group.coil->id).name);
  switch (group.cause->desc->control) {
    case Control::Lscr: return fmt::format("it stands in the step {}", Facts::text(*group.cause));
    case Control::Jump: return fmt::format("{} may skip it", Facts::text(*group.cause));
    default: return fmt::format("{} may end the block before it", Facts::text(*group.cause));
  }
}

void checkOut007(const Facts& facts, FindingSink& sink) {
  std::vector<Group> groups;
  std::unordered_map<std::uint64_t, std::size_t> byCause;
  for (const InstructionPlace& place : facts.instructions()) {
    const Instruction& instruction = *place.instruction;
    if (!isCoil(kindOf(instruction)) || instruction.operands.empty() || instruction.operands[0].area == Area::L)
      continue;
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
  for (const Group& group : groups) {
    const std::string more = group.count == 1 ? std::string() : fmt::format(", with {} other coils", group.count - 1);
    Finding& finding =
        sink.report(group.coil->span, fmt::format("{} keeps its last value while the coil is left out{}: {}",
                                                  facts.name(group.coil->operands[0]), more, causeText(facts, group)));
    finding.address = toString(group.coil->operands[0]);
    if (group.cause != nullptr) finding.related.push_back({group.cause->span, "this decides whether the coil runs"});
    finding.help =
        "reset the bit where the code is left out, or drive it from code that always runs; what coils do in an "
        "inactive step is an open point of the manual";
  }
}

}  // namespace

extern constexpr Rule out007_coil_may_not_run = {
    .id = "OUT007",
    .title = "Coil in code that may not run",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects =
        "= inside a range that a jump may skip, in a subroutine called on a condition, behind a conditional return, or "
        "in an SCR segment",
    .why = "the bit freezes at its last value; what coils do in an inactive SCR segment is not in the manual text",
    .manual = "001:5782, 001:6735, 001:5830",
    .bad = "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.1\n= Q0.0\nNetwork 3\nLBL 1\n",
    .good = "Network 1\nLDN I0.0\nA I0.1\n= Q0.0\n",
    .falsePositives = "outputs that are meant to hold",
    .peers = "SA0022 (nearest)",
    .check = checkOut007,
};

}  // namespace rungproof
