// Time-delay interrupts, delayed interrupts, error blocks and masks in the transition system and on the engine: the
// same memory after random scans, with interrupts, failing modules and masked errors at random. RUNGPROOF_SEED chooses
// others.
#include <gtest/gtest.h>

#include <cstdlib>

#include "frontend/input/project.hpp"
#include "tests/agreement7/encoder_run.hpp"

namespace rungproof::agreement7 {
namespace {

std::string organizationBlock7(int number, const std::string& statements) {
  return "ORGANIZATION_BLOCK OB " + std::to_string(number) +
         "\nVAR_TEMP\n  info : ARRAY[0..19] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\n" + statements +
         "\nEND_ORGANIZATION_BLOCK\n";
}

void expectSameScans(const std::string& blocks) {
  const char* chosen = std::getenv("RUNGPROOF_SEED");
  const std::uint64_t seed = chosen == nullptr ? 20320035 : std::strtoull(chosen, nullptr, 10);
  const Program program = readText("x.awl", blocks);
  for (const Finding& finding : program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  int scans = 0;
  std::string approximation;
  for (std::uint64_t one = seed; one < seed + 25 && scans < 60; ++one) {
    const AgreementOutcome outcome = compareWithEngine(program, one, 20);
    ASSERT_EQ(outcome.difference, "") << "seed " << one << "\n" << blocks;
    scans += outcome.scans;
    approximation = outcome.approximation;
  }
  EXPECT_GE(scans, 20) << approximation << blocks;
}

const std::string count = "L MW 12; L 1; +I; T MW 12;";
const std::string start = "CALL SFC 32 (OB_NR := 20, DTIME := T#12MS, SIGN := MW 16, RET_VAL := MW 20);";
const std::string cancel = "CALL SFC 33 (OB_NR := 20, RET_VAL := MW 22);";

TEST(OrganizationAgreement, DelaysStartedAndCancelled) {
  expectSameScans(organizationBlock7(1, "A I 0.0; FP M 1.0; JCN a;" + start + "a: A I 0.1; JCN b;" + cancel +
                                            "b: L MW 12; T MW 14; L MW 16; L 1; +I; T MW 16;") +
                  organizationBlock7(20, count + "L LW 6; T MW 18;"));
}

TEST(OrganizationAgreement, DelaysOfASubroutineThatIsCalledTwice) {
  const std::string fc =
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  number : INT;\n  time : TIME;\nEND_VAR\nBEGIN\nNETWORK\nA I 0.0; JCN a;"
      "CALL SFC 32 (OB_NR := #number, DTIME := #time, SIGN := W#16#1, RET_VAL := MW 20);\na: NOP 0;\nEND_FUNCTION\n";
  expectSameScans(fc +
                  organizationBlock7(1,
                                     "L ID 4; L DW#16#3F; AD; T MD 30; CALL FC 1 (number := 20, time := MD 30);"
                                     "L MW 12; T MW 14; L MW 32; T MW 34; CALL FC 1 (number := 21, time := T#9MS);") +
                  organizationBlock7(20, count) + organizationBlock7(21, "L MW 32; L 2; +I; T MW 32;"));
}

TEST(OrganizationAgreement, DelaysThatBlocksRestart) {
  expectSameScans(organizationBlock7(100, start) + organizationBlock7(1, "L MW 12; T MW 14;") +
                  organizationBlock7(20, count + "A I 0.0; JCN a;" + start + "a: NOP 0;"));
}

TEST(OrganizationAgreement, InterruptsThatAreDelayed) {
  expectSameScans(organizationBlock7(
                      1,
                      "L MW 12; T MW 14; A I 0.0; JCN a; CALL SFC 41 (RET_VAL := MW 20); a: L MW 12; T MW 24; A I 0.1;"
                      "JCN b; CALL SFC 42 (RET_VAL := MW 22); b: L MW 28; T MW 26;" +
                          start) +
                  organizationBlock7(20, count) + organizationBlock7(35, "L MW 28; L 1; +I; T MW 28;"));
}

const std::string errors =
    "L PIW 256; T MW 4; L 10; A I 0.3; JC t; L 11; t: T MW 6; OPN DB [MW 6]; L DBW 2; T MW 8; L 7; T DBW 0; L IW 4; "
    "BTI; T MW 10;"
    "L MW 4; T PQW 260; L DB10.DBW 0; T MW 30;";
const std::string data =
    "DATA_BLOCK DB 10\nSTRUCT\n  a : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
    "DATA_BLOCK DB 11\nREAD_ONLY\nSTRUCT\n  a : INT := 5;\n  b : INT := 6;\nEND_STRUCT;\nBEGIN\n"
    "END_DATA_BLOCK\n";

TEST(OrganizationAgreement, ErrorsThatBlocksTake) {
  const std::string given = "A I 0.0; JCN a; CALL SFC 44 (VAL := MD 12, RET_VAL := MW 20); a: NOP 0;";
  expectSameScans(data + organizationBlock7(1, errors) + organizationBlock7(121, count + "L LB 1; T MB 24;" + given) +
                  organizationBlock7(122, "L MW 26; L 1; +I; T MW 26;" + given));
}

TEST(OrganizationAgreement, ErrorsThatAreMasked) {
  const std::string mask =
      "A I 0.1; JCN m; CALL SFC 36 (PRGFLT_SET_MASK := DW#16#FF, ACCFLT_SET_MASK := DW#16#FF, RET_VAL := MW 40, "
      "PRGFLT_MASKED := MD 42, ACCFLT_MASKED := MD 46); m: A I 0.2; JCN n; CALL SFC 37 (PRGFLT_RESET_MASK := DW#16#FF, "
      "ACCFLT_RESET_MASK := DW#16#FF, RET_VAL := MW 40, PRGFLT_MASKED := MD 42, ACCFLT_MASKED := MD 46); n: NOP 0;";
  expectSameScans(data + organizationBlock7(1, mask + errors) + organizationBlock7(121, count) +
                  organizationBlock7(122, "L MW 26; L 1; +I; T MW 26;"));
  expectSameScans(data + organizationBlock7(1, mask + errors));
}

}  // namespace
}  // namespace rungproof::agreement7
