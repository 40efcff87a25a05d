// The public timer families in STL, each with all its properties within a limit of CPU time for the whole run of
// `prove`: reading, encoding, searching and checking the certificates with Z3.
#include <gtest/gtest.h>

#include "tests/timing/measured_proof.hpp"
#include "tests/timing/stl_families.hpp"

namespace rungproof {
namespace {

/// `limit`: CPU seconds for everything.
void expectProved(const std::string& program, std::size_t properties, double limit,
                  const std::vector<std::string>& options = {"--scan-time", "100ms"}) {
  const MeasuredProof measured = measureProof(program, options, 12, limit);
  EXPECT_EQ(measured.verdicts.size(), properties);
  for (const auto& [name, verdict] : measured.verdicts) EXPECT_EQ(verdict, "PROVED") << name;
  ::testing::Test::RecordProperty("seconds", std::to_string(measured.cpuSeconds));
  std::printf("%.3f s of %.3f s\n", measured.cpuSeconds, limit);
  EXPECT_LE(measured.cpuSeconds, limit);
}

// The best of six other checkers on the same families, in seconds: starter-16 0.01, phase-16 0.09, chain-4 0.01,
// chain-16 0.13; timed-1 0.03 and timed-4 0.77 with timers as they are, timed-16 0.08 and timed-64 0.8 only after the
// timers have been saturated by hand. Reading, encoding and the second solver's check of every certificate are part of
// the limits here. The timed ones are slower than those of the others: a timer does not count the scan that enables it,
// so that its value equals the count only where a bit remembers the input, which IC3 on words finds and no template of
// an invariant does yet (measured: 0.10, 0.12, 0.36, 1.0, 3.4 s; the last two twice that where others have the caches).
TEST(Family, Starter16) { expectProved(families::starter(16), 15, 0.05); }
TEST(Family, Starter64) { expectProved(families::starter(64), 63, 0.1); }
TEST(Family, Phase4) { expectProved(families::phase(4), 4, 0.1); }
TEST(Family, Phase16) { expectProved(families::phase(16), 16, 0.135); }
TEST(Family, Phase64) { expectProved(families::phase(64), 64, 1.0); }
TEST(Family, Chain4) { expectProved(families::chain(4), 3, 0.05); }
TEST(Family, Chain16) { expectProved(families::chain(16), 15, 0.195); }
TEST(Family, Chain64) { expectProved(families::chain(64), 63, 0.4); }
TEST(Family, Timed1) { expectProved(families::timed(1, 100), 1, 0.2); }
TEST(Family, Timed1WithPreset30000) { expectProved(families::timed(1, 30000), 1, 0.2); }
TEST(Family, Timed4) { expectProved(families::timed(4, 100), 4, 0.77); }
TEST(Family, Timed16) { expectProved(families::timed(16, 100), 16, 3); }
TEST(Family, Timed64) { expectProved(families::timed(64, 100), 64, 10); }

/// Two interlocked coils among 10,000 networks that have nothing to do with them: reading, and finding out that they
/// have nothing to do with them, is all that these may cost.
TEST(Family, ThreeNetworksAmongTenThousand) {
  std::string networks =
      "Network 1\nLD I0.0\nAN Q0.1\n= Q0.0\nNetwork 2\nLD I0.1\nAN Q0.0\n= Q0.1\nNetwork 3\nLD Q0.0\n= Q0.2\n";
  for (int i = 0; i < 10000; ++i) {
    const std::string own = families::bitOf("V", i), word = "VW" + std::to_string(2000 + 2 * (i % 1000));
    networks += "Network " + std::to_string(i + 4) + "\nLD " + families::bitOf("I", 8 + i % 56) + "\nO " + own +
                "\nAN " + families::bitOf("M", i % 200) + "\n= " + own + "\nLD " + own + "\n+I " +
                std::to_string(i % 100) + ", " + word + "\n";
  }
  expectProved(families::programOf("//@ prove apart: never Q0.0 and Q0.1\n", networks), 1, 0.25);
}

}  // namespace
}  // namespace rungproof
