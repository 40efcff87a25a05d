// Pulse outputs: PLS with the control bytes of the manual.
#include <gtest/gtest.h>

#include "plant.hpp"

namespace rungproof::manual {
namespace {

/// Special memory of one output: addresses 001:4656-4680.
struct Output {
  std::uint32_t q;
  std::string line, status, control, cycle, width, count, segment, table;
};
const std::vector<Output> outputs = {{0, "PLS 0", "SMB66", "SMB67", "SMW68", "SMW70", "SMD72", "SMB166", "SMW168"},
                                     {1, "PLS 1", "SMB76", "SMB77", "SMW78", "SMW80", "SMD82", "SMB176", "SMW178"}};

Bench prepared(const Output& o, unsigned control) {
  Bench bench({"LD I5.0", o.line});
  bench.set("I5.0", 1);
  bench.set(o.control, control);
  bench.set(o.cycle, 500);
  bench.set(o.width, 120);
  bench.set(o.count, 40000);
  bench.set(o.status, 0x80);  // idle
  return bench;
}

TEST(Pulse, NothingWithoutPowerFlow) {
  for (const Output& o : outputs) {
    Bench bench = prepared(o, 0x85);
    bench.set("I5.0", 0);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::PulseBusy, o.q), 0U);
    EXPECT_EQ(bench.value(o.status), 0x80U);
    EXPECT_EQ(bench.reg(Reg::PulseCycle, o.q), 0U);
  }
}

TEST(Pulse, ControlBytesOfSingleTrains) {
  // 001:4682-4699: byte, loads the cycle, loads the count, time base 1 ms. A value never loaded is 0 and becomes the
  // least.
  struct Row {
    unsigned byte;
    bool cycle, count, ms;
  };
  for (const Output& o : outputs) {
    for (const Row& row : std::vector<Row>{{0x81, true, false, false},
                                           {0x84, false, true, false},
                                           {0x85, true, true, false},
                                           {0x89, true, false, true},
                                           {0x8C, false, true, true},
                                           {0x8D, true, true, true}}) {
      Bench bench = prepared(o, row.byte);
      bench.scan();
      EXPECT_EQ(bench.reg(Reg::PulseBusy, o.q), 1U) << row.byte;
      EXPECT_EQ(bench.reg(Reg::PulseIsPwm, o.q), 0U);
      EXPECT_EQ(bench.reg(Reg::PulseCycle, o.q), row.cycle ? 500U : 2U) << row.byte;
      EXPECT_EQ(bench.reg(Reg::PulseCount, o.q), row.count ? 40000U : 1U) << row.byte;
      EXPECT_EQ(bench.reg(Reg::PulseIsMs, o.q), row.ms ? 1U : 0U);
      EXPECT_EQ(bench.value(o.status), 0U) << "not idle";
      EXPECT_EQ(bench.reg(Reg::PulseBusy, 1 - o.q), 0U) << "the other output is not touched";
      EXPECT_TRUE(bench.eno());
      EXPECT_TRUE(bench.quiet());
    }
  }
}

TEST(Pulse, KeptValuesAreUsedAgain) {
  Bench bench = prepared(outputs[0], 0x84);
  bench.store.set(Reg::PulseCycle, 0, 777, true);
  bench.scan();
  EXPECT_EQ(bench.reg(Reg::PulseCycle, 0), 777U);
  EXPECT_EQ(bench.reg(Reg::PulseCount, 0), 40000U);
}

TEST(Pulse, LeastCycleAndCount) {
  // 001:4570-4574.
  for (const auto& [given, used] :
       std::vector<std::pair<int, unsigned>>{{0, 2}, {1, 2}, {2, 2}, {3, 3}, {65535, 65535}}) {
    Bench bench = prepared(outputs[0], 0x85);
    bench.set("SMW68", given);
    bench.set("SMD72", given == 65535 ? 0xFFFFFFFF : 0);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::PulseCycle, 0), used) << given;
    EXPECT_EQ(bench.reg(Reg::PulseCount, 0), given == 65535 ? 0xFFFFFFFFU : 1U);
  }
}

