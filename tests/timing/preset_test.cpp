// The cost of a proof and of a witness must not grow with the preset: 30,000 ticks of 100 ms may cost at most 1.5 times
// as much as 50 ticks.
#include <gtest/gtest.h>

#include "tests/timing/measured_proof.hpp"
#include "tests/timing/stl_families.hpp"

namespace rungproof {
namespace {

constexpr double mostGrowth = 1.5;
/// s: a witness of 30,000 ticks is repeated scan by scan; comparisons of 12 and 15 bits instead of 6 are solved by
/// several engines at once, each of which takes its part of the processor until one of them has the proof.
constexpr double allowance = 0.1;

/// One timer behind an input. Between the scan end at which the input is seen first and that at which the bit is on
/// there are at least preset ticks, of which up to 10 have come before: scans last up to 500 ms.
std::string delayed(int preset, bool proof) {
  const std::string property =
      proof ? "//@ prove late: Q0.0 implies held(I0.0, " + std::to_string(preset * 100 - 1200) + "ms)\n"
            : "//@ reach late: Q0.0\n";
  return families::programOf(property, "Network 1\nLD I0.0\nTON T37, " + std::to_string(preset) + "\nLD T37\n= Q0.0\n");
}

/// A star-delta starter with its changeover time in ticks.
std::string starDelta(int preset, bool proof) {
  const std::string property = proof
                                   ? "//@ prove late: Q0.2 implies held(Q0.0, " + std::to_string(preset * 100 - 1200) +
                                         "ms)\n//@ prove apart: never Q0.1 and Q0.2\n"
                                   : "//@ reach late: Q0.2\n";
  return families::programOf(
      property, "Network 1\nLD I0.0\nO Q0.0\nA I0.1\nA I0.2\n= Q0.0\nNetwork 2\nLD Q0.0\nTON T37, " +
                    std::to_string(preset) +
                    "\nNetwork 3\nLD Q0.0\nAN T37\nAN Q0.2\n= Q0.1\nNetwork 4\nLD Q0.0\nA T37\nAN Q0.1\n= Q0.2\n");
}

void expectIndependent(std::string (*program)(int, bool), bool proof) {
  const MeasuredProof small = measureProof(program(50, proof), {}, 5),
                      middle = measureProof(program(3000, proof), {}, 5),
                      large = measureProof(program(30000, proof), {}, 5);
  for (const MeasuredProof* m : {&small, &middle, &large})
    EXPECT_EQ(m->verdicts.at("late"), proof ? "PROVED" : "REACHABLE");
  ::testing::Test::RecordProperty("seconds", std::to_string(small.cpuSeconds) + " " +
                                                 std::to_string(middle.cpuSeconds) + " " +
                                                 std::to_string(large.cpuSeconds));
  std::printf("%.3f %.3f %.3f s\n", small.cpuSeconds, middle.cpuSeconds, large.cpuSeconds);
  EXPECT_LE(middle.cpuSeconds, mostGrowth * small.cpuSeconds + allowance);
  EXPECT_LE(large.cpuSeconds, mostGrowth * small.cpuSeconds + allowance) << small.cpuSeconds << " s with preset 50";
}

TEST(Preset, ProofAboutOneTimer) { expectIndependent(delayed, true); }
TEST(Preset, WitnessOfOneTimer) { expectIndependent(delayed, false); }
TEST(Preset, ProofAboutStarDelta) { expectIndependent(starDelta, true); }
TEST(Preset, WitnessOfStarDelta) { expectIndependent(starDelta, false); }

}  // namespace
}  // namespace rungproof
