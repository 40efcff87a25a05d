// Coils, set and reset, bistables.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "plant.hpp"

namespace rungproof::manual {
namespace {

TEST(Coil, AssignCopiesTheTopEveryTime) {
  // Network 1 of 001:2817: one condition, three targets; the stack stays.
  Bench bench({"LD I0.0", "= Q0.0", "= Q0.1", "= V0.0", "= T37", "= C5", "= M31.7"});
  for (const bool on : {true, false, true}) {
    bench.set("I0.0", on);
    bench.scan();
    for (const char* bit : {"Q0.0", "Q0.1", "V0.0", "T37", "C5", "M31.7"})
      EXPECT_EQ(bench.value(bit), on ? 1U : 0U) << bit;
    EXPECT_EQ(bench.stack[0], on);
    EXPECT_EQ(bench.value("V0.1"), 0U) << "one bit only";
  }
}

TEST(Coil, AssignImmediateWritesImageAndTerminal) {
  Bench bench({"LD I0.0", "=I Q1.2", "= Q1.3"});
  for (const bool on : {true, false}) {
    bench.set("I0.0", on);
    bench.scan();
    EXPECT_EQ(bench.value("Q1.2"), on ? 1U : 0U);
    EXPECT_EQ(bench.reg(Reg::PhysicalOutput, 10), on ? 1U : 0U);
    EXPECT_EQ(bench.reg(Reg::PhysicalOutput, 11), 0U) << "plain = waits for the end of the scan";
  }
}

TEST(Coil, SetAndResetGroupsOfTheExample) {
  // Networks 2 to 5 of 001:2817. Inputs: I0.1 sets, I0.2 resets Q0.2-Q0.7; I0.3 & I0.4 sets, I0.3 & I0.5 resets
  // Q1.0-Q1.7; network 5 assigns Q1.0 in every scan.
  Bench bench({"LD I0.1", "S Q0.2, 6", "LD I0.2", "R Q0.2, 6", "LD I0.3", "LPS", "A I0.4", "S Q1.0, 8", "LPP", "A I0.5",
               "R Q1.0, 8", "LD I0.6", "= Q1.0"});
  const auto after = [&](unsigned inputs) {
    bench.set("IB0", inputs);
    bench.scan();
    return bench.value("QW0");
  };
  EXPECT_EQ(after(0), 0x0000U);
  EXPECT_EQ(after(0b0000010), 0xFC00U) << "six bits from Q0.2";
  EXPECT_EQ(after(0), 0xFC00U) << "latched";
  EXPECT_EQ(after(0b0000110), 0x0000U) << "reset stands below and wins";
  EXPECT_EQ(after(0b0011000), 0x00FEU) << "Q1.0 is overridden by network 5";
  EXPECT_EQ(after(0b1000000), 0x00FFU);
  EXPECT_EQ(after(0b0101000), 0x0000U);
  EXPECT_EQ(after(0b0010000), 0x0000U) << "no power flow, no change";
}

TEST(Coil, SetAndResetCrossByteBorders) {
  Bench bench({"LD I0.0", "S M1.6, 11", "LD I0.1", "R M1.7, 9"});
  bench.set("IB0", 1);
  bench.scan();
  // M1.6, M1.7, M2.0-M2.7, M3.0: eleven bits.
  EXPECT_EQ(bench.value("MD0"), 0x00C0FF01U);
  bench.set("IB0", 2);
  bench.scan();
  EXPECT_EQ(bench.value("MD0"), 0x00400001U);
}

TEST(Coil, CountMayBeVariable) {
  Bench bench({"LD SM0.0", "S V10.0, VB0"});
  bench.set("VB0", 5);
  EXPECT_EQ(bench.scan().value("VB10"), 0x1FU);
  bench.set("VB0", 255);
  bench.scan();
  EXPECT_EQ(bench.value("VB41"), 0x7FU) << "255 bits from V10.0 end at V41.6";
  EXPECT_EQ(bench.value("VB42"), 0U);
  EXPECT_TRUE(bench.eno());
  EXPECT_TRUE(bench.quiet());
}

TEST(Coil, ResetClearsCurrentValuesOfTimersAndCounters) {
  // 001:2791; S sets the bit only.
  Bench bench({"LD I0.0", "R T37, 2", "R C10, 3", "LD I0.1", "S C20, 2", "S T50, 1"});
  for (std::uint32_t n = 36; n <= 39; ++n) {
    bench.store.set(Reg::TimerCurrent, n, 100 + n, true);
    bench.store.set(Reg::TimerBit, n, 1, true);
  }
  for (std::uint32_t n = 9; n <= 13; ++n) {
    bench.store.set(Reg::CounterCurrent, n, 100 + n, true);
    bench.store.set(Reg::CounterBit, n, 1, true);
  }
  bench.store.set(Reg::CounterCurrent, 20, 7, true);
  bench.store.set(Reg::TimerCurrent, 50, 8, true);
  bench.scan();
  EXPECT_EQ(bench.current("T37"), 137) << "no power flow";
  bench.set("IB0", 3);
  bench.scan();
  for (std::uint32_t n = 36; n <= 39; ++n) {
    const bool cleared = n == 37 || n == 38;
    EXPECT_EQ(bench.reg(Reg::TimerCurrent, n), cleared ? 0U : 100 + n) << n;
    EXPECT_EQ(bench.reg(Reg::TimerBit, n), cleared ? 0U : 1U) << n;
  }
  for (std::uint32_t n = 9; n <= 13; ++n) {
    const bool cleared = n >= 10 && n <= 12;
    EXPECT_EQ(bench.reg(Reg::CounterCurrent, n), cleared ? 0U : 100 + n) << n;
    EXPECT_EQ(bench.reg(Reg::CounterBit, n), cleared ? 0U : 1U) << n;
  }
  EXPECT_EQ(bench.value("C20"), 1U);
  EXPECT_EQ(bench.value("C21"), 1U);
  EXPECT_EQ(bench.value("C22"), 0U);
  EXPECT_EQ(bench.current("C20"), 7);
  EXPECT_EQ(bench.value("T50"), 1U);
  EXPECT_EQ(bench.current("T50"), 8);
}

TEST(Coil, LeavingTheAreaIsError0091) {
  // M has 32 bytes: 256 bits; from M31.7 there is one.
  for (const char* line : {"S M31.7, VB0", "R M31.7, VB0"}) {
    const bool sets = line[0] == 'S';
    for (const bool partly : {false, true}) {
      Bench bench({"LD SM0.0", line});
      ASSERT_TRUE(bench.choices.set("latch-over-border", partly ? "up-to-border" : "nothing"));
      bench.set("MB31", sets ? 0 : 0xFF);
      bench.set("VB0", 2);
      bench.scan();
      EXPECT_TRUE(bench.met(Hazard::OutOfRange)) << line;
      EXPECT_FALSE(bench.eno());
      EXPECT_TRUE(bench.errorBit());
      EXPECT_EQ(bench.value("M31.7"), sets == partly ? 1U : 0U) << line;
      bench.set("VB0", 1);
      bench.scan();
      EXPECT_TRUE(bench.quiet());
      EXPECT_TRUE(bench.eno());
      EXPECT_EQ(bench.value("M31.7"), sets ? 1U : 0U);
    }
  }
  Bench timers({"LD SM0.0", "R T255, 2"});
  EXPECT_TRUE(timers.scan().met(Hazard::OutOfRange));
}

TEST(Coil, CountZeroFollowsTheChoice) {
  for (const bool error : {false, true}) {
    Bench bench({"LD SM0.0", "S V10.0, VB0"});
    ASSERT_TRUE(bench.choices.set("latch-zero-count", error ? "error" : "nothing"));
    bench.scan();
    EXPECT_EQ(bench.value("VB10"), 0U);
    EXPECT_EQ(bench.met(Hazard::OutOfRange), error);
    EXPECT_EQ(bench.eno(), !error);
  }
}

TEST(Coil, BadPointerOfTheCountIsError0006) {
  Bench bench({"LD I0.0", "S V10.0, *AC1"});
  bench.set("AC1", 0xFF000000);
  bench.scan();
  EXPECT_TRUE(bench.quiet()) << "not executed without power flow";
  bench.set("I0.0", 1);
  bench.scan();
  EXPECT_TRUE(bench.met(Hazard::BadIndirectAddress));
  EXPECT_FALSE(bench.eno());
  EXPECT_EQ(bench.value("VB10"), 0U);
  bench.set("AC1", pointer::encode(Area::V, 50));
  bench.set("VB50", 3);
  bench.scan();
  EXPECT_TRUE(bench.quiet());
  EXPECT_EQ(bench.value("VB10"), 7U);
}

TEST(Coil, CountsOfTheDescriptor) {
  // 001:2789 and 001:2800.
  for (const auto& [name, most] :
       std::vector<std::pair<const char*, int>>{{"S", 255}, {"R", 255}, {"SI", 128}, {"RI", 128}}) {
    const OperandDesc& count = s7200Instructions().named(name)->operand(1);
    EXPECT_EQ(count.ranges[0].low, 1) << name;
    EXPECT_EQ(count.ranges[0].high, most) << name;
    EXPECT_EQ(count.ranges[1].cpus & s7200Cpus, 0U) << name;
  }
}

TEST(Coil, ResetEndsAnOffDelayButNotAnOnDelay) {
  // 001:6586: TOF needs a new falling edge after R; TON goes on from 0 while its input is on.
  Bench bench({"LD I0.0", "TOF T37, 100", "LDN I0.0", "TON T38, 100", "LD I0.1", "R T37, 2", "R C37, 1", "LD I0.2",
               "R C37, 2"});
  for (const std::uint32_t timer : {37U, 38U}) bench.store.set(Reg::TimerRunning, timer, 1, true);
  bench.set("IB0", 0b100);
  bench.scan();
  EXPECT_EQ(bench.reg(Reg::TimerRunning, 38), 1U);
  EXPECT_EQ(bench.reg(Reg::TimerRunning, 37), 1U) << "R of a counter leaves the timer of that number";
  bench.set("IB0", 0b010);
  bench.scan();
  EXPECT_EQ(bench.reg(Reg::TimerRunning, 37), 0U);
  EXPECT_EQ(bench.reg(Reg::TimerRunning, 38), 1U);
}

TEST(Coil, SetAndResetImmediate) {
  Bench bench({"LD I0.0", "SI Q0.6, 4", "LD I0.1", "RI Q0.7, 2", "LD I0.2", "SI Q0.0, 128", "LD I0.3", "SI Q0.1, 128",
               "RI Q15.7, 2"});
  const auto pins = [&](unsigned inputs) {
    bench.set("IB0", inputs);
    bench.scan();
    unsigned value = 0;
    for (unsigned i = 0; i < 16; ++i) value |= static_cast<unsigned>(bench.reg(Reg::PhysicalOutput, i)) << i;
    return value;
  };
  EXPECT_EQ(pins(0), 0U);
  EXPECT_EQ(pins(1), 0b1111000000U) << "Q0.6 to Q1.1 at once";
  EXPECT_EQ(bench.value("QB0"), 0xC0U);
  EXPECT_EQ(bench.value("QB1"), 0x03U);
  EXPECT_EQ(pins(2), 0b1001000000U);
  EXPECT_EQ(bench.value("QB0"), 0x40U);
  EXPECT_EQ(bench.value("QB1"), 0x02U);
  EXPECT_EQ(pins(4), 0xFFFFU) << "128 is the whole image";
  EXPECT_EQ(bench.reg(Reg::PhysicalOutput, 127), 1U);
  EXPECT_TRUE(bench.quiet());
  Bench high({"LD SM0.0", "SI Q2.3, 2"});
  high.scan();
  for (std::uint32_t pin = 0; pin < 128; ++pin)
    EXPECT_EQ(high.reg(Reg::PhysicalOutput, pin), pin == 19 || pin == 20 ? 1U : 0U) << pin;
  pins(8);
  EXPECT_EQ(bench.outside.hazards(), (std::vector<Hazard>{Hazard::OutOfRange, Hazard::OutOfRange}))
      << "128 from Q0.1, and 2 from Q15.7";
}

/// Output and top of the stack of `box M0.0` with inputs and previous bit given.
TEST(Bistable, TruthTables) {
  for (unsigned row = 0; row < 8; ++row) {
    const bool set = (row & 1) != 0, reset = (row & 2) != 0, before = (row & 4) != 0;
    // 001:2897-2908: previous, 0, 1, and the dominant input for both.
    const bool sr = set || (!reset && before), rs = !reset && (set || before);
    for (const bool setDominant : {true, false}) {
      Bench bench({"LD I0.2", "LD I0.0", "LD I0.1", setDominant ? "SR M0.0" : "RS M0.0", "= Q0.0", "LPP", "= Q0.1"});
      bench.set("IB0", (set ? 1 : 0) | (reset ? 2 : 0) | 4);
      bench.set("M0.0", before);
      bench.scan();
      EXPECT_EQ(bench.value("M0.0"), (setDominant ? sr : rs) ? 1U : 0U) << row;
      EXPECT_EQ(bench.value("Q0.0"), (setDominant ? sr : rs) ? 1U : 0U) << "OUT mirrors the bit";
      EXPECT_EQ(bench.value("Q0.1"), 1U) << "two levels became one";
    }
  }
}

}  // namespace
}  // namespace rungproof::manual
