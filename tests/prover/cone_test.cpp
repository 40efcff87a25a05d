// Which networks the encoding of a question leaves out: those that can have no effect on what is asked. Each way in
// which one network can act on another keeps it in; that the rest changes nothing is compared with the engine in
// tests/differential.
#include <gtest/gtest.h>

#include "analysis/unread/cone_of_influence.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof {
namespace {

/// Networks of the main program outside the cone of Q0.0: "2 4". "all in" where nothing is left out.
std::string outsideOfLamp(const std::string& networks, const std::string& otherBlocks = "") {
  const ProgramInput input = test::inputOf("", networks, otherBlocks);
  const PlaceRow lamp = rowOf(Area::Q, Width::Bit, 0, 0);
  const std::vector<bool> isOutside = outsideCone(Facts(input.program), std::span(&lamp, 1));
  std::string text;
  const Pou& main = input.program.pous[0];
  for (std::size_t n = 0; n < main.networks.size() && !isOutside.empty(); ++n) {
    const std::vector<Instruction>& row = main.networks[n].instructions;
    const bool isLeftOut = std::ranges::all_of(row, [&](const Instruction& i) { return isOutside[i.id]; });
    EXPECT_TRUE(isLeftOut || std::ranges::none_of(row, [&](const Instruction& i) { return isOutside[i.id]; }));
    if (isLeftOut) text += (text.empty() ? "" : " ") + std::to_string(n + 1);
  }
  return text.empty() ? "all in" : text;
}

constexpr const char* lamp = "Network 1\nLD M0.0\n= Q0.0\n";
constexpr const char* stranger = "Network 9\nLD I1.0\n= Q1.1\n";

std::string withStranger(const std::string& networks, const std::string& otherBlocks = "") {
  return outsideOfLamp(lamp + networks + stranger, otherBlocks);
}

TEST(Cone, FollowsWritersBackwards) {
  // Q0.0 <- M0.0 <- T37 <- I0.1 and VW10 <- VW12; what is written for others only stays out.
  EXPECT_EQ(withStranger("Network 2\nLD T37\n= M0.0\nNetwork 3\nLD I0.1\nTON T37, VW10\nNetwork 4\nLD I0.2\nMOVW VW12, "
                         "VW10\nNetwork 5\nLD Q0.0\n= M3.0\n"),
            "5 6");
}

TEST(Cone, PartsOfAPlaceCount) {
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nMOVB VB0, MB0\n"), "3");        // the byte of M0.0
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nMOVD VD0, MD0\n"), "3");        // the double word
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nMOVB VB0, MB1\n"), "2 3");      // the byte beside it
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nFILL 0, VW0, 4\n"), "2 3");     // other words
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nFILL 0, MW0, 4\n"), "3");       // words over M0.0
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nBMB VB0, VB8, VB1\n"), "2 3");  // up to 255 bytes of V
}

TEST(Cone, RowsOfBitsReachAsFarAsTheirCount) {
  // R M0.0 is within reach of 1 and of a count that memory holds; a row from M0.1 is not.
  EXPECT_EQ(outsideOfLamp("Network 1\nLD M1.0\n= Q0.0\nNetwork 2\nLD I0.1\nR M0.6, 3\n"), "all in");
  EXPECT_EQ(outsideOfLamp("Network 1\nLD M1.0\n= Q0.0\nNetwork 2\nLD I0.1\nR M0.6, 2\n"), "2");
  EXPECT_EQ(outsideOfLamp("Network 1\nLD M1.0\n= Q0.0\nNetwork 2\nLD I0.1\nR M0.6, VB0\n"), "all in");
}

TEST(Cone, WhatMovesTheFlowStaysIn) {
  // What a jump, an END or a step depends on decides whether the coil is reached.
  EXPECT_EQ(withStranger("Network 2\nLD M5.0\nJMP 1\nNetwork 3\nLD I0.5\n= M5.0\nNetwork 4\nLBL 1\n"), "5");
  EXPECT_EQ(withStranger("Network 2\nLD M5.0\nEND\nNetwork 3\nLD I0.5\n= M5.0\n"), "4");
  EXPECT_EQ(withStranger("Network 2\nLD M5.0\nSTOP\nNetwork 3\nLD I0.5\n= M5.0\n"), "4");
  EXPECT_EQ(withStranger("Network 2\nLSCR S0.0\nNetwork 3\nLD M5.0\nSCRT S0.1\nNetwork 4\nSCRE\nNetwork 5\nLD I0.5\n= "
                         "M5.0\n"),
            "6");
  EXPECT_EQ(withStranger("Network 2\nLD SM0.0\nFOR VW0, 1, VW2\nNetwork 3\nNEXT\nNetwork 4\nLD I0.1\nMOVW VW4, VW2\n"),
            "5");
}

TEST(Cone, WhatCanEndTheProgramStaysIn) {
  // A compare contact with a number that is not legal ends it (001:13935), with integers nothing can happen.
  EXPECT_EQ(withStranger("Network 2\nLDR> VD0, 1.0\n= M7.0\nNetwork 3\nLD I0.1\nMOVD VD4, VD0\n"), "4");
  EXPECT_EQ(withStranger("Network 2\nLDD> VD0, 1\n= M7.0\nNetwork 3\nLD I0.1\nMOVD VD4, VD0\n"), "2 3 4");
}

TEST(Cone, PointersMayWriteAnything) {
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nMOVB 1, *VD0\nNetwork 3\nLD I0.2\nMOVD &VB100, VD0\n"), "4");
  // What is read through one may be anything, too: the whole program is in where the cone reads through a pointer.
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nMOVB *VD0, MB0\n"), "all in");
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nMOVB *VD0, VB9\n"), "2 3");
}

TEST(Cone, StatusBitsHaveManyWriters) {
  // SM1.0 is written by every addition; SM4.3 by every run-time error.
  EXPECT_EQ(outsideOfLamp("Network 1\nLD SM1.0\n= Q0.0\nNetwork 2\nLD I0.1\n+I VW0, VW2\nNetwork 3\nLD I0.2\nMOVB 1, "
                          "VB9\n"),
            "3");
  EXPECT_EQ(outsideOfLamp("Network 1\nLD SM4.3\n= Q0.0\nNetwork 2\nLD I0.2\nMOVB 1, VB9\n"), "all in");
}

TEST(Cone, LevelsOfTheStackGoFromNetworkToNetwork) {
  // Network 3 ands what network 2 has left.
  EXPECT_EQ(withStranger("Network 2\nLD I0.1\nLD I0.2\n= M7.0\nNetwork 3\nALD\n= M0.0\n"), "all in");
}

TEST(Cone, DevicesStayIn) {
  EXPECT_EQ(withStranger("Network 2\nLD SM0.1\nMOVB 16#F8, SMB37\nHDEF 0, 0\nHSC 0\n"), "3");
  EXPECT_EQ(withStranger("Network 2\nLD SM0.1\nMOVB 9, SMB30\nNetwork 3\nLD I0.1\nXMT VB100, 0\n"), "all in");
  // A timed interrupt with its time; what its routine writes for others is left out with the routine's network.
  EXPECT_EQ(withStranger("Network 2\nLD SM0.1\nMOVB 10, SMB34\nATCH INT_0, 10\nENI\n",
                         "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCB VB0\nEND_INTERRUPT_BLOCK\n"),
            "3");
  // T32 raises event 21 (001:5476).
  EXPECT_EQ(withStranger("Network 2\nLD SM0.1\nATCH INT_0, 21\nENI\nNetwork 3\nLD I0.5\nTON T32, 10\nNetwork 4\nLD "
                         "I0.6\nTON T37, 10\n",
                         "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCB MB0\nEND_INTERRUPT_BLOCK\n"),
            "4 5");
}

TEST(Cone, BlocksThatAreCalledAreLookedInto) {
  const char* block =
      "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.7\n= M0.0\nNetwork 2\nLD I0.6\n= M9.0\n"
      "END_SUBROUTINE_BLOCK\n";
  EXPECT_EQ(withStranger("Network 2\nLD M5.0\nCALL SBR_0\nNetwork 3\nLD I0.5\n= M5.0\n", block), "4");
}

TEST(Cone, VerdictsAreThoseOfTheWholeProgram) {
  // Fifty strangers, and the two networks that decide.
  std::string networks = "Network 1\nLD I0.0\nAN Q0.1\n= Q0.0\nNetwork 2\nLD I0.1\nAN Q0.0\n= Q0.1\n";
  for (int i = 3; i < 53; ++i) {
    const std::string n = std::to_string(i);
    networks += "Network " + n + "\nLD I1.1\nTON T" + std::to_string(34 + i) + ", 20\nMUL VW" + std::to_string(2 * i) +
                ", VD" + std::to_string(200 + 4 * i) + "\n";
  }
  const ProgramInput input = test::inputOf(
      "//@ prove apart: never Q0.0 and Q0.1\n//@ reach second: Q0.1\n//@ prove wrong: Q0.0 implies not I0.1\n",
      networks);
  for (const bool usesCone : {true, false}) {
    ProverOptions options = test::usualOptions();
    options.usesCone = usesCone;
    const ProofRun run = prove(input.program, input.properties, options);
    EXPECT_EQ(test::outcomeOf(run, "apart"), Outcome::Proved);
    EXPECT_EQ(test::outcomeOf(run, "second"), Outcome::Reachable);
    EXPECT_EQ(test::outcomeOf(run, "wrong"), Outcome::Violated);
    EXPECT_TRUE(run.disagreements.empty());
  }
}

}  // namespace
}  // namespace rungproof
