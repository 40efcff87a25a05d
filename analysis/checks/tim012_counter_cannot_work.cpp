// TIM012: a counter whose reset or load input is constant, or whose count input can never rise. What needs the values
// of the run is the prover's. Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
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
  for (const InstructionPlace& place : facts.placesOf([](const Desc& desc) { return isCounterBox(desc.role); })) {
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

/// The top level resets or loads, the others count (001:3994-4004).
void askCounter(Asking& asking, const Instruction& box) {
  const Asking::Runs* runs = asking.runsOf(box);
  if (runs == nullptr || !isCounterBox(roleOf(box)) || roleOf(box) == Role::IecCounter || box.operands.empty()) return;
  const std::string name = toString(box.operands[0]);
  if (runs->samples(0)) {
    asking.ask({.name = fmt::format("{} is not always held", name),
                .message = fmt::format(
                    "the reset or load input of {} is on in every reachable state, so it never counts", name),
                .address = name,
                .place = &box,
                .bad = runs->off[0].node});
  }
  for (std::size_t k = 1; k < runs->on.size(); ++k) {
    if (!runs->samples(k)) continue;
    const Graph::Bool before{
        asking.askedProperties().before(fmt::format("rest of input {} of {}", k, name), runs->off[k].node)};
    asking.ask({.name = fmt::format("the count input of {} at stack level {} can rise", name, k + 1),
                .message = fmt::format("a count input of {} never rises in any reachable state", name),
                .address = name,
                .place = &box,
                .bad = asking.graph().land(before, runs->on[k]).node});
  }
}

void askTim012(Asking& asking) {
  for (const Flow& flow : asking.encoding().plan().flows) {
    for (const FlowStep& step : flow.steps) askCounter(asking, *step.instruction);
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
    .dialects = dialect::S7200,
    .check = checkTim012,
    .ask = {.in = asked::Lint, .turn = 84, .cost = 3, .wantsYes = true, .program = askTim012},
    .tell = {.advice = "the last load before the box is the reset or load input (001:3994-4004)"},
};

}  // namespace rungproof
