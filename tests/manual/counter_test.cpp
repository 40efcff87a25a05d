// Counters of both instruction sets.
#include <gtest/gtest.h>

#include "plant.hpp"

namespace rungproof::manual {
namespace {

/// A count input as a pulse: one scan at 0, one at 1.
void pulse(Bench& bench, std::string_view input, int times = 1) {
  for (int i = 0; i < times; ++i) {
    bench.set(input, 0);
    bench.scan();
    bench.set(input, 1);
    bench.scan();
  }
}
void put(Bench& bench, std::uint32_t number, int value) {
  bench.store.set(Reg::CounterCurrent, number, static_cast<std::uint16_t>(value), true);
}

TEST(CountUp, CountsEdgesAndGoesOnPastThePreset) {
  Bench bench({"LD I0.0", "LD I0.1", "CTU C3, +2", "LD C3", "= Q0.0"});
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C3"), 1);
  EXPECT_EQ(bench.value("Q0.0"), 0U);
  bench.scan();
  EXPECT_EQ(bench.current("C3"), 1) << "a level is no edge";
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.value("Q0.0"), 1U) << "current = PV";
  pulse(bench, "I0.0", 3);
  EXPECT_EQ(bench.current("C3"), 5);
  EXPECT_EQ(bench.value("Q0.0"), 1U);
  bench.set("I0.1", 1);
  bench.scan();
  EXPECT_EQ(bench.current("C3"), 0);
  EXPECT_EQ(bench.value("C3"), 0U);
  bench.set("I0.0", 0);
  bench.scan();
  bench.set("I0.0", 1);
  bench.scan();
  EXPECT_EQ(bench.current("C3"), 0) << "reset has priority";
  bench.set("I0.1", 0);
  bench.scan();
  EXPECT_EQ(bench.current("C3"), 0) << "the edge came under reset";
}

TEST(CountUp, StopsAt32767) {
  Bench bench({"LD I0.0", "LD I0.1", "CTU C3, 32767"});
  put(bench, 3, 32766);
  bench.scan();
  EXPECT_EQ(bench.value("C3"), 0U);
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C3"), 32767);
  EXPECT_EQ(bench.value("C3"), 1U);
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C3"), 32767);
}

TEST(CountUp, PresetIsSignedAndReadInEveryPass) {
  Bench bench({"LD I0.0", "LD I0.1", "CTU C0, VW10"});
  bench.set("VW10", -1);
  EXPECT_EQ(bench.scan().value("C0"), 1U) << "0 >= -1";
  bench.set("VW10", 1);
  EXPECT_EQ(bench.scan().value("C0"), 0U);
  bench.set("VW10", 0);
  EXPECT_EQ(bench.scan().value("C0"), 1U);
  bench.set("I0.1", 1);
  EXPECT_EQ(bench.scan().value("C0"), 0U) << "reset clears the bit although 0 >= 0";
}

TEST(Counter, FirstScanStoresTheCountInputByDefault) {
  for (const char* line : {"CTU C1, 5", "CTD C1, 5"}) {
    for (const bool counts : {false, true}) {
      Bench bench({"LD I0.0", "LD I0.1", line});
      ASSERT_TRUE(bench.choices.set("counter-first-edge", counts ? "counts" : "stored"));
      put(bench, 1, 3);
      bench.set("I0.0", 1);
      bench.scan();
      const int step = line[2] == 'U' ? 1 : -1;
      EXPECT_EQ(bench.current("C1"), counts ? 3 + step : 3) << line;
      bench.scan();
      EXPECT_EQ(bench.current("C1"), counts ? 3 + step : 3) << line;
    }
  }
}

TEST(CountDown, ExampleOfTheManual) {
  // 001:4037-4050: C1 from 3 to 0 while I0.1 is off; the bit shows 0.
  Bench bench({"LD I0.0", "LD I0.1", "CTD C1, +3", "LD C1", "= Q0.0"});
  bench.set("I0.1", 1);
  bench.scan();
  EXPECT_EQ(bench.current("C1"), 3);
  EXPECT_EQ(bench.value("Q0.0"), 0U);
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C1"), 3) << "held while the load input is on";
  bench.set("I0.1", 0);
  for (const int expected : {2, 1}) {
    pulse(bench, "I0.0");
    EXPECT_EQ(bench.current("C1"), expected);
    EXPECT_EQ(bench.value("Q0.0"), 0U);
  }
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C1"), 0);
  EXPECT_EQ(bench.value("Q0.0"), 1U);
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C1"), 0) << "stops at 0";
  bench.set("I0.1", 1);
  bench.scan();
  EXPECT_EQ(bench.value("Q0.0"), 0U) << "loading clears the bit";
}

TEST(CountDown, FirstScanBitFollowsTheChoice) {
  for (const bool off : {false, true}) {
    Bench bench({"LD I0.0", "LD I0.1", "CTD C1, +3"});
    ASSERT_TRUE(bench.choices.set("ctd-first-scan", off ? "off" : "on"));
    EXPECT_EQ(bench.scan().value("C1"), off ? 0U : 1U);
    EXPECT_EQ(bench.scan().value("C1"), 1U);
  }
}

TEST(CountUpDown, ExampleOfTheManual) {
  // 000:3459-3478: up, down, reset, preset 4. The order of the levels is count-up, count-down, reset.
  Bench bench({"LD I0.0", "LD I0.1", "LD I0.2", "CTUD C48, +4", "LD C48", "= Q0.0"});
  bench.scan();
  pulse(bench, "I0.0", 4);
  EXPECT_EQ(bench.current("C48"), 4);
  EXPECT_EQ(bench.value("Q0.0"), 1U);
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C48"), 5) << "counts on past PV";
  pulse(bench, "I0.1", 2);
  EXPECT_EQ(bench.current("C48"), 3);
  EXPECT_EQ(bench.value("Q0.0"), 0U);
  bench.set("I0.2", 1);
  bench.scan();
  EXPECT_EQ(bench.current("C48"), 0);
  bench.set("I0.2", 0);
  pulse(bench, "I0.1", 2);
  EXPECT_EQ(bench.current("C48"), -2);
}

TEST(CountUpDown, WrapsAtBothEnds) {
  Bench bench({"LD I0.0", "LD I0.1", "LD I0.2", "CTUD C48, +4"});
  put(bench, 48, 32767);
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C48"), -32768);
  EXPECT_EQ(bench.value("C48"), 0U);
  pulse(bench, "I0.1");
  EXPECT_EQ(bench.current("C48"), 32767);
  EXPECT_EQ(bench.value("C48"), 1U);
}

TEST(CountUpDown, BothEdgesCancelAndResetWins) {
  Bench bench({"LD I0.0", "LD I0.1", "LD I0.2", "CTUD C48, 7"});
  put(bench, 48, 7);
  bench.scan();
  bench.set("IB0", 3);
  bench.scan();
  EXPECT_EQ(bench.current("C48"), 7);
  EXPECT_EQ(bench.value("C48"), 1U);
  bench.set("IB0", 7);
  bench.scan();
  EXPECT_EQ(bench.current("C48"), 0);
  EXPECT_EQ(bench.value("C48"), 0U);
}

TEST(CountUpDown, MayStopAtThePreset) {
  Bench bench({"LD I0.0", "LD I0.1", "LD I0.2", "CTUD C48, 2"});
  ASSERT_TRUE(bench.choices.set("ctud-at-preset", "stops"));
  pulse(bench, "I0.0", 4);
  EXPECT_EQ(bench.current("C48"), 2);
  pulse(bench, "I0.1");
  EXPECT_EQ(bench.current("C48"), 1);
}

TEST(Counter, TakesItsLevelsAndLeavesTheStack) {
  Bench bench({"CTUD C9, 1"});
  const std::array<bool, 9> iv{false, false, true, true, false, true};
  EXPECT_EQ(bench.scanWithStack({}).stack, (std::array<bool, 9>{}));
  EXPECT_EQ(bench.scanWithStack(iv).stack, iv);
  EXPECT_EQ(bench.current("C9"), 1) << "level 2 counts up";
}

TEST(Counter, BadPresetPointerLeavesTheCounter) {
  Bench bench({"LD I0.0", "LD I0.1", "CTU C9, *VD0"});
  bench.set("VD0", 0xFF000000);
  for (const int input : {0, 1, 0, 1}) {
    bench.set("I0.0", input);
    bench.scan();
    EXPECT_TRUE(bench.met(Hazard::BadIndirectAddress));
  }
  EXPECT_EQ(bench.current("C9"), 0);
}

TEST(IecCountUp, StopsAtThePreset) {
  Bench bench({"LD I0.0", "LD I0.1", "CTU.IEC C1, 2, Q0.0, VW10"});
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.value("VW10"), 1U);
  EXPECT_EQ(bench.value("Q0.0"), 0U);
  pulse(bench, "I0.0", 3);
  EXPECT_EQ(bench.value("VW10"), 2U);
  EXPECT_EQ(bench.value("Q0.0"), 1U);
  EXPECT_EQ(bench.current("C1"), 2);
  bench.set("I0.1", 1);
  bench.scan();
  EXPECT_EQ(bench.value("VW10"), 0U);
  EXPECT_EQ(bench.value("Q0.0"), 0U);
  // Above PV, by a smaller PV: no change, Q on.
  Bench smaller({"LD I0.0", "LD I0.1", "CTU.IEC C1, VW0, Q0.0, VW10"});
  smaller.set("VW0", 3);
  put(smaller, 1, 5);
  pulse(smaller, "I0.0");
  EXPECT_EQ(smaller.current("C1"), 5);
  EXPECT_EQ(smaller.value("Q0.0"), 1U);
}

