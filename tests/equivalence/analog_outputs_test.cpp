// Analog outputs are compared and shown as words: what the program gives to AQW4 is a number, not 16 outputs.
#include "tests/equivalence/pair.hpp"

namespace rungproof::test {

namespace {

Equivalence comparedWords(const char* before, const char* after, EquivalenceOptions options = {}) {
  const ProgramInput one = pairSide("old.awl", exportOf(before), ""), other = pairSide("new.awl", exportOf(after), "");
  options.everyOutput = true;
  return compareBehaviour({&one.program, one.properties}, {&other.program, other.properties}, options);
}

}  // namespace

TEST(AnalogOutputs, DifferAsNumbers) {
  const Equivalence found = comparedWords("LD I0.0;MOVW 5,AQW4", "LD I0.0;MOVW -300,AQW4");
  ASSERT_TRUE(found.run.has_value());
  EXPECT_EQ(found.run->signal, "AQW4");
  EXPECT_EQ(found.run->valueBefore, 5U);
  EXPECT_EQ(found.run->valueAfter, 65236U) << "-300 in 16 bits";
  ASSERT_EQ(found.outputs.size(), 2U) << "AQW4 and RUN";
  EXPECT_EQ(found.outputs[0].name, "AQW4");
}

TEST(AnalogOutputs, OfOneProgramOnlyAreComparedWithZero) {
  const Equivalence found = comparedWords("LD I0.0;= Q0.0", "LD I0.0;= Q0.0;MOVW 0,AQW2;MOVW VW0,AQW4");
  EXPECT_EQ(equalityText(found.equality), "EQUAL") << "VW0 is never written";
  EXPECT_EQ(found.outputs.size(), 4U) << "Q0.0, AQW2, AQW4 and RUN";
}

TEST(AnalogOutputs, AreMappedAsWords) {
  EquivalenceOptions options;
  ASSERT_TRUE(options.pairs.add({Area::AQ, 0}, {Area::AQ, 32}, 16));  // AQW0 = AQW4
  const Equivalence same = comparedWords("LD I0.0;MOVW VW0,AQW0;INCW VW0", "LD I0.0;MOVW VW0,AQW4;INCW VW0", options);
  EXPECT_EQ(equalityText(same.equality), "EQUAL");
  EXPECT_EQ(same.outputs.size(), 2U);
  const Equivalence other = comparedWords("LD I0.0;MOVW VW0,AQW0;INCW VW0", "LD I0.0;INCW VW0;MOVW VW0,AQW4", options);
  ASSERT_TRUE(other.run.has_value());
  EXPECT_EQ(other.run->signal, "AQW0") << "of OLD";
  EXPECT_EQ(other.run->valueAfter, other.run->valueBefore + 1);
}

TEST(AnalogOutputs, ComeLaterWithLatency) {
  EquivalenceOptions options;
  options.latency = 1;
  EXPECT_EQ(
      equalityText(comparedWords("LD SM0.0;MOVW AIW0,AQW0", "LD SM0.0;MOVW VW0,AQW0;MOVW AIW0,VW0", options).equality),
      "EQUAL");
}

}  // namespace rungproof::test
