// What only the S7-200 SMART has, one mnemonic at a time: every instruction of its own whose result is known. The seed
// stands in every failure.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <random>
#include <set>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "likeness.hpp"
#include "smart_case.hpp"
#include "tests/manual/plant.hpp"

namespace rungproof::reference {

namespace {

constexpr Target st60{s7200Cpu("ST60"), Edition::Smart28};

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

}  // namespace

void compareOnSmart(const std::string& mnemonic, std::uint64_t seed) {
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

std::uint64_t smartSeed() {
  const char* given = std::getenv("RUNGPROOF_SEED");
  return given == nullptr ? 1 : std::strtoull(given, nullptr, 10);
}
std::uint64_t smartCases(std::uint64_t usual) {
  const char* given = std::getenv("RUNGPROOF_CASES");
  return given == nullptr ? usual : std::strtoull(given, nullptr, 10);
}

namespace {

std::vector<std::string> smartMnemonics() {
  std::vector<std::string> list;
  for (const Desc& desc : s7200Instructions().all()) {
    const std::string name(desc.stl);
    if ((desc.cpus & s7200Cpus) == 0 && naive::signatureOf(name)) list.push_back(name);
  }
  return list;
}

class SmartSingle : public testing::TestWithParam<std::string> {};

TEST_P(SmartSingle, AgreesWithTheNaiveInterpreter) {
  const std::uint64_t first = smartSeed(), end = first + 4 * smartCases(60);
  for (std::uint64_t seed = first; seed < end && !HasFatalFailure(); ++seed) compareOnSmart(GetParam(), seed * 7919);
}

INSTANTIATE_TEST_SUITE_P(Every, SmartSingle, testing::ValuesIn(smartMnemonics()));

TEST(SmartSingles, AreAllButDevicesAndWhatIsAnyValue) {
  for (const Desc& desc : s7200Instructions().all()) {
    const std::string name(desc.stl);
    if ((desc.cpus & s7200Cpus) != 0) continue;
    EXPECT_NE(naive::signatureOf(name).has_value(), leftOutOfSmart.contains(name)) << name;
  }
  EXPECT_EQ(smartMnemonics().size(), 17U)
      << "NAND, NOR, NXOR by three widths, two of BCD, three absolute values, three arc functions";
}

}  // namespace
}  // namespace rungproof::reference
