// An error of ours costs the question in which it comes, and no other: here the reader of properties is taken to have
// made an address that no encoding can read, which breaks an assertion.
#include <algorithm>

#include "analysis/equivalence/equivalence.hpp"
#include "ir/check.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

const std::string networks = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\nA I0.0\n= Q0.1\n";

void breakAddresses(Property& property) {
  for (ExprNode& node : property.first.nodes) {
    if (node.op == ExprOp::Address) node.operand.kind = OperandKind::Indirect;
  }
}
ProgramInput withBroken(const std::string& properties, const std::string& name) {
  ProgramInput input = inputOf(properties, networks);
  const auto broken = std::ranges::find(input.properties.properties, name, &Property::name);
  EXPECT_NE(broken, input.properties.properties.end());
  breakAddresses(*broken);
  return input;
}

TEST(BrokenQuestion, CostsItselfOnly) {
  const ProgramInput input = withBroken(
      "//@ prove follows: Q0.1 implies Q0.0\n//@ prove broken: never Q0.0\n//@ prove off: never Q0.1\n"
      "//@ prove again: Q0.1 implies I0.1\n",
      "broken");
  std::vector<std::string> told;
  const ProofRun run = prove(input.program, input.properties, usualOptions(),
                             [&](const ProofResult& row, std::size_t, std::size_t total) {
                               told.push_back(row.property.name);
                               EXPECT_EQ(total, 4U);
                               return true;
                             });
  EXPECT_EQ(outcomeOf(run, "follows"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "off"), Outcome::Violated);
  EXPECT_EQ(outcomeOf(run, "again"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "broken"), Outcome::Unknown);
  EXPECT_TRUE(hasNote(*resultNamed(run, "broken"), "internal error: "));
  EXPECT_FALSE(hasNote(*resultNamed(run, "off"), "internal error"));
  EXPECT_EQ(told, (std::vector<std::string>{"follows", "broken", "off", "again"}));
}

TEST(BrokenQuestion, LeavesBuiltInChecksAlone) {
  const ProgramInput input = withBroken("//@ prove broken: never Q0.0\n", "broken");
  ProverOptions options = usualOptions();
  options.checks.builtin = true;
  const ProofRun run = prove(input.program, input.properties, options);
  const ProofRun without = prove(input.program, {}, options);
  EXPECT_EQ(outcomeOf(run, "broken"), Outcome::Unknown);
  EXPECT_EQ(run.results.size(), without.results.size() + 1);
}

// Where it breaks an assumption, nothing is decided; nothing is equal either.
TEST(BrokenQuestion, AssumptionsLeaveAllOpen) {
  ProgramInput input = withBroken("//@ assume known: I0.0\n//@ prove off: never Q0.1\n", "known");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "off"), Outcome::Unknown);
  EXPECT_TRUE(hasNote(*resultNamed(run, "off"), "internal error: "));
  EquivalenceOptions options;
  options.prover = usualOptions();
  const Side side{&input.program, input.properties};
  const Equivalence found = compareBehaviour(side, side, options);
  EXPECT_EQ(found.equality, Equality::Unknown);
  EXPECT_TRUE(
      std::ranges::any_of(found.notes, [](const std::string& note) { return note.starts_with("internal error"); }));
}

TEST(BrokenQuestion, IsToldByAnException) { EXPECT_THROW(CHECK(1 == 2, "never so"), InternalError); }

}  // namespace
}  // namespace rungproof::test
