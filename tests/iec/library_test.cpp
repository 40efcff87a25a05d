// Blocks of the library beside timers and counters: what is known of their values, counted by hand from the formulas of
// the standard's annex; and that each block of the list can be declared and called.
#include "frontend/iec/iec_lowering.hpp"
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

using LibraryInputs = std::vector<std::pair<std::string, Row>>;

std::string programWith(const std::string& variables, const std::string& body) {
  return "PROGRAM p\nVAR_INPUT " + variables + "END_VAR\n" + body + "\nEND_PROGRAM\n";
}

const IecChoices inSeconds = {{"iec-time-number", "seconds"}};

TEST(IecLibrary, EveryBlockCanBeDeclaredAndCalled) {
  const std::vector<std::string> names = iec::libraryBlockNames();
  EXPECT_GE(names.size(), 30U);
  for (const std::string& name : names) {
    const Program program = readIecText("PROGRAM p\nVAR b : " + name + "; END_VAR\nb();\nEND_PROGRAM\n");
    EXPECT_EQ(findingsIec(program), "") << name;
    Simulator simulator(program, {});
    for (int i = 0; i < 3; ++i) simulator.scan();
    EXPECT_TRUE(simulator.errors().list().empty()) << name;
  }
}

// 2.5 * 4 s in each call with RUN: 10, 20; R1 sets 7.
TEST(IecLibrary, AnIntegralAddsWhileItRuns) {
  const std::string text = programWith("run, r1 : BOOL; END_VAR VAR i : INTEGRAL; q : BOOL; x : REAL; ",
                                       "i(RUN := run, R1 := r1, XIN := 2.5, X0 := 7.0, CYCLE := T#4s); q := i.Q; x := "
                                       "i.XOUT;");
  const LibraryInputs inputs = {{"run", {1, 1, 0, 1, 1}}, {"r1", {0, 0, 0, 1, 0}}};
  EXPECT_EQ(IecRun(text, 10, inSeconds).follow("x", inputs), (Row{10, 20, 20, 7, 17}));
  EXPECT_EQ(IecRun(text, 10, inSeconds).follow("q", inputs), (Row{1, 1, 1, 0, 1}));
  // In milliseconds 2.5 * 4000.
  EXPECT_EQ(IecRun(text).follow("x", {{"run", {1}}}), (Row{10000}));
}

// XIN 0 while it stands; then 20 in each call of 1 s: (3 * 20 + 0 - 0) / 10 = 6; (60 + 20 - 0) / 10 = 8; (60 + 20 - 20)
// / 10 = 6; X3 is 20 then: (0 + 20 - 20) / 10 = 0.
TEST(IecLibrary, ADerivativeOfAStep) {
  const std::string text = programWith("run : BOOL; x : INT; END_VAR VAR d : DERIVATIVE; y : REAL; ",
                                       "d(RUN := run, XIN := INT_TO_REAL(x), CYCLE := T#1s); y := d.XOUT;");
  EXPECT_EQ(IecRun(text, 10, inSeconds).follow("y", {{"run", {0, 1, 1, 1, 1}}, {"x", {0, 20, 20, 20, 20}}}),
            (Row{0, 6, 8, 6, 0}));
}

// ERROR = 3 - 1 = 2. By hand: ITERM = TR * (X0 - ERROR) = 4 * (10 - 2) = 32, so XOUT = KP * (2 + 32 / 4) = KP * X0
// = 20. Running with 1 s: ITERM 34, DTERM from X1..X3 = 2: (0 + 2 - 2) / 10 = 0; XOUT = 2 * (2 + 34 / 4) = 21.
TEST(IecLibrary, ARegulatorGoesOnFromTheValueByHand) {
  const std::string text = programWith(
      "auto : BOOL; END_VAR VAR c : PID; y : REAL; ",
      "c(AUTO := auto, PV := 3.0, SP := 1.0, X0 := 10.0, KP := 2.0, TR := 4.0, TD := 5.0, CYCLE := T#1s); y := "
      "c.XOUT;");
  EXPECT_EQ(IecRun(text, 10, inSeconds).follow("y", {{"auto", {0, 1}}}), (Row{20, 21}));
}

