// Verdicts on programs of IEC 61131-3: what is free, what open points do to a verdict, what is not covered. The reason
// stands beside each.
#include <map>

#include "analysis/selfcheck/self_check.hpp"
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

std::string program(const std::string& declarations, const std::string& statements, const std::string& properties) {
  return "PROGRAM main\n" + declarations + "\n" + properties + "\n" + statements + "\nEND_PROGRAM\n";
}

TEST(IecProve, InputsOfAProgramAreFree) {
  const IecOutput output =
      proofOfIec(program("VAR_INPUT x : BOOL; END_VAR VAR q : BOOL; END_VAR", "q := x;", "//@ prove stays: not q"));
  EXPECT_TRUE(output.has("VIOLATED  stays")) << output.text;
  EXPECT_TRUE(output.has("assumes: x has any value in every scan")) << output.text;
  EXPECT_EQ(output.exit, 1);
}

TEST(IecProve, LocatedInputsAndGlobalsThatNobodyWritesAreFree) {
  const IecOutput output = proofOfIec(
      "CONFIGURATION c VAR_GLOBAL panel : INT; kept : INT := 5; END_VAR\nRESOURCE r ON PLC\nTASK t(INTERVAL := T#20ms, "
      "PRIORITY := 1);\n"
      "PROGRAM p WITH t : main;\nEND_RESOURCE\nEND_CONFIGURATION\n" +
      program("VAR_EXTERNAL panel, kept : INT; END_VAR VAR i AT %IX0.3 : BOOL; q AT %QX0.0 : BOOL; n, m : INT; END_VAR",
              "q := i; n := panel; m := kept;",
              "//@ prove off: not %QX0.0\n//@ prove zero: n = 0\n//@ prove five: m = 5 or first_scan"));
  EXPECT_TRUE(output.has("VIOLATED  off") && output.has("VIOLATED  zero") && output.has("PROVED  five")) << output.text;
  EXPECT_TRUE(output.has("every scan lasts 20 ms")) << output.text;  // the interval of the task
}

TEST(IecProve, StateIsNotFree) {  // q starts FALSE, and nothing sets it
  EXPECT_TRUE(proofOfIec(program("VAR q : BOOL; END_VAR", "q := q;", "//@ prove stays: not q")).has("PROVED  stays"));
}

TEST(IecProve, ADivisionByZeroEndsTheScanOrGivesZero) {
  const std::string text = program("VAR_INPUT x : INT; END_VAR VAR y : INT; z : BOOL; END_VAR",
                                   "y := 10 / x; z := x = 0;", "//@ prove never zero: not z");
  const IecOutput both = proofOfIec(text);
  EXPECT_TRUE(both.has("VIOLATED  never zero") && both.has("iec-div-zero")) << both.text;  // the reading "zero" goes on
  const IecOutput fault = proofOfIec(text, {"--choice", "iec-div-zero=fault"});
  EXPECT_TRUE(fault.has("PROVED  never zero")) << fault.text;  // where x is 0 the scan has no end
}

TEST(IecProve, TheRightSideOfAndMayBeComputedOrNot) {  // with x = 0: no division by the reading "yes"
  const std::string text =
      program("VAR_INPUT x : INT; END_VAR VAR q, z : BOOL; END_VAR", "q := x <> 0 AND 10 / x > 2; z := x = 0;",
              "//@ prove never zero: not z\n//@ prove three: q implies x > 0 and x < 4");
  EXPECT_TRUE(proofOfIec(text, {"--choice", "iec-div-zero=fault"}).has("VIOLATED  never zero"));
  EXPECT_TRUE(proofOfIec(text, {"--choice", "iec-div-zero=fault", "--choice", "iec-short-circuit=no"})
                  .has("PROVED  never zero"));
  EXPECT_TRUE(proofOfIec(text).has("PROVED  three"));
}

TEST(IecProve, CountersStopAtThePresetOrAtTheEndOfTheType) {
  const std::string text =
      program("VAR_INPUT u : BOOL; END_VAR VAR c : CTU; END_VAR", "c(CU := u, R := FALSE, PV := 2);",
              "//@ prove two: c.CV <= 2\n//@ prove reached: c.Q implies c.CV >= 2");
  EXPECT_TRUE(proofOfIec(text).has("VIOLATED  two"));
  EXPECT_TRUE(proofOfIec(text).has("PROVED  reached"));
  EXPECT_TRUE(proofOfIec(text, {"--choice", "iec-counter-limit=preset"}).has("PROVED  two"));
}

