// Classes of obligations in growing sizes: every property has its verdict, within a limit of CPU time for the whole run
// of `prove`, and the time does not grow with what should not cost: with presets and with the limits of counters, and
// with the number of steps no faster than the program does.
#include <gtest/gtest.h>

#include "tests/timing/measured_proof.hpp"
#include "tests/timing/obligation_families.hpp"

namespace rungproof {
namespace {

using families::ObligationFamily;

/// s, for any size that is decided: the slowest take about half of it on a quiet machine.
constexpr double mostForOne = 3;

/// The least CPU time of some runs of each decided size; all verdicts are checked.
std::vector<double> secondsOf(const ObligationFamily& family, int runs) {
  std::vector<double> seconds;
  for (std::size_t i = 0; i < family.decided; ++i) {
    const MeasuredProof measured = measureProof(family.program(family.sizes[i]), {}, runs, 0.03);
    EXPECT_FALSE(measured.verdicts.empty());
    for (const auto& [name, verdict] : measured.verdicts)
      EXPECT_EQ(verdict, family.verdict) << family.name << " " << family.sizes[i] << ": " << name;
    std::printf("%s %d: %.3f s\n", std::string(family.name).c_str(), family.sizes[i], measured.cpuSeconds);
    seconds.push_back(measured.cpuSeconds);
  }
  return seconds;
}

ObligationFamily familyNamed(std::string_view name) {
  for (const ObligationFamily& family : families::obligationFamilies()) {
    if (family.name == name) return family;
  }
  ADD_FAILURE() << name;
  return {};
}

class Obligations : public ::testing::TestWithParam<ObligationFamily> {};

TEST_P(Obligations, AreDecidedWithinTheLimit) {
  for (const double seconds : secondsOf(GetParam(), 3)) EXPECT_LE(seconds, mostForOne);
}

INSTANTIATE_TEST_SUITE_P(All, Obligations, ::testing::ValuesIn(families::obligationFamilies()), [](const auto& info) {
  std::string name(info.param.name);
  std::ranges::replace(name, ' ', '_');
  return name;
});

/// The largest size against the smallest: at most `growth` times, and a fixed part that no proof depends on.
void expectGrowth(std::string_view name, double growth, double allowance) {
  const std::vector<double> seconds = secondsOf(familyNamed(name), 5);
  ASSERT_GE(seconds.size(), 2U);
  EXPECT_LE(seconds.back(), growth * seconds.front() + allowance) << name;
}

/// From 50 to 200 steps: linear would be 4.
constexpr double mostForSteps = 6;
TEST(ObligationGrowth, StepChain) { expectGrowth("step chain", mostForSteps, 0); }
TEST(ObligationGrowth, StepRing) { expectGrowth("step ring", mostForSteps, 0); }

/// From 50 to 30,000 ticks. The allowance is for the witness of 6000 scans and more, which the engine repeats one by
/// one, and for comparisons of 15 bits instead of 6.
constexpr double mostForPresets = 1.5, presetAllowance = 0.1;
TEST(ObligationGrowth, ShortWait) { expectGrowth("short wait", mostForPresets, presetAllowance); }
TEST(ObligationGrowth, LongWait) { expectGrowth("long wait", mostForPresets, presetAllowance); }
TEST(ObligationGrowth, EarlyEnd) { expectGrowth("early end", mostForPresets, presetAllowance); }
TEST(ObligationGrowth, FineEnd) { expectGrowth("fine end", mostForPresets, presetAllowance); }
TEST(ObligationGrowth, LateEnd) { expectGrowth("late end", mostForPresets, presetAllowance); }

TEST(ObligationGrowth, CounterLamp) { expectGrowth("counter lamp", 1.5, 0.01); }
/// The allowance is for a run of 65,535 scans, found once and repeated once.
TEST(ObligationGrowth, CounterReached) { expectGrowth("counter reached", 1.5, presetAllowance); }

}  // namespace
}  // namespace rungproof
