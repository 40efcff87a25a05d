// Where the prover's system and the engine could part: addresses that the program does not use, scans that always end
// the program. And what is printed when they do part.
#include <gtest/gtest.h>

#include "analysis/proof/question_system.hpp"
#include "analysis/witness/both_traces.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof {
namespace {

ProofRun agreedOf(const std::string& properties, const std::string& networks, const std::string& otherBlocks = "") {
  const ProgramInput input = test::inputOf(properties, networks, otherBlocks);
  ProofRun run = prove(input.program, input.properties, test::usualOptions());
  EXPECT_TRUE(run.disagreements.empty());
  return run;
}

TEST(Agreement, AnalogInputThatTheProgramDoesNotRead) {
  // An input may have any value, read or not.
  const ProofRun run = agreedOf(
      "//@ prove none: AIW0 > 5 implies Q0.0\n//@ reach seven: AIW0 = 7\n//@ reach other: AIW2 > 3 and Q0.0\n"
      "//@ reach rising: rises(AIW4 > 100)\n//@ prove same: AIW6 = AIW6\n",
      "NETWORK 1\nLD I0.0\n= Q0.0\n");
  EXPECT_EQ(test::outcomeOf(run, "none"), Outcome::Violated);
  for (const char* name : {"seven", "other", "rising"}) EXPECT_EQ(test::outcomeOf(run, name), Outcome::Reachable);
  EXPECT_EQ(test::outcomeOf(run, "same"), Outcome::Proved);
}

TEST(Agreement, ProgramThatAFatalErrorEndsInItsFirstScan) {
  // 99999 is no pointer, and a compare contact over it is fatal (001:13906): there is no second scan.
  const ProofRun run = agreedOf("//@ reach second: not first_scan\n",
                                "NETWORK 1\nLD SM0.0\nMOVD 99999, AC2\nNETWORK 2\nLD I0.0\nAW= *AC2, +0\n= Q0.0\n");
  EXPECT_EQ(test::outcomeOf(run, "second"), Outcome::Unreachable);
}

TEST(Agreement, ProgramThatStopsItself) {
  const ProofRun run = agreedOf("//@ reach second: not first_scan\n", "NETWORK 1\nLD SM0.0\nSTOP\n");
  EXPECT_EQ(test::outcomeOf(run, "second"), Outcome::Unreachable);
}

TEST(Agreement, ProgramThatCannotCompareItsNumber) {
  // 7FC00000 is no number: comparing it is fatal in the first scan.
  const ProofRun run = agreedOf("//@ reach second: not first_scan\n",
                                "NETWORK 1\nLD SM0.0\nMOVD 16#7FC00000, VD0\nNETWORK 2\nLDR= VD0, 1.0\n= M0.0\n");
  EXPECT_EQ(test::outcomeOf(run, "second"), Outcome::Unreachable);
}

TEST(Agreement, ProgramThatStopsInARoutineOfItsOwn) {
  const ProofRun run = agreedOf("//@ reach second: not first_scan\n", "NETWORK 1\nLD SM0.0\nCALL SBR0\n",
                                "SUBROUTINE_BLOCK SBR0:SBR0\nBEGIN\nNETWORK 1\nLD SM0.0\nSTOP\nEND_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(test::outcomeOf(run, "second"), Outcome::Unreachable);
}

TEST(Agreement, ScansThatTakeLongerThanTheWatchdogAllows) {
  // 250 rounds of 20 REAL divisions, each of them more than 100 us (001:14522-14646), are more than 500 ms.
  std::string body;
  for (int i = 0; i < 20; ++i) body += "/R 1.5, AC0\n";
  const ProofRun run =
      agreedOf("//@ prove off: not Q0.0\n", "NETWORK 1\nLD SM0.0\nFOR VW0, +1, +250\nNETWORK 2\nLD SM0.0\n" + body +
                                                "NETWORK 3\nNEXT\nNETWORK 4\nLD I0.0\n= Q0.0\n");
  EXPECT_NE(test::outcomeOf(run, "off"), Outcome::Violated);
}

TEST(BothTraces, SayWhatSolverAndEngineMakeOfARun) {
  // A made-up run: two scans with I0.0 off and on. Both make Q0.0 follow it.
  const ProgramInput input = test::inputOf("//@ reach on: Q0.0\n", "NETWORK 1\nLD I0.0\n= Q0.0\n");
  QuestionSystem side(input.program, input.properties, input.properties.properties,
                      encoderOptionsOf(test::usualOptions()), {});
  const TransitionSystem& system = side.system();
  EncodedScan& encoding = side.askedProperties().encoding();
  WordTrace trace;
  trace.initial.assign(system.states.size(), 0);
  for (const std::uint64_t value : {0U, 1U}) {
    std::vector<std::uint64_t>& scan = trace.inputs.emplace_back();
    for (const Node n : system.inputs) {
      const std::string& name = encoding.graph().variables()[encoding.graph()[n].value].name;
      scan.push_back(name == "I0.0" ? value : name == "time.tens" ? trace.inputs.size() : 0);
    }
  }
  const BothTraces both = bothTracesOf(input.program, encoding, system, trace, {direct(Area::Q, Width::Bit, 0, 0)});
  ASSERT_EQ(both.solver.size(), 2U);
  EXPECT_EQ(both.solver[0], "scan 1 (10 ms): Q0.0=0 I0.0=0");
  EXPECT_EQ(both.solver[1], "scan 2 (10 ms): Q0.0=1 I0.0=1");
  EXPECT_EQ(both.engine, both.solver);
}

}  // namespace
}  // namespace rungproof
