// Witnesses and proofs over time: long presets are reached by stretches that are replayed scan by scan, and found as
// quickly as short ones; what time alone cannot reach is not claimed.
#include <set>

#include "analysis/graph/evaluate.hpp"
#include "analysis/proof/question_system.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

TEST(Time, LongPresetIsReachedInRealScans) {
  // 3000 s behind one input; a scan lasts 500 ms at most, so at least 6000 scans pass.
  const ProgramInput input = inputOf("//@ reach late: T37\n", "Network 1\nLD I0.0\nTON T37, 30000\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  const ProofResult* result = resultNamed(run, "late");
  ASSERT_TRUE(result != nullptr && result->witness);
  EXPECT_EQ(result->outcome, Outcome::Reachable);
  EXPECT_GE(result->witness->scanCount, 6000U);
  EXPECT_GE(result->witness->milliseconds, 3000U * 1000U - 100U);
}

TEST(Time, TimerIsNotEarly) {
  // Preset 50 at 100 ms is 4901 ms of ticks at least; they count from the start of the scan before the one that enables
  // the timer, and scan ends lie up to 500 ms after scan starts: 4901 + 1 - 1000 ms between scan ends.
  const ProgramInput input =
      inputOf("//@ prove not before: T37 implies held(I0.0, 3900ms)\n", "Network 1\nLD I0.0\nTON T37, 50\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions(3));
  EXPECT_NE(outcomeOf(run, "not before"), Outcome::Violated);
}

// The scan that sees the input counts the ticks of the scan before it, and the last one has not had its own yet, up to
// five of them: 30,000 ticks of 100 ms may take 3,000,498 ms between scan ends, and no more (tests/timing/
// obligation_families.hpp counts them). A run that needs a wait of exactly that length is found by its length.
TEST(Time, WaitThatIsOneTickShortIsFound) {
  for (const auto& [excess, outcome] :
       {std::pair("3000400ms", Outcome::Violated), {"3000498ms", Outcome::Violated}, {"3000500ms", Outcome::Proved}}) {
    const ProgramInput input = inputOf(std::string("//@ prove on: held(I0.0, ") + excess + ") implies T37\n",
                                       "Network 1\nLD I0.0\nTON T37, 30000\n");
    const ProofRun run = prove(input.program, input.properties, usualOptions(20));
    EXPECT_TRUE(run.disagreements.empty());
    const ProofResult* result = resultNamed(run, "on");
    ASSERT_NE(result, nullptr);
    EXPECT_EQ(result->outcome, outcome) << excess;
    if (outcome != Outcome::Violated) continue;
    ASSERT_TRUE(result->witness);
    EXPECT_GE(result->witness->milliseconds, 3'000'400U);
  }
}

// A timer of 1 ms counts on between the instructions (001:6607): it begins at its instruction, which may be the last
// moment of the scan in which the input has come on, and has counted all ms from there to the end of any later scan. Of
// scans that all last 10 ms, 500 are the shortest wait that is longer than 4990 ms.
TEST(Time, WaitsOfOneMillisecondTimersAreDecidedToTheMillisecond) {
  const auto outcomes = [](const TimeRange& time) {
    const ProgramInput input = inputOf(
        "//@ prove shorter: held(I0.0, 4990ms) implies T32\n//@ prove one less: held(I0.0, 4999ms) implies T32\n"
        "//@ prove whole: held(I0.0, 5s) implies T32\n",
        "Network 1\nLD I0.0\nTON T32, 5000\n");
    ProverOptions options = usualOptions(20);
    options.time = time;
    const ProofRun run = prove(input.program, input.properties, options);
    EXPECT_TRUE(run.disagreements.empty());
    return std::vector{outcomeOf(run, "shorter"), outcomeOf(run, "one less"), outcomeOf(run, "whole")};
  };
  using enum Outcome;
  EXPECT_EQ(outcomes(usualOptions().time), (std::vector{Violated, Violated, Proved}));
  EXPECT_EQ(outcomes({10, 10}), (std::vector{Violated, Proved, Proved}));
}

// A constraint on the moments of 1 ms ticks shares the length of the scan with every question about time, but binds
// only inputs that such a question does not depend on: neither may be in its accelerated system.
TEST(Time, AcceleratedSystemKnowsAllItsVariables) {
  const ProgramInput input =
      inputOf("//@ prove late: T37 implies held(I0.0, 1s)\n//@ at every instruction prove early: T32 implies T96\n",
              "Network 1\nLD I0.0\nTON T37, 50\nNetwork 2\nLD I0.0\nTON T32, 50\nTON T96, 40\n");
  const EncoderOptions options = encoderOptionsOf(usualOptions(), true);
  QuestionSystem side(input.program, input.properties, input.properties.properties, options, {});
  const TransitionSystem system = side.accelerated(0, {1, 500});
  std::set<Node> known(system.inputs.begin(), system.inputs.end());
  std::vector<Node> roots = system.constraints;
  for (const StateVariable& state : system.states) {
    known.insert(state.node);
    roots.push_back(state.next);
  }
  roots.push_back(system.questions[0].bad);
  for (const Node n : coneOf(*system.graph, roots)) {
    const NodeData& node = (*system.graph)[n];
    if (node.op != Op::Variable) continue;
    EXPECT_TRUE(known.contains(n)) << system.graph->variables()[node.value].name;
  }
}

}  // namespace
}  // namespace rungproof::test
