// As many functions as the numbers of an S7-400 allow, called one after the other: blocks are looked up by number, and
// the ways to them are not followed where statements have no rungs.
#include <gtest/gtest.h>

#include "tests/bench/read_and_lint.hpp"
#include "tests/machine_pace.hpp"

namespace rungproof::testing {
namespace {

/// Functions with a parameter each if `hasParameters`, all called by OB1.
std::string manyFunctions(int count, bool hasParameters) {
  std::string text, calls;
  for (int i = 1; i <= count; ++i) {
    const std::string number = std::to_string(i), bit = std::to_string(i / 8) + "." + std::to_string(i % 8);
    text += "FUNCTION FC " + number + " : VOID\n";
    if (hasParameters) text += "VAR_INPUT\n  x : BOOL ;\nEND_VAR\nVAR_TEMP\n  t : BOOL ;\nEND_VAR\n";
    text += std::string("BEGIN\nNETWORK\nA ") + (hasParameters ? "#x;\n= #t;\nA #t" : "I 0.0") + ";\n= M " + bit +
            ";\nEND_FUNCTION\n";
    calls += "CALL FC " + number + (hasParameters ? " (x := I 0.0);\n" : ";\n");
  }
  return text + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + calls + "END_ORGANIZATION_BLOCK\n";
}

/// Ten times as many may take thirty times as long, as in lint_growth_test.cpp.
TEST(Scale, ManyFunctionsThatOneBlockCalls) {
  for (const bool hasParameters : {false, true}) {
    const auto secondsOf = [&](int count) {
      const std::string text = manyFunctions(count, hasParameters);
      return test::quietSeconds([&] { EXPECT_GT(readAndLint(text), 0U); }, 0, 3);
    };
    const double small = secondsOf(6000), large = secondsOf(60'000);
    std::printf("6,000 functions: %.0f ms; 60,000 functions: %.0f ms\n", small * 1000, large * 1000);
    EXPECT_LT(large, 30 * small) << hasParameters;
    EXPECT_LT(large, 5) << hasParameters;
  }
}

}  // namespace
}  // namespace rungproof::testing
