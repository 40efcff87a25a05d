// What a run of the bench and a scan of the plant are in this program: the meanings on the mutated domain, and, for
// control instructions, a changed text.
#include <optional>

#include "tests/manual_a/bench_run.hpp"
#include "tests/manual_b/plant_run.hpp"
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

Bench& Bench::run(bool asInterrupt, const Start& start) {
  world.errors.begin(store);
  setReadings(store, choices);
  const auto runOn = [&](World& outside, Concrete::Store& memory) {
    Mutated domain(outside);
    Mutated::Store state(memory);
    return withText(*plan_,
                    [&](const Plan& plan) { return BenchRun::on(plan, domain, state, asInterrupt, start, watch); });
  };
  Mutation& mutation = Mutation::instance();
  World otherWorld;
  otherWorld.values = world.values;
  Concrete::Store otherStore = store;
  const Outcome outcome = runOn(world, store);
  if (mutation.isActive() && mutation.comparesOutcomes && !mutation.outcomeDiffers) {
    mutation.pause(true);
    const Outcome other = runOn(otherWorld, otherStore);
    mutation.pause(false);
    mutation.outcomeDiffers = !(other == outcome && otherStore == store && otherWorld.errors == world.errors);
  }
  BenchRun::finish(*this, outcome, asInterrupt);
  return *this;
}

Plant& Plant::scan(int ten, int hundred) {
  PlantRun::begin(*this);
  const auto scanOn = [&](Surroundings& surroundings, Concrete::Store& memory) {
    reached.clear();
    Mutated domain(surroundings);
    Mutated::Store state(memory);
    return withText(*plan_,
                    [&](const Plan& plan) { return PlantRun::on(*this, plan, domain, state, ten, hundred, watch); });
  };
  Mutation& mutation = Mutation::instance();
  Surroundings otherOutside = outside;
  Concrete::Store otherStore = store;
  std::optional<Outcome> other;
  if (mutation.isActive() && mutation.comparesOutcomes && !mutation.outcomeDiffers) {
    mutation.pause(true);
    other = scanOn(otherOutside, otherStore);
    mutation.pause(false);
  }
  const Outcome outcome = scanOn(outside, store);
  if (other) {
    mutation.outcomeDiffers = !(*other == outcome && otherStore == store && otherOutside.errors == outside.errors &&
                                otherOutside.signals == outside.signals);
  }
  PlantRun::finish(*this, outcome);
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
