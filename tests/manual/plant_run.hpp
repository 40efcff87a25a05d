// How the plant runs its program over any domain. Used by plant_run.cpp (plain numbers and the blurred domain) and by
// tests/mutation (changed meanings).
#pragma once

#include "ir/families/run.hpp"
#include "plant.hpp"

namespace rungproof::manual {

/// Stack and end of a run, as plain truth values.
template <class D>
Outcome outcomeOf(const Machine<D>& machine) {
  const auto plain = [](const auto& truth) {
    if constexpr (std::same_as<std::remove_cvref_t<decltype(truth)>, bool>)
      return truth;
    else
      return truth.v;
  };
  Outcome outcome;
  for (std::size_t i = 0; i < outcome.stack.size(); ++i) outcome.stack[i] = plain(machine.stack[i]);
  outcome.halted = plain(machine.halted);
  outcome.faulted = plain(machine.faulted);
  return outcome;
}

/// Tells a domain that wants to know that the next instruction begins.
template <class D>
void announce(D& domain) {
  if constexpr (requires { domain.begins(); }) domain.begins();
}

struct PlantRun {
  using Run = Plant::Run;

  /// Called in front of every instruction of the walk.
  struct Hooks {
    Plant& plant;
    std::optional<std::array<bool, 9>> stack{};
    template <class S>
    void before(S& scan, const FlowStep& step) {
      auto& m = scan.machine();
      for (std::size_t i = 0; stack && i < stack->size(); ++i) m.stack[i] = m.d.constant((*stack)[i]);
      stack.reset();
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
    void freshLocal(S& scan, std::uint32_t base, std::uint32_t byte) {
      auto& m = scan.machine();
      m.store.save(Area::L, (base + byte) * 8, 8, m.d.literal(plant.freshLocal, 8), m.guard);
    }
  };

  static const Plan& plan(const Plant& plant) { return *plant.plan_; }

  /// `prepare` sees the machine before the run.
  template <class D, class Prepare>
  static Outcome on(Plant& plant, const Plan& plan, D& domain, typename D::Store& state, const Run& run,
                    Prepare&& prepare) {
    Machine<D> machine(domain, state, plan);
    prepare(machine);
    machine.ticks100 = machine.number(static_cast<std::uint64_t>(run.hundred), 16);
    refresh(plant, machine, 10, run.ten);
    Hooks hooks{plant, run.stack};
    Scan<D, Hooks> scan(machine, hooks);
    if (run.isInterrupt)
      scan.interrupt(0, domain.constant(true));
    else
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
  static void finish(Plant& plant, const Run& run, const Outcome& outcome) {
    plant.outside.errors.check(plant.store, plant.program_, outcome.halted, outcome.faulted);
    plant.stack = outcome.stack;
    plant.halted = outcome.halted;
    if (!run.isInterrupt) plant.store.set(Reg::FirstScan, 0, 0, true);
  }
};

}  // namespace rungproof::manual
