// The run of the engine's machine for the comparisons.
#include "tests/agreement7/engine_run.hpp"

namespace rungproof::agreement7 {

bool runOnce(const Program& program, Concrete::Store& store, Around& around, std::uint32_t ms, const Registers& put,
             const Registers& take) {
  const Plan plan(program);
  Concrete domain(around);
  setReadings(store, Choices{});
  Machine<Concrete> machine(domain, store, plan);
  return runOn(machine, ms, put, take);
}

}  // namespace rungproof::agreement7
