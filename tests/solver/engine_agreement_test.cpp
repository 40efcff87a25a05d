// Thousands of small random systems: every engine must give the verdict of the plain search of reference.hpp, with
// a run that is really bad or an invariant that is really inductive.
#include <gtest/gtest.h>

#include "analysis/bits/bit_unrolling.hpp"
#include "reference.hpp"

namespace rungproof {
namespace {

constexpr unsigned seed = 20031;
constexpr int systems = 3000;

struct Named {
  const char* name;
  std::unique_ptr<Engine> (*make)(const BitSystem&, const EngineOptions&);
  bool decides;    ///< decides every small system
  bool shortest;   ///< its violations are shortest ones
  double seconds;  ///< for one system
};

class Agreement : public testing::TestWithParam<Named> {};

TEST_P(Agreement, WithPlainSearch) {
  const Named& engine = GetParam();
  std::mt19937 random(seed);
  int proved = 0, violated = 0;
  for (int n = 0; n < systems; ++n) {
    SCOPED_TRACE(testing::Message() << engine.name << ", seed " << seed << ", system " << n);
    const BitSystem system = reference::randomSystem(random);
    const std::optional<int> expected = reference::shortestViolation(system);
    EngineOptions options;
    options.bound = 130;  // no shortest violation among 2^7 states is longer
    const Verdict verdict = engine.make(system, options)->advance(Budget::seconds(engine.seconds));
    if (verdict.answer == Answer::Unknown && expected) {
      ASSERT_LE(verdict.depth, *expected);
    }
    if (expected && (engine.decides || engine.make == makeBmc)) {
      ASSERT_EQ(verdict.answer, Answer::Violated);
      if (engine.shortest && verdict.answer == Answer::Violated) {
        ASSERT_EQ(verdict.depth, *expected);
      }
    }
    if (!expected) {
      ASSERT_NE(verdict.answer, Answer::Violated);
      if (engine.decides) {
        ASSERT_EQ(verdict.answer, Answer::Proved);
      }
    }
    if (verdict.answer == Answer::Violated) {
      ++violated;
      ASSERT_TRUE(verdict.trace.has_value());
      ASSERT_TRUE(isViolation(system, *verdict.trace));
    }
    if (verdict.answer == Answer::Proved) {
      ++proved;
      ASSERT_TRUE(verdict.certificate.has_value());
      if (verdict.certificate->k == 0) {
        ASSERT_TRUE(reference::isInductive(system, *verdict.certificate));
      }
    }
    if (testing::Test::HasFatalFailure()) return;
  }
  // The generator must not be one-sided.
  EXPECT_GT(violated, systems / 10);
  if (engine.decides || engine.make == makeKInduction) {
    EXPECT_GT(proved, systems / 10);
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, Agreement,
                         testing::Values(Named{"bmc", makeBmc, false, true, 20},
                                         Named{"kinduction", makeKInduction, false, true, 0.05},
                                         Named{"ic3", makeIc3, true, false, 20},
                                         Named{"exhaustive", makeExhaustive, true, false, 20},
                                         Named{"simulation", makeSimulation, false, false, 0.001}),
                         [](const auto& info) { return std::string(info.param.name); });

/// Resuming after tiny budgets must not change the verdict.
TEST(Agreement, InterruptedIc3GoesOn) {
  std::mt19937 random(seed + 1);
  for (int n = 0; n < 300; ++n) {
    SCOPED_TRACE(testing::Message() << "seed " << seed + 1 << ", system " << n);
    const BitSystem system = reference::randomSystem(random);
    const bool reachable = reference::shortestViolation(system).has_value();
    const EngineOptions options;
    const std::unique_ptr<Engine> engine = makeIc3(system, options);
    Verdict verdict;
    for (int round = 0; round < 10000 && verdict.answer == Answer::Unknown; ++round) {
      verdict = engine->advance(Budget::seconds(0.00001 * (1 + round)));
    }
    ASSERT_EQ(verdict.answer, reachable ? Answer::Violated : Answer::Proved);
    if (!reachable) {
      ASSERT_TRUE(reference::isInductive(system, *verdict.certificate));
    }
  }
}

}  // namespace
}  // namespace rungproof
