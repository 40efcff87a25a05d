// What the S7-200 SMART changes, engine and naive interpreter side by side on a CPU ST60: every instruction that only
// it has and whose result is known, comparisons of numbers that are none, and all instructions of both families on
// operands that both have. The seed stands in every failure; RUNGPROOF_SEED sets it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <random>

#include "ir/isa.hpp"
#include "likeness.hpp"
#include "single_case.hpp"

namespace rungproof::reference {
namespace {

constexpr Target st60{Cpu::St60, Edition::Smart28};

/// Devices, and what is any value.
const std::set<std::string> leftOutOfSmart = {"GIP",        "SIP",   "GERR",  "GET",   "PUT",   "TCON",
                                              "TSEND",      "TRECV", "TDCON", "RDREC", "WRREC", "BLKMOV_BIR",
                                              "BLKMOV_BIW", "S_ITR", "S_RTR", "S_RTI"};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  std::uint32_t pick(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
  /// A value from the borders of its type, or any.
  std::uint32_t value(char letter) {
    static constexpr std::uint32_t words[] = {0, 1, 0x7FFF, 0x8000, 0x8001, 0xFFFF, 0x9999, 0x1234};
    static constexpr std::uint32_t wides[] = {0,          1,          0x7FFFFFFF, 0x80000000, 0x80000001, 0xFFFFFFFF,
                                              0x99999999, 0x12345678, 0x0000000A, 99999999,   100000000,  0x00A00000};
    static constexpr float reals[] = {0.0F, -0.0F, 1.0F, -1.0F, 0.5F, -0.25F, 1.0001F, -2.0F, 3e38F, 1e-39F};
    if (letter == 'r' || letter == 'R') {
      if (pick(8) == 0) return pick(2) == 0 ? 0x7FC00000U : 0xFF800000U;  // not a number, infinite
      return pick(3) == 0 ? static_cast<std::uint32_t>(random_()) : std::bit_cast<std::uint32_t>(reals[pick(10)]);
    }
    if (pick(2) == 0) return static_cast<std::uint32_t>(random_());
    return letter == 'd' || letter == 'D' ? wides[pick(12)] : words[pick(8)];
  }
  std::string place(char letter, std::size_t operand) {
    const std::uint32_t at = 100 + 8 * static_cast<std::uint32_t>(operand) + pick(2);
    if (pick(5) == 0) return fmt::format("AC{}", operand);
    const bool isWord = letter == 'w' || letter == 'W', isByte = letter == 'b' || letter == 'B';
    return fmt::format("V{}{}", isByte ? 'B' : isWord ? 'W' : 'D', at);
  }

 private:
  std::mt19937_64 random_;
};

/// One scan of the statement by both, from the same random memory.
void compareOnce(const std::string& mnemonic, std::uint64_t seed) {
  Draw draw(seed);
  const std::string_view signature = *naive::signatureOf(mnemonic);
  std::string statement = mnemonic;
  std::vector<std::pair<std::string, std::uint32_t>> settings;
  for (std::size_t i = 0; i < signature.size(); ++i) {
    const std::string place = draw.place(signature[i], i);
    statement += (i == 0 ? " " : ", ") + place;
    settings.emplace_back(place, draw.value(signature[i]));
  }
  manual::Plant plant("LD I0.7; " + statement, st60);
  plant.set("I0.7", draw.pick(5) == 0 ? 0 : 1);
  for (const auto& [place, value] : settings) plant.set(place, value);
  for (const char* status : {"SM1.0", "SM1.1", "SM1.2", "SM1.3", "SM1.6"}) plant.set(status, draw.pick(2));
  naive::Interpreter plain(plant.program());
  copyState(plant, plain);
  plant.scan();
  plain.scan(0, 0);
  const Instruction& last = plant.program().pous[0].networks[0].instructions.back();
  ASSERT_EQ(reference::difference(plant, plain, &last), "") << "seed " << seed << ": " << statement;
}

std::uint64_t firstSeed() {
  const char* given = std::getenv("RUNGPROOF_SEED");
  return given == nullptr ? 1 : std::strtoull(given, nullptr, 10);
}

TEST(SmartReference, WhatOnlyTheFamilyHas) {
  int compared = 0;
  for (const Desc& desc : instructionTable()) {
    const std::string name(desc.stl);
    if ((desc.cpus & s7200Cpus) != 0) continue;
    EXPECT_NE(naive::signatureOf(name).has_value(), leftOutOfSmart.contains(name)) << name;
    if (!naive::signatureOf(name)) continue;
    ++compared;
    for (std::uint64_t seed = firstSeed(); seed < firstSeed() + 400 && !HasFatalFailure(); ++seed)
      compareOnce(name, seed * 7919);
  }
  EXPECT_EQ(compared, 17) << "NAND, NOR, NXOR by three widths, two of BCD, three absolute values, three arc functions";
}

TEST(SmartReference, WhatBothFamiliesHave) {
  int compared = 0;
  for (const Desc& desc : instructionTable()) {
    const std::string name(desc.stl);
    const bool isOfBoth = (desc.cpus & s7200Cpus) != 0 && (desc.cpus & cpuBit(st60.cpu)) != 0;
    const auto signature = naive::signatureOf(name);
    if (!isOfBoth || !signature || signature->empty() || desc.control != Control::None) continue;
    if (signature->find_first_not_of("bwdrBWDR") != std::string_view::npos) continue;  // of one value each
    ++compared;
    for (std::uint64_t seed = firstSeed(); seed < firstSeed() + 60 && !HasFatalFailure(); ++seed)
      compareOnce(name, seed * 104729);
  }
  EXPECT_GT(compared, 120);
}

/// A REAL that is no number stops an S7-200 (fatal error 0012); here the contact is 0 and the scan goes on.
TEST(SmartReference, NoComparisonStopsTheCpu) {
  for (const char* relation : {"=", "<>", "<", "<=", ">", ">="}) {
    for (const char* joint : {"LD", "A", "O"}) {
      manual::Plant plant(fmt::format("LD SM0.0; {}R{} VD0, VD4; = Q0.0; LD SM0.0; = Q0.1", joint, relation), st60);
      plant.set("VD0", 0x7FC00000).set("VD4", 0x3F800000);
      naive::Interpreter plain(plant.program());
      copyState(plant, plain);
      plant.scan();
      plain.scan(0, 0);
      EXPECT_EQ(plant.outside.hazards().size(), 1U) << "an error that is reported, not fatal";
      EXPECT_FALSE(plant.halted) << joint << relation;
      EXPECT_EQ(plant.value("Q0.1"), 1U) << joint << relation;
      EXPECT_EQ(plant.value("Q0.0"), std::string_view(joint) == "O" ? 1U : 0U) << joint << relation;
      EXPECT_EQ(plain.memory.at(Area::Q)[0], plant.value("QB0")) << joint << relation;
    }
  }
}

}  // namespace
}  // namespace rungproof::reference
