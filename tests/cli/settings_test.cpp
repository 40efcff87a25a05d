// Values of the common options: defaults, forms of times, ranks of origins, values that exclude each other.
#include <gtest/gtest.h>

#include "frontend/files/closest_word.hpp"
#include "frontend/settings/options.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {
namespace {

using namespace std::chrono_literals;

TEST(Duration, TakesNumbersWithUnits) {
  EXPECT_EQ(durationNamed("5ms"), Duration(5ms));
  EXPECT_EQ(durationNamed("1.5s"), Duration(1500ms));
  EXPECT_EQ(durationNamed("200us"), Duration(200us));
  EXPECT_EQ(durationNamed("2min"), Duration(2min));
  EXPECT_EQ(durationNamed("0ms"), Duration(0));
}

TEST(Duration, RefusesEverythingElse) {
  for (const char* text : {"", "5", "ms", "-5ms", "5 ms", "5m", "1.2.3s", ".s", "99999999999min", "1e3s", "5MS"}) {
    EXPECT_EQ(durationNamed(text), std::nullopt) << text;
  }
}

TEST(ScanTimeOption, IsOneTimeOrTwoInOrder) {
  const auto range = scanTimeNamed("5ms..20ms");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->low, Duration(5ms));
  EXPECT_EQ(range->high, Duration(20ms));
  const auto one = scanTimeNamed("10ms");
  ASSERT_TRUE(one);
  EXPECT_EQ(one->low, one->high);
  for (const char* text : {"20ms..5ms", "0ms", "5ms..", "..5ms", "5ms...20ms", "5..20ms"})
    EXPECT_FALSE(scanTimeNamed(text)) << text;
}

TEST(Settings, BeginWithTheDefaultsOfTheTable) {
  const Settings settings;
  EXPECT_EQ(settings.target().cpu, s7200Cpu("226"));           // the default
  EXPECT_EQ(settings.target().edition, Edition::Edition2004);  // default 2004
  EXPECT_EQ(settings.timeout(), Duration(30s));
  EXPECT_EQ(settings.level(), Severity::Note);
  EXPECT_FALSE(settings.scanTime());
  EXPECT_FALSE(settings.flag(Opt::NoSuppress));
  EXPECT_EQ(settings.origin(Opt::Cpu), "default");
}

TEST(Settings, SplitListsAtCommas) {
  Settings settings;
  settings.set(Opt::Select, {"ADR,OUT", "STK"}, "command line");
  EXPECT_EQ(settings.list(Opt::Select), (std::vector<std::string>{"ADR", "OUT", "STK"}));
}

TEST(Settings, KeepCommasInFileNames) {
  Settings settings;
  settings.set(Opt::Symbols, {"names, old.sdf"}, "command line");
  EXPECT_EQ(settings.list(Opt::Symbols), (std::vector<std::string>{"names, old.sdf"}));
}

// The 226XM is described by the 2003 edition only, the 224XP by the 2004 edition only.
TEST(Settings, TakeTheEditionThatKnowsTheCpu) {
  Settings settings;
  settings.set(Opt::Cpu, {"226XM"}, "command line");
  EXPECT_EQ(settings.target().edition, Edition::Edition2003);
  EXPECT_FALSE(settings.check());
  settings.set(Opt::Edition, {"2004"}, "command line");
  EXPECT_TRUE(settings.check());
}

TEST(Settings, ChoicesKnowTheirOrigin) {
  Settings settings;
  EXPECT_EQ(settings.choices().watchdogMs(), 500);
  EXPECT_FALSE(settings.setChoice("watchdog", "300ms", "rungproof.toml:7"));
  EXPECT_EQ(settings.choices().watchdogMs(), 300);
  EXPECT_EQ(settings.choiceOrigin(Choice::WatchdogMs), "rungproof.toml:7");
  EXPECT_TRUE(settings.setChoice("watchdog", "1s", "command line"));
  EXPECT_TRUE(settings.setChoice("watchdogs", "300ms", "command line"));
}

TEST(OptionTable, EveryDefaultIsAPermittedValue) {
  for (const OptionInfo& info : optionTable()) {
    if (info.initial.empty()) continue;
    EXPECT_FALSE(checkValue(info, info.initial)) << info.name;
  }
}

TEST(EditDistance, CountsInsertionsDeletionsChangesAndSwaps) {
  EXPECT_EQ(editDistance("", "lint"), 4u);
  EXPECT_EQ(editDistance("lint", "lint"), 0u);
  EXPECT_EQ(editDistance("lnit", "lint"), 1u);  // two neighbours swapped
  EXPECT_EQ(editDistance("lin", "lint"), 1u);
  EXPECT_EQ(editDistance("prove", "probe"), 1u);
}

TEST(Closest, GivesNothingForStrangers) {
  const std::vector<std::string_view> names = {"lint", "prove", "xref"};
  EXPECT_EQ(closest("lnt", names), "lint");
  EXPECT_EQ(closest("frobnicate", names), "");
}

}  // namespace
}  // namespace rungproof
