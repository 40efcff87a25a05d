// Pulse outputs of the S7-200 SMART: trains have a frequency, bit 6 of the control byte is 1 for a train, and outputs 2
// and 3 are Q0.3 and Q0.2. Numbers that look the same mean something else in the other family.
#include <fmt/format.h>

#include "ir/s7200/cpu.hpp"
#include "tests/equivalence/pair.hpp"

namespace rungproof::test {

namespace {

constexpr Target smartCpu{s7200Cpu("ST60"), Edition::Smart28}, classicCpu{s7200Cpu("226"), Edition::Edition2004};

Equivalence comparedPulsesOf(const std::string& before, const std::string& after, Target targetBefore = smartCpu,
                             Target targetAfter = smartCpu) {
  ProgramInput one, other;
  one.program = readText("old.awl", exportOf(before), {.target = targetBefore});
  other.program = readText("new.awl", exportOf(after), {.target = targetAfter});
  for (const ProgramInput* input : {&one, &other}) {
    for (const Finding& finding : input->program.findings)
      EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  }
  EquivalenceOptions options;
  options.prover.timeout = 20;
  Equivalence found = compareBehaviour({&one.program, {}}, {&other.program, {}}, options);
  for (const Disagreement& disagreement : found.disagreements) ADD_FAILURE() << disagreement.explanation;
  return found;
}

/// A train of `count` pulses from the generator whose control byte is SMB`control`.
std::string trainOf(int output, int control, const std::string& hertz, const std::string& count = "100",
                    const std::string& command = "16#C5") {
  return fmt::format("LD I0.0;= Q0.5|LD SM0.1;MOVB {},SMB{};MOVW {},SMW{};MOVD {},SMD{};PLS {}", command, control,
                     hertz, control + 1, count, control + 5, output);
}

}  // namespace

TEST(SmartPulses, EveryOutputIsCompared) {
  for (const auto& [output, control] : {std::pair{0, 67}, std::pair{1, 77}, std::pair{2, 567}, std::pair{3, 581}}) {
    const std::string slow = trainOf(output, control, "1000");
    EXPECT_EQ(equalityText(comparedPulsesOf(slow, slow).equality), "EQUAL") << output;
    const Equivalence found = comparedPulsesOf(slow, trainOf(output, control, "2000"));
    EXPECT_EQ(equalityText(found.equality), "DIFFERENT") << output;
    ASSERT_TRUE(found.run.has_value()) << output;
    EXPECT_EQ(found.run->signal, fmt::format("PLS{}.frequency", output));
    EXPECT_EQ(found.run->valueBefore, 1000U);
    EXPECT_EQ(found.run->valueAfter, 2000U);
    const Equivalence longer = comparedPulsesOf(slow, trainOf(output, control, "1000", "200"));
    ASSERT_TRUE(longer.run.has_value()) << output;
    EXPECT_EQ(longer.run->signal, fmt::format("PLS{}.count", output));
  }
}

TEST(SmartPulses, TheTimeBaseIsNoPartOfATrain) {
  EXPECT_NE(equalityText(comparedPulsesOf(trainOf(0, 67, "1000"), trainOf(0, 67, "1000", "100", "16#CD")).equality),
            "DIFFERENT")
      << "bit 3 is the time base of a modulation";
}

TEST(SmartPulses, LimitsOfATrain) {
  EXPECT_NE(
      equalityText(
          comparedPulsesOf(trainOf(0, 67, "1000", "16#7FFFFFFF"), trainOf(0, 67, "1000", "16#FFFFFFFF")).equality),
      "DIFFERENT")
      << "more than 2147483647 pulses are 2147483647";
  EXPECT_NE(equalityText(comparedPulsesOf(trainOf(0, 67, "0"), trainOf(0, 67, "1")).equality), "DIFFERENT")
      << "0 Hz becomes 1 Hz";
}

/// 16#85 is a train on an S7-200 (bit 6 is 0), a modulation on an S7-200 SMART; 16#C5 the other way round.
TEST(SmartPulses, TheSameCommandsMeanSomethingElseInTheOtherFamily) {
  for (const char* command : {"16#85", "16#C5"}) {
    const std::string program = trainOf(0, 67, "1000", "100", command);
    EXPECT_EQ(equalityText(comparedPulsesOf(program, program, classicCpu, smartCpu).equality), "DIFFERENT") << command;
  }
  EXPECT_NE(equalityText(
                comparedPulsesOf(trainOf(0, 67, "1000", "100", "16#85"), trainOf(0, 67, "1000"), classicCpu, smartCpu)
                    .equality),
            "EQUAL")
      << "1000 us and 1000 Hz are the same, 500 and 500 are not: no number is compared";
}

/// HSC1 counts I0.6 on an S7-200 and I0.1 on an S7-200 SMART.
TEST(SmartPulses, CountersOfTheOtherFamilyCountOtherInputs) {
  const std::string program = "LD SM0.1;MOVB 16#F8,SMB47;HDEF 1,0;HSC 1|LDD>= HC1,100;= Q0.0";
  EXPECT_EQ(equalityText(comparedPulsesOf(program, program).equality), "EQUAL");
  EXPECT_NE(equalityText(comparedPulsesOf(program, program, classicCpu, smartCpu).equality), "EQUAL");
}

}  // namespace rungproof::test
