// What the standard leaves open is proved for each reading: widths of sums before they are compared, divided or
// widened, PT of a timer that runs, limits of FOR that the body changes. Expected values are counted by hand.
#include <gtest/gtest.h>

#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

/// Verdicts without a choice, and with the first and the second reading of one.
void expectVerdicts(const std::string& text, const std::string& choice, const std::string& first,
                    const std::string& second, const std::string& both, const std::string& one,
                    const std::string& other) {
  EXPECT_TRUE(proofOfIec(text).has(both)) << proofOfIec(text).text;
  const IecOutput a = proofOfIec(text, {"--choice", choice + "=" + first});
  EXPECT_TRUE(a.has(one)) << first << ": " << a.text;
  const IecOutput b = proofOfIec(text, {"--choice", choice + "=" + second});
  EXPECT_TRUE(b.has(other)) << second << ": " << b.text;
}

// 32767 + 1 is -32768 as INT, and 32768 in 32 bits.
TEST(IecReadings, ASumMayBeComparedInMoreBits) {
  const std::string text =
      "PROGRAM P\nVAR i AT %IW1 : INT; q AT %QX0.0 : BOOL; END_VAR\nq := (i + 1) > 0;\nEND_PROGRAM\n";
  expectVerdicts("//@ prove p: i = 32767 implies not q\n" + text, "iec-intermediate", "declared", "wide", "VIOLATED  p",
                 "PROVED  p", "VIOLATED  p");
  EXPECT_TRUE(proofOfIec("//@ prove p: i = 32767 implies q\n" + text, {"--choice", "iec=openplc"}).has("PROVED  p"));
}

// 30000 + 30000 is -5536 as INT; half of it is -2768.
TEST(IecReadings, ASumMayBeDividedInMoreBits) {
  const std::string text =
      "PROGRAM P\nVAR a AT %IW1 : INT; b AT %IW3 : INT; y : INT; END_VAR\ny := (a + b) / 2;\nEND_PROGRAM\n";
  const std::string asked = "//@ prove p: a = 30000 and b = 30000 implies y = ";
  expectVerdicts(asked + "-2768\n" + text, "iec-intermediate", "declared", "wide", "VIOLATED  p", "PROVED  p",
                 "VIOLATED  p");
  expectVerdicts(asked + "30000\n" + text, "iec-intermediate", "declared", "wide", "VIOLATED  p", "VIOLATED  p",
                 "PROVED  p");
}

TEST(IecReadings, ASumMayBeWidenedBeforeOrBehind) {
  const std::string text = "PROGRAM P\nVAR i AT %IW1 : INT; d : DINT; END_VAR\nd := i + 1;\nEND_PROGRAM\n";
  expectVerdicts("//@ prove p: i = 32767 implies d = -32768\n" + text, "iec-intermediate", "declared", "wide",
                 "VIOLATED  p", "PROVED  p", "VIOLATED  p");
  expectVerdicts("//@ prove p: i = 32767 implies d = 32768\n" + text, "iec-intermediate", "declared", "wide",
                 "VIOLATED  p", "VIOLATED  p", "PROVED  p");
}

// 16384 + 16384 is -32768 as INT: a divisor that is 0 by neither reading, and 32767 + 32767 + 2 is 0 as INT alone.
TEST(IecReadings, ADivisorMayBeASum) {
  const std::string text =
      "PROGRAM P\nVAR a AT %IW1 : INT; y : INT; END_VAR\nIF a = 16384 THEN y := a / (a + a); END_IF;\nEND_PROGRAM\n";
  expectVerdicts("//@ prove p: y = 0\n" + text, "iec-intermediate", "declared", "wide", "PROVED  p", "PROVED  p",
                 "PROVED  p");
  const std::string zero =
      "//@ prove p: b <> 32767\nPROGRAM P\nVAR b AT %IW1 : INT; y : INT; END_VAR\ny := 1 / (b + b + 2);\nEND_PROGRAM\n";
  EXPECT_TRUE(
      proofOfIec(zero, {"--choice", "iec-div-zero=fault", "--choice", "iec-intermediate=declared"}).has("PROVED  p"));
  EXPECT_TRUE(
      proofOfIec(zero, {"--choice", "iec-div-zero=fault", "--choice", "iec-intermediate=wide"}).has("VIOLATED  p"));
  EXPECT_TRUE(proofOfIec(zero, {"--choice", "iec-div-zero=fault"}).has("VIOLATED  p"));
}

// 32767 + 1 is -32768 or 32768, no label of the first and above each limit of the second.
TEST(IecReadings, SelectorsAndLimitsMayBeSums) {
  const std::string choice =
      "PROGRAM P\nVAR i AT %IW1 : INT; n : INT; END_VAR\n"
      "CASE i + 1 OF -32768: n := 1; ELSE n := 2; END_CASE;\nEND_PROGRAM\n";
  expectVerdicts("//@ prove p: i = 32767 implies n = 1\n" + choice, "iec-intermediate", "declared", "wide",
                 "VIOLATED  p", "PROVED  p", "VIOLATED  p");
  const std::string loop =
      "PROGRAM P\nVAR i AT %IW1 : INT; k, n : INT; END_VAR\nn := 0;\n"
      "FOR k := 1 TO i + 1 DO n := n + 1; IF n = 3 THEN EXIT; END_IF; END_FOR;\nEND_PROGRAM\n";
  expectVerdicts("//@ prove p: i = 32767 implies n = 0\n" + loop, "iec-intermediate", "declared", "wide", "VIOLATED  p",
                 "PROVED  p", "VIOLATED  p");
  expectVerdicts("//@ prove p: i = 32767 implies n = 3\n" + loop, "iec-intermediate", "declared", "wide", "VIOLATED  p",
                 "VIOLATED  p", "PROVED  p");
}

