// The S7-200 SMART against its tables, row by row: areas of each CPU and firmware, instructions, special memory.
#include <gtest/gtest.h>

#include "analysis/flow/facts.hpp"
#include "analysis/lint/lint.hpp"
#include "analysis/rule.hpp"
#include "frontend/input/project.hpp"
#include "frontend/stl/system_symbol.hpp"
#include "ir/s7200/event.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7200/special_memory.hpp"
#include "tests/ir/tsv.hpp"

namespace rungproof::tables {
namespace {

Target smartTarget(const Row& row) { return {*cpuNamed(row.at("cpu")), *editionNamed(row.at("edition"))}; }

/// "31.7" -> 31 and 7; "255" -> 255 and 0.
std::pair<std::uint32_t, unsigned> place(const std::string& cell) {
  const std::size_t dot = cell.find('.');
  return {static_cast<std::uint32_t>(std::stoul(cell)),
          dot == std::string::npos ? 0U : static_cast<unsigned>(std::stoul(cell.substr(dot + 1)))};
}

const std::map<std::string, Area> areas = {{"I", Area::I},  {"Q", Area::Q}, {"AIW", Area::AI}, {"AQW", Area::AQ},
                                           {"V", Area::V},  {"M", Area::M}, {"S", Area::S},    {"SM", Area::SM},
                                           {"L", Area::L},  {"T", Area::T}, {"C", Area::C},    {"AC", Area::AC},
                                           {"HC", Area::HC}};

void expectNumber(const Row& row) {
  const Target target = smartTarget(row);
  const CpuFeatures features = cpuFeatures(target);
  const std::string& what = row.at("area");
  const int high = row.at("high") == "-" ? -1 : std::stoi(row.at("high"));
  if (what == "HSC") {
    EXPECT_TRUE(hscExists(target, high));
    EXPECT_FALSE(hscExists(target, high + 1));
  } else if (what == "PLS") {
    EXPECT_EQ(features.pulseOutputs, high + 1);
  } else if (what == "PORT") {
    EXPECT_EQ(features.ports, high + 1);
  } else if (what == "PID_LOOP") {
    EXPECT_EQ(features.pidLoops, high + 1);
  } else if (what == "SBR") {
    EXPECT_EQ(features.subroutines, high + 1);
  } else if (what == "INT") {
    EXPECT_EQ(features.interruptRoutines, high + 1);
  } else if (what == "LBL") {
    EXPECT_EQ(features.labels, high + 1);
  } else if (what == "EDGE") {
    EXPECT_EQ(features.edges, high);
  } else {
    ADD_FAILURE() << "nothing knows " << what;
  }
}

}  // namespace

TEST(SmartTables, AreasOfEachCpuAndFirmware) {
  const std::vector<Row> rows = read("smart-operand-ranges.tsv");
  ASSERT_EQ(rows.size(), 1556U);
  std::size_t addresses = 0;
  for (const Row& row : rows) {
    SCOPED_TRACE(row.at("edition") + " " + row.at("cpu") + " " + row.at("access") + " " + row.at("area") + " " +
                 row.at("high"));
    const Target target = smartTarget(row);
    EXPECT_TRUE(editionCovers(target.edition, target.cpu));
    const std::string& access = row.at("access");
    if (access == "limit" || access == "onboard") continue;  // size of the program, of retention; which points are real
    if (access == "number") {
      expectNumber(row);
      continue;
    }
    ++addresses;
    const Area area = areas.at(row.at("area"));
    const Width width = access == "bit"    ? Width::Bit
                        : access == "byte" ? Width::Byte
                        : access == "word" ? Width::Word
                                           : Width::DWord;
    if (row.at("high") == "-") {
      EXPECT_FALSE(addressLimit(target, area, width).has_value());
      continue;
    }
    const auto [low, lowBit] = place(row.at("low"));
    const auto [high, highBit] = place(row.at("high"));
    EXPECT_TRUE(addressExists(target, area, width, low, lowBit));
    EXPECT_TRUE(addressExists(target, area, width, high, highBit));
    const std::uint32_t step = isAnalogue(area) ? 2 : 1;
    // Behind the controller's PROFINET data lie those of the I-device, without a gap.
    const bool goesOn = high >= 1148 && high <= 1151;
    EXPECT_EQ(addressExists(target, area, width, high + step, 0), goesOn);
  }
  EXPECT_GT(addresses, 1000U);
}

TEST(SmartTables, BetweenTheImageAndProfinetIsNothing) {
  const Target st30{s7200Cpu("ST30"), Edition::Smart28};
  for (const std::uint32_t byte : {32U, 100U, 127U}) EXPECT_FALSE(addressExists(st30, Area::I, Width::Byte, byte, 0));
  EXPECT_FALSE(addressExists(st30, Area::Q, Width::Word, 31, 0)) << "QW31 would reach QB32";
  EXPECT_FALSE(addressExists(st30, Area::Q, Width::DWord, 126, 0)) << "QD126 would begin in the gap";
  EXPECT_TRUE(addressExists(st30, Area::Q, Width::DWord, 128, 0));
}

TEST(SmartTables, InstructionsOfTheFamily) {
  const std::vector<Row> rows = read("smart-instructions.tsv");
  ASSERT_EQ(rows.size(), 283U);
  for (const Row& row : rows) {
    const std::string& name = row.at("mnemonic");
    SCOPED_TRACE(name);
    const Desc* desc = s7200Instructions().named(name);
    ASSERT_NE(desc, nullptr);
    if (desc->olderDialectOnly) {
      EXPECT_EQ(row.at("in_smart"), "no");
      continue;
    }
    const bool isKnown = row.at("in_smart") == "yes" || row.at("in_smart") == "2.8";
    EXPECT_EQ((desc->cpus & smartCpus) != 0, isKnown);
    EXPECT_EQ((desc->cpus & s7200Cpus) != 0, row.at("in_classic") == "yes");
    EXPECT_EQ(desc->since28, row.at("in_smart") == "2.8");
  }
}

/// One source spells them otherwise; both are read.
TEST(SmartTables, OtherSpellings) {
  EXPECT_EQ(s7200Instructions().alias("ABSD"), s7200Instructions().named("ABSDI"));
  EXPECT_EQ(s7200Instructions().alias("CEVENT"), s7200Instructions().named("CEVNT"));
}

TEST(SmartTables, WhatTheFamilyLacksIsRefused) {
  const auto errors = [](const std::string& statement, Target target) {
    const Program program = readText(
        "a.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\n" + statement + "\nEND_ORGANIZATION_BLOCK\n",
        {.target = target});
    std::string found;
    for (const Finding& finding : runRules(Facts(program), RuleSelection({"ADR006", "ADR009"}, {}), {}))
      found += std::string(severityName(finding.severity)) + ": " + finding.message;
    return found;
  };
  const Target st40{s7200Cpu("ST40"), Edition::Smart28}, older{s7200Cpu("ST40"), Edition::Smart27},
      cr40s{s7200Cpu("CR40s"), Edition::Smart28}, classic;
  EXPECT_NE(errors("NETR VB100, 0", st40).find("error: the CPU ST40 has no instruction NETR"), std::string::npos);
  EXPECT_EQ(errors("GET VB100", st40), "");
  EXPECT_NE(errors("GET VB100", classic).find("error: the CPU 226 has no instruction GET"), std::string::npos);
  EXPECT_EQ(errors("NANDW VW0, VW2", st40), "");
  EXPECT_NE(errors("NANDW VW0, VW2", older).find("warning: NANDW came with firmware V2.8"), std::string::npos);
  EXPECT_NE(errors("HDEF 0, 2", st40).find("MODE"), std::string::npos) << "a start input is gone";
  EXPECT_EQ(errors("HDEF 0, 10", st40), "");
  EXPECT_NE(errors("HSC 4", cr40s).find("HSC4"), std::string::npos);
  EXPECT_EQ(errors("HSC 4", st40), "");
  EXPECT_EQ(errors("LDS 20", st40), "");
  EXPECT_NE(errors("LDS 20", classic), "");
  EXPECT_EQ(errors("SI Q0.0, 200", st40), "");
  EXPECT_NE(errors("SI Q0.0, 200", classic), "");
  EXPECT_EQ(errors("PLS 2", st40), "");
  EXPECT_NE(errors("PLS 2", {s7200Cpu("ST20"), Edition::Smart28}), "") << "two pulse outputs";
  EXPECT_NE(errors("PLS 0", cr40s), "") << "none";
}

TEST(SmartTables, EventsOfTheFamily) {
  const Target st40{s7200Cpu("ST40"), Edition::Smart28}, st20{s7200Cpu("ST20"), Edition::Smart28},
      cr40s{s7200Cpu("CR40s"), Edition::Smart28};
  for (int event = 0; event < eventCount; ++event) {
    const bool isListed = (event <= 13 || event >= 16) && !(event >= 39 && event <= 42);
    EXPECT_EQ(eventExists(st40, event), isListed) << event;
    EXPECT_EQ(eventExists(st20, event), isListed && event != 34) << event << ": no third pulse output";
    // No signal board, no second port, no pulse outputs, no counters 4 and 5.
    const bool needsMore = (event >= 34 && event <= 38) || event >= 43 || event == 19 || event == 20 ||
                           (event >= 24 && event <= 26) || (event >= 29 && event <= 31) || event == 33;
    EXPECT_EQ(eventExists(cr40s, event), isListed && !needsMore) << event;
    EXPECT_FALSE(eventExists(Target{}, event) && event > 33) << event;
  }
}

TEST(SmartTables, SpecialMemoryIsReadOnlyToByte29) {
  const Target st40{s7200Cpu("ST40"), Edition::Smart28};
  for (const Row& row : read("smart-sm-bits.tsv")) {
    const std::string& address = row.at("address");
    if (!address.starts_with("SM") || address.find('-') != std::string::npos) continue;
    const std::size_t at = address.find_first_of("0123456789");
    const auto [byte, bit] = place(address.substr(at));
    const SmRow& found = smRow(st40, byte, bit);
    EXPECT_TRUE(found.holds(byte, bit)) << address;
    if (row.at("access") == "rw") {
      EXPECT_TRUE(found.isWritable()) << address;
    }
    if (byte < 30) {
      EXPECT_FALSE(found.isWritable()) << address;
    }
  }
  EXPECT_EQ(smSource(st40, 0, 7), SmSource::FirstScan) << "the clock was lost, for one scan";
  EXPECT_EQ(smSource(Target{}, 0, 7), SmSource::Free) << "the mode switch";
  EXPECT_EQ(smSource(st40, 31, 7), SmSource::Program) << "no saving by program";
}

// The editor writes these names instead of addresses, so an export needs no symbol table for them.
TEST(SmartTables, SystemNames) {
  std::size_t named = 0;
  for (const Row& row : read("smart-sm-bits.tsv")) {
    const std::string& name = row.at("name");
    if (name.empty() || name.find(' ') != std::string::npos) continue;
    ++named;
    const std::optional<Operand> found = systemSymbol(name);
    ASSERT_TRUE(found.has_value()) << name;
    EXPECT_EQ(toString(*found), row.at("address")) << name;
  }
  EXPECT_EQ(named, 77U);
}

}  // namespace rungproof::tables
