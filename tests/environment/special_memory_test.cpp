// Special memory as the manual's tables D-1 to D-20 describe it, row by row, and what programs see of SM0 and of bits
// that the surroundings choose. The readings in tests/data/sm-bits.tsv come from the manual's columns: status that
// modules, switches and lines give is free, status of a request is its device's, what the program sets stays.
#include "ir/s7200/special_memory.hpp"

#include "tests/engine/rig.hpp"
#include "tests/ir/tsv.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

/// Bits of "SM3.1-SM3.7", "SMB8-SMB21", "SMW22".
struct BitRange {
  std::uint32_t first, last;  ///< byte * 8 + bit
};
BitRange rangeOf(const std::string& address) {
  const auto place = [](const std::string& text) -> std::pair<std::uint32_t, std::uint32_t> {
    const bool isBit = std::isdigit(static_cast<unsigned char>(text[2])) != 0;
    const auto byte = static_cast<std::uint32_t>(std::stoul(text.substr(isBit ? 2 : 3)));
    if (isBit) {
      const auto bit = static_cast<std::uint32_t>(text.back() - '0');
      return {byte * 8 + bit, byte * 8 + bit};
    }
    const std::uint32_t bytes = text[2] == 'B' ? 1 : text[2] == 'W' ? 2 : 4;
    return {byte * 8, byte * 8 + bytes * 8 - 1};
  };
  const std::vector<std::string> ends = tables::split(address, '-');
  return {place(ends.front()).first, place(ends.back()).second};
}

struct ManualRow {
  std::string address, reading, manual;
  bool isWritable;
  BitRange bits;
};
std::vector<ManualRow> manualRows() {
  std::vector<ManualRow> rows;
  for (const tables::Row& row : tables::read("sm-bits.tsv")) {
    rows.push_back(
        {row.at("address"), row.at("reading"), row.at("manual"), row.at("access") == "rw", rangeOf(row.at("address"))});
  }
  return rows;
}

std::string bitName(std::uint32_t bit) { return "SM" + std::to_string(bit / 8) + "." + std::to_string(bit % 8); }

TEST(SpecialMemory, TableSaysWhatTheManualSaysOfEveryBit) {
  const std::map<std::string, SmSource> sources = {
      {"one", SmSource::Constant},         {"constant", SmSource::Constant}, {"computed", SmSource::Computed},
      {"first scan", SmSource::FirstScan}, {"free", SmSource::Free},         {"device", SmSource::Device},
      {"program", SmSource::Program}};
  const std::vector<ManualRow> rows = manualRows();
  ASSERT_EQ(rows.size(), 271U);
  for (const ManualRow& row : rows) {
    if (row.reading == "mixed") continue;  // SMB31: its bits have rows of their own
    const bool overlapsLinear = row.address == "SMD168" || row.address == "SMD178";  // SMB170, SMB180 have rows
    for (std::uint32_t bit = row.bits.first; bit <= row.bits.last - (overlapsLinear ? 16 : 0); ++bit) {
      const SmRow& found = smRow(Target{}, bit / 8, bit % 8);
      EXPECT_EQ(found.source, sources.at(row.reading)) << row.address << " " << row.manual;
      EXPECT_EQ(found.isWritable(), row.isWritable) << row.address << " " << row.manual;
    }
  }
}

/// One program whose properties ask for 1 and for 0 in every bit, at the ends of scans.
std::map<std::string, Outcome> smVerdicts(const std::vector<std::uint32_t>& bits, const std::string& networks) {
  std::string properties;
  for (const std::uint32_t bit : bits) {
    const std::string name = bitName(bit);
    properties += "//@ reach one" + std::to_string(bit) + ": not first_scan and " + name + "\n";
    properties += "//@ reach zero" + std::to_string(bit) + ": not first_scan and not " + name + "\n";
    properties += "//@ reach early" + std::to_string(bit) + ": first_scan and " + name + "\n";
  }
  const ProgramInput input = inputOf(properties, networks);
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  std::map<std::string, Outcome> verdicts;
  for (const ProofResult& result : run.results) verdicts[result.property.name] = result.outcome;
  return verdicts;
}

