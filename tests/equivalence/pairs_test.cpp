// Every pair gets the verdict that was reasoned out by hand.
#include "tests/equivalence/pairs.hpp"

namespace rungproof::test {

class HandStated : public testing::TestWithParam<Pair> {};

TEST_P(HandStated, HasTheVerdictThatWasReasonedOut) {
  const Pair& pair = GetParam();
  const ProgramInput before = pairSide("old.awl", exportOf(pair.before), pair.properties);
  const ProgramInput after = pairSide("new.awl", exportOf(pair.after), pair.properties);
  const Side oldSide{&before.program, before.properties}, newSide{&after.program, after.properties};
  const Equivalence found = compareBehaviour(oldSide, newSide, optionsOf(pair, before.program, after.program));
  EXPECT_EQ(equalityText(found.equality), equalityText(pair.truth)) << pair.why;
  EXPECT_EQ(found.run.has_value(), pair.truth == Equality::Different);
  EXPECT_TRUE(found.disagreements.empty());
  for (const std::string& note : found.notes) EXPECT_EQ(note, "") << "a note is only made where nothing is decided";
}

INSTANTIATE_TEST_SUITE_P(Pairs, HandStated, testing::ValuesIn(pairs),
                         [](const testing::TestParamInfo<Pair>& info) { return info.param.name; });

TEST(HandStatedPairs, AreEnoughAndHalfOfThemDiffer) {
  const auto count = [](Equality truth) { return std::ranges::count(pairs, truth, &Pair::truth); };
  EXPECT_GE(pairs.size(), 60U);
  EXPECT_GE(count(different) * 2, static_cast<std::ptrdiff_t>(pairs.size()));
}

}  // namespace rungproof::test
