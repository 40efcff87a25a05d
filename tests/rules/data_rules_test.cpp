// Rules ARI, PTR, HSP and STY on cases that their examples do not show. Lines are those of the text, from 1.
#include <gtest/gtest.h>

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
  EXPECT_EQ(lines("HSP001", "Network 1\nLD SM0.1\nHDEF 0, 0\nHSC 0\nNetwork 2\nLD I0.0\nHDEF 0, 3\n"), Lines{7});
}

}  // namespace
}  // namespace rungproof::testing