/// First and last bit of every row with that reading.
std::vector<std::uint32_t> endsOfRows(const std::string& reading) {
  std::set<std::uint32_t> bits;
  for (const ManualRow& row : manualRows()) {
    if (row.reading == reading) bits.insert({row.bits.first, row.bits.last});
  }
  return {bits.begin(), bits.end()};
}

TEST(SpecialMemory, FreeBitsMayBeAnythingInAnyScan) {
  const std::vector<std::uint32_t> bits = endsOfRows("free");
  const std::map<std::string, Outcome> verdicts = smVerdicts(bits, "Network 1\nLD SM0.0\n= Q0.0\n");
  for (const std::uint32_t bit : bits) {
    EXPECT_EQ(verdicts.at("one" + std::to_string(bit)), Outcome::Reachable) << bitName(bit);
    EXPECT_EQ(verdicts.at("zero" + std::to_string(bit)), Outcome::Reachable) << bitName(bit);
  }
}

TEST(SpecialMemory, FirstScanBitsMayBeOnInTheFirstScanOnly) {
  const std::vector<std::uint32_t> bits = endsOfRows("first scan");
  const std::map<std::string, Outcome> verdicts = smVerdicts(bits, "Network 1\nLD SM0.0\n= Q0.0\n");
  for (const std::uint32_t bit : bits) {
    EXPECT_EQ(verdicts.at("one" + std::to_string(bit)), Outcome::Unreachable) << bitName(bit);
    EXPECT_EQ(verdicts.at("early" + std::to_string(bit)), Outcome::Reachable) << bitName(bit);
  }
}

// CPU 226: identifier 1001 (001:14138).
TEST(SpecialMemory, ConstantBitsAreConstant) {
  const std::map<std::string, Outcome> verdicts =
      smVerdicts({0, 6 * 8 + 4, 6 * 8 + 5, 6 * 8 + 7}, "Network 1\nLD SM0.0\n= Q0.0\n");
  EXPECT_EQ(verdicts.at("zero0"), Outcome::Unreachable);
  EXPECT_EQ(verdicts.at("zero52"), Outcome::Unreachable);
  EXPECT_EQ(verdicts.at("one53"), Outcome::Unreachable);
  EXPECT_EQ(verdicts.at("zero55"), Outcome::Unreachable);
}

/// A word that the program writes from an input word, so that both values of each bit come; some rows are its low half.
TEST(SpecialMemory, ProgramBitsAreWhatTheProgramWrites) {
  const std::vector<std::uint32_t> bits = endsOfRows("program");
  std::string networks = "Network 1\nLD SM0.0\n";
  std::set<std::uint32_t> bytes;
  for (const std::uint32_t bit : bits) bytes.insert(bit / 8);
  for (const std::uint32_t byte : bytes) networks += "MOVB IB0, SMB" + std::to_string(byte) + "\n";
  const std::map<std::string, Outcome> written = smVerdicts(bits, networks);
  const std::map<std::string, Outcome> untouched = smVerdicts(bits, "Network 1\nLD SM0.0\n= Q0.0\n");
  for (const std::uint32_t bit : bits) {
    const std::string number = std::to_string(bit);
    const bool isOfModule =
        smRow(Target{}, bit / 8, bit % 8).source == SmSource::Free;  // the linear PTO behind SMD168, SMD178
    EXPECT_EQ(written.at("one" + number), Outcome::Reachable) << bitName(bit);
    EXPECT_EQ(written.at("zero" + number), Outcome::Reachable) << bitName(bit);
    if (!isOfModule) {
      EXPECT_NE(untouched.at("one" + number), Outcome::Reachable) << bitName(bit);
    }
  }
}

