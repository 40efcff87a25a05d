// Rings that two instances within another write through pointers: each stays within its own array, whatever comes.
#include "proved_text.hpp"
#include "tests/ring_program.hpp"

namespace rungproof::test {
namespace {

using enum Outcome;

class InstanceRing : public testing::TestWithParam<int> {};

// The position counts from 0 and starts again at the end of the array. What is written to the first ring leaves the
// position of the second alone, and 1 is reached with the first rise of I0.1.
TEST_P(InstanceRing, IsProvedAndViolated) {
  const int second = 18 + 2 * GetParam();
  const ProgramInput input =
      inputOfSource(ringsInTwoInstances(GetParam()) +
                    fmt::format("ORGANIZATION_BLOCK OB 1\n//@ prove within: DB1.DBW8 < {0} and DB1.DBW{1} < {0}\n"
                                "//@ prove apart: DB1.DBW{1} <> prev(DB1.DBW{1}) implies rises(I0.1) or first_scan\n"
                                "//@ prove still: DB1.DBW{1} = 0\n"
                                "BEGIN\nNETWORK\nCALL FB 2 , DB 1;\nEND_ORGANIZATION_BLOCK\n",
                                GetParam(), second));
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "within"), Proved);
  EXPECT_EQ(outcomeOf(run, "apart"), Proved);
  EXPECT_EQ(outcomeOf(run, "still"), Violated);
}

INSTANTIATE_TEST_SUITE_P(Places, InstanceRing, testing::Values(4, 12));

}  // namespace
}  // namespace rungproof::test
