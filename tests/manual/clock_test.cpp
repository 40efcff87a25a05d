// Real-time clock: buffer layout, refused data, CPUs without a clock.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "plant.hpp"

namespace rungproof::manual {
namespace {

/// 19 bytes as TODWX takes them: 04-09-30 23:59:58 Thursday, mode FF, correction 01:00 from 04-01 02:00 to 10-31 03:00.
const std::vector<int> sample = {0x04, 0x09, 0x30, 0x23, 0x59, 0x58, 0x00, 0x05, 0xFF, 0x01,
                                 0x00, 0x04, 0x01, 0x02, 0x00, 0x10, 0x31, 0x03, 0x00};

void fill(Bench& bench, const std::vector<int>& bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) bench.store.area(Area::V)[i] = static_cast<std::uint8_t>(bytes[i]);
}
Bench readBench(const char* line, Target target = {}) {
  Bench bench({"LD I0.0", line}, target);
  for (std::uint32_t i = 0; i < 19; ++i) bench.outside.values[{External::ClockByte, i}] = i == 6 ? 0x99 : 0x10 + i;
  for (std::uint32_t i = 0; i < 30; ++i) bench.store.area(Area::V)[i] = 0xEE;
  bench.set("I0.0", 1);
  return bench;
}

TEST(Clock, ReadsEightOrNineteenBytes) {
  for (const auto& [line, size] :
       std::vector<std::pair<const char*, std::uint32_t>>{{"TODR VB0", 8}, {"TODRX VB0", 19}}) {
    Bench bench = readBench(line);
    bench.set("I0.0", 0);
    EXPECT_EQ(bench.scan().value("VB0"), 0xEEU) << "no power flow";
    bench.set("I0.0", 1);
    bench.scan();
    for (std::uint32_t i = 0; i < 30; ++i) {
      EXPECT_EQ(bench.store.area(Area::V)[i], i >= size ? 0xEE
                                              : i == 6  ? 0
                                                        : 0x10 + i)
          << line << " byte " << i << "; byte 6 is always 0";
    }
    EXPECT_TRUE(bench.eno());
    EXPECT_TRUE(bench.quiet());
  }
}

TEST(Clock, CpusWithPlugInClock) {
  for (const Cpu cpu : {s7200Cpu("221"), s7200Cpu("222"), s7200Cpu("224"), s7200Cpu("224XP"), s7200Cpu("226")}) {
    const bool builtIn = cpu != s7200Cpu("221") && cpu != s7200Cpu("222");
    for (const char* line : {"TODR VB0", "TODRX VB0", "TODW VB100", "TODWX VB100"}) {
      for (const bool fitted : {false, true}) {
        Bench bench = readBench(line, {cpu, Edition::Edition2004});
        ASSERT_TRUE(bench.choices.set("clock-module", fitted ? "fitted" : "absent"));
        for (std::size_t i = 0; i < sample.size(); ++i)
          bench.store.area(Area::V)[100 + i] = static_cast<std::uint8_t>(sample[i]);
        bench.scan();
        EXPECT_EQ(bench.met(Hazard::NoClock), !builtIn && !fitted) << line;
        EXPECT_EQ(bench.eno(), builtIn || fitted);
        const bool reads = line[3] == 'R';
        const bool acts = builtIn || fitted;
        EXPECT_EQ(bench.value("VB0"), reads && acts ? 0x10U : 0xEEU) << line;
        EXPECT_EQ(bench.reg(Reg::ClockSetting, 0), !reads && acts ? 0x04U : 0U) << line;
      }
    }
  }
}

TEST(Clock, SettingTakesTheWholeBuffer) {
  for (const auto& [line, size] :
       std::vector<std::pair<const char*, std::uint32_t>>{{"TODW VB0", 8}, {"TODWX VB0", 19}}) {
    Bench bench({"LD I0.0", line});
    fill(bench, sample);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::ClockSetting, 0), 0U) << "no power flow";
    bench.set("I0.0", 1);
    bench.scan();
    EXPECT_TRUE(bench.quiet()) << line;
    EXPECT_TRUE(bench.eno());
    for (std::uint32_t i = 0; i < 19; ++i)
      EXPECT_EQ(bench.reg(Reg::ClockSetting, i), i < size ? static_cast<unsigned>(sample[i]) : 0U) << i;
  }
}

/// Whether TODW or TODWX takes the sample with one byte changed.
bool takes(const char* line, std::size_t at, int byte, const char* rule = "bcd-and-range") {
  Bench bench({"LD SM0.0", line});
  EXPECT_TRUE(bench.choices.set("clock-data", rule));
  std::vector<int> bytes = sample;
  bytes[at] = byte;
  fill(bench, bytes);
  bench.scan();
  const bool refused = bench.met(Hazard::ClockData);
  EXPECT_EQ(bench.eno(), !refused);
  EXPECT_EQ(bench.errorBit(), refused);
  EXPECT_EQ(bench.reg(Reg::ClockSetting, 1), refused ? 0U : static_cast<unsigned>(bytes[1]));
  return !refused;
}

