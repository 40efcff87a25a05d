// Random runs keep the constraints, and what they reach is reachable; a quick violation is found.
#include <gtest/gtest.h>

#include "analysis/bits/simulation_runs.hpp"
#include "tests/solver/reference.hpp"

namespace rungproof {
namespace {

/// A counter of three bits that counts while an input is on; a second input must be on whenever the first is.
struct ThreeBits {
  ThreeBits() {
    const Lit go = system.addInput("go"), allowed = system.addInput("allowed");
    Lit carry = go;
    for (int i = 0; i < 3; ++i) {
      bits[i] = system.addLatch("bit", LatchInit::Zero);
      system.setNext(bits[i], system.addXor(bits[i], carry));
      carry = system.addAnd(carry, bits[i]);
    }
    system.constraints = {system.addOr(negate(go), allowed)};
    system.bads = {system.addAnd(system.addAnd(bits[0], bits[1]), bits[2])};
  }
  BitSystem system;
  Lit bits[3];
};

TEST(Simulation, RunsKeepTheConstraints) {
  ThreeBits counter;
  SimulationRuns runs(counter.system, 17);
  for (int scan = 0; scan < 200; ++scan) {
    ASSERT_TRUE(runs.choose());
    EXPECT_EQ(runs.live() & ~runs.simulator().value(counter.system.constraints[0]), 0U) << "scan " << scan;
    runs.step();
  }
}

TEST(Simulation, FindsARunAsLongAsTheCounterNeeds) {
  ThreeBits counter;
  EngineOptions options;
  options.seed = 5;
  const std::unique_ptr<Engine> engine = makeSimulation(counter.system, options);
  Verdict verdict;
  for (int i = 0; i < 50 && verdict.answer == Answer::Unknown; ++i) verdict = engine->advance(Budget::seconds(1));
  ASSERT_EQ(verdict.answer, Answer::Violated);
  ASSERT_TRUE(verdict.trace.has_value());
  EXPECT_GE(verdict.trace->inputs.size(), 8U);  // seven scans to count to 7, and the one that shows it
  std::uint32_t state = 0;
  for (std::size_t scan = 0; scan < verdict.trace->inputs.size(); ++scan) {
    std::uint32_t inputs = 0;
    for (std::uint32_t i = 0; i < 2; ++i) inputs |= static_cast<std::uint32_t>(verdict.trace->inputs[scan][i]) << i;
    EXPECT_TRUE(reference::isLegal(counter.system, state, inputs));
    EXPECT_EQ(reference::isBad(counter.system, state, inputs), scan + 1 == verdict.trace->inputs.size());
    state = reference::nextState(counter.system, state, inputs);
  }
}

TEST(Simulation, NeverFindsWhatIsUnreachable) {
  ThreeBits counter;
  counter.system.bads = {counter.system.addAnd(counter.bits[0], negate(counter.bits[0]))};
  const std::unique_ptr<Engine> engine = makeSimulation(counter.system, {});
  EXPECT_EQ(engine->advance(Budget::seconds(0.1)).answer, Answer::Unknown);
}

}  // namespace
}  // namespace rungproof
