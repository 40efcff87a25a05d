// Rules CTL, SUB, INT and SCR on cases that their examples do not show. Lines are those of the text, from 1.
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

TEST(ControlRules, LabelsBelongToBlocks) {
  // Both blocks have a label 1: legal (s7200 E13). The jump to label 2 finds it in the other block only.
  EXPECT_EQ(lines("CTL001",
                  "LD I0.0\nJMP 1\nINCB VB0\nLBL 1\nLD I0.1\nJMP 2\nLD SM0.0\nCALL 1\nMEND\nSBR 1\nLD I0.2\nJMP "
                  "1\nINCB VB1\nLBL 1\nLBL 2\nRET\n"),
            Lines{6});
}

TEST(ControlRules, LoopTimeIsBounded) {
  EXPECT_EQ(lines("CTL004", "Network 1\nLD I0.0\nFOR VW0, +1, +100\nNetwork 2\nLD SM0.0\nINCW VW2\nNetwork 3\nNEXT\n"),
            Lines());
  // 30,000 rounds of a REAL function of more than 100 us each.
  EXPECT_EQ(
      lines("CTL004", "Network 1\nLD I0.0\nFOR VW0, +1, +30000\nNetwork 2\nLD SM0.0\nSIN VD2, VD6\nNetwork 3\nNEXT\n"),
      Lines{3});
}

TEST(ControlRules, BlocksOfTheOlderDialectNeedTheirEnds) {
  EXPECT_EQ(lines("CTL006", "LD I0.0\n= Q0.0\nLD SM0.0\nCALL 1\nMEND\nSBR 1\nLD I0.1\n= Q0.1\nRET\n"), Lines());
}

TEST(InterruptRules, WhatAnInterruptWritesMayBeOverwrittenByACopy) {
  const std::string start = "LD SM0.1\nATCH 0, 0\nENI\n", end = "MEND\nINT 0\nR Q0.0, 1\nRETI\n";
  // Lines 4 to 7: QB0 is copied, changed and written back.
  EXPECT_EQ(lines("INT004", (start + "LD SM0.0\nMOVB QB0, VB0\nORB 128, VB0\nMOVB VB0, QB0\n" + end).c_str()),
            Lines{7});
  // One instruction is not interrupted; interrupts are off; a constant is no copy of the old value.
  EXPECT_EQ(lines("INT004", (start + "LD SM0.0\nORB 128, QB0\n" + end).c_str()), Lines());
  EXPECT_EQ(
      lines("INT004", (start + "LD SM0.0\nDISI\nMOVB QB0, VB0\nORB 128, VB0\nMOVB VB0, QB0\nENI\n" + end).c_str()),
      Lines());
  EXPECT_EQ(lines("INT004", (start + "LD SM0.0\nMOVB QB0, VB0\nMOVB 0, QB0\n" + end).c_str()), Lines());
}

TEST(CallRules, NineLevelsAreTooMany) {
  std::string text = "LD SM0.0\nCALL 1\nMEND\n";
  for (int n = 1; n <= 9; ++n)
    text += "SBR " + std::to_string(n) + "\n" + (n < 9 ? "CALL " + std::to_string(n + 1) : std::string("INCB VB0")) +
            "\nRET\n";
  EXPECT_EQ(lines("SUB002", text.c_str()).size(), 1U);
}

TEST(CallRules, ConditionalCallsAreNotCertain) {
  // Of calls under a contact and its inverse one runs in a scan: the edge has its memory for itself.
  EXPECT_EQ(lines("SUB006", "LD I0.0\nCALL 1\nLDN I0.0\nCALL 1\nMEND\nSBR 1\nLD I0.1\nEU\n= Q0.0\nRET\n"), Lines());
  const Linted linted("LD I0.0\nCALL 1\nLDN I0.2\nCALL 1\nMEND\nSBR 1\nLD I0.1\nEU\n= Q0.0\nRET\n");
  ASSERT_EQ(linted.of("SUB006").size(), 1U);
  EXPECT_EQ(linted.of("SUB006")[0].severity, Severity::Warning);
  EXPECT_EQ(linted.of("SUB006")[0].confirmation, Confirmation::Unconfirmed);
}

