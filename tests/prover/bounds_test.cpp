// Bounds on differences of words are kept by every scan, by themselves: also where no other invariant was found in
// time, so that states count which no run reaches, such as a timer with a value below zero.
#include <gtest/gtest.h>

#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/portfolio/invariants_bounds.hpp"
#include "analysis/proof/question_system.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

/// Clauses that a scan can break from a state that satisfies all of them.
std::size_t brokenByAScan(const BitBlast& blast, const std::vector<Node>& clauses) {
  Unrolling steps(blast.bits(), Unrolling::Start::Any);
  Sat sat(Sat::Use::Many);
  BitCnf cnf(steps.graph(), sat);
  for (const Lit constraint : blast.bits().constraints) sat.add({cnf.literal(steps.at(0, constraint))});
  for (const Node n : clauses) sat.add({cnf.literal(steps.at(0, blast.of(n)[0]))});
  return static_cast<std::size_t>(std::ranges::count_if(clauses, [&](Node n) {
    const Sat::Outcome outcome = sat.solve({-cnf.literal(steps.at(1, blast.of(n)[0]))}, Budget::seconds(20));
    return outcome != Sat::Outcome::Unsatisfiable;
  }));
}

TEST(BoundsOfPrograms, AreInductiveWithoutOtherInvariants) {
  std::size_t found = 0;
  const std::filesystem::path corpus = std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus";
  for (const char* name : {"defects/swapped_parameters.awl", "interlocks/notaus.awl", "interlocks/reversing.awl"}) {
    const ProgramInput input = corpusInput(corpus / name);
    ProverOptions options = usualOptions();
    std::vector<Property> goals;
    for (const Property& property : input.properties.properties) {
      if (property.isGoal()) goals.push_back(property);
    }
    QuestionSystem side(input.program, input.properties, goals, encoderOptionsOf(options), {});
    for (std::size_t q = 0; q < goals.size(); ++q) {
      const TransitionSystem system = side.only(q);
      for (const BoundScope scope :
           {BoundScope::Chain, BoundScope::Few, BoundScope::Stops, BoundScope::All, BoundScope::Pending}) {
        BitBlast blast(system, {0});
        const MinedBounds mined = mineBounds(system, blast, {}, 1, scope, Budget::seconds(5));
        blast.add(mined.clauses);
        found += mined.clauses.size();
        EXPECT_EQ(brokenByAScan(blast, mined.clauses), 0U) << name << ": " << goals[q].name;
      }
    }
  }
  EXPECT_GT(found, 10U);
}

}  // namespace
}  // namespace rungproof::test
