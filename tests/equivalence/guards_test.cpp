// What a proof about the product of two programs does not show: then nothing is decided, and the reason is said.
#include "tests/equivalence/pair.hpp"

namespace rungproof::test {

namespace {

Equivalence compared(const char* before, const std::string& after, const char* properties = "", bool steady = false) {
  const ProgramInput one = pairSide("old.awl", exportOf(before), properties);
  const ProgramInput other = pairSide("new.awl", exportOf(after), properties);
  EquivalenceOptions options;
  options.prover.timeout = 20;
  options.steadyInputs = steady;
  return compareBehaviour({&one.program, one.properties}, {&other.program, other.properties}, options);
}

bool says(const Equivalence& found, const std::string& part) {
  return std::ranges::any_of(found.notes,
                             [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

/// 250 rounds of some 3 ms each by the times of Appendix F: longer than the watchdog (001:13920), without effect.
std::string slowLoop(int rounds) {
  std::string text = "LD I0.1;FOR VW0,1," + std::to_string(rounds) + "|LD SM0.0";
  for (int i = 0; i < 3; ++i) text += ";EXP VD4,VD8;SIN VD4,VD8;LN VD12,VD8;TAN VD4,VD8";
  return text + "|NEXT";
}

/// A motor that runs up by the profile in V memory from VB500 on (001:4596): nothing of that stands in the process
/// image.
std::string profile(const std::string& pulses) {
  return "LD I0.0;= Q0.5|LD SM0.1;MOVB 1,VB500;MOVW 500,VW501;MOVW 0,VW503;MOVD " + pulses +
         ",VD505;MOVW 500,SMW168;MOVB 16#A0,SMB67;PLS 0";
}

}  // namespace

TEST(Guards, ALoopThatOutlastsTheWatchdogOfOneProgramOnly) {
  const Equivalence found = compared("LD I0.0;= Q0.0", "LD I0.0;= Q0.0|" + slowLoop(250));
  ASSERT_EQ(equalityText(found.equality), "DIFFERENT") << "with I0.1 on NEW stops by fatal error 3";
  EXPECT_EQ(found.run->signal, "RUN");
  EXPECT_EQ(found.run->scan, 1U) << "I0.1 on from the start";
}

/// With steady inputs the engine makes no runs of its own, and the proof knows no execution times.
TEST(Guards, ALoopThatMayOutlastTheWatchdogOfOneProgramOnly) {
  const Equivalence found = compared("LD I0.0;= Q0.0", "LD I0.0;= Q0.0|" + slowLoop(250), "", true);
  EXPECT_EQ(equalityText(found.equality), "UNKNOWN");
  EXPECT_TRUE(says(found, "watchdog"));
}

TEST(Guards, LeaveEachOutputOpen) {
  const ProgramInput one = pairSide("old.awl", exportOf("LD I0.0;= Q0.0|LD I0.2;= Q0.1"), "");
  const ProgramInput other = pairSide("new.awl", exportOf("LD I0.0;= Q0.0|LDN I0.2;= Q0.1|" + slowLoop(250)), "");
  EquivalenceOptions options;
  options.everyOutput = true;  // as diff asks
  for (const ObservedVerdict& output : compareBehaviour({&one.program, {}}, {&other.program, {}}, options).outputs)
    EXPECT_NE(output.equality, Equality::Equal) << output.name << ": NEW may stop";
}

TEST(Guards, AShortLoopIsNoReason) {
  EXPECT_EQ(compared("LD I0.0;= Q0.0", "LD I0.0;= Q0.0|" + slowLoop(3)).equality, Equality::Equal);
}

TEST(Guards, AssumptionsThatContradictEachOther) {
  const Equivalence found = compared("LD I0.0;= Q0.0", "LDN I0.0;= Q0.0", "assume a: I0.0;assume b: not I0.0");
  EXPECT_EQ(equalityText(found.equality), "UNKNOWN") << "no run shows a difference, because there is none at all";
  EXPECT_TRUE(says(found, "contradict"));
}

TEST(Guards, AssumptionsThatTheProgramContradicts) {
  // Q0.0 is on where I0.0 is, so that no scan has I0.0 without it.
  const Equivalence found = compared("LD I0.0;= Q0.0", "LD I0.0;= Q0.0;= Q0.1", "assume a: I0.0 and not Q0.0");
  EXPECT_EQ(equalityText(found.equality), "UNKNOWN");
  EXPECT_TRUE(says(found, "contradict"));
}

TEST(Guards, ProfilesThatDiffer) {
  const Equivalence found = compared(profile("100").c_str(), profile("200"));
  EXPECT_EQ(equalityText(found.equality), "UNKNOWN");
  EXPECT_TRUE(says(found, "PLS"));
}

TEST(Guards, PulsesThatAreAlikeAreNoReason) {
  EXPECT_EQ(equalityText(compared(profile("200").c_str(), profile("200") + "|LD SM0.0;MOVW 7,VW0").equality), "EQUAL");
  EXPECT_EQ(equalityText(compared(profile("200").c_str(), profile("200")).equality), "EQUAL");
}

TEST(Guards, DataBlocksThatDiffer) {
  const auto withBlock = [](int value) {
    return "DATA_BLOCK DB1\nBEGIN\nVW0 " + std::to_string(value) + "\nEND_DATA_BLOCK\n" + exportOf("LDW= VW0,5;= Q0.0");
  };
  const ProgramInput one = pairSide("old.awl", withBlock(5), ""), other = pairSide("new.awl", withBlock(6), "");
  EXPECT_EQ(equalityText(compareBehaviour({&one.program, {}}, {&other.program, {}}, {}).equality), "DIFFERENT");
  EXPECT_EQ(equalityText(compareBehaviour({&one.program, {}}, {&one.program, {}}, {}).equality), "EQUAL");
}

}  // namespace rungproof::test
