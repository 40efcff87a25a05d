// Time properties of IEC timers: what can be said between ends of scans about a time that is read once in each call.
// A scan that begins at t and lasts d <= 150 ms calls the timer after p of them, 0 <= p <= d. The timer of PT = 2 s
// starts in scan k and is up in the first scan n with t(n) + p(n) - t(k) - p(k) >= 2000; held() in scan n measures
// t(n) + d(n) - t(k) - d(k) from the end of scan k on. Hence every limit below, to the millisecond.
#include <fmt/format.h>

#include "proved_text.hpp"

namespace rungproof::test {
namespace {

struct Limit {
  const char* name;
  int timer;  ///< SFB
  const char* form;
  int most;  ///< ms, the last number for which it holds, or the first
  int broken;
};

constexpr Limit limits[] = {
    // 2000 + d(n) - p(n) - d(k) + p(k) >= 2000 - 150
    {"OnDelayIsNotEarly", 4, "Q0.0 implies held(I0.0, {}ms)", 1850, 1851},
    // Q is off in scan n: at most 1999 + d(n) - p(n) - d(k) + p(k) <= 1999 + 150
    {"OnDelayIsNotLate", 4, "held(I0.0, {}ms) implies Q0.0", 2150, 2149},
    {"OffDelayIsNotEarly", 5, "falls(Q0.0) implies held(not I0.0, {}ms)", 1850, 1851},
    {"OffDelayIsNotLate", 5, "held(not I0.0, {}ms) implies not Q0.0", 2150, 2149},
    {"PulseIsNotLonger", 3, "not held(Q0.0, {}ms)", 2150, 2149},
    // Up to the end of scan n - 1: 2000 - p(n) - d(k) + p(k) >= 2000 - 2 * 150
    {"PulseIsNotShorter", 3, "falls(Q0.0) implies prev(held(Q0.0, {}ms))", 1700, 1701},
};

/// In scans of 1 to 150 ms.
ProofRun proved(const ProgramInput& input) {
  ProverOptions options = usualOptions(30);
  options.time.high = 150;
  ProofRun run = prove(input.program, input.properties, options);
  EXPECT_TRUE(run.disagreements.empty());
  return run;
}

class IecTimer : public testing::TestWithParam<Limit> {};

TEST_P(IecTimer, HoldsToTheMillisecond) {
  const Limit& limit = GetParam();
  const ProgramInput input =
      inputOfSource(fmt::format("DATA_BLOCK DB 4\nSFB {0}\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
                                "//@ prove holds: {1}\n//@ prove breaks: {2}\nBEGIN\nNETWORK\n"
                                "CALL SFB {0}, DB 4 (IN := I 0.0, PT := T#2S, Q := Q 0.0);\nEND_ORGANIZATION_BLOCK\n",
                                limit.timer, fmt::format(fmt::runtime(limit.form), limit.most),
                                fmt::format(fmt::runtime(limit.form), limit.broken)));
  const ProofRun run = proved(input);
  EXPECT_EQ(outcomeOf(run, "holds"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "breaks"), Outcome::Violated);
}

INSTANTIATE_TEST_SUITE_P(Limits, IecTimer, testing::ValuesIn(limits),
                         [](const auto& info) { return std::string(info.param.name); });

// A monitoring time in a block with two instances: a motor whose contactor does not answer is off in the scan in which
// the time of 3 s is up. In scan n it is still on: at most 2999 + d(n) - p(n) - d(k) + p(k) <= 2999 + 150, as above.
TEST(IecTimers, MonitoringTimesOfTwoInstances) {
  const ProgramInput input = inputOfSource(
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  start : BOOL;\n  stop : BOOL;\n  answer : BOOL;\n  limit : TIME := T#3S;\n"
      "END_VAR\nVAR_OUTPUT\n  q : BOOL;\n  fault : BOOL;\nEND_VAR\nVAR\n  mon : SFB 4;\nEND_VAR\nVAR_TEMP\n"
      "  wait : BOOL;\nEND_VAR\nBEGIN\nNETWORK\nA #start; S #q; ON #stop; O #fault; R #q; A #q; AN #answer; = #wait;\n"
      "CALL #mon (IN := #wait, PT := #limit);\nA #mon.Q; S #fault; R #q;\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 2\nFB 1\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\n//@ prove first: not held(Q0.0 and not I0.2, 3150ms)\n"
      "//@ prove second: not held(Q1.0 and not I1.2, 3150ms)\n//@ prove early: not held(Q1.0 and not I1.2, 3149ms)\n"
      "BEGIN\nNETWORK\nCALL FB 1, DB 1 (start := I 0.0, stop := I 0.1, answer := I 0.2, q := Q 0.0);\n"
      "CALL FB 1, DB 2 (start := I 1.0, stop := I 1.1, answer := I 1.2, q := Q 1.0);\nEND_ORGANIZATION_BLOCK\n");
  const ProofRun run = proved(input);
  EXPECT_EQ(outcomeOf(run, "first"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "second"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "early"), Outcome::Violated);
}

}  // namespace
}  // namespace rungproof::test