// Without a request no device writes: a pulse output is idle (001:4651), a transmitter too (001:14109), nothing else is
// on. What RCV's status shows before the first RCV is not said: it may be anything in the first scan.
TEST(SpecialMemory, DeviceBitsStayWithoutARequest) {
  const std::vector<std::uint32_t> bits = endsOfRows("device");
  const std::map<std::string, Outcome> verdicts = smVerdicts(bits, "Network 1\nLD SM0.0\n= Q0.0\n");
  const std::set<std::string> idle = {"SM4.5", "SM4.6", "SM66.7", "SM76.7"};
  for (const std::uint32_t bit : bits) {
    const std::string number = std::to_string(bit), name = bitName(bit);
    const bool isReceive = bit / 8 == 86 || bit / 8 == 186;
    if (isReceive) {
      const bool isAlwaysZero = bit % 8 == 3 || bit % 8 == 4;
      EXPECT_EQ(verdicts.at("early" + number) == Outcome::Reachable, !isAlwaysZero) << name;
    } else {
      const std::string other = (idle.contains(name) ? "zero" : "one") + number;
      EXPECT_EQ(verdicts.at(other), Outcome::Unreachable) << name;
    }
  }
}

/// All verdicts of the properties over a program.
std::map<std::string, Outcome> smOutcomes(const std::string& properties, const std::string& networks) {
  const ProgramInput input = inputOf(properties, networks);
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  std::map<std::string, Outcome> verdicts;
  for (const ProofResult& result : run.results) verdicts[result.property.name] = result.outcome;
  return verdicts;
}

// SM0.1 is on in the first scan (001:14051), and properties find it as the program saw it.
TEST(SpecialMemory, PropertiesSeeStatusBitsAsTheProgramDid) {
  const auto verdicts = smOutcomes(
      "//@ prove first: SM0.1 implies Q0.0\n//@ prove only: Q0.0 = SM0.1\n//@ prove same: first_scan = SM0.1\n"
      "//@ prove second: SM0.5 = Q0.1\n//@ prove minute: SM0.4 = Q0.2\n//@ prove scan: SM0.6 = Q0.3\n"
      "//@ prove toggles: first_scan or SM0.6 <> prev(SM0.6)\n",
      "Network 1\nLD SM0.1\n= Q0.0\nNetwork 2\nLD SM0.5\n= Q0.1\nNetwork 3\nLD SM0.4\n= Q0.2\nNetwork 4\nLD SM0.6\n= "
      "Q0.3\n");
  for (const auto& [name, outcome] : verdicts) EXPECT_EQ(outcome, Outcome::Proved) << name;
}

TEST(SpecialMemory, TracesShowStatusBitsAsTheProgramSawThem) {
  Rig rig("LD SM0.1\n= Q0.0\nLD SM0.6\n= Q0.1\nLD SM0.3\n= Q0.2\n");
  EXPECT_EQ(rig.wave("SM0.1", 3), "100");
  Rig same("LD SM0.6\n= Q0.1\n");
  for (int scan = 0; scan < 4; ++scan) {
    same.scans(1);
    EXPECT_EQ(same.get("SM0.6"), same.get("Q0.1"));
  }
}

// After STOP and RUN the bit is 0 (001:14053): an initialisation that hangs on it does not run.
TEST(SpecialMemory, InitialisationByPowerUpBitMayBeLeftOut) {
  const auto power = smOutcomes("//@ initial retentive\n//@ prove off: never Q0.0\n//@ reach on: not Q0.0\n",
                                "Network 1\nLD SM0.3\nS M0.0, 1\nNetwork 2\nLDN M0.0\n= Q0.0\n");
  EXPECT_EQ(power.at("off"), Outcome::Violated);
  EXPECT_EQ(power.at("on"), Outcome::Reachable);
  // The same by SM0.1, which is on whenever RUN begins.
  const auto first =
      smOutcomes("//@ prove off: never Q0.0\n", "Network 1\nLD SM0.1\nS M0.0, 1\nNetwork 2\nLDN M0.0\n= Q0.0\n");
  EXPECT_EQ(first.at("off"), Outcome::Proved);
}

