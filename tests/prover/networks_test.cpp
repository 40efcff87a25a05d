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

// Network 2 of the subroutine makes the output, network 1 the flag that it reads; network 3 has nothing to do with
// them.
TEST(Networks, NamesWhatMakesTheOutputsOfACall) {
  const ProgramInput input = inputOf(
      "//@ prove sub: Q0.0 implies I0.0\n", "Network 1\nLD SM0.0\nCALL SBR_0, I0.0, Q0.0\nNetwork 2\nLD I0.6\n= Q0.6\n",
      "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nin:BOOL;\nEND_VAR\nVAR_OUTPUT\nout:BOOL;\nEND_VAR\nBEGIN\n"
      "Network 1\nLD #in\nA I0.7\n= M0.0\nNetwork 2\nLD M0.0\n= #out\nNetwork 3\nLD I0.4\n= M4.0\n"
      "END_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(networksOf(input, "sub"), "MAIN 1; SBR_0 1, 2");
}

// A pointer reaches V, M and Q, and no accumulator (001:1461).
TEST(Networks, NamesWhatAPointerMayReach) {
  const ProgramInput input = inputOf("//@ prove seven: VW100 = 0 or VW100 = 7\n",
                                     "Network 1\nLD SM0.0\nMOVD &VB50, VD0\nNetwork 2\nLD I0.3\nMOVW 7, VW50\n"
                                     "Network 3\nLD SM0.0\nMOVW *VD0, VW100\nNetwork 4\nLD I0.3\nMOVB IB0, AC1\n");
  EXPECT_EQ(networksOf(input, "seven"), "MAIN 1-3");
}

/// The networks of a source of an S7-300 with that property.
std::string networksOfSource(const std::string& property, const std::string& blocks, const std::string& statements) {
  const ProgramInput input = inputOfSource(blocks + "ORGANIZATION_BLOCK OB 1\n//@ prove it: " + property + "\nBEGIN\n" +
                                           statements + "END_ORGANIZATION_BLOCK\n");
  return networksOf(input, "it");
}

// Two blocks alike: only the one whose output is asked for counts, and in it the networks that make the output.
TEST(Networks, CallsOfTheS7300HandBackByReferenceAndByInstance) {
  const std::string networks = "NETWORK\nA #x;\n= #own;\nNETWORK\nA #own;\n= #y;\nNETWORK\nA I 7.0;\n= M 7.0;\n";
  std::string functions, instances;
  for (const char* number : {"1", "2"}) {
    functions += fmt::format(
        "FUNCTION FC {} : VOID\nVAR_INPUT\n x : BOOL;\nEND_VAR\nVAR_OUTPUT\n y : BOOL;\nEND_VAR\nVAR_TEMP\n own : "
        "BOOL;\nEND_VAR\nBEGIN\n{}END_FUNCTION\n",
        number, networks);
    instances += fmt::format(
        "FUNCTION_BLOCK FB {0}\nVAR_INPUT\n x : BOOL;\nEND_VAR\nVAR_OUTPUT\n y : BOOL;\nEND_VAR\nVAR\n own : "
        "BOOL;\nEND_VAR\nBEGIN\n{1}END_FUNCTION_BLOCK\nDATA_BLOCK DB {0}\nFB {0}\nBEGIN\nEND_DATA_BLOCK\n",
        number, networks);
  }
  EXPECT_EQ(networksOfSource("Q0.1 implies I0.1", functions,
                             "NETWORK\nCALL FC 1 (x := I 0.0, y := Q 0.0);\nNETWORK\nCALL FC 2 (x := I 0.1, y := Q "
                             "0.1);\n"),
            "OB1 2; FC2 1, 2");
  EXPECT_EQ(networksOfSource("Q0.1 implies I0.1", instances,
                             "NETWORK\nCALL FB 1, DB 1 (x := I 0.0, y := Q 0.0);\nNETWORK\nCALL FB 2, DB 2 (x := I "
                             "0.1, y := Q 0.1);\n"),
            "OB1 2; FB2 1, 2");
  EXPECT_EQ(networksOfSource("DB2.DBX2.0 implies I0.1", instances,
                             "NETWORK\nCALL FB 1, DB 1 (x := I 0.0, y := Q 0.0);\nNETWORK\nCALL FB 2, DB 2 (x := I "
                             "0.1, y := Q 0.1);\n"),
            "OB1 2; FB2 1, 2");
}

// The open data block, an address register and the RLO come out of networks before.
TEST(Networks, RegistersOfTheS7300TieNetworksTogether) {
  const std::string data =
      "DATA_BLOCK DB 1\nSTRUCT\n w : ARRAY [1 .. 4] OF WORD;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  EXPECT_EQ(networksOfSource("MW20 = 0", data,
                             "NETWORK\nOPN DB 1;\nNETWORK\nA I 7.0;\n= M 7.0;\nNETWORK\nL DBW 2;\nT MW 20;\n"),
            "OB1 1, 3");
  EXPECT_EQ(networksOfSource("MW20 = 0", data,
                             "NETWORK\nLAR1 P#30.0;\nNETWORK\nA I 7.0;\n= Q 7.0;\nNETWORK\nL MW [AR1,P#2.0];\nT MW "
                             "20;\n"),
            "OB1 1, 3");
  EXPECT_EQ(networksOfSource("MW20 = 3", data, "NETWORK\nL 3;\nNETWORK\nT MW 20;\n"), "OB1 1, 2");
}

TEST(Networks, ListJoinsRows) {
  EXPECT_EQ(networkList({{"MAIN", 1}, {"MAIN", 3}, {"MAIN", 4}, {"MAIN", 5}, {"SBR_0", 2}}), "MAIN 1, 3-5; SBR_0 2");
  EXPECT_EQ(networkList({}), "");
}

}  // namespace
}  // namespace rungproof::test