TEST(IecProve, TimersCountMilliseconds) {  // at a scan of 10 ms, 50 ms have passed when the sixth scan begins
  const std::string text =
      program("VAR_INPUT i : BOOL; p : TIME; END_VAR VAR t : TON; v : TON; END_VAR",
              "t(IN := i, PT := T#50ms); v(IN := i, PT := p);",
              "//@ prove soon: i held 50ms implies t.Q\n//@ prove not sooner: t.Q implies held(i, 50ms)\n"
              "//@ prove elapsed: t.ET >= 0 and t.ET <= 50\n//@ reach own preset: v.Q and p = 30");
  const IecOutput output = proofOfIec(text, {"--scan-time", "10ms"});
  EXPECT_TRUE(output.has("PROVED  soon") && output.has("PROVED  not sooner") && output.has("PROVED  elapsed"))
      << output.text;
  EXPECT_TRUE(output.has("REACHABLE  own preset")) << output.text;
}

TEST(IecProve, NumbersAreMeantAsTheyAreDeclared) {
  const IecOutput output = proofOfIec(
      program("VAR_INPUT u : UINT; s : SINT; d : UDINT; r : REAL; END_VAR VAR q : BOOL; END_VAR", "q := u > 40000;",
              "//@ prove word: q implies u > 40000\n//@ prove small: u >= 0 and u <= 65535\n"
              "//@ reach minus: s = -128\n//@ prove byte: s < 128\n//@ prove long: d >= 0\n//@ reach half: r = 0.5"));
  for (const char* const part :
       {"PROVED  word", "PROVED  small", "REACHABLE  minus", "PROVED  byte", "PROVED  long", "REACHABLE  half"})
    EXPECT_TRUE(output.has(part)) << part << "\n" << output.text;
}

TEST(IecProve, WhatWasNotReadIsNotCovered) {
  const IecOutput output = proofOfIec(program("VAR q, r : BOOL; s : WSTRING; END_VAR",
                                              "q := FALSE;\ns := \"x\";\nr := unknown;", "//@ prove off: not q"));
  EXPECT_TRUE(output.has("NOT COVERED  off")) << output.text;
  EXPECT_EQ(output.exit, 2);
  EXPECT_TRUE(proofOfIec("PROGRAM main VAR q : BOOL; END_VAR\n//@ prove off: not q\nLD q\nFROB\nST q\nEND_PROGRAM\n")
                  .has("NOT COVERED  off"));
}

TEST(IecProve, ALoopThatMayNotEndIsNoScan) {  // i never reaches 3 where x is TRUE: that scan has no end
  const IecOutput output = proofOfIec(
      program("VAR_INPUT x : BOOL; END_VAR VAR i : INT; q : BOOL; END_VAR",
              "i := 0; WHILE i < 3 DO IF NOT x THEN i := i + 1; END_IF; END_WHILE; q := x;", "//@ prove ends: not q"));
  EXPECT_FALSE(output.has("VIOLATED  ends")) << output.text;
}

TEST(IecProve, ProofsCarryCertificates) {
  const test::TemporaryFolder folder;
  folder.file("main.st", program("VAR_INPUT a, b : BOOL; END_VAR VAR m : BOOL; END_VAR", "m := (a OR m) AND b;",
                                 "//@ prove needs b: m implies b"));
  std::istringstream in;
  std::ostringstream out, err;
  EXPECT_EQ(runProgram({"prove", folder.path("main.st"), "--certificate", folder.path("proofs"), "--isolated"},
                       {in, out, err}),
            0);
  EXPECT_TRUE(std::filesystem::exists(folder.path("proofs/needs_b.smt2"))) << out.str() << err.str();
}

