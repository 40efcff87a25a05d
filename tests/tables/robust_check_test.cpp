// The enumeration of skews against plays of all of them, and what it says of windows of time.
#include "analysis/testing/robust_check.hpp"

#include <gtest/gtest.h>

#include "analysis/testing/bench_rows.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project.hpp"
#include "test_command.hpp"

namespace rungproof {
namespace {

/// Rows of a table whose columns are the inputs and outputs of the program; a row is input, value, wait.
struct Step {
  std::size_t input;
  double value;
  TestWait wait;
};

class Checked {
 public:
  explicit Checked(const std::string& text)
      : program(readText("p.awl", text)), signals(testSignalsOf(program, {})), rows(program, signals, {}, 10000) {}

  TestCase test(const std::vector<Step>& steps) const {
    BenchTest bench;
    for (const Step& step : steps) bench.push_back({{{step.input, step.value}}, step.wait});
    TestCase test = rows.caseOf(bench);
    rows.expectValues(test);
    return test;
  }
  /// What fails in some play with scans of that length, over all skews.
  std::vector<std::set<std::size_t>> failingInPlays(const TestCase& test, std::uint32_t us) const {
    std::vector<std::set<std::size_t>> failing(test.rows.size());
    std::size_t all = 1;
    for (std::size_t i = 0; i < test.rows.size(); ++i) all *= 5;
    for (std::size_t code = 0; code < all; ++code) {
      TestPlayOptions play;
      play.length = [us](std::uint64_t) { return us; };
      play.stopsAtFailure = false;
      for (std::size_t i = 0, rest = code; i < test.rows.size(); ++i, rest /= 5)
        play.skews.push_back(static_cast<int>(rest % 5) - 2);
      Simulator simulator(program);
      for (const TestFailure& failure : playTest(simulator, rows.columns(), test, play).failures)
        if (failure.signal) failing[failure.step].insert(*failure.signal);
    }
    return failing;
  }

