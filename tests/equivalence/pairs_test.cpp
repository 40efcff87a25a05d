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

/// NEW reads I0.3 and I0.4 besides; Q0.0 differs where I0.0 and not I0.4 are on, whatever I0.3 is: it stays off.
TEST(DifferingRun, ChangesNoInputWithoutEffect) {
  const Pair pair{"", "LD I0.0;= Q0.0", "LD I0.3;= Q0.3|LD I0.0;A I0.4;= Q0.0", Equality::Different, ""};
  const ProgramInput before = pairSide("old.awl", exportOf(pair.before), ""),
                     after = pairSide("new.awl", exportOf(pair.after), "");
  EquivalenceOptions options = optionsOf(pair, before.program, after.program);
  options.observed = {direct(Area::Q, Width::Bit, 0, 0)};
  const Equivalence found =
      compareBehaviour({&before.program, before.properties}, {&after.program, after.properties}, options);
  ASSERT_TRUE(found.run);
  EXPECT_EQ(found.run->signal, "Q0.0");
  for (const ReplayScan& scan : found.run->after) {
    for (const PresetValue& input : scan.inputs)
      EXPECT_EQ(input.value, toString(input.operand) == "I0.0" ? 1U : 0U) << toString(input.operand);
  }
}

TEST(HandStatedPairs, AreEnoughAndHalfOfThemDiffer) {
  const auto count = [](Equality truth) { return std::ranges::count(pairs, truth, &Pair::truth); };
  EXPECT_GE(pairs.size(), 60U);
  EXPECT_GE(count(different) * 2, static_cast<std::ptrdiff_t>(pairs.size()));
}

}  // namespace rungproof::test