// A call is made once by each reading; an error in one statement changes nothing of the next.
TEST(IecReadings, ASumMayHoldCalls) {
  const std::string text =
      "FUNCTION Same : INT\nVAR_INPUT x : INT; END_VAR\nSame := x;\nEND_FUNCTION\n"
      "PROGRAM P\nVAR i AT %IW1 : INT; q AT %QX0.0 : BOOL; END_VAR\nq := (Same(i) + 1) > 0;\nEND_PROGRAM\n";
  expectVerdicts("//@ prove p: i = 32767 implies not q\n" + text, "iec-intermediate", "declared", "wide", "VIOLATED  p",
                 "PROVED  p", "VIOLATED  p");
  const IecOutput behindAnError = proofOfIec(
      "//@ prove p: i = 32767 implies not q\nPROGRAM P\nVAR i AT %IW1 : INT; r, q : BOOL; END_VAR\n"
      "r := (i + 1) > (i + nowhere);\nq := (i + 1) > 0;\nEND_PROGRAM\n");
  EXPECT_FALSE(behindAnError.has("PROVED  p")) << behindAnError.text;
}

// The low 16 bits are the same by both readings: no choice is asked for.
TEST(IecReadings, AVariableOfItsTypeTakesTheLowBits) {
  const IecOutput output = proofOfIec(
      "//@ prove p: i = 32767 implies j = -32768\n"
      "PROGRAM P\nVAR i AT %IW1 : INT; j : INT; END_VAR\nj := i + 1;\nEND_PROGRAM\n");
  EXPECT_TRUE(output.has("PROVED  p") && !output.has("iec-intermediate")) << output.text;
}

// The hour of the start, or the 10 ms of now.
TEST(IecReadings, ARunningTimerMayKeepItsPreset) {
  const std::string text =
      "//@ prove p: held(go, 60ms) and short implies t.Q\n"
      "PROGRAM P\nVAR go AT %IX0.0 : BOOL; short AT %IX0.1 : BOOL; t : TON; pt : TIME; END_VAR\n"
      "IF short THEN pt := T#10ms; ELSE pt := T#1h; END_IF;\n";
  for (const char* call : {"t(IN := go, PT := pt);\n", "t.PT := pt; t(IN := go);\n"}) {
    const std::string whole = text + call + "END_PROGRAM\n";
    EXPECT_TRUE(proofOfIec(whole, {"--scan-time", "20ms"}).has("VIOLATED  p")) << call;
    EXPECT_TRUE(proofOfIec(whole, {"--scan-time", "20ms", "--choice", "iec-timer-preset=live"}).has("PROVED  p"))
        << call;
    EXPECT_TRUE(proofOfIec(whole, {"--scan-time", "20ms", "--choice", "iec-timer-preset=latched"}).has("VIOLATED  p"))
        << call;
  }
}

// Two calls with a constant each: whichever starts the timer, the other one changes PT while it runs, or does not.
TEST(IecReadings, TwoCallsMayGiveTwoPresets) {
  const std::string text =
      "PROGRAM P\nVAR go AT %IX0.0 : BOOL; short AT %IX0.1 : BOOL; t : TON; END_VAR\n"
      "IF short THEN t(IN := go, PT := T#10ms); ELSE t(IN := go, PT := T#1h); END_IF;\nEND_PROGRAM\n";
  const std::string asked = "//@ prove p: held(go, 60ms) and short implies t.Q\n";
  EXPECT_TRUE(proofOfIec(asked + text, {"--scan-time", "20ms"}).has("VIOLATED  p"));
  EXPECT_TRUE(proofOfIec(asked + text, {"--scan-time", "20ms", "--choice", "iec-timer-preset=live"}).has("PROVED  p"));
}

// Three passes as the limit was, five as the body leaves it.
TEST(IecReadings, ALimitOfForMayBeLookedAtOnce) {
  const auto text = [](const char* count) {
    return std::string("//@ prove p: n = ") + count +
           "\nPROGRAM P\nVAR i, b, n : INT; END_VAR\nb := 3; n := 0;\n"
           "FOR i := 1 TO b DO b := 5; n := n + 1; END_FOR;\nEND_PROGRAM\n";
  };
  expectVerdicts(text("5"), "iec-for-bounds", "each-pass", "once", "VIOLATED  p", "PROVED  p", "VIOLATED  p");
  expectVerdicts(text("3"), "iec-for-bounds", "each-pass", "once", "VIOLATED  p", "VIOLATED  p", "PROVED  p");
}

// The step likewise: 1, 3 with the step of 2 that the body sets; 1, 2, 3 with the step of before.
TEST(IecReadings, AStepOfForMayBeLookedAtOnce) {
  const auto text = [](const char* count) {
    return std::string("//@ prove p: n = ") + count +
           "\nPROGRAM P\nVAR i, s, n : INT; END_VAR\ns := 1; n := 0;\n"
           "FOR i := 1 TO 3 BY s DO s := 2; n := n + 1; END_FOR;\nEND_PROGRAM\n";
  };
  expectVerdicts(text("2"), "iec-for-bounds", "each-pass", "once", "VIOLATED  p", "PROVED  p", "VIOLATED  p");
  expectVerdicts(text("3"), "iec-for-bounds", "each-pass", "once", "VIOLATED  p", "VIOLATED  p", "PROVED  p");
}

}  // namespace
}  // namespace rungproof
