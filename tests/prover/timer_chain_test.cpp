// Timers that start each other: how long all of them take together, in each family. What is asked is less than the
// timers can take at the least, or more than they take when every scan is short.
#include <gtest/gtest.h>

#include "analysis/portfolio/bound_templates.hpp"
#include "analysis/proof/question_system.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

constexpr int timers = 7;

ProverOptions shortScans() {
  ProverOptions options = usualOptions(60);
  options.time = {1, 50};
  return options;
}

/// "At least this long" and "longer than that": ms from the input to the output.
std::string asked(const char* input, const char* output, int least, int more) {
  return fmt::format(
      "//@ prove least: always {1} implies held({0}, {2}ms)\n//@ prove more: always {1} implies held({0}, {3}ms)\n",
      input, output, least, more);
}

void expectLeast(const ProgramInput& input) {
  for (const Finding& finding : input.program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  const ProofRun run = prove(input.program, input.properties, shortScans());
  EXPECT_EQ(outcomeOf(run, "least"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "more"), Outcome::Violated);
}

ProgramInput chainOfTon() {
  std::string networks = "NETWORK 1\nLD I0.0\nTON T37, 10\n";
  for (int k = 1; k < timers; ++k)
    networks += fmt::format("NETWORK {}\nLD I0.0\nA T{}\nTON T{}, 10\n", k + 1, 36 + k, 37 + k);
  networks += fmt::format("NETWORK {}\nLD I0.0\nA T{}\n= Q0.0\n", timers + 1, 36 + timers);
  return inputOf(asked("I0.0", "Q0.0", timers * 900, timers * 1000 + 100), networks);
}

// A TON of 100 ms may have its first tick at once, and each later one loses at most a scan: 7 x 1000 - 100 - 7 x 50 ms.
// With scans of 1 ms seven timers take less than 7,100 ms.
TEST(TimerChain, OfAnS7200) { expectLeast(chainOfTon()); }

// SD of 1 s counts 10 ms: each timer may be 10 ms short, and is seen at most a scan of 50 ms late or early.
TEST(TimerChain, OfAnS7300) {
  std::string text = asked("I0.0", "Q4.0", timers * 900, timers * 1000 + 500) +
                     "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n  info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\n";
  for (int k = 1; k <= timers; ++k) {
    text += "NETWORK\n      A     I 0.0;\n";
    if (k > 1) text += fmt::format("      A     T {};\n", k - 1);
    text += fmt::format("      L     S5T#1S;\n      SD    T {};\n", k);
  }
  text += fmt::format("NETWORK\n      A     I 0.0;\n      A     T {};\n      =     Q 4.0;\nEND_ORGANIZATION_BLOCK\n",
                      timers);
  expectLeast(inputOfSource(text));
}

// ET of a TON is exact from the beginning of a scan to that of another, and the next TON starts in the scan in which Q
// comes: 7 x 1000 ms. held() counts from end to end: a first scan of 50 ms and a last one of 1 ms make it 49 ms less,
// and any first scan that is longer than the last makes it less than 7 s.
TEST(TimerChain, OfIec) {
  std::string text = asked("start", "done", timers * 1000 - 49, timers * 1000) +
                     "PROGRAM Main\nVAR\n  start AT %IX0.0 : BOOL;\n  done AT %QX0.0 : BOOL;\n";
  for (int k = 1; k <= timers; ++k) text += fmt::format("  t{} : TON;\n", k);
  text += "END_VAR\n";
  for (int k = 1; k <= timers; ++k)
    text += fmt::format("t{}(IN := start{}, PT := T#1s);\n", k, k > 1 ? fmt::format(" AND t{}.Q", k - 1) : "");
  text += fmt::format("done := start AND t{}.Q;\nEND_PROGRAM\n", timers);
  expectLeast(inputOfSource(text));
}

// Two bounds on the clock and one on the difference, for each of two conditions of a timer; twice as many timers are
// not four times as many bounds.
TEST(TimerChain, BoundsGrowWithTheTimers) {
  const ProgramInput input = chainOfTon();
  std::vector<Property> goals{input.properties.properties.front()};
  QuestionSystem side(input.program, input.properties, goals, encoderOptionsOf(shortScans()), {});
  const TransitionSystem system = side.only(0);
  BitBlast blast(system, {0});
  const BoundTemplates found = boundTemplates(system, blast, {}, 1, BoundScope::Chain, Budget::seconds(20));
  EXPECT_GT(found.templates.size(), static_cast<std::size_t>(2 * timers));
  EXPECT_LE(found.templates.size(), static_cast<std::size_t>(6 * timers));
}

}  // namespace
}  // namespace rungproof::test
