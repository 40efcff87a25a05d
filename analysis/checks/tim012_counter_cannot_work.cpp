// TIM012: a counter whose reset or load input is constant, or whose count input can never rise. What needs the values
// of the run is the prover's. Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool hasOwnReset(const Facts& facts, std::uint32_t number) {
  const std::uint32_t cell = facts.index().cells().cell(Area::C, number, 0);
  if (cell == facts.index().cells().size() || facts.index().isWrittenAtLarge(cell)) return true;
  const std::span<const std::uint32_t> accesses = facts.index().at(cell);
  return std::any_of(accesses.begin(), accesses.end(),
                     [&](std::uint32_t i) { return facts.access(i).write && !facts.access(i).isBox; });
}

void checkTim012(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place : facts.instructions()) {
    const Instruction& instruction = *place.instruction;
    const Role role = roleOf(instruction);
    const std::span<const Condition> inputs = facts.stack().inputs(instruction.id);
    if (!isCounterBox(role) || inputs.size() < 2 || instruction.operands.empty()) continue;
    const std::string name = facts.name(instruction.operands[0]);
    const auto report = [&](std::string message, std::string_view help) {
      Finding& finding = sink.report(instruction.span, std::move(message));
      finding.address = toString(instruction.operands[0]);
      finding.confirmation = Confirmation::NotNeeded;
      finding.help = std::string(help);
    };
    const std::string_view top = role == Role::Ctd ? "load" : "reset";
    if ((inputs[0] & condition::Always) != 0) {
      report(fmt::format("the {} input of {} is always on, so it never counts", top, name),
             "the last load before the box is the reset or load input (001:3994-4004)");
    } else if ((inputs[0] & condition::Never) != 0 && !hasOwnReset(facts, instruction.operands[0].offset)) {
      report(fmt::format("the {} input of {} is never on", top, name), "connect it, or reset the counter by R");
    }
    for (std::size_t k = 1; k < inputs.size(); ++k) {
      if ((inputs[k] & (condition::Always | condition::Never)) == 0) continue;
      report(fmt::format("a count input of {} never changes, so it has no rising edge", name),
             "count inputs count the change from 0 to 1");
    }
  }
}

}  // namespace

extern constexpr Rule tim012_counter_cannot_work = {
    .id = "TIM012",
    .title = "Counter that cannot work",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects = "a counter whose reset or load input is always on or never on, or whose count input has no rising edge",
    .why = "the reset level has priority over counting, and only a change from 0 to 1 counts",
    .manual = "001:3994-4005",
    .bad = "Network 1\nLD I0.0\nLD SM0.0\nCTU C1, +10\nNetwork 2\nLD C1\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nLD I0.1\nCTU C1, +10\nNetwork 2\nLD C1\n= Q0.0\n",
    .questions = Questions::Rungs,
    .check = checkTim012,
};

}  // namespace rungproof