  Program program;
  TestSignals signals;
  BenchRows rows;
};

// A latch that holds, an output that comes 300 ms later, and a pulse of one scan: rows of one scan and of six, whose
// inputs may meet, pass what they set to one another in all ways that skews allow.
TEST(RobustCheck, EnumeratesWhatPlaysShow) {
  const Checked of(std::string(test::motorProgram) + "Network 4\nLD I0.0\nEU\n= Q0.2\n");
  const std::vector<std::vector<Step>> tests = {{{0, 1, {1, 0}}, {0, 0, {1, 0}}, {1, 1, {1, 0}}},
                                                {{0, 1, {6, 0}}, {0, 0, {1, 400000}}, {1, 1, {6, 0}}},
                                                {{0, 1, {2, 0}}, {1, 1, {1, 0}}, {1, 0, {3, 0}}, {0, 0, {2, 0}}},
                                                {{0, 1, {1, 300000}}, {0, 0, {1, 100000}}, {1, 1, {1, 0}}}};
  for (const std::vector<Step>& steps : tests) {
    const TestCase test = of.test(steps);
    for (const std::uint32_t us : {1000U, 10000U, 37000U, 100000U}) {
      RobustCheck check(of.program, of.rows.columns(), {{}, us, us, 1});
      const RobustCells cells = check.quick(test);  // of one length: the enumeration alone
      EXPECT_EQ(cells.failing, of.failingInPlays(test, us)) << us << " us, " << steps.size() << " steps";
    }
  }
}

// A timed interrupt counts while I0.0 is on, an interrupt of an edge stores what was counted.
constexpr const char* countingProgram =
    "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nMOVB 50, SMB34\nATCH INT_0, 10\nATCH INT_1, 0\nENI\n"
    "Network 2\nLDN I0.0\nMOVW 0, VW0\nNetwork 3\nLDW>= VW0, 20\n= Q0.0\nNetwork 4\nLDW>= VW2, 5\n= Q0.1\n"
    "END_ORGANIZATION_BLOCK\nINTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD I0.0\nINCW VW0\n"
    "END_INTERRUPT_BLOCK\nINTERRUPT_BLOCK INT_1:INT1\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW VW0, VW2\n"
    "END_INTERRUPT_BLOCK\n";

TEST(RobustCheck, EnumeratesInterruptsAsPlaysShowThem) {
  const Checked of(countingProgram);
  const std::vector<std::vector<Step>> tests = {{{0, 0, {2, 0}}, {0, 1, {6, 0}}, {0, 1, {1, 300000}}, {0, 0, {2, 0}}},
                                                {{0, 1, {1, 500000}}, {0, 0, {1, 0}}, {0, 1, {1, 100000}}}};
  for (const std::vector<Step>& steps : tests) {
    const TestCase test = of.test(steps);
    for (const std::uint32_t us : {1999U, 10000U, 37000U, 90000U, 100000U}) {
      RobustCheck check(of.program, of.rows.columns(), {{}, us, us, 1});
      EXPECT_EQ(check.quick(test).failing, of.failingInPlays(test, us)) << us << " us, " << steps.size() << " steps";
    }
  }
}

// At 10 ms 60 and 300 ms make 7 ticks of 50 ms. With I0.0 two scans early it is on for 2 + 6 + 3 scans of 100 ms, from
// 400 ms on, and for 2 + 6 + 4 scans of 90 ms, from 360 ms on. The program of the last one sees 20 ticks: those of 450
// to 1400 ms, or of 400 to 1350 ms.
TEST(RobustCheck, FindsWhatInterruptsCountWithEarlyInputs) {
  const Checked of(countingProgram);
  const TestCase test = of.test({{0, 0, {6, 0}}, {0, 1, {6, 0}}, {0, 1, {1, 300000}}, {0, 0, {6, 0}}});
  ASSERT_EQ(test.rows[2].expects[0]->high, 0);
  for (const std::uint32_t us : {90000U, 100000U}) {
    RobustCheck check(of.program, of.rows.columns(), {{}, us, us, 1});
    EXPECT_TRUE(check.quick(test).failing[2].contains(0)) << us;
  }
  RobustCheck check(of.program, of.rows.columns(), {{}, 1000, 100000, 1});
  const RobustCells cells = check.full(test, RobustCheck::Clock::now() + std::chrono::seconds(20));
  EXPECT_TRUE(cells.isProved);
  EXPECT_TRUE(cells.failing[2].contains(0));
}

// Pulses of PLS run on by themselves: no state is kept, and the longest ways are tried.
TEST(RobustCheck, TriesTheExtremesWithDevices) {
  const std::string text(countingProgram);
  const Checked of(text.substr(0, text.find("Network 4")) + "Network 4\nLD I0.1\nPLS 0\n" +
                   text.substr(text.find("END_ORG")));
  RobustCheck check(of.program, of.rows.columns(), {{}, 1000, 100000, 1});
  EXPECT_TRUE(check.onlyTries());
  const TestCase test = of.test({{0, 0, {6, 0}}, {0, 1, {6, 0}}, {0, 1, {1, 300000}}, {0, 0, {6, 0}}});
  const RobustCells cells = check.full(test, RobustCheck::Clock::now() + std::chrono::seconds(5));
  EXPECT_FALSE(cells.isProved);
  EXPECT_TRUE(cells.failing[2].contains(0));
}

// After the start the motor runs whatever the skews; 300 ms later the lamp: 600 ms are enough at 1 to 20 ms and with
// two scans of skew at either end. 301 ms are 31 scans of 10 ms, the last of which begins at 300 ms and sees the third
// tick of T37, and 16 scans of 19 ms, the last of which begins at 285 ms and does not.
TEST(RobustCheck, KnowsWindowsOfTime) {
  const Checked of(test::motorProgram);
  RobustCheck check(of.program, of.rows.columns(), {{}, 1000, 20000, 1});
  const auto end = RobustCheck::Clock::now() + std::chrono::seconds(10);
  const RobustCells late = check.full(of.test({{0, 1, {1, 600000}}}), end);
  EXPECT_TRUE(late.isProved);
  EXPECT_TRUE(late.failing[0].empty());
  const RobustCells early = check.full(of.test({{0, 1, {1, 301000}}}), end);
  EXPECT_EQ(early.failing[0], (std::set<std::size_t>{1}));
}

// A division by 0 stops this controller: the divisor has to be there in the first scan, which a late input is not.
TEST(RobustCheck, SeesTheCpuStop) {
  const std::string text =
      "PROGRAM P\nVAR_INPUT D : INT; END_VAR\nVAR_OUTPUT Q : INT; END_VAR\nQ := 100 / D;\nEND_PROGRAM\n";
  Program program = readText("p.st", text);
  SimulatorOptions engine;
  engine.choices.set("iec-div-zero", "fault");
  const TestSignals signals = testSignalsOf(program, readProperties(program, {}, lookupIn(program)));
  ASSERT_EQ(signals.inputs.size(), 1U);
  const BenchRows rows(program, signals, engine, 10000);
  BenchStep first;
  first.changes.emplace_back(0, 5.0);
  TestCase test = rows.caseOf(BenchTest{first});
  rows.expectValues(test);
  RobustCheck check(program, rows.columns(), {engine, 10000, 10000, 1});
  EXPECT_EQ(check.quick(test).stops, (std::set<std::size_t>{0}));
}

// Without time nothing is proved.
TEST(RobustCheck, SaysWhatItHasNotProved) {
  const Checked of(test::motorProgram);
  RobustCheck check(of.program, of.rows.columns(), {{}, 1000, 100000, 1});
  EXPECT_FALSE(check.full(of.test({{0, 1, {6, 0}}}), RobustCheck::Clock::now()).isProved);
}

}  // namespace
}  // namespace rungproof
