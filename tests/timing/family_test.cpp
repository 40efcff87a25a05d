// The public timer families in STL, each with all its properties within a limit of CPU time for the whole run of
// `prove`: reading, encoding, searching and checking the certificates with Z3.
#include <gtest/gtest.h>

#include "tests/timing/measured_proof.hpp"
#include "tests/timing/stl_families.hpp"

namespace rungproof {
namespace {

/// Best figures of other checkers on the same families, on the timers as they are or saturated by hand, in seconds.
/// The bar is 1.5 times that.
constexpr double barFactor = 1.5;

void expectProved(const std::string& program, std::size_t properties, double best, const std::vector<std::string>& options = {"--scan-time", "100ms"}) {
  const MeasuredProof measured = measureProof(program, options, 4);
  EXPECT_EQ(measured.verdicts.size(), properties);
  for (const auto& [name, verdict] : measured.verdicts) EXPECT_EQ(verdict, "PROVED") << name;
  testing::Test::RecordProperty("seconds", std::to_string(measured.cpuSeconds));
  std::printf("%.3f s\n", measured.cpuSeconds);
  EXPECT_LE(measured.cpuSeconds, barFactor * best);
}

TEST(Family, Starter16) { expectProved(families::starter(16), 15, 0.01); }
TEST(Family, Starter64) { expectProved(families::starter(64), 63, 0.04); }
TEST(Family, Phase4) { expectProved(families::phase(4), 4, 0.04); }
TEST(Family, Phase16) { expectProved(families::phase(16), 16, 0.09); }
TEST(Family, Chain4) { expectProved(families::chain(4), 3, 0.01); }
TEST(Family, Chain16) { expectProved(families::chain(16), 15, 0.13); }
TEST(Family, Chain64) { expectProved(families::chain(64), 63, 0.52); }
TEST(Family, Timed1) { expectProved(families::timed(1, 100), 1, 0.04); }
TEST(Family, Timed1WithPreset30000) { expectProved(families::timed(1, 30000), 1, 0.03); }
TEST(Family, Timed4) { expectProved(families::timed(4, 100), 4, 0.04); }
TEST(Family, Timed16) { expectProved(families::timed(16, 100), 16, 0.08); }
TEST(Family, Timed64) { expectProved(families::timed(64, 100), 64, 0.66); }

}  // namespace
}  // namespace rungproof