// The manual's jump over the treatment of lost data (001:5801): it may run, and it may not.
TEST(SpecialMemory, LostDataMayBeTreatedOrNot) {
  const auto verdicts = smOutcomes(
      "//@ reach treated: Q0.1\n//@ reach kept: not Q0.1 and first_scan\n//@ prove once: first_scan or not Q0.2\n",
      "Network 1\nLDN SM0.2\nJMP 4\nNetwork 2\nLD SM0.0\n= Q0.1\nNetwork 3\nLBL 4\nNetwork 4\nLD SM0.2\n= Q0.2\n");
  EXPECT_EQ(verdicts.at("treated"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("kept"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("once"), Outcome::Proved);
}

// Module data, potentiometer, mode switch, module error, linear PTO: seen through comparisons of every width.
TEST(SpecialMemory, WhatModulesAndSwitchesGiveIsNeverConstant) {
  const auto verdicts = smOutcomes(
      "//@ prove a: never Q0.0\n//@ prove b: never Q0.1\n//@ prove c: never Q0.2\n//@ prove d: never Q0.3\n"
      "//@ prove e: never Q0.4\n//@ prove f: Q0.5\n//@ prove g: never Q0.6\n",
      "Network 1\nLDW= SMW200, 16#0102\n= Q0.0\nNetwork 2\nLDB= SMB28, 7\n= Q0.1\nNetwork 3\nLD SM9.2\n= Q0.2\n"
      "Network 4\nLDB= SMB170, 1\n= Q0.3\nNetwork 5\nLDD= SMD545, 16#01020304\n= Q0.4\nNetwork 6\nLD SM0.7\n= Q0.5\n"
      "Network 7\nLDW= SMW98, 3\n= Q0.6\n");
  for (const auto& [name, outcome] : verdicts) EXPECT_EQ(outcome, Outcome::Violated) << name;
}

// A word over bytes of two kinds: SMB29 is a potentiometer, SMB30 is what the program wrote.
TEST(SpecialMemory, WordOverTwoKindsIsCut) {
  const auto verdicts = smOutcomes("//@ prove low: Q0.0\n//@ prove high: never Q0.1\n//@ prove program: SMB30 = 5\n",
                                   "Network 1\nLD SM0.0\nMOVB 5, SMB30\nNetwork 2\nLDW= SMW29, 5\n= Q0.0\n"
                                   "Network 3\nLDW= SMW29, 16#2105\n= Q0.1\n");
  EXPECT_EQ(verdicts.at("low"), Outcome::Violated);
  EXPECT_EQ(verdicts.at("high"), Outcome::Violated);
  EXPECT_EQ(verdicts.at("program"), Outcome::Proved);
}

// The 224 XP has no identifier in the manual (001:14138): a program must not count on one.
TEST(SpecialMemory, UnknownIdentifierIsFree) {
  EXPECT_EQ(smSource({s7200Cpu("224XP"), Edition::Edition2004}, 6, 5), SmSource::Free);
  EXPECT_EQ(smSource({s7200Cpu("224"), Edition::Edition2004}, 6, 5), SmSource::Constant);
  EXPECT_EQ(cpuRow(s7200Cpu("221")).identifier, 0x60);
}

// In a simulation they keep sensible values, and the stimulus drives them.
TEST(SpecialMemory, SimulationKeepsDefaultsAndTakesAStimulus) {
  Rig rig("LD SM0.3\n= Q0.0\nLD SM0.2\n= Q0.1\nLD SM0.7\n= Q0.2\nLDB= SMB28, 7\n= Q0.3\n");
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.0"), 1);
  EXPECT_EQ(rig.get("Q0.1"), 0);
  EXPECT_EQ(rig.get("Q0.2"), 1);
  rig.set("SM0.3", 1);  // too late: the first scan is over
  rig.set("SM0.7", 0);
  rig.set("SMB28", 7);
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.0"), 0);
  EXPECT_EQ(rig.get("Q0.2"), 0);
  EXPECT_EQ(rig.get("Q0.3"), 1);
  Rig warm("LD SM0.3\n= Q0.0\nLD SM0.2\n= Q0.1\n");
  warm.set("SM0.3", 0);
  warm.set("SM0.2", 1);
  warm.scans(1);
  EXPECT_EQ(warm.get("Q0.0"), 0);
  EXPECT_EQ(warm.get("Q0.1"), 1);
}

}  // namespace
}  // namespace rungproof::test
