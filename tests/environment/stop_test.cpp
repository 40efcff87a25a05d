// Scans that a fatal error ends have no end: nothing is written, the CPU is in STOP with its outputs off
// (001:13906-13910), and no property is asked about them. STOP itself ends a scan (001:5691-5695).
#include <gtest/gtest.h>

#include "tests/engine/rig.hpp"
#include "tests/environment/asked.hpp"

namespace rungproof {
namespace {

using test::asked;
using test::verdict;

// Comparison with a REAL that is none: error 0012 (001:13935), with I0.0 in any scan.
const std::string badReal = "LD I0.0;MOVD 16#7FC00000,VD0;LDR= VD0,1.0;= M0.0;";
const std::string mirror = "LD I0.1;= Q0.0";

TEST(ScanWithoutEnd, IllegalRealInAComparison) {
  EXPECT_EQ(verdict({badReal + mirror, "Q0.0 = I0.1"}), Outcome::Proved);
  EXPECT_EQ(verdict({badReal + mirror, "never I0.0"}), Outcome::Proved);  // no scan with I0.0 comes to its end
  EXPECT_EQ(verdict({badReal + mirror, "reach Q0.0"}), Outcome::Reachable);
  EXPECT_EQ(verdict({badReal + mirror, "reach I0.0"}), Outcome::Unreachable);
}

// Error 0011 (001:13934): VD0 names nothing.
TEST(ScanWithoutEnd, BadPointerInAComparison) {
  EXPECT_EQ(verdict({"LD I0.2;MOVD 16#FFFFFFFF,VD0;LDB= *VD0,1;= M0.0;" + mirror, "never I0.2"}), Outcome::Proved);
  EXPECT_EQ(verdict({"LD I0.2;MOVD 16#FFFFFFFF,VD0;LDB= *VD0,1;= M0.0;" + mirror, "Q0.0 = I0.1"}), Outcome::Proved);
}

// Other pointers, division by 0 and calls that nest too deeply are no fatal errors (001:13945): the scan goes on.
TEST(ScanWithoutEnd, OtherErrorsLetTheScanGoOn) {
  EXPECT_EQ(verdict({"LD I0.0;MOVD 16#FFFFFFFF,VD0;LD I0.2;MOVB 1,*VD0;" + mirror, "Q0.0 = I0.1"}), Outcome::Proved);
  EXPECT_EQ(verdict({"LD I0.0;MOVD 16#FFFFFFFF,VD0;LD I0.0;MOVB 1,*VD0;" + mirror, "reach I0.0 and Q0.0"}),
            Outcome::Reachable);
  EXPECT_EQ(verdict({"LD I0.0;DIV 0,VD0;" + mirror, "reach I0.0 and Q0.0"}), Outcome::Reachable);
}

TEST(ScanWithoutEnd, InAnInterruptRoutine) {
  const test::Asked routine{"LD SM0.1;ATCH INT_0,10;ENI;LD SM0.0;MOVB 5,SMB34;" + mirror,
                            "Q0.0 = I0.1",
                            10,
                            0,
                            "",
                            "INTERRUPT_BLOCK INT_0:INT0;BEGIN;Network 1;LD SM0.0;MOVD 16#7FC00000,VD0;LDR= VD0,1.0;"
                            "= M0.0;END_INTERRUPT_BLOCK"};
  EXPECT_EQ(verdict(routine), Outcome::Proved);
}

// What was on stays on only until the scan that is cut off; nothing is asked after it.
TEST(ScanWithoutEnd, PatternsOverSeveralScans) {
  EXPECT_EQ(verdict({badReal + mirror, "I0.1 leads to I0.0 within 3 scans"}), Outcome::Violated);
  EXPECT_EQ(verdict({badReal + mirror, "prev(I0.1) = prev(Q0.0)"}), Outcome::Proved);
  EXPECT_EQ(verdict({badReal + mirror, "once(I0.1) = once(Q0.0)"}), Outcome::Proved);
  EXPECT_EQ(verdict({badReal + mirror, "held(I0.1, 50ms) = held(Q0.0, 50ms)", 10}), Outcome::Proved);
}

// Instructions in front of the error did run.
TEST(ScanWithoutEnd, PropertiesOfEveryInstructionSeeWhatRan) {
  const std::string program = "LD I0.0;= M1.0;MOVD 16#7FC00000,VD0;LDR= VD0,1.0;= M0.0;LD I0.1;= Q0.0";
  EXPECT_EQ(verdict({program, "never M1.0", 10}), Outcome::Proved);
  const ProgramInput input =
      test::inputOf("//@ at every instruction prove inside: never M1.0\n", "Network 1\n" + test::linesOf(program));
  EXPECT_EQ(test::outcomeOf(prove(input.program, input.properties, test::usualOptions()), "inside"), Outcome::Violated);
}

TEST(ScanWithoutEnd, AssumptionsAreNotAskedEither) {
  test::Asked question{badReal + mirror, "reach Q0.0", 10};
  question.declarations = "assume held: I0.1 or I0.0";
  EXPECT_EQ(verdict(question), Outcome::Reachable);
}

// The scan of a STOP has its end: the image is as the program left it.
TEST(Stop, EndsItsScan) {
  EXPECT_EQ(verdict({"LD I0.1;= Q0.0;LD I0.0;STOP", "Q0.0 = I0.1"}), Outcome::Proved);
  EXPECT_EQ(verdict({"LD I0.1;= Q0.0;LD I0.0;STOP", "reach I0.0 and Q0.0"}), Outcome::Reachable);
  EXPECT_EQ(verdict({"LD I0.0;STOP;" + mirror, "Q0.0 = I0.1"}), Outcome::Violated);
  EXPECT_EQ(verdict({"LD I0.1;= Q0.0;LD I0.0;STOP", "not prev(I0.0) or first_scan"}), Outcome::Proved);
}

TEST(Stop, OfAnInterruptRoutineLetsTheScanEnd) {
  const test::Asked routine{"LD SM0.1;ATCH INT_0,10;ENI;LD SM0.0;MOVB 5,SMB34;" + mirror,
                            "Q0.0 = I0.1",
                            10,
                            0,
                            "",
                            "INTERRUPT_BLOCK INT_0:INT0;BEGIN;Network 1;LD SM0.0;STOP;END_INTERRUPT_BLOCK"};
  EXPECT_EQ(verdict(routine), Outcome::Proved);
}

TEST(Stop, WhatIsNotAskedIsAnAssumption) {
  const auto saysSo = [](const ProofResult& result) {
    return std::ranges::any_of(result.assumptions, [](const std::string& a) { return a.find("in STOP") != a.npos; });
  };
  EXPECT_TRUE(saysSo(asked({badReal + mirror, "Q0.0 = I0.1"})));
  EXPECT_TRUE(saysSo(asked({"LD I0.1;= Q0.0;LD I0.0;STOP", "Q0.0 = I0.1"})));
  EXPECT_FALSE(saysSo(asked({mirror, "Q0.0 = I0.1"})));
}

// The engine: outputs off, image as it was, the reason in its list of errors.
TEST(Stop, OfTheEngineWritesNothing) {
  Rig rig("LD I0.0\nMOVD 16#7FC00000, VD0\nLD I0.1\n= Q0.0\nLDR= VD0, 1.0\n= M0.0\nLD I0.2\n= Q0.1\n");
  rig.set("I0.1", 1);
  rig.scans(1);
  ASSERT_TRUE(rig.simulator->physicalOutput(0, 0));
  rig.set("I0.0", 1);
  rig.set("I0.2", 1);
  rig.scans(1);
  EXPECT_FALSE(rig.simulator->isRunning());
  EXPECT_FALSE(hasScanEnd(rig.simulator->store()));
  EXPECT_FALSE(rig.simulator->physicalOutput(0, 0));
  EXPECT_EQ(rig.get("Q0.1"), 0);
  ASSERT_NE(rig.simulator->errors().fatal(), nullptr);
  EXPECT_EQ(rig.simulator->errors().fatal()->hazard, Hazard::FatalReal);
}

}  // namespace
}  // namespace rungproof
