// Durations in comments and names, and TIM015, which holds them against what the timers do.
#include <gtest/gtest.h>

#include "analysis/comment/duration_text.hpp"
#include "lint.hpp"

namespace rungproof::testing {
namespace {

/// "5000000 10000b" of "5 s on a time base of 10 ms".
std::string read(std::string_view text) {
  std::string result;
  for (const WrittenDuration& d : durationsIn(text))
    result += (result.empty() ? "" : " ") + std::to_string(d.us) + (d.isTimeBase ? "b" : "");
  return result;
}

TEST(Durations, AreReadInFourLanguages) {
  for (const auto& [text, expected] :
       {std::pair{"5 s", "5000000"}, std::pair{"5s", "5000000"}, std::pair{"0.5 sec", "500000"},
        std::pair{"1,5 Sekunden", "1500000"}, std::pair{"2 minutes", "120000000"}, std::pair{"250ms", "250000"},
        std::pair{"3 Std", "10800000000"}, std::pair{"5 сек", "5000000"}, std::pair{"100 МС", "100000"},
        std::pair{"2 минуты", "120000000"}, std::pair{"5秒", "5000000"}, std::pair{"延时3分钟", "180000000"},
        std::pair{"500毫秒", "500000"}, std::pair{"50x100ms", "5000000"},
        std::pair{"50 * 100 ms = 5 s", "5000000 5000000"}, std::pair{"50×10ms", "500000"},
        std::pair{"1 h 30 min", "3600000000 1800000000"}})
    EXPECT_EQ(read(text), expected) << text;
}

TEST(Durations, OtherNumbersAreNone) {
  for (const char* text : {"S5 timer", "T37", "SM0.5", "step 3", "5 m/s", "3 sensors", "Q0.5 s", "2nd step", "10 %",
                           "24 V", "5 stop buttons", "16#0A s", "3 mines", "4 hoists", "7 с/цикл", "12.05.2024 s7"})
    EXPECT_EQ(read(text), "") << text;
}

/// A preset is a whole number of steps, so that a comma behind it is none of its own: "PT=20, 2 s".
TEST(Durations, APresetHasNoFraction) {
  EXPECT_EQ(read("PT=20,2秒"), "2000000");
  EXPECT_EQ(read("pt = 50,5s"), "5000000");
  EXPECT_EQ(read("PV=30,3 сек"), "3000000");
  EXPECT_EQ(read("t=1,5 s"), "1500000") << "a time may have a fraction";
  EXPECT_EQ(read("opt=1,5 s"), "1500000");
}

/// The Russian "с" is "s" and also "with" and "from".
TEST(Durations, ARussianPrepositionIsNoSecond) {
  EXPECT_EQ(read("таймер 5 с датчиком"), "");
  EXPECT_EQ(read("бак 2 с насосом"), "");
  EXPECT_EQ(read("2 с двигателя"), "");
  EXPECT_EQ(read("5 с"), "5000000");
  EXPECT_EQ(read("5 с, насос"), "5000000");
  EXPECT_EQ(read("5 с после пуска"), "5000000");
  EXPECT_EQ(read("100 мс"), "100000");
}

TEST(Durations, TimeBasesAreToldByTheWordBesideThem) {
  EXPECT_EQ(read("10 ms time base"), "10000b");
  EXPECT_EQ(read("100ms-Timer"), "100000b");
  EXPECT_EQ(read("Zeitbasis 100 ms, 5 s"), "100000b 5000000");
  EXPECT_EQ(read("база времени 10 мс"), "10000b");
  EXPECT_EQ(read("时基100毫秒"), "100000b");
  EXPECT_EQ(read("resolution: 1 ms"), "1000b");
  EXPECT_EQ(read("5 s timer"), "5000000") << "no resolution is 5 s";
}

TEST(Durations, StandInNames) {
  const auto named = [](std::string_view name) {
    const auto found = durationsInName(name);
    return found.empty() ? 0 : found.front().us;
  };
  EXPECT_EQ(named("Delay_5s"), 5000000);
  EXPECT_EQ(named("T_500ms_Pump"), 500000);
  EXPECT_EQ(named("Nachlauf2min"), 120000000);
  EXPECT_EQ(named("Step5"), 0);
  EXPECT_EQ(named("Motor3start"), 0);
}

std::vector<std::string> found(const std::string& network, std::string_view symbols = {}) {
  return Linted("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1" + network + "\nEND_ORGANIZATION_BLOCK\n", {}, symbols)
      .messages("TIM015");
}

TEST(Tim015, FindsWhatDisagrees) {
  for (const char* network : {"\nLD I0.0\nTON T36, 50 // 5 s (50x100ms)",                  // 500 ms
                              "\nLD I0.0\nTON T37, 50 // 500 ms",                          // 5 s
                              "\n// motor runs on for 2 min\nLD I0.0\nTOF T38, 120",       // 12 s
                              " // T40: 30 sec delay\nLD I0.0\nTON T40, 30",               // 3 s
                              "\n// Zeitbasis 10 ms\nLD I0.0\nTON T37, 50",                // 100 ms
                              "\n// задержка 10 сек\nLD I0.0\nTON T33, 100",               // 1 s
                              "\n//延时5秒\nLD I0.0\nTON T97, 50",                         // 500 ms
                              "\n// T37 3 s, T38 4 s\nLD I0.0\nTON T37, 30\nTON T38, 20",  // T38: 2 s
                              "\nLD I0.0\nTONR T5, 600 // one minute: 60 min",             // 60 s
                              "\nLD SM0.5\nTON T37, 50 // 1 s",                            // beside the timer
                              "\n// T37 1 s\nLD SM0.5\nTON T37, 50",                       // it is named
                              "\n// after 3 s\nLD SM0.5\nTON T37, 50",                     // no time of the clock
                              "\n// after 1 s\nLD I0.0\nTON T37, 50"})                     // no clock
    EXPECT_EQ(found(network).size(), 1U) << network;
}

TEST(Tim015, IsSilentWhereTheTextIsTrueOrSpeaksOfSomethingElse) {
  for (const char* network :
       {"\nLD I0.0\nTON T37, 50 // 5 s (50x100ms)", "\nLD I0.0\nTON T33, 50 // 500 ms",
        "\nLD I0.0\nTON T37, 51 // at least 5 s",   // PV + 1
        "\nLD I0.0\nTON T37, VW0 // 5 s at first",  // the preset is a variable
        "\n// 100 ms timer\nLD I0.0\nTON T37, 50",
        "\n// after 2 s, and 10 s later the horn\nLD I0.0\nTON T37, 50",  // two times, one timer
        "\n// see T40: 3 s\nLD I0.0\nTON T37, 50", "\nLD I0.0 // pressed for 2 s\nTON T37, 20",
        // The clock bit of the network: half a second on, one from edge to edge.
        "\n// blinks with 1 s\nLD I0.0\nTON T37, 50\nLD SM0.5\nA T37\n= Q0.0",
        "\n// 500 ms clock\nLD T37\nA SM0.5\n= Q0.0\nLD I0.0\nTON T37, 50", "\n// once in 1 min\nLD SM0.4\nTON T37, 50",
        "\n// belt at 5 m/s\nLD I0.0\nTON T37, 50", "\nLD I0.0\nTON T37, 50 // T37 5 s; the drive needs 1 s"})
    EXPECT_TRUE(found(network).empty()) << network << ": " << found(network).front();
}

TEST(Tim015, SaysWhatIsTrueAndNamesTheTimer) {
  const Linted linted(
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nTON T36, 50 // 5 s\nEND_ORGANIZATION_BLOCK\n");
  const std::vector<Finding> findings = linted.of("TIM015");
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].address, "T36");
  EXPECT_EQ(findings[0].message, "T36 runs for 500 ms (50 steps of 10 ms), but the comment says 5 s");
}

TEST(Tim015, ReadsSymbolsAndHeadsOfBlocks) {
  EXPECT_EQ(found("\nLD I0.0\nTON Delay_5s, 50", "Delay_5s\tT33\t\n").size(), 1U) << "500 ms";
  EXPECT_EQ(found("\nLD I0.0\nTON Delay_5s, 50", "Delay_5s\tT37\t\n").size(), 0U);
  EXPECT_EQ(found("\nLD I0.0\nTON Horn, 50", "Horn\tT33\tsounds for 5 seconds\n").size(), 1U);
  const std::string head =
      "ORGANIZATION_BLOCK MAIN:OB1\n// T37  5 s   start\n// T38  10 s  stop\nBEGIN\nNetwork 1\n"
      "LD I0.0\nTON T37, 50\nTON T38, 10\nEND_ORGANIZATION_BLOCK\n";
  const Linted listed(head);
  ASSERT_EQ(listed.of("TIM015").size(), 1U);
  EXPECT_EQ(listed.of("TIM015")[0].address, "T38");
}

}  // namespace
}  // namespace rungproof::testing
