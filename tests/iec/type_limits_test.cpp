// Values that a type does not have: what comes from outside without an address and what is kept over the loss of power
// is a value of its type. Where the program itself or an address gives the value, it can be any pattern.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

const std::string modes = "TYPE Mode : (Off, Hand, Auto); Gap : (Low := 1, High := 5); END_TYPE\n";

std::string limitedProgram(const std::string& declarations, const std::string& statements,
                           const std::string& properties) {
  return modes + "PROGRAM main\n" + declarations + "\n" + properties + "\n" + statements + "\nEND_PROGRAM\n";
}

TEST(TypeLimits, InputsHaveAValueOfTheirType) {
  // Off is 0 and Auto is 2; Gap has the values 1 and 5 alone; a day has 86,400,000 ms.
  const IecOutput output = proofOfIec(limitedProgram(
      "VAR_INPUT m : Mode; g : Gap; p : INT (-5..10); t : TOD; END_VAR VAR a, b, c : DINT; END_VAR",
      "a := TO_DINT(m); b := TO_DINT(g); c := p;",
      "//@ prove mode: a >= 0 and a <= 2\n//@ prove gap: b = 1 or b = 5\n//@ prove part: c >= -5 and c <= 10\n"
      "//@ prove day: t >= 0 and t < 86400000\n//@ reach last: a = 2\n//@ reach low: c = -5"));
  for (const char* const name : {"mode", "gap", "part", "day"})
    EXPECT_TRUE(output.has(std::string("PROVED  ") + name)) << output.text;
  EXPECT_TRUE(output.has("REACHABLE  last") && output.has("REACHABLE  low")) << output.text;
  // The verdicts rest on it, so the report says it.
  EXPECT_TRUE(output.has("assume type_of_m: m >= 0 and m <= 2")) << output.text;
  EXPECT_TRUE(output.has("assume type_of_g: g = 1 or g = 5")) << output.text;
}

TEST(TypeLimits, AnAddressGivesAnyPattern) {
  const IecOutput output =
      proofOfIec(limitedProgram("VAR p AT %IW0 : INT (0..10); c : INT; END_VAR", "c := p;", "//@ prove part: c <= 10"));
  EXPECT_TRUE(output.has("VIOLATED  part")) << output.text;
}

TEST(TypeLimits, WhatTheProgramWritesIsNotAssumed) {  // p is 11 at the end of each scan
  const IecOutput output = proofOfIec(limitedProgram("VAR_INPUT p : INT (0..10); x : INT; END_VAR VAR c : INT; END_VAR",
                                                     "p := x; c := p;", "//@ prove part: c <= 10"),
                                      {"--choice", "iec-subrange=stored"});
  EXPECT_TRUE(output.has("VIOLATED  part")) << output.text;
}

TEST(TypeLimits, KeptValuesAreOfTheirType) {
  const IecOutput output = proofOfIec(limitedProgram(
      "VAR_INPUT x : BOOL; END_VAR VAR RETAIN m : Mode; p : INT (3..10); n : INT; END_VAR VAR a : INT; END_VAR",
      "CASE m OF Off: a := 1; Hand: a := 2; Auto: a := 3; ELSE a := 9; END_CASE;",
      "//@ initial retentive\n//@ prove known: a <> 9\n//@ prove part: p >= 3\n//@ prove open: n >= 3\n"
      "//@ reach hand: a = 2"));
  EXPECT_TRUE(output.has("PROVED  known") && output.has("PROVED  part")) << output.text;
  EXPECT_TRUE(output.has("VIOLATED  open") && output.has("REACHABLE  hand")) << output.text;
}

TEST(TypeLimits, LaterValuesMayLieOutside) {  // only the start is of the type: by the reading `stored` p grows on
  const IecOutput output = proofOfIec(limitedProgram("VAR RETAIN p : INT (3..10); END_VAR", "p := p + 1;",
                                                     "//@ initial retentive\n//@ prove part: p <= 10"),
                                      {"--choice", "iec-subrange=stored"});
  EXPECT_TRUE(output.has("VIOLATED  part")) << output.text;
}

TEST(TypeLimits, AStateThatStepsThroughItsNamesIsKeptInThem) {
  const IecOutput output = proofOfIec(limitedProgram(
      "VAR_INPUT go : BOOL; END_VAR VAR RETAIN m : Mode; END_VAR VAR next : Mode; lost : BOOL; END_VAR",
      "lost := FALSE;\nCASE m OF Off: IF go THEN next := Hand; END_IF; Hand: next := Auto; Auto: next := "
      "Off; ELSE lost := TRUE; END_CASE;\nm := next;",
      "//@ initial retentive\n//@ prove known: not lost"));
  EXPECT_TRUE(output.has("PROVED  known")) << output.text;
}

