// Rules ARI, PTR, HSP and STY on cases that their examples do not show. Lines are those of the text, from 1.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

TEST(ArithmeticRules, DivisorsThatAreNeverZero) {
  EXPECT_EQ(lines("ARI001", "Network 1\nLD SM0.1\nMOVW +4, VW0\nNetwork 2\nLD SM0.0\n/I VW0, VW2\n"), Lines());
  EXPECT_EQ(lines("ARI001", "Network 1\nLD SM0.0\n/I 0, VW2\n"), Lines{3});
}

TEST(ArithmeticRules, FlagsBelongToTheLastInstruction) {
  // ADD sets SM1.1; the move between leaves status bits alone (001:5601).
  EXPECT_EQ(lines("ARI005", "Network 1\nLD SM0.0\n+I VW0, VW2\nMOVW VW2, VW4\nNetwork 2\nLD SM1.1\n= Q0.0\n"), Lines());
  EXPECT_EQ(lines("ARI005", "Network 1\nLD SM1.1\n= Q0.0\n"), Lines{2});
}

TEST(ArithmeticRules, AccumulatorsHaveUpperHalves) {
  EXPECT_EQ(lines("ARI006", "Network 1\nLD SM0.0\nMOVW VW0, AC0\nDTR AC0, VD4\n"), Lines{4});
  EXPECT_EQ(lines("ARI006", "Network 1\nLD SM0.0\nMOVD +0, AC0\nMOVW VW0, AC0\nDTR AC0, VD4\n"), Lines());
}

TEST(PointerRules, KnownAddressesAreFollowed) {
  EXPECT_EQ(lines("PTR001", "Network 1\nLD SM0.0\nMOVD &VB10238, AC1\n+D +2, AC1\nMOVB *AC1, VB0\n"),
            Lines{5});  // VB10240
  EXPECT_EQ(lines("PTR001", "Network 1\nLD SM0.0\nMOVD &VB10238, AC1\nMOVW *AC1, VW0\n"), Lines());
}

TEST(PointerRules, PlacesAndTargets) {
  EXPECT_EQ(lines("PTR002", "Network 1\nLD SM0.0\nMOVD &VB0, AC0\nMOVB *AC0, VB9\n"), Lines{4});  // not AC0 (001:1459)
}

TEST(PointerRules, TwoStepsOfOneByteAreAWord) {
  EXPECT_EQ(lines("PTR003", "Network 1\nLD SM0.0\nMOVD &VB100, AC1\nMOVW *AC1, VW0\nINCD AC1\nINCD AC1\n"), Lines());
  EXPECT_EQ(lines("PTR003", "Network 1\nLD SM0.0\nMOVD &VB100, AC1\nMOVD *AC1, VD0\n+D +2, AC1\n"), Lines{5});
}

TEST(PointerRules, BlocksAndTables) {
  EXPECT_EQ(lines("PTR004", "Network 1\nLD I0.0\nBMB VB0, VB5, 10\n"), Lines{3});     // overlap
  EXPECT_EQ(lines("PTR004", "Network 1\nLD I0.0\nBMW VW10230, VW0, 6\n"), Lines{3});  // VW10230 to VW10240
  EXPECT_EQ(lines("PTR005", "Network 1\nLD SM0.1\nMOVW +200, VW100\nNetwork 2\nLD I0.0\nEU\nATT VW0, VW100\n"),
            Lines{3});
  EXPECT_EQ(
      lines("PTR005",
            "Network 1\nLD SM0.1\nMOVW +20, VW100\nNetwork 2\nLD I0.0\nEU\nATT VW0, VW100\nFND= VW100, +5, VW50\n"),
      Lines{8});
}

TEST(DeviceRules, GuardsOfOneScan) {
  EXPECT_EQ(lines("HSP004", "Network 1\nLD I0.0\nEU\n= M0.0\nNetwork 2\nLD M0.0\nATT VW0, VW100\n"),
            Lines());                                                                      // a bit with an edge
  EXPECT_EQ(lines("HSP004", "Network 1\nLD M0.0\nATT VW0, VW100\nR M0.0, 1\n"), Lines());  // resets its own request
  EXPECT_EQ(lines("HSP004", "Network 1\nLD SM0.0\nAN V200.6\nAN V200.5\nNETR VB200, 0\n"), Lines());  // 000:1400
  EXPECT_EQ(lines("HSP004", "Network 1\nLD I0.0\nS SM31.7, 1\n"), Lines{3});
  // Bit 7 of the control byte enables the train: without it PLS ends one, and may do so again and again.
  EXPECT_EQ(lines("HSP004", "Network 1\nLD I0.0\nMOVB 16#05, SMB67\nPLS 0\n"), Lines());
  EXPECT_EQ(lines("HSP004", "Network 1\nLD I0.0\nMOVB 16#85, SMB67\nPLS 0\n"), Lines{4});
  EXPECT_EQ(lines("HSP004", "Network 1\nLD I0.0\nMOVB 16#05, SMB77\nPLS 0\n"), Lines{4});
  EXPECT_EQ(lines("HSP001", "Network 1\nLD SM0.1\nHDEF 0, 0\nHSC 0\nNetwork 2\nLD I0.0\nHDEF 0, 3\n"), Lines{7});
}

