// SUB006: an edge, timer or counter in a subroutine that is called several times in a scan. Calls that exclude each
// other by the text (exclusion.hpp) are one call; where that stays open the finding is a warning. Tested by its
// examples, tests/rules/control_rules_test.cpp and tests/rules/exclusion_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/exclusion.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool keepsState(Role role) { return role == Role::Eu || role == Role::Ed || isTimerBox(role) || isCounterBox(role); }

/// Whether two calls of the block certainly run in one scan.
bool isCertain(const Facts& facts, std::uint32_t block) {
  int certain = 0;
  for (const std::uint32_t s : facts.calls().callsOf(block)) {
    const CallSite& site = facts.calls().sites()[s];
    const std::uint32_t id = site.instruction->id;
    const bool isAlways = (facts.stack().at(id).flow & condition::Always) != 0 && !facts.execution().at(id).isSkipped;
    const Runs runs = facts.execution().runs(site.caller);
    if (isAlways && facts.execution().at(id).isReachable && (runs == Runs::Once || runs == Runs::Several))
      certain += facts.execution().at(id).inLoop ? 2 : 1;
  }
  return certain >= 2;
}

/// Whether of any two calls of the block the text lets one run at a time, and each runs once.
bool areTurns(const Facts& facts, Exclusion& exclusion, std::uint32_t block) {
  std::vector<std::uint32_t> ways;
  for (const std::uint32_t s : facts.calls().callsOf(block)) {
    const CallSite& site = facts.calls().sites()[s];
    if (facts.execution().at(site.instruction->id).inLoop || facts.calls().reachedFromInterrupt(site.caller) ||
        facts.execution().runs(site.caller) == Runs::Several)
      return false;
    ways.push_back(exclusion.waysTo(site.instruction->id));
  }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    for (std::size_t k = i + 1; k < ways.size(); ++k) {
      if (!exclusion.exclude(ways[i], ways[k])) return false;
    }
  }
  return true;
}

void checkSub006(const Facts& facts, FindingSink& sink) {
  std::optional<Exclusion> exclusion;
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    if (facts.program().pous[block].kind != PouKind::Subroutine || facts.execution().runs(block) != Runs::Several)
      continue;
    if (!exclusion) exclusion.emplace(facts);
    if (areTurns(facts, *exclusion, block)) continue;
    const bool isSure = isCertain(facts, block);
    for (const FlowStep& step : facts.plan().flows[block].steps) {
      const Instruction& instruction = *step.instruction;
      if (!keepsState(roleOf(instruction))) continue;
      Finding& finding = sink.report(
          instruction.span, fmt::format("{} stands in {}, which is called {} in a scan; all calls share its state",
                                        Facts::text(instruction), facts.program().pous[block].name,
                                        isSure ? "more than once" : "from several places"));
      int calls = 0;
      for (const std::uint32_t s : facts.calls().callsOf(block)) {
        if (++calls <= 4)
          finding.related.push_back({facts.calls().sites()[s].instruction->span, "a call of the block"});
      }
      if (!isSure) {
        finding.severity = Severity::Warning;
        finding.confirmation = Confirmation::Unconfirmed;
      }
      finding.help = "write a copy of the block for each use, or do the edge, timer or counter outside it (001:6771)";
    }
  }
}

}  // namespace

extern constexpr Rule sub006_box_in_shared_routine = {
    .id = "SUB006",
    .title = "Timer, counter or edge in a routine called twice",
    .severity = Severity::Error,
    .needs = Needs::Flow,
    .detects = "EU, ED, a timer or a counter in a subroutine that is called more than once in a scan",
    .why = "the manual forbids it: the box has one memory for all calls, so each call sees what the other left",
    .manual = "001:6771",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0\nCALL SBR0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.0\nEU\n= Q0.0\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.0\nEU\n= Q0.0\nEND_SUBROUTINE_BLOCK\n",
    .falsePositives =
        "calls on conditions that exclude each other in a way that the text does not show: reported as an unconfirmed "
        "warning",
    .peers = "SA0105 (nearest)",
    .dialects = dialect::S7200,
    .check = checkSub006,
};

}  // namespace rungproof