// From 10 to 30 in 4 s with calls of 1 s: 10, 15, 20, 25, then 30 and no longer busy.
TEST(IecLibrary, ARampTakesItsTime) {
  const std::string text =
      programWith("run : BOOL; END_VAR VAR r : RAMP; b : BOOL; x : REAL; ",
                  "r(RUN := run, X0 := 10.0, X1 := 30.0, TR := T#4s, CYCLE := T#1s); b := r.BUSY; x := r.XOUT;");
  const LibraryInputs inputs = {{"run", {0, 1, 1, 1, 1, 1, 1, 0}}};
  for (const IecChoices& choices : {IecChoices{}, inSeconds}) {
    EXPECT_EQ(IecRun(text, 10, choices).follow("x", inputs), (Row{10, 10, 15, 20, 25, 30, 30, 10}));
    EXPECT_EQ(IecRun(text, 10, choices).follow("b", inputs), (Row{0, 1, 1, 1, 1, 0, 0, 0}));
  }
}

TEST(IecLibrary, AClockBeginsWithWhatItIsSetToAndDoesNotGoBack) {
  const std::string text =
      "//@ prove q: c.Q = in\n//@ prove set: in and (first_scan or not prev(in)) implies c.CDT = 86400\n"
      "//@ prove forward: in and not first_scan and prev(in) implies c.CDT >= prev(c.CDT)\n"
      "//@ prove stands: in implies c.CDT = 86400\n"
      "PROGRAM p\nVAR in AT %IX0.0 : BOOL; c : RTC; END_VAR\nc(IN := in, PDT := "
      "DT#1970-01-02-00:00:00);\nEND_PROGRAM\n";
  const IecOutput output = proofOfIec(text);
  for (const char* part : {"PROVED  q", "PROVED  set", "PROVED  forward", "VIOLATED  stands"})
    EXPECT_TRUE(output.has(part)) << part << "\n" << output.text;
}

// CODESYS calls these inputs otherwise.
TEST(IecLibrary, InputsHaveASecondName) {
  const std::string text =
      "//@ prove latch: l.Q1 = ((a or not first_scan and prev(l.Q1)) and not b)\n//@ prove zero: b implies c.CV = 0\n"
      "//@ prove load: b implies d.CV = 7\n"
      "PROGRAM p\nVAR a AT %IX0.0 : BOOL; b AT %IX0.1 : BOOL; l : RS; s : SR; c : CTU; d : CTD; e : CTUD_DINT; q : "
      "BOOL;\n"
      "END_VAR\nl(SET := a, RESET1 := b); s(SET1 := a, RESET := b); c(CU := a, RESET := b, PV := 3);\n"
      "d(CD := a, LOAD := b, PV := 7); e.RESET := b; e(CU := a, LOAD := b, PV := 7); q := c.RESET;\nEND_PROGRAM\n";
  const IecOutput output = proofOfIec(text);
  for (const char* part : {"PROVED  latch", "PROVED  zero", "PROVED  load"})
    EXPECT_TRUE(output.has(part)) << part << "\n" << output.text;
  EXPECT_TRUE(proofOfIec("PROGRAM p\nVAR t : TON; END_VAR\nt(RESET := TRUE);\nEND_PROGRAM\n")
                  .has("block TON has no input RESET"));
}

// 2024-01-01 is 1704067200 s behind 1970; LTIME counts ns; TIME and TOD ms. Sums of constants are what sums of
// variables are.
TEST(IecLibrary, SumsOfConstantsOfDifferentUnits) {
  const std::string text =
      "PROGRAM p\nVAR i : BOOL; d : DT; l : LTIME; t : TIME; e : TOD; END_VAR\n"
      "d := DT#2024-01-01-00:00:00 + T#1s; l := LT#1s + T#1s; t := TOD#01:01:30 - TOD#01:00:00; e := TOD#01:00:00 + "
      "T#30m;\nEND_PROGRAM\n";
  const auto after = [&](const char* name) { return IecRun(text).follow(name, {{"i", {0}}})[0]; };
  EXPECT_EQ(after("d"), 1704067201);
  EXPECT_EQ(after("l"), 2'000'000'000);
  EXPECT_EQ(after("t"), 90'000);
  EXPECT_EQ(after("e"), 5'400'000);
}

}  // namespace
}  // namespace rungproof