// A value outside was stored in an earlier run, and is kept over the loss of power.
TEST(TypeLimits, WhatWasStoredOutsideIsKept) {
  const IecOutput stored = proofOfIec(
      limitedProgram("VAR_INPUT x : INT; END_VAR VAR RETAIN p : INT (3..10); END_VAR VAR q : BOOL; END_VAR",
                     "q := p > 10; p := x;", "//@ initial retentive\n//@ prove first: first_scan implies not q"),
      {"--choice", "iec-subrange=stored"});
  EXPECT_TRUE(stored.has("VIOLATED  first")) << stored.text;
}

TEST(TypeLimits, CopiesOfWhatComesFromOutsideAreKeptAsTheyCame) {
  const auto program = [](const std::string& before) {
    return limitedProgram("VAR n : Mode; q : BOOL; END_VAR VAR RETAIN m : Mode; END_VAR",
                          "q := m <> Off AND m <> Hand AND m <> Auto; m := n;",
                          before + "//@ initial retentive\n//@ prove first: first_scan implies not q");
  };
  EXPECT_TRUE(proofOfIec(program("//@ external n\n")).has("VIOLATED  first"));
  EXPECT_TRUE(proofOfIec(program("")).has("PROVED  first"));
}

// A statement with the number is refused, and so is a declaration: its bits are another number. Those from 32768
// to 65535 are told as patterns of an INT.
TEST(TypeLimits, AnInitialValueFitsIntoItsType) {
  const std::pair<std::string, std::string> wrong[] = {
      {"VAR n : INT := 65536; END_VAR", "65536 does not fit into INT"},
      {"VAR n : SINT := -129; END_VAR", "-129 does not fit into SINT"},
      {"VAR n : USINT := 256; END_VAR", "256 does not fit into USINT"},
      {"VAR n : UDINT := -1; END_VAR", "-1 does not fit into UDINT"},
      {"VAR n : ULINT := -1; END_VAR", "-1 does not fit into ULINT"},
      {"VAR n : BYTE := 16#100; END_VAR", "256 does not fit into BYTE"},
      {"VAR n : INT := 1.5; END_VAR", "a REAL number does not fit into INT"},
      {"VAR n : BOOL := 2; END_VAR", "2 is no BOOL"},
      {"VAR n : TIME := 5; END_VAR", "a duration is written T#5s"},
      {"VAR CONSTANT n : USINT := 300; END_VAR", "300 does not fit into USINT"},
      {"VAR RETAIN n : INT := 70000; END_VAR", "70000 does not fit into INT"},
      {"VAR n : ARRAY [0..2] OF SINT := [1, 2(256)]; END_VAR", "256 does not fit into SINT"},
      {"VAR n : Pair := (first := 300); END_VAR", "300 does not fit into USINT"},
      {"VAR n : Bad; END_VAR", "256 does not fit into USINT"},
      {"VAR n : INT (0..10) := 11; END_VAR", "11 is not within 0..10"},
      {"VAR n : CTU := (PV := 65536); END_VAR", "65536 does not fit into INT"}};
  const std::string types =
      "TYPE Pair : STRUCT first : USINT; END_STRUCT; Bad : STRUCT first : USINT := 256; END_STRUCT; END_TYPE\n";
  for (const auto& [declaration, message] : wrong) {
    const IecOutput output =
        proofOfIec("//@ prove p: q\n" + types + iecProgram(declaration + " VAR q : BOOL; END_VAR", "q := TRUE;"));
    EXPECT_TRUE(output.has(message) && output.exit == 2) << declaration << "\n" << output.text;
  }
  // The ends of the types themselves fit.
  const std::string right =
      "VAR a : INT := -32768; b : USINT := 255; c : ULINT := 18446744073709551615; d : LINT := -9223372036854775808; "
      "e : INT (0..10) := 10; f : BOOL := 1; g : TIME := T#0s; h : TIME := 0; i : REAL := 3; k : BYTE := 16#FF; "
      "END_VAR";
  EXPECT_EQ(findingsIec(readIecText(types + iecProgram(right, "f := TRUE;"))), "");
}

// The value that an input of a function has where a call leaves it out.
TEST(TypeLimits, ADefaultOfAFunctionFitsIntoItsType) {
  const std::string add =
      "FUNCTION Add : INT\nVAR_INPUT x : INT; y : SINT := 300; END_VAR\nAdd := x + y;\nEND_FUNCTION\n";
  const IecOutput output =
      proofOfIec("//@ prove p: n = 1\n" + add + iecProgram("VAR n : INT; END_VAR", "n := Add(x := 1);"));
  EXPECT_TRUE(output.has("300 does not fit into SINT") && !output.has("PROVED")) << output.text;
}

}  // namespace
}  // namespace rungproof
