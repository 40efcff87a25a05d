// CPU limits against tables 6-1 and 6-2 of both editions, row by row, and what is known of the CPUs before them.
#include "ir/s7200/cpu.hpp"
#include "tsv.hpp"

namespace rungproof::tables {
namespace {

Area areaOf(const std::string& name) {
  static const std::map<std::string, Area> areas = {
      {"I", Area::I}, {"Q", Area::Q},   {"AIW", Area::AI}, {"AQW", Area::AQ}, {"V", Area::V},
      {"M", Area::M}, {"S", Area::S},   {"SM", Area::SM},  {"L", Area::L},    {"T", Area::T},
      {"C", Area::C}, {"AC", Area::AC}, {"HC", Area::HC}};
  return areas.at(name);
}
Width widthOfAccess(const std::string& access) {
  return access == "bit" ? Width::Bit : access == "byte" ? Width::Byte : access == "word" ? Width::Word : Width::DWord;
}
/// Number of the last element of an area of table 6-1: "VB2047", "M31.7", "T255".
std::uint32_t lastNumber(const std::string& cell) {
  return static_cast<std::uint32_t>(std::stoul(cell.substr(cell.find_first_of("0123456789"))));
}

}  // namespace

TEST(CpuTable, LimitsAgreeWithTable62RowByRow) {
  const std::vector<Row> rows = read("operand-ranges.tsv");
  ASSERT_EQ(rows.size(), 382U);
  for (const Row& row : rows) {
    SCOPED_TRACE(row.at("edition") + " " + row.at("cpu") + " " + row.at("access") + " " + row.at("area") + " " +
                 row.at("source"));
    const Target target = targetOf(row);
    const Area area = areaOf(row.at("area"));
    const Width width = widthOfAccess(row.at("access"));
    const std::optional<AddressLimit> limit = addressLimit(target, area, width);
    if (row.at("effective_high") == "none") {
      EXPECT_FALSE(limit.has_value());
      EXPECT_FALSE(addressExists(target, area, width, 0, 0));
      EXPECT_EQ(areaSize(target, area), 0U);
      continue;
    }
    ASSERT_TRUE(limit.has_value());
    const auto low = static_cast<std::uint32_t>(std::stoul(row.at("effective_low")));
    const auto high = static_cast<std::uint32_t>(std::stoul(row.at("effective_high")));
    if (area != Area::HC) {
      EXPECT_EQ(limit->lastByte, high);
    }
    // The 2003 edition repeats its rows for each CPU; the limit names the first of equal ones.
    const bool isPrintedOnce = target.edition == Edition::Edition2004;
    EXPECT_EQ(limit->source.substr(0, isPrintedOnce ? std::string_view::npos : 4),
              row.at("source").substr(0, isPrintedOnce ? std::string::npos : 4));
    EXPECT_TRUE(addressExists(target, area, width, low, 0));
    EXPECT_TRUE(addressExists(target, area, width, high, 7));
    if (area != Area::HC) {
      EXPECT_FALSE(addressExists(target, area, width, high + (area == Area::AI || area == Area::AQ ? 2 : 1), 0));
    }
    const bool bitsByNumber = area == Area::T || area == Area::C;
    if (width == Width::Bit && !bitsByNumber) {
      EXPECT_FALSE(addressExists(target, area, width, low, 8));
    }
    if (area == Area::AI || area == Area::AQ) {
      EXPECT_FALSE(addressExists(target, area, width, 1, 0)) << "odd";
    }
  }
}

TEST(CpuTable, WhatTheTableDoesNotListDoesNotExist) {
  // No bit access to accumulators, analog words or counters' HC; no byte access to timers; no double word of a counter.
  const Target target;
  EXPECT_FALSE(addressLimit(target, Area::AC, Width::Bit).has_value());
  EXPECT_FALSE(addressLimit(target, Area::AI, Width::Byte).has_value());
  EXPECT_FALSE(addressLimit(target, Area::AI, Width::DWord).has_value());
  EXPECT_FALSE(addressLimit(target, Area::HC, Width::Word).has_value());
  EXPECT_FALSE(addressLimit(target, Area::T, Width::Byte).has_value());
  EXPECT_FALSE(addressLimit(target, Area::C, Width::DWord).has_value());
}

TEST(CpuTable, MisprintsCarryANote) {
  // Printed 255 for the byte accumulators of the 224XP, 226 and, in 2003, 226XM.
  for (const Row& row : read("operand-ranges.tsv")) {
    if (row.at("high") == row.at("effective_high") || row.at("area") == "HC" || row.at("area") == "L") continue;
    const std::optional<AddressLimit> limit =
        addressLimit(targetOf(row), areaOf(row.at("area")), widthOfAccess(row.at("access")));
    EXPECT_FALSE(limit->note.empty()) << row.at("source");
  }
}

TEST(CpuTable, AreaSizesAgreeWithTable61) {
  static const std::map<std::string, std::pair<Area, std::uint32_t>> areas = {{"process_image_inputs", {Area::I, 1}},
                                                                              {"process_image_outputs", {Area::Q, 1}},
                                                                              {"V_memory", {Area::V, 1}},
                                                                              {"L_memory", {Area::L, 1}},
                                                                              {"M_memory", {Area::M, 1}},
                                                                              {"S_memory", {Area::S, 1}},
                                                                              {"timers_total", {Area::T, 1}},
                                                                              {"counters", {Area::C, 1}},
                                                                              {"accumulators", {Area::AC, 1}},
                                                                              {"analog_inputs", {Area::AI, 2}},
                                                                              {"analog_outputs", {Area::AQ, 2}}};
  int count = 0;
  for (const Row& row : read("cpu-features.tsv")) {
    const auto found = areas.find(row.at("feature"));
    if (found == areas.end()) continue;
    ++count;
    const auto& [area, step] = found->second;
    const std::uint32_t expected = row.at("high") == "none" ? 0 : lastNumber(row.at("high")) + step;
    EXPECT_EQ(areaSize(targetOf(row), area), expected) << row.at("edition") << row.at("cpu") << row.at("feature");
  }
  EXPECT_EQ(count, 110) << "11 features of 5 CPUs in 2 editions";
}

TEST(CpuTable, SpecialMemoryOfTable61) {
  for (const Row& row : read("cpu-features.tsv")) {
    if (row.at("feature") == "SM_memory_read_only") {
      EXPECT_EQ(smReadOnlyLast, lastNumber(row.at("high")));
    }
    if (row.at("feature") != "SM_memory_total") continue;
    const Target target = targetOf(row);
    // Tables 6-1 and 6-2 of 2004 disagree for the CPU 221: SM179 against SM165 (001:2652, 001:2681).
    const bool isContradiction = target.cpu == s7200Cpu("221") && target.edition == Edition::Edition2004;
    EXPECT_EQ(areaSize(target, Area::SM), isContradiction ? 166U : lastNumber(row.at("high")) + 1) << row.at("cpu");
  }
}

TEST(CpuTable, FeaturesAgreeWithTheTables) {
  int count = 0;
  for (const Row& row : read("cpu-features.tsv")) {
    const Target target = targetOf(row);
    const CpuFeatures features = cpuFeatures(target);
    const std::string& feature = row.at("feature");
    const std::string& value = row.at("value");
    SCOPED_TRACE(row.at("edition") + " " + row.at("cpu") + " " + feature);
    ++count;
    if (feature == "subroutines") {
      EXPECT_EQ(features.subroutines, std::stoi(row.at("high")) + 1);
    } else if (feature == "interrupt_routines") {
      EXPECT_EQ(features.interruptRoutines, std::stoi(row.at("high")) + 1);
    } else if (feature == "jump_labels") {
      EXPECT_EQ(features.labels, std::stoi(row.at("high")) + 1);
    } else if (feature == "edge_instructions") {
      EXPECT_EQ(features.edges, std::stoi(value));
    } else if (feature == "pid_loops") {
      EXPECT_EQ(features.pidLoops, std::stoi(value));
    } else if (feature == "ports") {
      EXPECT_EQ(features.ports, value == "0,1" ? 2 : 1);
    } else if (feature == "queue_communication") {
      EXPECT_EQ(features.queueCommunication, std::stoi(value));
    } else if (feature == "queue_io") {
      EXPECT_EQ(features.queueIo, std::stoi(value));
    } else if (feature == "queue_timed") {
      EXPECT_EQ(features.queueTimed, std::stoi(value));
    } else if (feature == "pulse_outputs") {
      EXPECT_EQ(features.pulseOutputs, std::stoi(value));
    } else if (feature == "real_time_clock") {
      EXPECT_EQ(features.clockBuiltIn, value == "built in");
    } else {
      --count;
    }
  }
  EXPECT_EQ(count, 6 * 10 + 3 * 10 + 2 * 5) << "table 6-1, queues, and two rows of 2004 alone";
}

TEST(CpuTable, EventsCountersAndTimers) {
  for (const Row& row : read("cpu-features.tsv")) {
    const Target target = targetOf(row);
    const std::string& feature = row.at("feature");
    SCOPED_TRACE(row.at("edition") + " " + row.at("cpu") + " " + feature);
    if (feature == "interrupt_events_EVNT") {
      for (int event = -1; event <= 40; ++event)
        EXPECT_EQ(eventExists(target, event), listed(row.at("value"), event)) << event;
    }
    if (feature == "hsc_total") {
      int counters = 0;
      for (int counter = -1; counter <= 6; ++counter) counters += hscExists(target, counter) ? 1 : 0;
      EXPECT_EQ(counters, std::stoi(row.at("value")));
    }
    if (feature == "high_speed_counters" && row.at("value").find(',') != std::string::npos) {
      for (int counter = 0; counter <= 6; ++counter)
        EXPECT_EQ(hscExists(target, counter), listed(row.at("value"), counter)) << counter;
    }
    if (feature.starts_with("timers_TON")) {
      const bool retentive = feature.starts_with("timers_TONR");
      const int resolution = feature.ends_with("_1ms") ? 1 : feature.ends_with("_10ms") ? 10 : 100;
      for (int number = 0; number < 256; ++number) {
        const bool inRow = listed(row.at("value"), number);
        EXPECT_EQ(timerResolution(number) == resolution && timerIsRetentive(number) == retentive, inRow) << number;
      }
    }
  }
  EXPECT_EQ(timerResolution(256), 0);
  EXPECT_EQ(timerResolution(-1), 0);
}

TEST(CpuTable, CpusBefore22x) {
  // 004:4565-4566 gives the timers: T0 to T63 on the 212, T0 to T127 on the 214. The program at 004:2500 writes up to
  // VD1056, which the 212 does not have; 004:359 and 004:4241 count with HSC 0, 1 and 2 of the 214; 004:67: only the
  // 214 has the second timed interrupt. The rest is general knowledge.
  for (const Edition edition : {Edition::Edition2003, Edition::Edition2004}) {
    const Target small{s7200Cpu("212"), edition}, large{s7200Cpu("214"), edition};
    EXPECT_EQ(areaSize(small, Area::T), 64U);
    EXPECT_EQ(areaSize(large, Area::T), 128U);
    EXPECT_FALSE(addressExists(small, Area::V, Width::DWord, 1056, 0));
    EXPECT_TRUE(addressExists(large, Area::V, Width::DWord, 1056, 0));
    EXPECT_EQ(areaSize(small, Area::V), 1024U);
    EXPECT_EQ(areaSize(large, Area::V), 4096U);
    EXPECT_FALSE(addressExists(small, Area::L, Width::Byte, 0, 0));
    EXPECT_FALSE(addressExists(large, Area::L, Width::Byte, 0, 0));
    for (int counter = 0; counter <= 5; ++counter) {
      EXPECT_EQ(hscExists(small, counter), counter == 0) << counter;
      EXPECT_EQ(hscExists(large, counter), counter <= 2) << counter;
    }
    for (int event = 0; event <= 33; ++event) {
      EXPECT_EQ(eventExists(small, event), listed("0-1,8-10,12", event)) << event;
      EXPECT_EQ(eventExists(large, event), event <= 20) << event;
    }
    EXPECT_EQ(cpuFeatures(small).pulseOutputs, 0);
    EXPECT_EQ(cpuFeatures(large).pulseOutputs, 2);
    EXPECT_FALSE(cpuFeatures(small).clockBuiltIn);
    EXPECT_TRUE(cpuFeatures(large).clockBuiltIn);
    EXPECT_EQ(cpuFeatures(small).subroutines, 16);
    EXPECT_EQ(cpuFeatures(large).subroutines, 64);
    EXPECT_EQ(cpuFeatures(small).labels, 64);
    EXPECT_EQ(cpuFeatures(large).labels, 256);
    EXPECT_EQ(cpuFeatures(small).queueTimed, 2);
    EXPECT_EQ(cpuFeatures(large).queueTimed, 4);
    EXPECT_EQ(cpuFeatures(large).pidLoops, 0);
  }
}

TEST(CpuTable, EditionsCoverTheirCpus) {
  for (const Cpu cpu : {s7200Cpu("221"), s7200Cpu("222"), s7200Cpu("224"), s7200Cpu("226")}) {
    EXPECT_TRUE(editionCovers(Edition::Edition2003, cpu));
    EXPECT_TRUE(editionCovers(Edition::Edition2004, cpu));
  }
  EXPECT_FALSE(editionCovers(Edition::Edition2003, s7200Cpu("224XP")));
  EXPECT_FALSE(editionCovers(Edition::Edition2004, s7200Cpu("226XM")));
  // A CPU that the edition does not describe keeps the limits of the one that does.
  EXPECT_EQ(areaSize({s7200Cpu("224XP"), Edition::Edition2003}, Area::V), 10240U);
  EXPECT_EQ(areaSize({s7200Cpu("226XM"), Edition::Edition2004}, Area::V), 10240U);
  EXPECT_EQ(cpuNamed("224XP"), s7200Cpu("224XP"));
  EXPECT_EQ(cpuNamed("CPU225"), std::nullopt);
  EXPECT_EQ(cpuName(s7200Cpu("226XM")), "226XM");
}

}  // namespace rungproof::tables
