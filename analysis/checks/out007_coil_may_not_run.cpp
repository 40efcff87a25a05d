// OUT007: a coil in code that is left out in some scans. One finding for each jump or block, at its first coil, and one
// for all the steps of a block.
// Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <vector>

#include "analysis/flow/skipped_code.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isCoilOfMemory(const Instruction& instruction) {
  return isCoil(roleOf(instruction)) && !instruction.operands.empty() && instruction.operands[0].area != Area::L;
}

constexpr std::size_t mostSteps = 8;  ///< that a finding about a chain names, or shows beside it

bool isCoilOfStep(const SkippedCode& coils) {
  return coils.cause != nullptr && coils.cause->desc->control == Control::Lscr;
}

/// The steps of one block are one chain, and one finding: each of them has coils.
void reportChain(const Facts& facts, const std::vector<SkippedCode>& steps, FindingSink& sink) {
  std::vector<std::string> named;
  for (const SkippedCode& step : steps) {
    if (named.size() < mostSteps)
      named.push_back(fmt::format("{} in {}{}", facts.name(step.first->operands[0]), Facts::text(*step.cause),
                                  step.count == 1 ? "" : fmt::format(" and {} more", step.count - 1)));
  }
  if (steps.size() > named.size()) named.push_back(fmt::format("{} more steps", steps.size() - named.size()));
  Finding& finding =
      sink.report(steps.front().first->span,
                  fmt::format("the coils of {} steps keep their last value while their step is not active: {}",
                              steps.size(), fmt::join(named, ", ")));
  finding.address = toString(steps.front().first->operands[0]);
  for (const SkippedCode& step : steps) {
    if (finding.related.size() < mostSteps) finding.related.push_back({step.cause->span, "this step decides"});
  }
  finding.help =
      "reset the bits where the step is left, or drive them from code that always runs; what coils do in an inactive "
      "step is an open point of the manual";
}

void reportOne(const Facts& facts, const SkippedCode& coils, FindingSink& sink) {
  const Operand& coil = coils.first->operands[0];
  const std::string more = coils.count == 1 ? std::string() : fmt::format(", with {} other coils", coils.count - 1);
  Finding& finding =
      sink.report(coils.first->span, fmt::format("{} keeps its last value while the coil is left out{}: {}",
                                                 facts.name(coil), more, causeText(facts, coils)));
  finding.address = toString(coil);
  if (coils.cause != nullptr) finding.related.push_back({coils.cause->span, "this decides whether the coil runs"});
  finding.help =
      "reset the bit where the code is left out, or drive it from code that always runs; what coils do in an "
      "inactive step is an open point of the manual";
}

void checkOut007(const Facts& facts, FindingSink& sink) {
  const std::vector<SkippedCode> all = skippedCode(facts, isCoilOfMemory);
  std::map<std::uint32_t, std::vector<SkippedCode>> chains;  // by block
  for (const SkippedCode& coils : all) {
    if (isCoilOfStep(coils)) chains[facts.blockOf(coils.first->id)].push_back(coils);
  }
  for (const SkippedCode& coils : all) {
    if (!isCoilOfStep(coils)) reportOne(facts, coils, sink);
  }
  for (const auto& [block, steps] : chains) {
    if (steps.size() == 1)
      reportOne(facts, steps.front(), sink);
    else
      reportChain(facts, steps, sink);
  }
}

/// A jump or a return that never comes to pass.
constexpr Explanation out007Explained[] = {{"LOG001", Where::RelatedPlace, powerReaches}};

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
    .dialects = dialect::S7200,
    .check = checkOut007,
    .explainedBy = out007Explained,
};

}  // namespace rungproof
