// Scans that all last as long: the bounds between timers and the property's clock are found there too, although what
// the clocks count by is a constant or a function of the time's own digits; and a wait is as many scans as fit it.
// Between the longest wait that a timer allows and one that a tick of its base is beyond it, nothing is asked here.
#include <fmt/format.h>

#include "proved_text.hpp"

namespace rungproof::test {
namespace {

Outcome outcomeAt(std::uint32_t scan, const ProgramInput& input, const std::string& property) {
  ProverOptions options = usualOptions(10);
  options.time = {scan, scan};
  const ProofRun run = prove(input.program, input.properties, options);
  EXPECT_TRUE(run.disagreements.empty());
  return outcomeOf(run, property);
}

/// Longest wait of the property's clock, in ms, that is a whole number of scans and ends before `limit`.
constexpr std::uint32_t longestWaitBelow(std::uint32_t limit, std::uint32_t scan) { return (limit - 1) / scan * scan; }

// In the first scan a timer has no ticks to count yet, so an input that is on from then on waits longest: between the
// starts of scans 1 and k lie (k - 1) scans, and as long as these last less than 4500 ms a phase exists in which they
// hold 44 ticks of 100 ms only. They last as long as lies between the ends of the two scans.
TEST(FixedScan, WaitsOfATimerAreDecidedToTheScan) {
  for (const std::uint32_t scan : {1U, 7U, 10U, 50U, 100U}) {
    const std::uint32_t longest = longestWaitBelow(4500, scan);
    const ProgramInput input = inputOf(fmt::format("//@ prove shorter: held(I0.0, {}ms) implies T37\n"
                                                   "//@ prove longer: held(I0.0, 4600ms) implies T37\n",
                                                   longest),
                                       "Network 1\nLD I0.0\nTON T37, 45\n");
    EXPECT_EQ(outcomeAt(scan, input, "shorter"), Outcome::Violated) << scan << " ms";
    EXPECT_EQ(outcomeAt(scan, input, "longer"), Outcome::Proved) << scan << " ms";
  }
}

// An S5 timer that may elapse at any instruction elapses 4500 ms after its start at the latest. It starts at an
// instruction of the scan in which the input has come on, which may be the scan's last moment; so between the ends of
// that scan and of one in which it has not elapsed lie less than 4500 ms. A start at that very moment elapses at the
// very end of a scan 4500 ms later, and has elapsed there.
TEST(FixedScan, WaitsOfAnS5TimerAreDecidedToTheScan) {
  for (const std::uint32_t scan : {10U, 50U, 100U}) {
    ProgramInput input;
    const std::uint32_t longest = longestWaitBelow(4500, scan);
    input.program = readText("test.awl", fmt::format("ORGANIZATION_BLOCK OB 1\n"
                                                     "//@ prove shorter: held(I0.0, {}ms) implies T1\n"
                                                     "//@ prove longer: held(I0.0, 4600ms) implies T1\n"
                                                     "BEGIN\nNETWORK\nA I 0.0;\nL S5T#4S500MS;\nSD T 1;\n"
                                                     "END_ORGANIZATION_BLOCK\n",
                                                     longest));
    input.properties = readProperties(input.program, {}, lookupIn(input.program));
    EXPECT_EQ(outcomeAt(scan, input, "shorter"), Outcome::Violated) << scan << " ms";
    EXPECT_EQ(outcomeAt(scan, input, "longer"), Outcome::Proved) << scan << " ms";
  }
}

}  // namespace
}  // namespace rungproof::test
