// Retentive ranges: how settings name them, and that "initial retentive" frees exactly what is named.
#include <gtest/gtest.h>

#include "frontend/settings/retentive_range.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof {
namespace {

std::string shown(std::string_view text) {
  const auto range = retentiveRangeNamed(text);
  return range ? std::string(areaName(range->area)) + std::to_string(range->first) + "-" + std::to_string(range->last)
               : "none";
}

TEST(RetentiveRange, IsReadFromItsName) {
  EXPECT_EQ(shown("VB0..VB99"), "V0-99");
  EXPECT_EQ(shown("MB14"), "M14-14");
  EXPECT_EQ(shown("T0 .. T31"), "T0-31");
  EXPECT_EQ(shown("C5"), "C5-5");
  for (const char* text : {"", "VB9..VB0", "VB0..MB3", "VW0..VW4", "V0.0", "QB0", "AC0", "VB0..", "SMB30"})
    EXPECT_EQ(shown(text), "none") << text;
}

Outcome onFirstScan(const char* address, Target target, std::optional<std::vector<RetentiveRange>> ranges) {
  const std::string load = std::string("LD ") + address + "\n= Q0.0\nLD I0.0\nS " + address + ", 1\n";
  ProgramInput input;
  input.program =
      readText("a.awl",
               "ORGANIZATION_BLOCK MAIN:OB1\n//@ initial retentive\n//@ reach p: first_scan and Q0.0\nBEGIN\n"
               "Network 1\n" +
                   load + "END_ORGANIZATION_BLOCK\n",
               {.target = target});
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  ProverOptions options = test::usualOptions();
  options.retentive = std::move(ranges);
  return test::resultNamed(prove(input.program, input.properties, options), "p")->outcome;
}

TEST(RetentiveRange, DecidesWhatStartsWithAnyValue) {
  const Target st40{s7200Cpu("ST40"), Edition::Smart28}, cpu226;
  const std::vector<RetentiveRange> some = {{Area::V, 0, 9}};
  EXPECT_EQ(onFirstScan("V5.0", st40, std::nullopt), Outcome::Unreachable) << "nothing, unless it is named";
  EXPECT_EQ(onFirstScan("V5.0", st40, some), Outcome::Reachable);
  EXPECT_EQ(onFirstScan("V10.0", st40, some), Outcome::Unreachable) << "the byte behind the range";
  EXPECT_EQ(onFirstScan("V10.0", cpu226, std::nullopt), Outcome::Reachable) << "all of V by default";
  EXPECT_EQ(onFirstScan("V10.0", cpu226, some), Outcome::Unreachable);
  EXPECT_EQ(onFirstScan("M14.0", cpu226, some), Outcome::Unreachable);
}

}  // namespace
}  // namespace rungproof
