// How the bench runs its program over any domain. Used by bench_run.cpp (plain numbers and the blurred domain) and by
// tests/mutation (changed meanings).
#pragma once

#include "bench.hpp"
#include "ir/scan.hpp"

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

struct BenchRun {
  using Start = Bench::Start;

  template <class D>
  struct Hooks {
    template <class S>
    void before(S& scan, const FlowStep&) {
      announce(scan.machine().d);
      if (!start) return;
      for (std::size_t i = 0; i < start->size(); ++i) scan.machine().stack[i] = scan.machine().d.constant((*start)[i]);
      start.reset();
    }
    template <class S>
    void callWithoutBody(S&, const Instruction&) {}
    template <class S>
    void freshLocal(S&, unsigned, std::uint32_t) {}
    Start start{};
  };

  static const Plan& plan(const Bench& bench) { return *bench.plan_; }

  /// `prepare` sees the machine before the run.
  template <class D, class Prepare>
  static Outcome on(const Plan& plan, D& domain, typename D::Store& state, bool asInterrupt, const Start& start,
                    Prepare&& prepare) {
    Machine<D> machine(domain, state, plan);
    prepare(machine);
    Hooks<D> hooks{start};
    Scan<D, Hooks<D>> scan(machine, hooks);
    if (asInterrupt)
      scan.interrupt(0, domain.constant(true));
    else
      scan.program();
    return outcomeOf(machine);
  }

  static void finish(Bench& bench, const Outcome& outcome, bool asInterrupt) {
    bench.world.errors.check(bench.store, bench.program_, outcome.halted, outcome.faulted);
    bench.stack = outcome.stack;
    bench.halted = outcome.halted;
    if (!asInterrupt) bench.store.set(Reg::FirstScan, 0, 0, true);
  }
};

}  // namespace rungproof::manual
