// Witnesses and proofs over time: long presets are reached by stretches that are replayed scan by scan, and found as
// quickly as short ones; what time alone cannot reach is not claimed.
#include <chrono>

#include "proved_text.hpp"

namespace rungproof::test {
namespace {

TEST(Time, LongPresetIsReachedInRealScans) {
  // 3000 s behind one input; a scan lasts 500 ms at most, so at least 6000 scans pass.
  const ProgramInput input = inputOf("//@ reach late: T37\n", "Network 1\nLD I0.0\nTON T37, 30000\n");
  const auto begin = std::chrono::steady_clock::now();
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  const ProofResult* result = resultNamed(run, "late");
  ASSERT_TRUE(result != nullptr && result->witness);
  EXPECT_EQ(result->outcome, Outcome::Reachable);
  EXPECT_GE(result->witness->scanCount, 6000U);
  EXPECT_GE(result->witness->milliseconds, 3000U * 1000U - 100U);
  EXPECT_LE(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 10.0);
}

TEST(Time, TimerIsNotEarly) {
  // Preset 50 at 100 ms is 4901 ms of ticks at least; they count from the start of the scan before the one that enables
  // the timer, and scan ends lie up to 500 ms after scan starts: 4901 + 1 - 1000 ms between scan ends.
  const ProgramInput input =
      inputOf("//@ prove not before: T37 implies held(I0.0, 3900ms)\n", "Network 1\nLD I0.0\nTON T37, 50\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions(3));
  EXPECT_NE(outcomeOf(run, "not before"), Outcome::Violated);
}

}  // namespace
}  // namespace rungproof::test
