// High-speed counters: HDEF and HSC.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "plant.hpp"

namespace rungproof::manual {
namespace {

const std::vector<std::uint32_t> controlBytes = {37, 47, 57, 137, 147, 157};  // 001:4272-4356

std::string line(const char* op, int a, int b = -1) {
  return std::string(op) + " " + std::to_string(a) + (b < 0 ? "" : ", " + std::to_string(b));
}

TEST(Hdef, ModesOfEachCounter) {
  // 001:14759-14801.
  const std::vector<std::vector<int>> modes = {{0, 1, 3, 4, 6, 7, 9, 10, 12},
                                               {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
                                               {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
                                               {0, 12},
                                               {0, 1, 3, 4, 6, 7, 9, 10},
                                               {0}};
  for (int counter = 0; counter < 6; ++counter) {
    for (int mode = 0; mode <= 12; ++mode) {
      const auto& list = modes[static_cast<std::size_t>(counter)];
      const bool usable = std::find(list.begin(), list.end(), mode) != list.end();
      Bench bench({"LD I5.0", line("HDEF", counter, mode)});
      bench.scan();
      EXPECT_EQ(bench.reg(Reg::HscMode, static_cast<std::uint32_t>(counter)), 0U) << "no power flow";
      bench.set("I5.0", 1);
      bench.scan();
      EXPECT_EQ(bench.reg(Reg::HscMode, static_cast<std::uint32_t>(counter)),
                usable ? static_cast<unsigned>(mode) + 1 : 0U)
          << counter << " mode " << mode;
      EXPECT_EQ(bench.met(Hazard::OutOfRange), !usable);
      EXPECT_EQ(bench.eno(), usable);
    }
  }
}

TEST(Hdef, CpusWithoutCounters1And2) {
  for (int counter = 0; counter < 6; ++counter) {
    const bool exists = counter != 1 && counter != 2;
    Bench bench({"LD SM0.0", line("HDEF", counter, 0), line("HSC", counter)}, {s7200Cpu("222"), Edition::Edition2004});
    bench.scan();
    EXPECT_EQ(bench.quiet(), exists) << counter;
    EXPECT_EQ(bench.reg(Reg::HscMode, static_cast<std::uint32_t>(counter)), exists ? 1U : 0U);
  }
}

TEST(Hdef, LatchesTheLevelsOnceOnly) {
  for (std::uint32_t counter = 0; counter < 6; ++counter) {
    Bench bench({"LD SM0.0", line("HDEF", static_cast<int>(counter), 0)});
    const std::string control = "SMB" + std::to_string(controlBytes[counter]);
    bench.set(control, 0xFD);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::HscSetup, counter), 5U) << "bits 0-2";
    EXPECT_TRUE(bench.quiet());
    bench.set(control, 0x02);
    bench.scan();
    EXPECT_EQ(bench.outside.hazards(), std::vector<Hazard>{Hazard::HdefTwice}) << "000A";
    EXPECT_EQ(bench.reg(Reg::HscSetup, counter), 5U) << "the first definition stays (001:4360)";
    EXPECT_FALSE(bench.eno());
    EXPECT_TRUE(bench.errorBit());
  }
}

TEST(Hdef, InputsServeOnePurpose) {
  struct Pair {
    int first, firstMode, second, secondMode;
    bool conflict;
  };
  // 001:4211-4213: HSC0 modes 3-11 need I0.1, HSC4 modes 3-11 need I0.4.
  for (const Pair& p : std::vector<Pair>{{0, 3, 3, 0, true},
                                         {0, 1, 3, 0, false},
                                         {0, 10, 3, 0, true},
                                         {0, 12, 3, 0, false},
                                         {0, 3, 3, 12, false},
                                         {4, 3, 5, 0, true},
                                         {4, 1, 5, 0, false},
                                         {3, 0, 0, 6, true},
                                         {5, 0, 4, 9, true},
                                         {1, 11, 2, 11, false},
                                         {0, 10, 4, 10, false}}) {
    Bench bench({"LD SM0.0", line("HDEF", p.first, p.firstMode), line("HDEF", p.second, p.secondMode)});
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::HscInputConflict), p.conflict)
        << p.first << " " << p.firstMode << " / " << p.second << " " << p.secondMode;
    EXPECT_EQ(bench.reg(Reg::HscMode, static_cast<std::uint32_t>(p.second)),
              p.conflict ? 0U : static_cast<unsigned>(p.secondMode) + 1);
    EXPECT_EQ(bench.reg(Reg::HscMode, static_cast<std::uint32_t>(p.first)), static_cast<unsigned>(p.firstMode) + 1);
    EXPECT_EQ(bench.eno(), !p.conflict);
  }
  // Edge events 0-7 belong to I0.0 to I0.3, two each.
  for (std::uint32_t event = 0; event < 9; ++event) {
    Bench bench({"LD SM0.0", "HDEF 0, 10"});  // I0.0, I0.1, I0.2
    bench.store.set(Reg::EventRoutine, event, 1, true);
    EXPECT_EQ(bench.scan().met(Hazard::HscInputConflict), event < 6) << event;
  }
}

