// Two rings that instances within another write through pointers cost little more than what their places ask for:
// before instances were cut into words as they are declared, the pointers were followed nowhere.
#include <gtest/gtest.h>

#include "tests/ring_program.hpp"
#include "tests/timing/measured_proof.hpp"

namespace rungproof::test {
namespace {

MeasuredProof ringsOf(int places) {
  return measureProof(ringsInTwoInstances(places) +
                      fmt::format("ORGANIZATION_BLOCK OB 1\n//@ prove within: DB1.DBW8 < {}\nBEGIN\nNETWORK\n"
                                  "CALL FB 2 , DB 1;\nEND_ORGANIZATION_BLOCK\n",
                                  places));
}

TEST(InstanceRingPace, GrowsWithItsPlaces) {
  const MeasuredProof few = ringsOf(4), more = ringsOf(16);
  EXPECT_EQ(few.verdicts.at("within"), "PROVED");
  EXPECT_EQ(more.verdicts.at("within"), "PROVED");
  std::printf("4 places %.3f s, 16 places %.3f s: x%.1f\n", few.cpuSeconds, more.cpuSeconds,
              more.cpuSeconds / few.cpuSeconds);
  EXPECT_LE(more.cpuSeconds, 10 * few.cpuSeconds + 0.05);
}

}  // namespace
}  // namespace rungproof::test
