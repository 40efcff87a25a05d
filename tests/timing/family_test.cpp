// The public timer families in STL, each with all its properties within a limit of CPU time for the whole run of
// `prove`: reading, encoding, searching and checking the certificates with Z3.
#include <gtest/gtest.h>

#include "tests/timing/measured_proof.hpp"
#include "tests/timing/stl_families.hpp"

namespace rungproof {
namespace {

void expectProved(const std::string& program, std::size_t properties, double seconds, const std::vector<std::string>& options = {"--scan-time", "100ms"}) {
  const MeasuredProof measured = measureProof(program, options, 2);
  EXPECT_EQ(measured.verdicts.size(), properties);
  for (const auto& [name, verdict] : measured.verdicts) EXPECT_EQ(verdict, "PROVED") << name;
  testing::Test::RecordProperty("seconds", std::to_string(measured.cpuSeconds));
  EXPECT_LE(measured.cpuSeconds, seconds);
}

TEST(Family, Starter16) { expectProved(families::starter(16), 15, 0.2); }
TEST(Family, Starter64) { expectProved(families::starter(64), 63, 0.6); }
TEST(Family, Phase4) { expectProved(families::phase(4), 4, 3.0); }
TEST(Family, Chain4) { expectProved(families::chain(4), 3, 0.4); }
TEST(Family, Timed1) { expectProved(families::timed(1, 100), 1, 0.3); }
TEST(Family, Timed1WithPreset30000) { expectProved(families::timed(1, 30000), 1, 1.0); }
TEST(Family, Timed4) { expectProved(families::timed(4, 100), 4, 0.8); }
TEST(Family, Timed16) { expectProved(families::timed(16, 100), 16, 1.5); }

}  // namespace
}  // namespace rungproof