TEST(Pulse, PipelineHoldsOneTrain) {
  for (const Output& o : outputs) {
    Bench bench = prepared(o, 0x85);
    bench.scan();
    bench.set(o.cycle, 1);
    bench.set(o.count, 7);
    bench.set(o.control, 0x8D);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::PulseCycle, o.q), 500U) << "the running train goes on";
    EXPECT_EQ(bench.reg(Reg::PulseCount, o.q), 40000U);
    EXPECT_EQ(bench.reg(Reg::PulseIsMs, o.q), 0U);
    EXPECT_EQ(bench.reg(Reg::PulsePending, o.q), 1U);
    EXPECT_EQ(bench.reg(Reg::PulseNextCycle, o.q), 2U);
    EXPECT_EQ(bench.reg(Reg::PulseNextCount, o.q), 7U);
    EXPECT_EQ(bench.reg(Reg::PulseNextIsMs, o.q), 1U);
    EXPECT_EQ(bench.value(o.status), 0U);
    bench.set(o.count, 9);
    bench.scan();
    EXPECT_EQ(bench.value(o.status), 0x40U) << "pipeline overflow, bit 6";
    EXPECT_EQ(bench.reg(Reg::PulseNextCount, o.q), 7U);
    EXPECT_TRUE(bench.quiet());
  }
}

TEST(Pulse, DisablingStops) {
  for (const Output& o : outputs) {
    Bench bench = prepared(o, 0x85);
    bench.scan().scan();
    bench.set(o.control, 0x05);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::PulseBusy, o.q), 0U);
    EXPECT_EQ(bench.reg(Reg::PulsePending, o.q), 0U);
    EXPECT_EQ(bench.value(o.status), 0xA0U) << "idle and aborted by the user";
    Bench idle = prepared(o, 0x05);
    idle.scan();
    EXPECT_EQ(idle.value(o.status), 0x80U) << "nothing ran";
    Bench pwm = prepared(o, 0xD3);
    pwm.scan();
    pwm.set(o.control, 0x53);
    pwm.scan();
    EXPECT_EQ(pwm.reg(Reg::PulseBusy, o.q), 0U);
    EXPECT_EQ(pwm.value(o.status) & 0x20U, 0U) << "no train was aborted";
  }
}

TEST(Pulse, ControlBytesOfWidthModulation) {
  struct Row {
    unsigned byte;
    bool cycle, width, ms;
  };
  for (const Output& o : outputs) {
    for (const Row& row : std::vector<Row>{{0xD1, true, false, false},
                                           {0xD2, false, true, false},
                                           {0xD3, true, true, false},
                                           {0xD9, true, false, true},
                                           {0xDA, false, true, true},
                                           {0xDB, true, true, true}}) {
      Bench bench = prepared(o, row.byte);
      bench.store.set(Reg::PulseCycle, o.q, 1000, true);
      bench.store.set(Reg::PulseWidth, o.q, 1, true);
      bench.scan();
      EXPECT_EQ(bench.reg(Reg::PulseBusy, o.q), 1U);
      EXPECT_EQ(bench.reg(Reg::PulseIsPwm, o.q), 1U);
      EXPECT_EQ(bench.reg(Reg::PulseCycle, o.q), row.cycle ? 500U : 1000U) << row.byte;
      EXPECT_EQ(bench.reg(Reg::PulseWidth, o.q), row.width ? 120U : 1U) << row.byte;
      EXPECT_EQ(bench.reg(Reg::PulseIsMs, o.q), row.ms ? 1U : 0U);
      // Running PWM takes new values at any time.
      bench.set(o.cycle, 0);
      bench.set(o.width, 0);
      bench.set(o.control, 0xD3);
      bench.scan();
      EXPECT_EQ(bench.reg(Reg::PulseCycle, o.q), 2U);
      EXPECT_EQ(bench.reg(Reg::PulseWidth, o.q), 0U);
      EXPECT_TRUE(bench.quiet());
    }
  }
}

