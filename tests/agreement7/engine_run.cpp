// The run of the engine's machine for the comparisons.
#include "tests/agreement7/engine_run.hpp"

namespace rungproof::agreement7 {

bool runOnce(const Program& program, Concrete::Store& store, Around& around, std::uint32_t ms, const Registers& put,
             const Registers& take) {
  const Plan plan(program);
  Concrete domain(around);
  setReadings(store, Choices{});
  Machine<Concrete> machine(domain, store, plan);
  machine.set(Reg::LastScan, 0, ms);
  refreshS5Timers(machine);
  MarkHooks hooks{put, take};
  Scan<Concrete, MarkHooks> scan(machine, hooks, 100000);
  scan.program();
  return !machine.halted && !machine.faulted;
}

}  // namespace rungproof::agreement7