TEST(CallRules, ArgumentsInAccumulatorsAreNoLoss) {
  EXPECT_EQ(lines("SUB007", "LD SM0.0\nMOVW VW0, AC0\nCALL 1\nMOVW AC0, VW2\nMEND\nSBR 1\n+I 1, AC0\nRET\n"), Lines());
}

TEST(LocalMemory, PathsAreJoined) {
  // LW0 is written on one side of the jump only.
  EXPECT_EQ(lines("SUB005",
                  "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD SM0.0\nMOVW +1, LW0\nNetwork 3\nLBL 1\nNetwork 4\nLD "
                  "SM0.0\nMOVW LW0, VW0\n"),
            Lines{11});
  EXPECT_EQ(lines("SUB005",
                  "Network 1\nLD SM0.0\nMOVW +1, LW0\nNetwork 2\nLD I0.0\nJMP 1\nNetwork 3\nLD SM0.0\nMOVW +2, "
                  "LW0\nNetwork 4\nLBL 1\nNetwork 5\nLD SM0.0\nMOVW LW0, VW0\n"),
            Lines());
}

TEST(InterruptRules, TimedIntervals) {
  EXPECT_EQ(lines("INT002", "LD SM0.1\nATCH 0, 10\nENI\nMEND\nINT 0\nINCB VB0\nRETI\n"),
            Lines{2});  // SMB34 is never set
  EXPECT_EQ(lines("INT002", "LD SM0.1\nMOVB 0, SMB34\nATCH 0, 10\nENI\nMEND\nINT 0\nINCB VB0\nRETI\n"),
            Lines{2});                                                                               // 0 ms
  EXPECT_EQ(lines("INT002", "LD SM0.1\nATCH 0, 21\nENI\nMEND\nINT 0\nINCB VB0\nRETI\n"), Lines{2});  // no T32
}

TEST(StepRules, DummyStepsOfAConvergenceNeedNoSegment) {
  // 001:5865-5872: two branches end in steps without a segment, and a network outside tests both.
  const char* text =
      "Network 1\nLD SM0.1\nS S0.0, 2\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD I0.0\nSCRT S1.0\nNetwork 4\nSCRE\nNetwork "
      "5\nLSCR S0.1\nNetwork 6\nLD I0.1\nSCRT S1.1\nNetwork 7\nSCRE\n"
      "Network 8\nLD S1.0\nA S1.1\nS S0.0, 2\nR S1.0, 2\n";
  EXPECT_EQ(lines("SCR001", text), Lines());
  EXPECT_EQ(lines("SCR003", text), Lines());
}

TEST(ControlRules, ParametersOfCallTakeTheAreasOfTable678) {
  // 001:6753-6757: a WORD input may be AIW but not AQW; an output AQW but not AIW; HC only as a double word input.
  const auto messages = [](const std::string& actuals) {
    const Linted linted("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0, " + actuals +
                        "\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\na:WORD;\nb:DINT;\nEND_VAR\n"
                        "VAR_OUTPUT\nc:WORD;\nd:DINT;\nEND_VAR\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW #a, #c\nMOVD #b, #d\n"
                        "END_SUBROUTINE_BLOCK\n");
    return linted.messages("SUB003");
  };
  using Messages = std::vector<std::string>;
  EXPECT_EQ(messages("AIW0, HC1, AQW0, AC1"), Messages());
  EXPECT_EQ(messages("AQW0, VD0, VW4, VD8"),
            Messages{"AQW0 does not fit parameter a (WORD): table 6-78 does not list it"});
  EXPECT_EQ(messages("VW0, VD2, AIW0, VD8"),
            Messages{"AIW0 does not fit parameter c (WORD): table 6-78 does not list it"});
  EXPECT_EQ(messages("VW0, VD2, VW6, HC1"),
            Messages{"HC1 does not fit parameter d (DINT): table 6-78 does not list it"});
}

