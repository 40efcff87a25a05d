// What a run of the plant is in this program: the meanings on the mutated domain, and, for
// control instructions, a changed text.
#include <optional>

#include "tests/manual/plant_run.hpp"
#include "tests/mutation/mutated.hpp"

namespace rungproof::manual {

namespace {

using mutation::Mutated;
using mutation::Mutation;

/// Removes or moves each instruction of the active mutant.
bool changeText(Program& program) {
  bool changed = false;
  for (Pou& pou : program.pous) {
    for (Network& network : pou.networks) {
      std::vector<Instruction>& list = network.instructions;
      std::vector<bool> moved(list.size(), false);
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i].desc->control == Control::None || moved[i]) continue;
        const int change = Mutation::instance().changeOfWhole(mutation::Op::Text, *list[i].desc);
        const std::size_t other = change == 2 ? i + 1 : i - 1;
        if (change == 1) list[i] = statement("NOP 0");
        if (change > 1 && other < list.size()) {
          std::swap(list[i], list[other]);
          moved[other] = true;
        }
        changed = changed || change != 0;
      }
    }
  }
  if (changed) program.number();
  return changed;
}

/// Runs with the plan of the program, or of a changed copy of it.
template <class Run>
Outcome withText(const Plan& plan, Run&& run) {
  Program copy = *plan.program;
  const Outcome outcome = changeText(copy) ? run(Plan(copy)) : run(plan);
  Mutation::instance().watch({});
  return outcome;
}

const auto watch = [](const auto& machine) {
  Mutation::instance().watch({&machine.current, &machine.frame, &machine.inInterrupt});
};

}  // namespace

Plant& Plant::run(const Run& run) {
  PlantRun::begin(*this);
  const auto runOn = [&](Surroundings& surroundings, Concrete::Store& memory) {
    reached.clear();
    Mutated domain(surroundings);
    Mutated::Store state(memory);
    return withText(*plan_, [&](const Plan& plan) { return PlantRun::on(*this, plan, domain, state, run, watch); });
  };
  Mutation& mutation = Mutation::instance();
  Surroundings otherOutside = outside;
  Concrete::Store otherStore = store;
  std::optional<Outcome> other;
  if (mutation.isActive() && mutation.comparesOutcomes && !mutation.outcomeDiffers) {
    mutation.pause(true);
    other = runOn(otherOutside, otherStore);
    mutation.pause(false);
  }
  const Outcome outcome = runOn(outside, store);
  if (other) {
    mutation.outcomeDiffers = !(*other == outcome && otherStore == store && otherOutside.errors == outside.errors &&
                                otherOutside.signals == outside.signals);
  }
  PlantRun::finish(*this, run, outcome);
  return *this;
}

void Plant::refresh(int resolution, int count) {
  Mutated domain(outside);
  Mutated::Store state(store);
  Machine<Mutated> machine(domain, state, *plan_);
  watch(machine);
  PlantRun::refresh(*this, machine, resolution, count);
  Mutation::instance().watch({});
}

}  // namespace rungproof::manual