/// Table 6-26 (001:4216-4237): HSC0 and HSC4 have no start input, HSC3 and HSC5 the clock alone; mode 12 is that of
/// HSC0 and HSC3. On the S7-200 SMART HSC1 and HSC3 have the clock alone.
TEST(DeviceRules, ModesThatACounterHasNot) {
  const auto linesOf = [](const char* definition, Cpu cpu) {
    return Linted(std::string("Network 1\nLD SM0.1\n") + definition + "\n", {cpu, usualEdition(cpu)}).lines("HSP001");
  };
  const Cpu old = *cpuNamed("226"), smart = *cpuNamed("ST40");
  for (const char* wrong :
       {"HDEF 0, 2", "HDEF 0, 11", "HDEF 3, 1", "HDEF 3, 9", "HDEF 4, 5", "HDEF 5, 12", "HDEF 1, 12"})
    EXPECT_EQ(linesOf(wrong, old), Lines{3}) << wrong;
  for (const char* right :
       {"HDEF 0, 10", "HDEF 0, 12", "HDEF 1, 11", "HDEF 2, 5", "HDEF 3, 0", "HDEF 3, 12", "HDEF 4, 9"})
    EXPECT_EQ(linesOf(right, old), Lines()) << right;
  for (const char* wrong : {"HDEF 1, 3", "HDEF 3, 9", "HDEF 1, 1"}) EXPECT_EQ(linesOf(wrong, smart), Lines{3}) << wrong;
  for (const char* right : {"HDEF 1, 0", "HDEF 3, 0", "HDEF 0, 10"}) EXPECT_EQ(linesOf(right, smart), Lines()) << right;
}

// 001:4999-5028: the rule that operands stay on overflow is not repeated for INC and DEC.
TEST(ArithmeticRules, TheHelpSaysWhatAnOverflowDoes) {
  const auto help = [](const std::string& box) {
    const std::vector<Finding> findings = Linted("Network 1\nLD I0.0\n" + box + "\n").of("ARI002");
    return findings.size() == 1 ? std::string(findings[0].help) : std::to_string(findings.size()) + " findings";
  };
  EXPECT_TRUE(help("INCW VW0").starts_with("INCW goes on from 32767 with -32768")) << help("INCW VW0");
  EXPECT_TRUE(help("DECW VW0").starts_with("DECW goes on from -32768 with 32767"));
  EXPECT_TRUE(help("INCB VB0").starts_with("INCB goes on from 255 with 0"));
  EXPECT_TRUE(help("DECB VB0").starts_with("DECB goes on from 0 with 255"));
  EXPECT_TRUE(help("INCD VD0").starts_with("INCD goes on from 2147483647 with -2147483648"));
  EXPECT_TRUE(help("DECD VD0").starts_with("DECD goes on from -2147483648 with 2147483647"));
  EXPECT_TRUE(help("+I 5, VW0").starts_with("on overflow the operands stay as they were"));
  EXPECT_TRUE(help("*I VW2, VW0").starts_with("on overflow the operands stay as they were"));
}

TEST(ArithmeticRules, WholeNumbersAndRealsAreNotMixed) {
  const auto of = [](const std::string& boxes) { return Linted("Network 1\nLD SM0.0\n" + boxes).of("ARI008").size(); };
  for (const char* boxes : {"ITD VW0, VD4\n*R 2.0, VD4\n", "ITD AIW0, AC0\n+R VD8, AC0\n", "MOVD 5, VD4\n/R VD4, VD8\n",
                            "MOVR 1.5, VD4\n+D 1, VD4\n", "*R 2.0, VD4\nINCD VD4\n", "ROUND VD0, VD4\nSQRT VD4, VD8\n",
                            "ITD VW0, AC0\nMOVD AC0, VD4\n*R 2.0, VD4\n", "DTR VD0, VD4\nDTR VD4, VD8\n"})
    EXPECT_EQ(of(boxes), 1U) << boxes;
  for (const char* boxes : {"ITD VW0, VD4\nDTR VD4, VD4\n*R 2.0, VD4\n", "MOVD 16#3F800000, VD4\n*R 2.0, VD4\n",
                            "MOVD 0, VD4\n+R VD0, VD4\n",                  // 0 is 0.0
                            "ITD VW0, VD4\nMOVR VD4, VD8\n",               // a copy of the bits
                            "ITD VW0, VD4\nMOVR VD8, VD4\n*R 2.0, VD4\n",  // written again
                            "ITD VW0, VD4\nMOVW 0, VW6\n*R 2.0, VD4\n",    // one half is written again
                            "ITD VW0, VD4\nLD I0.0\n*R 2.0, VD4\n",        // another power flow
                            "ITD VW0, VD4\nNetwork 2\nLD SM0.0\n*R 2.0, VD4\n", "TRUNC VD0, VD4\n+D 1, VD4\n",
                            "ITD VW0, AC0\nMOVR 2.0, *AC1\n*R 2.0, AC0\n"})  // wherever AC1 points to
    EXPECT_EQ(of(boxes), 0U) << boxes;
}

}  // namespace
}  // namespace rungproof::testing
