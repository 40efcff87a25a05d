// Functions of date, time and text in the transition system and on the engine: the same memory after random scans.
// RUNGPROOF_SEED chooses other inputs.
#include <gtest/gtest.h>

#include <cstdlib>

#include "frontend/input/project.hpp"
#include "tests/agreement7/encoder_run.hpp"

namespace rungproof::agreement7 {
namespace {

std::uint64_t seedOf(std::uint64_t standard) {
  const char* text = std::getenv("RUNGPROOF_SEED");
  return text == nullptr ? standard : std::strtoull(text, nullptr, 10);
}

void expectAgreement(const std::string& blocks, const std::string& statements) {
  const std::uint64_t seed = seedOf(50040601);
  const Program program = readText(
      "x.awl", blocks + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statements + "\nEND_ORGANIZATION_BLOCK\n");
  for (const Finding& finding : program.findings) FAIL() << finding.message;
  int scans = 0;
  for (std::uint64_t one = seed; one < seed + 400 && scans < 60; ++one) {  // not all inputs make a scan
    const AgreementOutcome outcome = compareWithEngine(program, one, 30);
    ASSERT_EQ(outcome.difference, "") << "seed " << one << "\n" << statements;
    ASSERT_TRUE(outcome.isExact) << outcome.approximation;
    scans += outcome.scans;
  }
  EXPECT_GE(scans, 60);
}

/// Two moments, a and b, of any day and time of day.
const char* const moments =
    "DATA_BLOCK DB 5\nSTRUCT\n  a : DATE_AND_TIME;\n  b : DATE_AND_TIME;\n  c : DATE_AND_TIME;\n  s : STRING [5];\n"
    "  t : STRING [3];\n  u : STRING [8];\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
const char* const anyMoments =
    "L ID 0; L DW#16#7FFFFFFF; AD; L L#86400000; MOD; T MD 20; L IW 4; L W#16#7FFF; AW; T MW 24;\n"
    "CALL FC 3 (IN1 := MW 24, IN2 := MD 20, RET_VAL := DB5.a);\n"
    "L ID 6; L DW#16#7FFFFFFF; AD; L L#86400000; MOD; T MD 26; L IB 5; L MW 24; XOW; T MW 30;\n"
    "CALL FC 3 (IN1 := MW 30, IN2 := MD 26, RET_VAL := DB5.b);\n";

TEST(LibraryAgreement, MomentsAndTheirSums) {
  expectAgreement(
      moments,
      std::string(anyMoments) +
          "CALL FC 1 (T := DB5.a, D := ID 10, RET_VAL := DB5.c);\n"
          "CALL FC 35 (T := DB5.b, D := ID 10, RET_VAL := DB5.b);\n"
          "CALL FC 6 (IN := DB5.c, RET_VAL := MW 40); CALL FC 7 (IN := DB5.c, RET_VAL := MW 42);\n"
          "CALL FC 8 (IN := DB5.c, RET_VAL := MD 44); CALL FC 34 (DT1 := DB5.a, DT2 := DB5.b, RET_VAL := MD 48);");
}

TEST(LibraryAgreement, MomentsCompared) {
  std::string calls = anyMoments;
  int bit = 0;
  for (const int number : {9, 12, 14, 18, 23, 28})
    calls += "CALL FC " + std::to_string(number) + " (DT1 := DB5.a, DT2 := DB5.b, RET_VAL := M 50." +
             std::to_string(bit++) + ");\n";
  expectAgreement(moments,
                  calls + "CALL FC 33 (IN := IW 0, RET_VAL := MD 52); CALL FC 40 (IN := ID 2, RET_VAL := MW 56);");
}

/// Texts of any length that they have room for, of few different characters.
const char* const anyTexts =
    "L IB 0; L 3; AW; T DB5.DBB 25; L IB 1; L 3; AW; T DB5.DBB 33;\n"
    "L ID 2; L DW#16#01010101; AD; T DB5.DBD 26;\n"
    "L IB 7; L 1; AW; T DB5.DBB 34; L IB 8; L 1; AW; T DB5.DBB 35; L IB 9; L 1; AW; T DB5.DBB 36;\n"
    "L IB 10; L 3; AW; T MW 20; L IB 11; L 3; AW; T MW 22;\n";

TEST(LibraryAgreement, TextsOfTexts) {
  for (const char* call : {"FC 2 (IN1 := DB5.s, IN2 := DB5.t", "FC 4 (IN := DB5.s, L := MW 20, P := MW 22",
                           "FC 17 (IN1 := DB5.s, IN2 := DB5.t, P := MW 20", "FC 20 (IN := DB5.s, L := MW 20",
                           "FC 26 (IN := DB5.s, L := MW 20, P := MW 22", "FC 32 (IN := DB5.s, L := MW 20",
                           "FC 31 (IN1 := DB5.s, IN2 := DB5.t, L := MW 20, P := MW 22"})
    expectAgreement(moments, std::string(anyTexts) + "CALL " + call + ", RET_VAL := DB5.u);");
}

TEST(LibraryAgreement, TextsFoundAndCompared) {
  std::string calls = anyTexts;
  int bit = 0;
  for (const int number : {10, 13, 15, 19, 24, 29})
    calls += "CALL FC " + std::to_string(number) + " (S1 := DB5.s, S2 := DB5.t, RET_VAL := M 50." +
             std::to_string(bit++) + ");\n";
  expectAgreement(moments, calls +
                               "CALL FC 11 (IN1 := DB5.s, IN2 := DB5.t, RET_VAL := MW 52); "
                               "CALL FC 21 (S := DB5.s, RET_VAL := MW 54);");
}

}  // namespace
}  // namespace rungproof::agreement7
