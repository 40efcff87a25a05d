// The networks that a proof names: writers of what is read, over scans where the value is carried, and callers.
#include "analysis/proof/proof_networks.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

std::string networksOf(const ProgramInput& input, const std::string& name) {
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  const ProofResult* result = resultNamed(run, name);
  EXPECT_TRUE(result != nullptr && result->outcome == Outcome::Proved);
  return result == nullptr ? "" : networkList(result->networks);
}

TEST(Networks, NamesWritersOnly) {
  const ProgramInput input =
      inputOf("//@ prove contact: Q0.0 implies I0.0\n", "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n");
  EXPECT_EQ(networksOf(input, "contact"), "MAIN 1");
}

TEST(Networks, FollowsFlagsOfTheSameScanAndLatches) {
  // Q0.0 needs M0.0 of the same scan, and Q0.0 itself from the scan before is a latch of network 2.
  const ProgramInput input =
      inputOf("//@ prove start first: Q0.0 implies once(I0.0)\n",
              "Network 1\nLD I0.0\n= M0.0\nNetwork 2\nLD M0.0\nO Q0.0\nA I0.1\n= Q0.0\nNetwork 3\nLD Q0.0\n= Q0.1\n");
  EXPECT_EQ(networksOf(input, "start first"), "MAIN 1, 2");
}

TEST(Networks, NamesCallersAndJumps) {
  const ProgramInput input = inputOf(
      "//@ prove sub: Q0.0 implies once(I0.0)\n", "Network 1\nLD I0.5\nCALL SBR_0\nNetwork 2\nLD I0.6\n= Q0.6\n",
      "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(networksOf(input, "sub"), "MAIN 1; SBR_0 1");
}

TEST(Networks, ListJoinsRows) {
  EXPECT_EQ(networkList({{"MAIN", 1}, {"MAIN", 3}, {"MAIN", 4}, {"MAIN", 5}, {"SBR_0", 2}}), "MAIN 1, 3-5; SBR_0 2");
  EXPECT_EQ(networkList({}), "");
}

}  // namespace
}  // namespace rungproof::test