TEST(Hdef, NotInInterruptRoutines) {
  Bench bench({"LD SM0.0"}, {}, {"HDEF 1, 11"});
  bench.interrupt();
  EXPECT_EQ(bench.outside.hazards(), std::vector<Hazard>{Hazard::NotInInterrupt});
  EXPECT_EQ(bench.reg(Reg::HscMode, 1), 0U);
}

TEST(Hsc, NeedsADefinition) {
  Bench bench({"LD I0.0", "HSC 1"});
  bench.set("SMB47", 0xF8);
  EXPECT_TRUE(bench.scan().quiet());
  bench.set("I0.0", 1);
  bench.scan();
  EXPECT_EQ(bench.outside.hazards(), std::vector<Hazard>{Hazard::HscWithoutHdef});
  EXPECT_EQ(bench.reg(Reg::HscEnabled, 1), 0U);
  EXPECT_FALSE(bench.eno());
  EXPECT_TRUE(bench.errorBit());
}

TEST(Hsc, TakesWhatTheControlByteAllows) {
  for (std::uint32_t counter = 0; counter < 6; ++counter) {
    const std::uint32_t control = controlBytes[counter];
    for (unsigned bits = 0; bits < 256; bits += 8) {
      Bench bench({"LD I7.0", line("HSC", static_cast<int>(counter))});
      bench.store.set(Reg::HscMode, counter, 1, true);
      bench.store.set(Reg::HscCurrent, counter, 111, true);
      bench.store.set(Reg::HscPreset, counter, 222, true);
      bench.store.set(Reg::HscUp, counter, (bits & 8) != 0 ? 0 : 1, true);
      bench.store.set(Reg::HscEnabled, counter, (bits & 128) != 0 ? 0 : 1, true);
      bench.set("SMB" + std::to_string(control), bits);
      bench.set("SMD" + std::to_string(control + 1), -5);
      bench.set("SMD" + std::to_string(control + 5), 70000);
      bench.scan();
      EXPECT_EQ(bench.reg(Reg::HscCurrent, counter), 111U) << "no power flow";
      bench.set("I7.0", 1);
      bench.scan();
      EXPECT_EQ(bench.value("HC" + std::to_string(counter)), (bits & 0x40) != 0 ? 0xFFFFFFFBU : 111U)
          << counter << " " << bits;
      EXPECT_EQ(bench.reg(Reg::HscPreset, counter), (bits & 0x20) != 0 ? 70000U : 222U);
      const bool up = (bits & 8) != 0, writesDirection = (bits & 0x10) != 0;
      EXPECT_EQ(bench.reg(Reg::HscUp, counter), (writesDirection ? up : !up) ? 1U : 0U);
      EXPECT_EQ(bench.reg(Reg::HscEnabled, counter), (bits & 0x80) != 0 ? 1U : 0U);
      EXPECT_TRUE(bench.quiet());
      EXPECT_TRUE(bench.eno());
    }
  }
}

TEST(Hsc, InitialisationOfTheExample) {
  // 001:4495-4507: HSC1 mode 11, F8: enabled, up, current 0, preset 50.
  Bench bench({"LD SM0.0", "HDEF 1, 11", "HSC 1"});
  bench.set("SMB47", 0xF8);
  bench.set("SMD52", 50);
  bench.store.set(Reg::HscCurrent, 1, 9, true);
  bench.scan();
  EXPECT_EQ(bench.reg(Reg::HscMode, 1), 12U);
  EXPECT_EQ(bench.reg(Reg::HscSetup, 1), 0U);
  EXPECT_EQ(bench.reg(Reg::HscCurrent, 1), 0U);
  EXPECT_EQ(bench.reg(Reg::HscPreset, 1), 50U);
  EXPECT_EQ(bench.reg(Reg::HscUp, 1), 1U);
  EXPECT_EQ(bench.reg(Reg::HscEnabled, 1), 1U);
}

}  // namespace
}  // namespace rungproof::manual