TEST(IecCountDown, LoadsAndStopsAtZero) {
  Bench bench({"LD I0.0", "LD I0.1", "CTD.IEC C1, 2, Q0.0, VW10"});
  bench.set("I0.1", 1);
  bench.scan();
  EXPECT_EQ(bench.value("VW10"), 2U);
  EXPECT_EQ(bench.current("C1"), 2);
  EXPECT_EQ(bench.value("Q0.0"), 0U);
  bench.set("I0.1", 0);
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.value("VW10"), 1U);
  EXPECT_EQ(bench.value("Q0.0"), 0U);
  pulse(bench, "I0.0", 2);
  EXPECT_EQ(bench.value("VW10"), 0U);
  EXPECT_EQ(bench.value("Q0.0"), 1U);
}

TEST(IecCountUpDown, StaysBetweenZeroAndThePreset) {
  // Levels: CU, CD, R, LD from the lowest to the top.
  Bench bench({"LD I0.0", "LD I0.1", "LD I0.2", "LD I0.3", "CTUD.IEC C1, 2, Q0.0, Q0.1, VW10"});
  bench.scan();
  EXPECT_EQ(bench.value("QB0"), 0b10U) << "QD at 0";
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C1"), 1);
  EXPECT_EQ(bench.value("QB0"), 0U);
  pulse(bench, "I0.0", 2);
  EXPECT_EQ(bench.value("VW10"), 2U);
  EXPECT_EQ(bench.value("QB0"), 0b01U) << "QU at PV";
  bench.set("IB0", 0);
  bench.scan();
  bench.set("IB0", 3);
  bench.scan();
  EXPECT_EQ(bench.value("VW10"), 2U) << "both edges at once";
  bench.set("IB0", 0);
  pulse(bench, "I0.1", 3);
  EXPECT_EQ(bench.value("VW10"), 0U);
  bench.set("IB0", 0b1000);
  bench.scan();
  EXPECT_EQ(bench.value("VW10"), 2U) << "LD loads PV";
  bench.set("IB0", 0b0100);
  bench.scan();
  EXPECT_EQ(bench.value("VW10"), 0U) << "R";
}

TEST(IecCountUpDown, ResetAgainstLoadFollowsTheChoice) {
  for (const bool load : {false, true}) {
    Bench bench({"LD I0.0", "LD I0.1", "LD I0.2", "LD I0.3", "CTUD.IEC C1, 2, Q0.0, Q0.1, VW10"});
    ASSERT_TRUE(bench.choices.set("iec-counter-priority", load ? "load" : "reset"));
    bench.set("IB0", 0b1100);
    bench.scan();
    EXPECT_EQ(bench.value("VW10"), load ? 2U : 0U);
  }
}

TEST(IecCounter, OpenOutputsAreNotWritten) {
  Bench bench({"LD I0.0", "LD I0.1", "CTU.IEC C1, 1"});
  pulse(bench, "I0.0");
  EXPECT_EQ(bench.current("C1"), 1);
  EXPECT_EQ(bench.value("C1"), 1U);
  EXPECT_EQ(bench.value("QB0"), 0U);
}

}  // namespace
}  // namespace rungproof::manual
