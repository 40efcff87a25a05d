// What a run of the bench and a scan of the plant are in this program: the meanings on the mutated domain, and, for
// control instructions, a changed text.
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
  if (!changeText(copy)) return run(plan);
  return run(Plan(copy));
}

const auto watch = [](const auto& machine) { Mutation::instance().watch(&machine.current); };

}  // namespace

Bench& Bench::run(bool asInterrupt, const Start& start) {
  world.hazards.clear();
  Mutated domain(world);
  Mutated::Store state(store);
  const Outcome outcome = withText(*plan_, [&](const Plan& plan) { return BenchRun::on(*this, plan, domain, state, asInterrupt, start, watch); });
  Mutation::instance().watch(nullptr);
  BenchRun::finish(*this, outcome, asInterrupt);
  return *this;
}

Plant& Plant::scan(int ten, int hundred) {
  PlantRun::begin(*this);
  Mutated domain(outside);
  Mutated::Store state(store);
  const Outcome outcome = withText(*plan_, [&](const Plan& plan) { return PlantRun::on(*this, plan, domain, state, ten, hundred, watch); });
  Mutation::instance().watch(nullptr);
  PlantRun::finish(*this, outcome);
  return *this;
}

void Plant::refresh(int resolution, int count) {
  Mutated domain(outside);
  Mutated::Store state(store);
  Machine<Mutated> machine(domain, state, *plan_, choices);
  watch(machine);
  PlantRun::refresh(*this, machine, resolution, count);
  Mutation::instance().watch(nullptr);
}

}  // namespace rungproof::manual
