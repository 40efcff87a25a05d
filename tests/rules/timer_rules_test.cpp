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

/// TIM008 on a network that feeds one timer, whose bit is read; how many findings are certain and how many are not.
std::pair<std::size_t, std::size_t> neverFires(const std::string& network, const std::string& reader = "LD T37\n") {
  const Linted linted("Network 1\n" + network + "Network 2\n" + reader + "= Q0.0\n");
  std::pair<std::size_t, std::size_t> count;
  for (const Finding& finding : linted.of("TIM008"))
    ++(finding.confirmation == Confirmation::NotNeeded ? count.first : count.second);
  return count;
}

// A clock bit is on for half of its period (001:14054-14055); no scan that samples it lasts longer than the watchdog.
TEST(TimerRules, AClockBitIsShorterThanTheTimer) {
  const std::pair<std::size_t, std::size_t> certain{1, 0}, open{0, 1}, none{0, 0};
  for (const char* network :
       {"LD SM0.5\nTON T37, 10\n", "LDN SM0.5\nTON T37, 10\n", "LD I0.0\nA SM0.5\nAN M0.0\nTON T37, 20\n",
        "LD SM0.4\nTON T37, 310\n", "LD SM0.6\nTON T37, 5\n",
        "LD I0.0\nLD SM0.5\nO SM0.5\nLD SM0.5\nALD\nALD\nTON T37, 10\n",
        "LD I0.0\nLPS\nA SM0.5\nTON T37, 10\nLPP\n= Q0.1\n", "LD SM0.5\nLPS\nA I0.0\n= Q0.1\nLPP\nTON T37, 10\n"})
    EXPECT_EQ(neverFires(network), certain) << network;
  EXPECT_EQ(neverFires("LD SM0.5\nTON T32, 1000\n", "LD T32\n"), certain) << "1 ms steps";
  // The prover is asked about edges of the program.
  EXPECT_EQ(neverFires("LD I0.0\nEU\nTON T37, 10\n"), open);
  EXPECT_EQ(neverFires("LD I0.0\nED\nA I0.1\nTON T37, 10\n"), open);
  for (const char* network :
       {"LD SM0.5\nTON T37, 5\n",           // the end of the half second may be reached
        "LD SM0.5\nTON T37, 9\n",           // a long scan may sample the clock late
        "LD SM0.4\nTON T37, 100\n",         // 10 of 30 s
        "LD SM0.5\nO I0.0\nTON T37, 10\n",  // I0.0 may stay on
        "LD SM0.5\nLD I0.0\nOLD\nTON T37, 10\n", "LD SM0.5\nNOT\nO I0.1\nTON T37, 10\n", "LD SM0.0\nTON T37, 10\n",
        "LD I0.0\nLPS\nA SM0.5\n= Q0.1\nLPP\nTON T37, 10\n",  // the clock is in the other branch
        "LDN SM0.1\nTON T37, 10\n", "LD SM0.5\nTON T37, VW0\n"})
    EXPECT_EQ(neverFires(network), none) << network;
  EXPECT_EQ(neverFires("LD SM0.5\nTONR T5, 10\n", "LD T5\n"), none) << "a TONR adds the pieces up";
  EXPECT_EQ(neverFires("LD SM0.5\nTON T37, 10\nMOVW 50, T37\n"), none) << "the program moves the timer on";
  EXPECT_EQ(neverFires("LD I1.0\nJMP 1\nLD SM0.5\nTON T33, 100\nLBL 1\n", "LD T33\n"), none)
      << "a timer of 10 ms that is left out runs on";
}

TEST(TimerRules, TheTimeAndTheClockAreNamed) {
  const Linted linted("Network 1\nLD SM0.5\nTON T37, 15\nNetwork 2\nLD T37\n= Q0.0\n");
  EXPECT_EQ(
      linted.messages("TIM008"),
      std::vector<std::string>{"T37 needs its input for 1.5 s without a break, and SM0.5 is on for 0.5 s at a time"});
}

}  // namespace
}  // namespace rungproof::testing