TEST(IecProve, RetainedVariablesMayStartWithAnyValue) {  // after a power cycle, by `initial retentive`
  const std::string text =
      program("VAR RETAIN n : INT; END_VAR VAR m : INT; t : BOOL; END_VAR VAR_INPUT x : BOOL; END_VAR", "t := x;",
              "//@ initial retentive\n//@ prove kept: n = 0\n//@ prove other: m = 0");
  const IecOutput output = proofOfIec(text);
  EXPECT_TRUE(output.has("VIOLATED  kept") && output.has("PROVED  other")) << output.text;
}

TEST(IecProve, WitnessesRepeat) {
  const test::TemporaryFolder folder;
  folder.file("main.st",
              program("VAR_INPUT a : BOOL; n : INT; END_VAR VAR t : TON; s : INT; END_VAR",
                      "t(IN := a, PT := T#70ms); IF t.Q THEN s := s + n; END_IF;", "//@ prove never: s <> 12"));
  std::istringstream in;
  std::ostringstream out, err;
  EXPECT_EQ(
      runProgram({"prove", folder.path("main.st"), "--traces", folder.path("runs"), "--isolated"}, {in, out, err}), 1);
  std::ostringstream again, errors;
  EXPECT_EQ(runProgram({"sim", folder.path("main.st"), "--stimulus", folder.path("runs/never.csv"), "--expect",
                        folder.path("runs/never.csv"), "--isolated"},
                       {in, again, errors}),
            0)
      << again.str() << errors.str();
}

/// Faults of a program with their fates, as "kind: text".
std::map<std::string, FaultResult> plantedInto(const std::string& text) {
  Program program = readIecText(text);
  const PropertySet set = readProperties(program, {}, lookupIn(program));
  SelfCheckOptions options;
  options.prover.timeout = 30;
  options.prover.time = {100, 100};
  options.seconds = 30;
  options.prover.jobs = 1;
  const ProofRun before = prove(program, set, options.prover);
  std::map<std::string, FaultResult> fates;
  for (const FaultResult& result : selfCheck(program, set, before.results, options).results)
    fates.emplace(fmt::format("{}: {}", faultKindName(result.fault.kind), result.fault.text), result);
  return fates;
}

// The property speaks of stop alone. Two FALSE for `spare` change nothing: it is in series with itself.
TEST(IecSelfCheck, TellsWhatThePropertiesNotice) {
  const std::map<std::string, FaultResult> faults = plantedInto(
      "//@ prove stop: stop implies not motor\nPROGRAM p\nVAR_INPUT start, stop, spare : BOOL; END_VAR\n"
      "VAR_OUTPUT motor, lamp : BOOL; END_VAR\nmotor := (start OR motor) AND NOT stop;\n"
      "lamp := spare AND spare;\nEND_PROGRAM\n");
  const auto fate = [&](const std::string& name) {
    const auto found = faults.find(name);
    EXPECT_NE(found, faults.end()) << name;
    return found == faults.end() ? FaultFate::Undecided : found->second.fate;
  };
  EXPECT_EQ(fate("contact polarity: NOT stop for stop"), FaultFate::Noticed);
  EXPECT_EQ(faults.at("contact polarity: NOT stop for stop").noticedBy, "stop");
  EXPECT_EQ(fate("removed contact: stop"), FaultFate::Noticed);  // NOT stop becomes TRUE
  EXPECT_EQ(fate("contact polarity: NOT start for start"), FaultFate::Unnoticed);
  EXPECT_EQ(faults.at("contact polarity: NOT start for start").where.find("motor in scan "), 0U);
  EXPECT_EQ(fate("removed contact: start"), FaultFate::Unnoticed);
  EXPECT_EQ(fate("removed contact: spare"), FaultFate::NoEffect);
  EXPECT_EQ(fate("connective: AND for OR"), FaultFate::Unnoticed);
  EXPECT_EQ(fate("connective: OR for AND"), FaultFate::Noticed);
  EXPECT_EQ(fate("swapped networks: statements 1 and 2 in the other order"), FaultFate::NoEffect);
}

