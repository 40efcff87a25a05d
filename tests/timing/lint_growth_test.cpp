// Cost of linting: reading, facts and all rules over a long program, in processor time at the pace of a quiet machine.
// Ten times the instructions leave the caches of a small machine and may cost thirty times the time (what grows with
// the square of the length costs a hundred times); 100,000 take half a second.
#include <gtest/gtest.h>

#include "analysis/lint/lint.hpp"
#include "frontend/input/project.hpp"
#include "tests/bench/long_program.hpp"
#include "tests/bench/read_and_lint.hpp"
#include "tests/machine_pace.hpp"

namespace rungproof::testing {
namespace {

/// Seconds to read a text, build the facts and run all rules.
double secondsFor(const std::string& text) {
  constexpr int attempts = 8;  // beside other work the least of a few is still too long
  return test::quietSeconds([&] { EXPECT_GT(readAndLint(text), 0U); }, 0, attempts);
}

TEST(Scale, LintingIsLinear) {
  const double small = secondsFor(test::longProgram(10000)), large = secondsFor(test::longProgram(100000));
  RecordProperty("milliseconds_10000", static_cast<int>(small * 1000));
  RecordProperty("milliseconds_100000", static_cast<int>(large * 1000));
  std::printf("10,000 instructions: %.0f ms; 100,000 instructions: %.0f ms\n", small * 1000, large * 1000);
  EXPECT_LT(large, 30 * small);
  EXPECT_LT(large, 0.5);
}

/// The worst case for look-ups by address: every instruction names the same bit.
TEST(Scale, OneBitForEverything) {
  std::string text = "Network 1\n";
  for (int i = 0; i < 50000; ++i) text += i % 2 == 0 ? "LD Q0.0\n" : "= Q0.0\n";
  const Program program = readText("one.awl", text);
  const auto checkAll = [&] {
    const Facts facts(program);
    const RuleSettings settings;
    FindingSink sink(program, settings);
    for (const Rule* rule : allRules()) {
      if (rule->check == nullptr) continue;
      sink.begin(*rule);
      rule->check(facts, sink);
    }
  };
  EXPECT_LT(test::quietSeconds(checkAll, 3.0), 3.0);
}

}  // namespace
}  // namespace rungproof::testing
