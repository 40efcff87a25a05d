// Every mnemonic that the naive interpreter knows, one at a time: random operands on a random machine, engine and naive
// interpreter side by side. Everything is compared: memory, registers, stack, ENO, errors. The seed stands in every
// failure; RUNGPROOF_SEED sets it, RUNGPROOF_CASES how many.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "likeness.hpp"
#include "single_case.hpp"

namespace rungproof::reference {
namespace {

/// Mnemonics whose meaning shows only over several scans or needs a program around it: sequence_test, reference_test.
bool isAlone(const Desc& desc) {
  const std::string name(desc.stl);
  if (desc.control != Control::None || name == "EU" || name == "ED") return false;
  return !name.starts_with("CTU") && !name.starts_with("CTD") && (!name.starts_with("TO") || name.starts_with("TOD")) &&
         name != "TP.IEC";
}

std::vector<std::string> mnemonics() {
  std::vector<std::string> list;
  for (const Desc& desc : s7200Instructions().all()) {
    const bool isOfS7200 = (desc.cpus & s7200Cpus) != 0;  // others: smart_test
    if (isOfS7200 && naive::signatureOf(std::string(desc.stl)) && isAlone(desc)) list.emplace_back(desc.stl);
  }
  return list;
}

std::string spelledOut(const testing::TestParamInfo<std::string>& info) {
  static const std::map<char, std::string> words = {{'+', "Add"},   {'-', "Sub"},   {'*', "Mul"},   {'/', "Div"},
                                                    {'=', "Equal"}, {'<', "Below"}, {'>', "Above"}, {'.', "_"}};
  std::string text;
  for (const char c : info.param) text += words.contains(c) ? words.at(c) : std::string(1, c);
  return text;
}

class Single : public testing::TestWithParam<std::string> {};

TEST_P(Single, AgreesWithTheNaiveInterpreter) {
  const auto fromOutside = [](const char* name, std::uint64_t otherwise) {
    const char* given = std::getenv(name);
    return given == nullptr ? otherwise : std::strtoull(given, nullptr, 10);
  };
  const std::uint64_t first = fromOutside("RUNGPROOF_SEED", 1), few = fromOutside("RUNGPROOF_CASES", 60);
  const std::uint64_t cases = isCompare(GetParam()) ? 5 * few : few;  // whose results are bits
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    SingleCase drawn(GetParam(), seed * 1000003);
    naive::Interpreter plain(drawn.plant().program());
    copyState(drawn.plant(), plain);
    drawn.plant().scan();
    plain.scan(0, 0);
    ASSERT_EQ(difference(drawn.plant(), plain, &drawn.instruction()), "")
        << "seed " << seed << ": " << drawn.statements();
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Single, testing::ValuesIn(mnemonics()), spelledOut);

}  // namespace
}  // namespace rungproof::reference