// Numbers are halved and doubled, TRUE and FALSE that are assigned change places; blocks of the standard stay whole.
TEST(IecSelfCheck, PlantsIntoNumbersAndAssignments) {
  const std::map<std::string, FaultResult> faults = plantedInto(
      "//@ prove late: lamp implies held(run, 1500ms)\nPROGRAM p\nVAR_INPUT run : BOOL; END_VAR\n"
      "VAR_OUTPUT lamp : BOOL; END_VAR\nVAR t : TON; END_VAR\nt(IN := run, PT := T#2s);\n"
      "IF t.Q THEN lamp := TRUE; ELSE lamp := FALSE; END_IF;\nEND_PROGRAM\n");
  const auto fate = [&](const std::string& name) {
    const auto found = faults.find(name);
    EXPECT_NE(found, faults.end()) << name;
    return found == faults.end() ? FaultFate::Undecided : found->second.fate;
  };
  EXPECT_EQ(fate("preset: 1000 for 2000"), FaultFate::Noticed);
  EXPECT_EQ(fate("preset: 4000 for 2000"), FaultFate::Unnoticed);
  EXPECT_EQ(fate("set for reset: lamp := TRUE for lamp := FALSE"), FaultFate::Noticed);
  EXPECT_EQ(fate("set for reset: lamp := FALSE for lamp := TRUE"), FaultFate::Noticed);  // the lamp is never on
  for (const auto& [name, result] : faults) EXPECT_EQ(name.find("ELAPSED"), std::string::npos) << name;
}

TEST(IecSelfCheck, NeedsAnOutput) {
  const IecOutput output = proofOfIec(
      "//@ prove p: never q\nPROGRAM p\nVAR q : BOOL; END_VAR\nq := FALSE;\nEND_PROGRAM\n", {"--self-check"});
  EXPECT_TRUE(output.has("no faults are planted: the program has no output")) << output.text;
}

/// What does not fit has any value (spec of conversions): the run that shows it is repeated, and what fits is exact.
TEST(IecProve, AConversionThatDoesNotFitHasAnyValue) {
  const auto program = [](const std::string& from, const std::string& to, const std::string& call) {
    return "PROGRAM P\nVAR_INPUT r : " + from + "; END_VAR\nVAR x : " + to + "; END_VAR\nx := " + call +
           ";\nEND_PROGRAM\n";
  };
  struct Row {
    std::string from, to, call, beyond, inside;
  };
  const std::vector<Row> rows = {
      {"REAL", "INT", "REAL_TO_INT(r)", "40000.0", "r = 7.0 implies x = 7"},
      {"REAL", "UINT", "REAL_TO_UINT(r)", "70000.0", "r = 7.0 implies x = 7"},
      {"REAL", "SINT", "REAL_TO_SINT(r)", "300.0", "r = 7.0 implies x = 7"},
      {"REAL", "DINT", "REAL_TO_DINT(r)", "3000000000.0", "r = 7.0 implies x = 7"},
      {"REAL", "DINT", "TRUNC(r)", "3000000000.0", "r = 7.5 implies x = 7"},
      {"REAL", "TIME", "REAL_TO_TIME(r)", "3000000000.0", "r = 0.0 implies x = 0"},
  };
  for (const Row& row : rows) {
    const std::string text = program(row.from, row.to, row.call);
    EXPECT_EQ(verdictOf(text, "r > " + row.beyond + " implies x = 5"), "VIOLATED") << row.call;
    EXPECT_EQ(verdictOf(text, "r > " + row.beyond + " implies x <> 5"), "VIOLATED") << row.call;
    EXPECT_EQ(verdictOf(text, row.inside), "PROVED") << row.call;
  }
}

/// 16#FF beside an SINT is its bit pattern, -1, as 16#FFFF is beside an INT; unsigned numbers are what they are.
TEST(IecProve, HexadecimalNumbersArePatternsOfSignedOnes) {
  const std::string text =
      "PROGRAM P\nVAR s : SINT; i : INT; d : DINT; u : USINT; w : UINT; END_VAR\n"
      "s := -1; i := -1; d := -1; u := 255; w := 65535;\nEND_PROGRAM\n";
  for (const char* property : {"s = 16#FF", "i = 16#FFFF", "d = 16#FFFFFFFF", "u = 16#FF", "w = 16#FFFF", "s < 16#7F"})
    EXPECT_EQ(verdictOf(text, property), "PROVED") << property;
}

}  // namespace
}  // namespace rungproof
