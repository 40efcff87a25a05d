// What a run of a case is in this program: the meanings on the mutated domain.
#include "tests/agreement7/engine_run.hpp"
#include "tests/mutation/mutated.hpp"

namespace rungproof::agreement7 {

bool runOnce(const Program& program, Concrete::Store& store, Around& around, std::uint32_t ms, const Registers& put,
             const Registers& take) {
  using mutation::Mutation;
  const Plan plan(program);
  mutation::Mutated domain(around);
  setReadings(store, Choices{});
  mutation::Mutated::Store state(store);
  Machine<mutation::Mutated> machine(domain, state, plan);
  Mutation::instance().watch({&machine.current, &machine.frame, &machine.inInterrupt});
  const bool runs = runOn(machine, ms, put, take);
  Mutation::instance().watch({});
  return runs;
}

}  // namespace rungproof::agreement7
