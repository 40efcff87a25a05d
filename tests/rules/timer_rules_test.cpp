// Rules TIM on cases that their examples do not show. Lines are those of the text, from 1.
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

TEST(TimerRules, ResolutionIsNamed) {
  const std::vector<std::string> messages = Linted("Network 1\nLD I0.0\nTONR T33, +10\n").messages("TIM003");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("10 ms"), std::string::npos);  // T33-T36 (001:6601-6603)
}

TEST(TimerRules, SkippedTimersMatterForHundredMilliseconds) {
  EXPECT_EQ(lines("TIM004",
                  "LD I0.0\nCALL 1\nMEND\nSBR 1\nLD I0.1\nTON T37, +10\nTON T33, +10\nLD T37\nA T33\n= Q0.0\nRET\n"),
            Lines{6});
  EXPECT_EQ(lines("TIM004", "Network 1\nLSCR S0.0\nNetwork 2\nLD SM0.0\nTON T37, +10\nNetwork 3\nSCRE\n"),
            Lines());  // steps are left out
}

TEST(TimerRules, OwnBitByResolution) {
  const Linted slow("Network 1\nLDN T37\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n");
  ASSERT_EQ(slow.of("TIM005").size(), 1U);
  EXPECT_EQ(slow.of("TIM005")[0].severity, Severity::Note);  // works (004:4608-4612)
  EXPECT_EQ(Linted("Network 1\nLDN T33\nTON T33, +10\n").of("TIM005")[0].severity, Severity::Warning);
  EXPECT_EQ(lines("TIM005", "Network 1\nLD I0.0\nLD I0.1\nAN T33\nOLD\nTON T33, +10\n"), Lines{4});
}

TEST(TimerRules, PresetsFromMovedConstants) {
  EXPECT_EQ(lines("TIM007", "Network 1\nLD SM0.1\nMOVW +0, VW0\nNetwork 2\nLD I0.0\nTON T37, VW0\n"), Lines{3});
  EXPECT_EQ(lines("TIM007", "Network 1\nLD SM0.1\nMOVW +5, VW0\nNetwork 2\nLD I0.0\nTON T37, VW0\n"), Lines());
  EXPECT_EQ(lines("TIM007", "Network 1\nLD I0.0\nTON T37, 40000\n"), Lines{3});
}

TEST(TimerRules, EqualityWithZeroIsSound) {
  EXPECT_EQ(lines("TIM010", "Network 1\nLDW= T37, +0\n= Q0.0\nNetwork 2\nLDW<> T37, +5\n= Q0.1\n"), Lines{5});
}

TEST(TimerRules, EdgesInTheFirstScan) {
  EXPECT_EQ(lines("TIM013", "LD SM0.1\nCALL 1\nMEND\nSBR 1\nLD I0.0\nEU\n= Q0.0\nRET\n"),
            Lines{6});                                                       // the block runs in the first scan only
  EXPECT_EQ(lines("TIM013", "Network 1\nLD SM0.1\nED\n= Q0.0\n"), Lines());  // falls in the second scan
}

TEST(TimerRules, EdgeDetectorsInCodeThatMayBeSkipped) {
  // Called on a condition, and in a step; the one in the main program runs in every scan.
  EXPECT_EQ(
      lines("TIM014",
            "LD I0.2\nEU\n= Q0.1\nLD I0.0\nCALL 1\nMEND\nSBR 1\nLD I0.1\nEU\nS Q0.0, 1\nLD I0.3\nED\nR Q0.0, 1\nRET\n"),
      Lines{9});
  EXPECT_EQ(lines("TIM014", "LD SM0.0\nCALL 1\nMEND\nSBR 1\nLD I0.1\nEU\n= Q0.0\nRET\n"), Lines());
  EXPECT_EQ(lines("TIM014", "Network 1\nLSCR S0.0\nNetwork 2\nLD I0.0\nEU\nSCRT S0.1\nNetwork 3\nSCRE\n"), Lines{5});
}

}  // namespace
}  // namespace rungproof::testing