// No block and no unread network can hold an interrupt routine.
TEST(InterruptRules, AMissingRoutineIsSaidBesideOtherGaps) {
  const auto of = [](const std::string& networks, const std::string& blocks = {}) {
    return Linted("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" + networks + "END_ORGANIZATION_BLOCK\n" + blocks)
        .of("INT002")
        .size();
  };
  const std::string attach = "Network 1\nLD SM0.1\nATCH INT0, 0\nENI\n";
  const std::string routine = "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\n= Q0.1\nEND_INTERRUPT_BLOCK\n";
  EXPECT_EQ(of(attach), 1U);
  EXPECT_EQ(of(attach + "Network 2\nLD I0.0\nCALL SBR3\n"), 1U);
  EXPECT_EQ(of(attach + "Network 2\nLD I0.0\nCALL MBUS_SLAVE, M0.0, MB1\n"), 1U);
  EXPECT_EQ(of(attach + "Network 2\nLDX I0.0\n= Q0.0\n"), 1U);
  EXPECT_EQ(of("Network 1\nLD SM0.1\nATCH INT5, 2\nATCH INT0, 0\nENI\n", routine), 1U);
  EXPECT_EQ(of("Network 1\nLD I0.0\nATCH INT0, 0\nLDX\n"), 1U);
  EXPECT_EQ(of(attach, routine), 0U);
  EXPECT_EQ(of(attach + "Network 2\nLD I0.0\nCALL SBR3\n", routine), 0U);
  EXPECT_EQ(of(attach + "Network 2\nLDX I0.0\n= Q0.0\n", routine), 0U);
  EXPECT_EQ(of(attach, "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1 // password-protected\nEND_INTERRUPT_BLOCK\n"),
            0U);
  EXPECT_EQ(of("Network 1\nLD SM0.1\nDTCH 0\n"), 0U);
  EXPECT_EQ(of(attach, "INTERRUPT_BLOK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\n= Q0.1\nEND_INTERRUPT_BLOCK\n"), 0U)
      << "a heading that cannot be read may be its own";
}

// A listing may leave out the table of a protected block with its text.
TEST(ControlRules, AProtectedBlockWithoutTableHasUnknownParameters) {
  const auto of = [](const std::string& call, const std::string& name, const std::string& table = {}) {
    return Linted("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\n" + call +
                  "\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK " + name + ":SBR1\n" + table +
                  "BEGIN\nNetwork 1 // This POU is password-protected.\nEND_SUBROUTINE_BLOCK\n")
        .of("SUB003")
        .size();
  };
  const std::string table = "VAR_INPUT\nA:WORD;\nEND_VAR\n";
  EXPECT_EQ(of("CALL SBR1, I0.0, 9600, 0, 1000, M0.1, MB1", "MBUS_CTRL"), 0U);
  EXPECT_EQ(of("CALL MBUS_SLAVE, M0.1, MB1", "MBUS_SLAVE"), 0U);
  EXPECT_EQ(of("CALL SBR1, I0.0, VW0", "Secret"), 0U);
  EXPECT_EQ(of("CALL SBR1", "Secret"), 0U);
  EXPECT_EQ(of("CALL SBR1, VW0", "Secret", table), 0U);
  EXPECT_EQ(of("CALL SBR1, I0.0", "PTO0_LDPOS"), 1U) << "the manual says five (001:8291)";
  EXPECT_EQ(of("CALL SBR1, M0.1, MW1", "MBUS_SLAVE"), 1U) << "Error is a byte";
  EXPECT_EQ(of("CALL SBR1, I0.0, 9600, 0, 1000, M0.1, MW1", "MBUS_CTRL"), 1U);
  EXPECT_EQ(of("CALL SBR1, VW0, VW2", "Secret", table), 1U);
  EXPECT_EQ(of("CALL SBR1, VB0", "Secret", table), 1U);
  EXPECT_EQ(of("CALL SBR1", "Secret", table), 1U);
}

}  // namespace
}  // namespace rungproof::testing
