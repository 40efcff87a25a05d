// Properties that hold at every instruction: what is true between two instructions and gone at the scan's end, in the
// program, in an interrupt routine that comes between them, and for timers that tick inside the scan. Every refutation
// has been repeated by the engine, or the outcome would be a disagreement.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

std::string placeOf(const ProofRun& run, const std::string& name) {
  const ProofResult* result = resultNamed(run, name);
  if (result == nullptr || !result->witness) return "no witness";
  return result->witness->place == nullptr ? "at the end" : Facts::text(*result->witness->place);
}

TEST(EveryInstruction, SeesWhatTheEndOfTheScanDoesNot) {
  // Q0.1 is on from its coil to the R two instructions later, in every scan with I0.0.
  const ProgramInput input = inputOf(
      "//@ at every instruction prove within: never Q0.0 and Q0.1\n//@ prove ends: never Q0.0 and Q0.1\n"
      "//@ at every instruction prove alone: never Q0.1 and not Q0.0\n",
      "Network 1\nLD I0.0\n= Q0.0\n= Q0.1\nNetwork 2\nLD Q0.0\nR Q0.1, 1\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "within"), Outcome::Violated);
  EXPECT_EQ(placeOf(run, "within"), "LD Q0.0");
  EXPECT_EQ(outcomeOf(run, "ends"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "alone"), Outcome::Proved);
}

TEST(EveryInstruction, ResultsKeepTheOrderOfTheProperties) {
  // They are asked on two encodings; nobody who reads the report should notice.
  const ProgramInput input = inputOf(
      "//@ prove one: Q0.0 implies I0.0\n//@ at every instruction prove two: Q0.0 implies I0.0\n//@ reach three: "
      "Q0.0\n",
      "Network 1\nLD I0.0\n= Q0.0\n= M0.0\nNetwork 2\nLD I0.1\nS M0.0, 1\n");
  ProverOptions options = usualOptions();
  options.checks.builtin = true;
  std::vector<std::size_t> done, totals;
  const ProofRun run =
      prove(input.program, input.properties, options, [&](const ProofResult&, std::size_t settled, std::size_t total) {
        done.push_back(settled);
        totals.push_back(total);
        return true;
      });
  ASSERT_GT(run.results.size(), 3U);
  for (const auto& [at, name] : {std::pair{0, "one"}, std::pair{1, "two"}, std::pair{2, "three"}})
    EXPECT_EQ(run.results[static_cast<std::size_t>(at)].property.name, name);
  EXPECT_EQ(run.results[0].outcome, Outcome::Proved);
  // Inside the scan Q0.0 is still that of the scan before when I0.0 has fallen.
  EXPECT_EQ(run.results[1].outcome, Outcome::Violated);
  EXPECT_EQ(run.results[2].outcome, Outcome::Reachable);
  for (std::size_t i = 3; i < run.results.size(); ++i) EXPECT_TRUE(run.results[i].builtin);
  ASSERT_EQ(done.size(), run.results.size());
  for (std::size_t i = 0; i < done.size(); ++i) {
    EXPECT_EQ(done[i], i + 1);
    EXPECT_EQ(totals[i], run.results.size());
  }
}

TEST(EveryInstruction, SeesTheScanEndToo) {
  // The last instruction makes it true: no instruction comes behind it.
  const ProgramInput input = inputOf("//@ at every instruction prove off: not Q0.0\n", "Network 1\nLD I0.0\n= Q0.0\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "off"), Outcome::Violated);
  EXPECT_EQ(placeOf(run, "off"), "at the end");
}

TEST(EveryInstruction, InterruptsComeInBetweenWithoutSharedMemory) {
  // Q0.0 is on between its coil and its R; the routine has Q0.1 on for a moment. Neither touches what the other does,
  // so no order of them changes a scan's end, but what is seen in between.
  const ProgramInput input = inputOf(
      "//@ at every instruction prove both: never Q0.0 and Q0.1\n//@ prove ends: never Q0.0 or Q0.1\n",
      "Network 1\nLD SM0.1\nATCH 0, 0\nENI\nNetwork 2\nLD I0.0\n= Q0.0\nR Q0.0, 1\n",
      "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\n= Q0.1\nLD SM0.0\nR Q0.1, 1\nEND_INTERRUPT_BLOCK\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "both"), Outcome::Violated);
  EXPECT_EQ(outcomeOf(run, "ends"), Outcome::Proved);
}

TEST(EveryInstruction, MillisecondTimersTickInside) {
  // T32 has 1 ms resolution and is refreshed inside the scan: M2.0 is written from T32 = 0, and before the next
  // instruction T32 can be on. T37 changes at its own instruction only.
  const ProgramInput input = inputOf(
      "//@ at every instruction prove fast: never T32 and M2.0\n//@ at every instruction prove slow: never T37 and "
      "M2.1\n",
      "Network 1\nLD I1.0\nTON T32, 5\nTON T37, 5\nNetwork 2\nLDN T32\n= M2.0\nLDN T37\n= M2.1\nNetwork 3\nLD M2.0\n= "
      "M3.0\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "fast"), Outcome::Violated);
  // M2.1 is still that of the last scan when T37 comes: it is seen between the timer and the coil.
  EXPECT_EQ(outcomeOf(run, "slow"), Outcome::Violated);
  EXPECT_EQ(placeOf(run, "slow"), "LDN T32");
}

TEST(EveryInstruction, FirstScanIsTheFirstScan) {
  const ProgramInput input = inputOf(
      "//@ at every instruction prove start: never first_scan and M1.0\n//@ at every instruction prove later: never "
      "M1.1 and not first_scan\n",
      "Network 1\nLD SM0.1\n= M1.0\n= M1.1\nNetwork 2\nLD SM0.0\nR M1.1, 1\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "start"), Outcome::Violated);
  EXPECT_EQ(outcomeOf(run, "later"), Outcome::Proved);
}

TEST(EveryInstruction, APremiseThatIsMetInsideIsNoVacuousOne) {
  // M0.0 is on between its S and its R only, and I0.0 is on there: Q0.0 follows I0.0 and was written before.
  const ProgramInput input =
      inputOf("//@ at every instruction prove inside: M0.0 implies Q0.0\n//@ prove ends: (M0.0 implies Q0.0)\n",
              "Network 1\nLD I0.0\n= Q0.0\nS M0.0, 1\nNetwork 2\nLD SM0.0\nR M0.0, 1\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "inside"), Outcome::Proved);
  const ProofResult* ends = resultNamed(run, "ends");
  ASSERT_NE(ends, nullptr);
  EXPECT_EQ(ends->outcome, Outcome::Vacuous);
  EXPECT_EQ(ends->notes, std::vector<std::string>{"the premise 'M0.0' can never be met"});
}

}  // namespace
}  // namespace rungproof::test
