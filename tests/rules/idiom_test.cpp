// Correct programs in the style of real ones: no rule may report an error or a warning on them.
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

std::string findings(const char* text) {
  const Linted linted(text);
  EXPECT_FALSE(hasReadErrors(linted.program)) << text;
  std::string result;
  for (const std::string& finding : linted.all(Severity::Warning)) result += finding + "\n";
  return result;
}

TEST(Idioms, SelfHoldingMotorWithInterlock) {
  EXPECT_EQ(findings("Network 1 // left\nLD I0.0\nO Q0.0\nA I0.2\nAN Q0.1\n= Q0.0\nNetwork 2 // right\nLD I0.1\nO "
                     "Q0.1\nA I0.2\nAN Q0.0\n= Q0.1\n"),
            "");
}

TEST(Idioms, StarDeltaWithTimer) {
  EXPECT_EQ(findings("Network 1\nLD I0.0\nO Q0.0\nA I0.1\n= Q0.0\nTON T37, +50\nAN T37\n= Q0.1\nNetwork 2\nLD T37\nA "
                     "Q0.0\n= Q0.2\n"),
            "");
}

TEST(Idioms, InitialisationAndReset) {
  EXPECT_EQ(findings("Network 1\nLD SM0.1\nMOVW +0, VW0\nMOVB 0, MB0\nR Q0.0, 8\nNetwork 2\nLD I0.0\nEU\n+I +1, "
                     "VW0\nNetwork 3\nLDW>= VW0, +10\nS Q0.1, 1\nMOVW +0, VW0\n"
                     "Network 4\nLD I0.1\nR Q0.1, 1\nNetwork 5\nLD I0.2\nA M0.0\n= Q0.2\n"),
            "");
}

TEST(Idioms, SequenceWithTimersInSteps) {
  EXPECT_EQ(findings("Network 1\nLD SM0.1\nS S0.1, 1\nNetwork 2\nLSCR S0.1\nNetwork 3\nLD SM0.0\nS Q0.4, 1\nR Q0.5, "
                     "2\nTON T37, +20\nNetwork 4\nLD T37\nSCRT S0.2\nNetwork 5\nSCRE\n"
                     "Network 6\nLSCR S0.2\nNetwork 7\nLD SM0.0\nS Q0.5, 2\nR Q0.4, 1\nTON T38, +250\nNetwork 8\nLD "
                     "T38\nSCRT S0.1\nNetwork 9\nSCRE\n"),
            "");
}

TEST(Idioms, TimedInterruptAveragesAnalogueInput) {
  EXPECT_EQ(findings("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nCALL SBR0\nEND_ORGANIZATION_BLOCK\n"
                     "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD SM0.0\nMOVB 100, SMB34\nATCH INT0, "
                     "10\nENI\nEND_SUBROUTINE_BLOCK\n"
                     "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW AIW4, VW100\nMOVW VW100, "
                     "AQW0\nEND_INTERRUPT_BLOCK\n"),
            "");
}

TEST(Idioms, OlderDialectBlocksWithoutLoad) {
  EXPECT_EQ(findings("LD SM0.1\nCALL 0\nLD I0.0\nEU\nCALL 1\nMEND\nSBR 0\nMOVB 0, VB0\nRET\nSBR 1\nINCB VB0\nMOVB VB0, "
                     "QB0\nRET\n"),
            "");
}

TEST(Idioms, LibraryCalls) {
  EXPECT_EQ(findings("Network 1\nLD SM0.1\nCALL USS_INIT, 1, 9600, 16#00000001, Q0.0, VB1\nNetwork 2\nLD SM0.0\nCALL "
                     "USS_CTRL, I0.0, I0.1, I0.2, I0.3, I0.4, 0, 1, 100.0, M0.0, VB2, VW4, VD6, Q0.1, "
                     "Q0.2, Q0.3, Q0.4\n"),
            "");
}

TEST(Idioms, DataBlockAndExternalVariables) {
  EXPECT_EQ(findings("//@ external VB100..VB199\nNetwork 1\nLDW>= VW100, +10\n= Q0.0\nNetwork 2\nLD V110.3\n= Q0.1\n"),
            "");
}

TEST(Idioms, PointerWalksThroughATable) {
  EXPECT_EQ(findings("Network 1\nLD I0.0\nEU\nMOVD &VB100, AC1\nMOVD +0, AC2\nFOR VW0, +1, +10\nNetwork 2\nLD "
                     "SM0.0\nMOVW *AC1, VW300\nMOVW VW300, VW302\n+D +2, AC1\nNetwork 3\nNEXT\n"
                     "Network 4\nLDW>= VW302, +5\n= Q0.0\nNetwork 5\nLD SM0.1\nFILL +0, VW100, 10\n"),
            "");
}

TEST(Idioms, DivisionLeavesRemainderAndQuotient) {
  EXPECT_EQ(findings("Network 1\nLD SM0.0\nITD AIW0, VD200\nDIV +10, VD200\nMOVW VW202, VW210\nMOVW VW200, VW212\nMOVB "
                     "VB211, QB0\nMOVB VB213, QB1\n"),
            "");
}

}  // namespace
}  // namespace rungproof::testing
