// Programs of which the vector code has forms of its own: loops that all traces go through alike or each for itself,
// what they count with written by pointers, calls that are done for all, sums that overflow. Each with registers of 512
// and of 256 bits, as far as the processor has them, against the reference engine.
#include <gtest/gtest.h>

#include <algorithm>

#include "frontend/input/project.hpp"
#include "tests/lanes/many_pair.hpp"

namespace rungproof::test {
namespace {

using lanes::Vectors;

Program mainOf(const std::string& text) {
  return readText("forms.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\n" + text);
}

/// Runs the program with all that the processor has; gives the share of its scans that ran side by side, in percent.
std::size_t agreeing(const std::string& text, std::uint32_t leastMs = 10) {
  const Program program = mainOf(text);
  for (const Finding& finding : program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  std::size_t least = 100;
  for (const Vectors most : {Vectors::Bits256, Vectors::Bits512}) {
    if (lanes::vectorsHere() < most) continue;
    for (std::uint64_t k = 0; k < 4; ++k) {
      const std::uint64_t seed = testSeed() + k;
      RandomSource random(seed);
      ManyOptions options;
      options.most = most;
      options.leastMs = leastMs;
      const ManyOutcome outcome = runBeside(program, random, options);
      EXPECT_EQ(outcome.hindrance, "");
      EXPECT_EQ(outcome.difference, "") << "seed " << seed << ", vectors " << static_cast<int>(most);
      least = std::min(least, outcome.sideBySide * 100 / std::max<std::size_t>(outcome.traceScans, 1));
    }
  }
  return least;
}

TEST(LaneForms, GroupsAreAsLargeAsTheRegistersAllow) {
  const Program program = mainOf("LD I0.0\n+I VW0, VW2\nEND_ORGANIZATION_BLOCK\n");
  const auto lanesWith = [&](Vectors most) { return ManyTraces(program, {}, 2, most).lanes(); };
  EXPECT_EQ(lanesWith(Vectors::None), 0U);
  EXPECT_EQ(lanesWith(Vectors::Bits256), lanes::vectorsHere() >= Vectors::Bits256 ? 32U : 0U);
  EXPECT_EQ(lanesWith(lanes::vectorsHere()),
            lanes::vectorsHere() == Vectors::Bits512 ? 64U : lanesWith(Vectors::Bits256));
}

/// All traces have the counters and the addresses in common, and each its own words.
TEST(LaneForms, LoopsOfAllTracesAlike) {
  EXPECT_EQ(agreeing("LD SM0.0\nMOVD &VB0, AC1\nMOVD &VB200, AC2\nMOVW 0, AC0\nFOR VW300, 1, 20\n"
                     "LD SM0.0\nMOVW *AC1, VW304\n+I VW304, AC0\nMOVW AC0, *AC2\n+D 2, AC1\n+D 2, AC2\n"
                     "LDW> *AC1, VW306\nMOVW *AC1, VW306\nMOVW VW300, VW308\nNEXT\nLDW>= VW306, 500\n= Q0.0\n"
                     "END_ORGANIZATION_BLOCK\n"),
            100U);
}

/// As many rounds as inputs say, by addresses that differ, within a loop of all.
TEST(LaneForms, LoopsOfEachTrace) {
  EXPECT_EQ(agreeing("LD SM0.0\nMOVB IB0, VB311\nMOVB 0, VB310\nANDW 7, VW310\nFOR VW300, 1, 3\n"
                     "LD SM0.0\nMOVD &VB0, AC1\nLD I1.0\n+D 40, AC1\nLD SM0.0\nFOR VW302, 0, VW310\n"
                     "LD SM0.0\n+I *AC1, VW320\nLD I1.1\nMOVW VW302, *AC1\nLD SM0.0\n+D 2, AC1\nNEXT\nLD SM0.0\n"
                     "INCW VW322\nNEXT\nEND_ORGANIZATION_BLOCK\n"),
            100U);
}

/// Where a pointer changes what a loop counts with, the trace leaves the code; others stay.
TEST(LaneForms, CountersThatPointersWrite) {
  const std::string loop =
      "LD SM0.0\nFOR VW300, 1, 5\nLD SM0.0\nMOVW 10, *AC1\n+D 1, AC1\nINCW VW310\nNEXT\nEND_ORGANIZATION_BLOCK\n";
  const std::size_t byTrace = agreeing("LD SM0.0\nMOVD &VB400, AC1\nLD I0.0\nA I0.1\nMOVD &VB297, AC1\n" + loop);
  const std::size_t byAll = agreeing("LD SM0.0\nMOVD &VB297, AC1\n" + loop);
  // Code for 512 bits takes for granted what all loops count with (lane_common.cpp). That for 256 bits counts by trace,
  // so that no trace has to leave it.
  const bool isWide = lanes::vectorsHere() == Vectors::Bits512;
  EXPECT_EQ(byTrace < 100, isWide);
  EXPECT_EQ(byAll < 100, isWide);
  EXPECT_EQ(agreeing("LD SM0.0\nMOVD &VB302, AC1\n" + loop), 100U);
}

/// The second call is made by the first one; results of calls that are not taken reach nothing.
TEST(LaneForms, CallsThatSomeTake) {
  const std::string bodies =
      "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\non:BOOL;\nvalue:INT;\nEND_VAR\nVAR_OUTPUT\n"
      "result:INT;\nEND_VAR\nBEGIN\nNetwork 1\nLD #on\nMOVW #value, #result\n+I 9000, #result\nLDN #on\n"
      "CALL SBR1, #value, #result\nLDW>= #result, 100\n= M5.0\nEND_SUBROUTINE_BLOCK\n"
      "SUBROUTINE_BLOCK SBR_1:SBR1\nVAR_INPUT\nvalue:INT;\nEND_VAR\nVAR_OUTPUT\nresult:INT;\nEND_VAR\nBEGIN\n"
      "Network 1\nLD SM0.0\nMOVW #value, #result\n-I 20000, #result\nAENO\nINCW VW200\nEND_SUBROUTINE_BLOCK\n";
  EXPECT_EQ(agreeing("LD I0.0\nCALL SBR0, I0.1, VW0, VW100\nLD I0.2\nCALL SBR0, I0.3, VW100, VW102\n"
                     "LD SM1.0\n= Q0.0\nLD SM1.1\n= Q0.1\nLD SM1.2\n= Q0.2\n" +
                     bodies),
            100U);
}

/// Sums with a constant and with another word, of 16 and 32 bits, at the ends of their ranges.
TEST(LaneForms, SumsThatOverflow) {
  std::string text;
  for (const char* sum : {"+I 20000, VW0", "+I -20000, VW2", "-I 30000, VW4", "-I -30000, VW6", "+I VW8, VW10",
                          "-I VW12, VW14", "+D VD16, VD20", "-D VD24, VD28", "+D 2000000000, VD32",
                          "-D 2000000000, VD36", "-D -2000000000, VD40", "-I -32768, VW44", "+I -32768, VW46"})
    text += std::string("LDN I0.0\n") + sum + "\nLD SM1.1\nS Q0.1, 1\nLD SM1.0\n= Q0.2\nLD SM1.2\n= Q0.3\n";
  EXPECT_EQ(agreeing(text + "END_ORGANIZATION_BLOCK\n"), 100U);
}

/// What one part has read, computed and chosen, later ones use; in between others of the same words are written.
TEST(LaneForms, StraightCodeOfSeveralParts) {
  std::string text;
  const auto word = [](int number) { return "VW" + std::to_string(2 * (number % 31)); };
  for (int k = 0; k < 120; ++k) {
    const std::string bit = std::to_string(k % 8);
    text += "LD I0." + bit + "\nAN M" + std::to_string(k % 5) + "." + bit + "\n+I " + std::to_string(900 + k) + ", " +
            word(7 * k) + "\nMOVW " + word(7 * k) + ", " + word(11 * k + 3) + "\nLDN I0." + bit + "\n-I " +
            word(5 * k + 1) + ", " + word(7 * k + 2) + "\nAENO\n= M" + std::to_string(k % 7) + "." + bit +
            "\nLDW>= " + word(3 * k) + ", " + std::to_string(100 * k) + "\nMOVW " + word(13 * k) + ", " +
            word(3 * k + 1) + "\nS Q0." + bit + ", 1\n";
  }
  text += "LD SM1.0\n= Q1.0\nLD SM1.1\n= Q1.1\nLD SM1.2\n= Q1.2\nEND_ORGANIZATION_BLOCK\n";
  EXPECT_EQ(agreeing(text, 200), 100U);
}

}  // namespace
}  // namespace rungproof::test
