// How the plant scans its program over any domain. Used by plant_run.cpp (plain numbers and the blurred domain) and by
// tests/mutation (changed meanings).
#pragma once

#include "ir/timer_refresh.hpp"
#include "plant.hpp"
#include "tests/manual_a/bench_run.hpp"

namespace rungproof::manual {

struct PlantRun {
  /// Called in front of every instruction of the walk.
  struct Hooks {
    Plant& plant;
    template <class S>
    void before(S& scan, const FlowStep& step) {
      auto& m = scan.machine();
      if (const auto passed = plant.ms.find(step.instruction->id); passed != plant.ms.end())
        refresh(plant, m, 1, passed->second);
      const auto routine = plant.interruptBefore.find(step.instruction->id);
      if (routine != plant.interruptBefore.end() && !m.inInterrupt) {
        m.current = nullptr;
        scan.interrupt(routine->second, m.d.constant(true));
        m.current = step.instruction;
      }
      announce(m.d);
    }
    template <class S>
    void callWithoutBody(S&, const Instruction&) {}
    template <class S>
    void freshLocal(S& scan, unsigned frame, std::uint32_t byte) {
      auto& m = scan.machine();
      m.store.save(Area::L, (frame * 64 + byte) * 8, 8, m.d.literal(plant.freshLocal, 8), m.guard);
    }
  };

  static const Plan& plan(const Plant& plant) { return *plant.plan_; }

  /// `prepare` sees the machine before the scan.
  template <class D, class Prepare>
  static Outcome on(Plant& plant, const Plan& plan, D& domain, typename D::Store& state, int ten, int hundred,
                    Prepare&& prepare) {
    Machine<D> machine(domain, state, plan);
    prepare(machine);
    machine.ticks100 = machine.number(static_cast<std::uint64_t>(hundred), 16);
    refresh(plant, machine, 10, ten);
    Hooks hooks{plant};
    Scan<D, Hooks> scan(machine, hooks);
    scan.program();
    return outcomeOf(machine);
  }
  template <class D>
  static void refresh(Plant& plant, Machine<D>& machine, int resolution, int count) {
    std::vector<const Desc*> order;  // for a domain that wants to know which timer is next
    for (const TimerUse& use : machine.plan.timers) {
      if (use.resolution == resolution && use.decides) order.push_back(use.desc);
    }
    std::size_t next = 0;
    const auto advances = [&] {
      if constexpr (requires { machine.d.advances(nullptr); })
        machine.d.advances(next < order.size() ? order[next++] : nullptr);
    };
    advances();
    refreshTimers(machine, resolution, machine.number(static_cast<std::uint64_t>(count), 16),
                  [&](const TimerUse& use, auto now) {
                    advances();
                    if constexpr (std::same_as<decltype(now), bool>)
                      plant.reached.emplace_back(use.number, now);
                    else
                      plant.reached.emplace_back(use.number, now.v);
                  });
  }
  static void begin(Plant& plant) {
    plant.outside.errors.begin(plant.store);
    setReadings(plant.store, plant.choices);
    plant.outside.signals.clear();
    plant.reached.clear();
  }
  static void finish(Plant& plant, const Outcome& outcome) {
    plant.outside.errors.check(plant.store, plant.program_, outcome.halted, outcome.faulted);
    plant.stack = outcome.stack;
    plant.halted = outcome.halted;
    plant.store.set(Reg::FirstScan, 0, 0, true);
  }
};

}  // namespace rungproof::manual