TEST(Pulse, ProfileStarts) {
  for (const Output& o : outputs) {
    for (const unsigned control : {0xA0U, 0xA8U}) {
      Bench bench = prepared(o, control);
      bench.set(o.table, 500);
      bench.set("VB500", 3);
      bench.scan();
      EXPECT_EQ(bench.reg(Reg::PulseBusy, o.q), 1U);
      EXPECT_EQ(bench.reg(Reg::PulseSegments, o.q), 3U);
      EXPECT_EQ(bench.reg(Reg::PulseTable, o.q), 500U);
      EXPECT_EQ(bench.reg(Reg::PulseIsMs, o.q), control == 0xA8 ? 1U : 0U);
      EXPECT_EQ(bench.value(o.segment), 1U) << "the first segment is active";
      EXPECT_EQ(bench.value(o.status), 0U);
      EXPECT_TRUE(bench.quiet());
      bench.set(o.control, 0);
      bench.scan();
      EXPECT_EQ(bench.value(o.status), 0xA0U);
      EXPECT_EQ(bench.reg(Reg::PulseSegments, o.q), 0U);
    }
  }
}

TEST(Pulse, ProfileErrors) {
  Bench empty = prepared(outputs[0], 0xA0);
  empty.set("SMW168", 500);
  empty.scan();
  EXPECT_EQ(empty.outside.hazards(), std::vector<Hazard>{Hazard::NoSegments}) << "000E";
  EXPECT_EQ(empty.reg(Reg::PulseBusy, 0), 0U);
  EXPECT_EQ(empty.value("SMB66"), 0x80U);
  EXPECT_FALSE(empty.eno());
  // V ends at VB10239: one segment needs nine bytes.
  for (const auto& [start, fits] : std::vector<std::pair<int, bool>>{{10231, true}, {10232, false}, {60000, false}}) {
    Bench bench = prepared(outputs[0], 0xA0);
    bench.set("SMW168", start);
    if (start < 10240) bench.store.area(Area::V)[static_cast<std::size_t>(start)] = 1;
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::PulseProfile), !fits) << start;
    EXPECT_EQ(bench.reg(Reg::PulseBusy, 0), fits ? 1U : 0U) << start;
  }
}

TEST(Pulse, RunningOutputsAreNotRedefined) {
  // 000D; first and second control byte, and whether the second is taken.
  struct Row {
    unsigned first, second;
    bool taken;
  };
  for (const Row& row : std::vector<Row>{{0x85, 0xD3, false},
                                         {0xD3, 0x85, false},
                                         {0x85, 0xA0, false},
                                         {0xA0, 0x85, false},
                                         {0xA0, 0xA0, false},
                                         {0xA0, 0xD3, false},
                                         {0xD3, 0xA0, false},
                                         {0x85, 0x85, true},
                                         {0xD3, 0xDB, true},
                                         {0xD3, 0xF3, true}}) {
    Bench bench = prepared(outputs[0], row.first);
    bench.set("VB0", 1);
    bench.scan();
    EXPECT_TRUE(bench.quiet());
    const auto before = bench.store;
    bench.set("SMB67", row.second);
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::PulseOutputBusy), !row.taken) << row.first << " " << row.second;
    EXPECT_EQ(bench.eno(), row.taken);
    EXPECT_EQ(bench.reg(Reg::PulseIsPwm, 0), before.get(Reg::PulseIsPwm, 0)) << row.first << " " << row.second;
    EXPECT_EQ(bench.reg(Reg::PulseSegments, 0), before.get(Reg::PulseSegments, 0)) << row.first << " " << row.second;
  }
}

}  // namespace
}  // namespace rungproof::manual