TEST(Clock, FieldsHaveTheRangesOfTheTable) {
  // 001:2935-2941: lowest and highest value of each byte and their neighbours.
  struct Field {
    std::size_t at;
    int low, high, below, above;
  };
  for (const char* line : {"TODW VB0", "TODWX VB0"}) {
    for (const Field& f : std::vector<Field>{{1, 0x01, 0x12, 0x00, 0x13},
                                             {2, 0x01, 0x31, 0x00, 0x32},
                                             {3, 0x00, 0x23, -1, 0x24},
                                             {4, 0x00, 0x59, -1, 0x60},
                                             {5, 0x00, 0x59, -1, 0x60},
                                             {7, 0x01, 0x07, -1, 0x08}}) {
      EXPECT_TRUE(takes(line, f.at, f.low)) << f.at;
      EXPECT_TRUE(takes(line, f.at, f.high)) << f.at;
      EXPECT_FALSE(takes(line, f.at, f.above)) << f.at;
      if (f.below >= 0) {
        EXPECT_FALSE(takes(line, f.at, f.below)) << f.at;
      }
    }
    EXPECT_TRUE(takes(line, 0, 0x00));
    EXPECT_TRUE(takes(line, 0, 0x99));
    EXPECT_FALSE(takes(line, 0, 0x9A)) << "not BCD";
    EXPECT_FALSE(takes(line, 0, 0xA0)) << "not BCD";
    EXPECT_TRUE(takes(line, 6, 0xFF)) << "byte 6 is not looked at";
  }
  EXPECT_TRUE(takes("TODW VB0", 7, 0)) << "0 switches the weekday off (001:2941)";
  EXPECT_FALSE(takes("TODWX VB0", 7, 0)) << "weekday 1-7";
}

TEST(Clock, ChoicesOfTheDataCheck) {
  EXPECT_TRUE(takes("TODW VB0", 2, 0x45, "bcd"));
  EXPECT_FALSE(takes("TODW VB0", 2, 0x1F, "bcd"));
  EXPECT_TRUE(takes("TODW VB0", 2, 0x1F, "any"));
  EXPECT_TRUE(takes("TODWX VB0", 8, 0x44, "any"));
}

TEST(Clock, DaylightModes) {
  // 001:2984-3005: 00-03, 08, 10-13 and FF; the rest is reserved.
  for (int mode = 0; mode < 256; ++mode) {
    const bool legal = mode <= 3 || mode == 8 || (mode >= 0x10 && mode <= 0x13) || mode == 0xFF;
    EXPECT_EQ(takes("TODWX VB0", 8, mode), legal) << mode;
  }
  EXPECT_TRUE(takes("TODW VB0", 8, 0x44)) << "TODW has no such byte";
}

TEST(Clock, UsersRuleCountsInModeFFOnly) {
  // Correction hours and minutes, month, day, hour, minute of begin and end.
  const std::vector<int> above = {0x24, 0x60, 0x13, 0x32, 0x24, 0x60, 0x13, 0x32, 0x24, 0x60};
  for (std::size_t i = 0; i < above.size(); ++i) {
    EXPECT_FALSE(takes("TODWX VB0", 9 + i, above[i])) << i;
    Bench other({"LD SM0.0", "TODWX VB0"});
    std::vector<int> bytes = sample;
    bytes[8] = 0x01;
    bytes[9 + i] = above[i];
    fill(other, bytes);
    EXPECT_FALSE(other.scan().met(Hazard::ClockData)) << i;
  }
  for (const std::size_t month : {11U, 15U}) EXPECT_FALSE(takes("TODWX VB0", month, 0));
  for (const std::size_t day : {12U, 16U}) EXPECT_FALSE(takes("TODWX VB0", day, 0));
}

TEST(Clock, BufferMustFit) {
  for (const auto& [line, room, fits] : std::vector<std::tuple<const char*, int, bool>>{{"TODR *AC1", 8, true},
                                                                                        {"TODR *AC1", 7, false},
                                                                                        {"TODRX *AC1", 19, true},
                                                                                        {"TODRX *AC1", 18, false},
                                                                                        {"TODW *AC1", 7, false},
                                                                                        {"TODWX *AC1", 18, false}}) {
    Bench bench({"LD SM0.0", line});
    bench.outside.values[{External::ClockByte, 0}] = 0x42;
    const std::uint32_t start = 10240 - static_cast<std::uint32_t>(room);
    bench.set("AC1", pointer::encode(Area::V, start));
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::OutOfRange), !fits) << line << room;
    EXPECT_EQ(bench.store.area(Area::V)[start], fits ? 0x42 : 0) << line << room;
  }
}

}  // namespace
}  // namespace rungproof::manual
