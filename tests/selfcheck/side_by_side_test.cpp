// Runs of a program and of a changed copy side by side: what is told of them, and what is not.
#include "analysis/selfcheck/side_by_side.hpp"

#include <gtest/gtest.h>

#include "analysis/equivalence/equivalence.hpp"
#include "analysis/selfcheck/fault.hpp"
#include "engine/lanes/lane_code.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

std::vector<const Property*> goalsIn(const PropertySet& set) {
  std::vector<const Property*> goals;
  for (const Property& property : set.properties) {
    if (property.isGoal()) goals.push_back(&property);
  }
  return goals;
}

SideBySide::Seen seenIn(const std::string& properties, const std::string& before, const std::string& after,
                        const ProverOptions& options = usualOptions(1)) {
  const ProgramInput old = inputOf(properties, before), changed = inputOf(properties, after);
  return SideBySide(old.program, old.properties, options).look(changed.program, goalsIn(old.properties));
}

/// Without AVX2 nothing is ever seen.
bool areVectorsHere() { return lanes::vectorsHere() != lanes::Vectors::None; }
std::string whereVectorsAre(const char* text) { return areVectorsHere() ? text : ""; }

const char* const motor = "Network 1\nLD I0.0\nO Q0.0\nA I0.1\n= Q0.0\n";
const char* const withoutStop = "Network 1\nLD I0.0\nO Q0.0\n= Q0.0\n";

TEST(SideBySide, ShowsADifferenceAndThePropertyThatNoticesIt) {
  const SideBySide::Seen seen = seenIn("//@ prove stop: not I0.1 implies not Q0.0\n", motor, withoutStop);
  // Of 256 traces some begin with start and without stop.
  EXPECT_EQ(seen.where, whereVectorsAre("Q0.0 in scan 1"));
  EXPECT_EQ(seen.noticedBy, whereVectorsAre("stop"));
}

TEST(SideBySide, NamesNoPropertyThatHolds) {
  const SideBySide::Seen seen = seenIn("//@ prove start: not Q0.0 implies not I0.0\n", withoutStop, withoutStop);
  EXPECT_EQ(seen.where, "");
  EXPECT_EQ(seen.noticedBy, "");
  const SideBySide::Seen other =
      seenIn("//@ prove stop: Q0.1 implies I0.7\n", std::string(motor) + "Network 2\nLD I0.7\n= Q0.1\n",
             std::string(withoutStop) + "Network 2\nLD I0.7\n= Q0.1\n");
  EXPECT_EQ(other.where, whereVectorsAre("Q0.0 in scan 1"));
  EXPECT_EQ(other.noticedBy, "");
}

TEST(SideBySide, NothingCountsAfterAnAssumptionIsBroken) {
  // The two differ where both buttons are pressed, which is assumed not to happen.
  const SideBySide::Seen seen = seenIn("//@ assume one hand: not (I0.0 and I0.1)\n//@ prove never: Q0.0 implies I0.0\n",
                                       "Network 1\nLD I0.0\nA I0.1\n= Q0.0\n", "Network 1\nLDN SM0.0\n= Q0.0\n");
  EXPECT_EQ(seen.where, "");
  EXPECT_EQ(seen.noticedBy, "");
}

TEST(SideBySide, DrawsTheConstantsOfTheProgramForAnalogInputs) {
  const SideBySide::Seen seen =
      seenIn("//@ prove high: Q0.0 implies AIW0 > 12345\n", "Network 1\nLDW> AIW0, 12345\n= Q0.0\n",
             "Network 1\nLDW>= AIW0, 12345\n= Q0.0\n");
  EXPECT_EQ(seen.where.empty(), !areVectorsHere());
  EXPECT_EQ(seen.noticedBy, whereVectorsAre("high"));
}

TEST(SideBySide, RunsLongEnoughForTimers) {
  const SideBySide::Seen seen = seenIn("", "Network 1\nLD I0.0\nTON T37, 100\nNetwork 2\nLD T37\n= Q0.0\n",
                                       "Network 1\nLD I0.0\nTON T37, 50\nNetwork 2\nLD T37\n= Q0.0\n");
  EXPECT_EQ(seen.where.empty(), !areVectorsHere());
}

TEST(SideBySide, TellsNothingOfWhatVectorCodeDoesNotRun) {
  ProverOptions options = usualOptions(1);
  ASSERT_TRUE(options.choices.set("unknown-bits", "one"));
  EXPECT_EQ(seenIn("", motor, withoutStop, options).where, "");
  // The copy goes to STOP in half of the traces in its first scan.
  EXPECT_EQ(seenIn("", motor, std::string(motor) + "Network 2\nLD I0.2\nSTOP\n").where, "");
}

TEST(SideBySide, WhatItShowsIsNeverProvedEqual) {
  std::size_t seenFaults = 0;
  for (const char* name : {"star_delta", "two_speed", "hoist"}) {
    const std::filesystem::path file =
        std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus" / "interlocks" / (std::string(name) + ".awl");
    const ProgramInput input = corpusInput(file);
    const ProverOptions options = proverOptions(file);
    const SideBySide runs(input.program, input.properties, options);
    for (const Fault& fault : faultsOf(input.program)) {
      Program copy = planted(input.program, fault);
      copy.number();
      if (runs.look(copy, {}).where.empty()) continue;
      ++seenFaults;
      EquivalenceOptions one;
      one.prover = options;
      one.prover.timeout = 1;
      one.oneScan = true;
      one.interruptsInside = true;
      EXPECT_NE(compareBehaviour({&input.program, input.properties}, {&copy, input.properties}, one).equality,
                Equality::Equal)
          << name << ": " << fault.text;
    }
  }
  if (areVectorsHere()) {
    EXPECT_GE(seenFaults, 60U);
  }
}

}  // namespace
}  // namespace rungproof::test
