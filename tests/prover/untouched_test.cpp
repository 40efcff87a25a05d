// Addresses that nothing writes, and external ranges to the bit.
#include <gtest/gtest.h>

#include "tests/prover/proved_text.hpp"

namespace rungproof {
namespace {

using test::hasNote;
using test::inputOf;
using test::outcomeOf;
using test::resultNamed;
using test::usualOptions;

ProofRun runOf(const std::string& properties, const std::string& networks) {
  const ProgramInput input = inputOf(properties, networks);
  return prove(input.program, input.properties, usualOptions());
}

/// Memory is zero at the start (the default environment), so nothing but a writer can set it.
TEST(Untouched, APropertyOverAnAddressThatNothingWritesSaysSo) {
  const ProofRun run = runOf(
      "//@ prove typo: never M9.0\n//@ reach lamp: Q0.7\n//@ prove pair: never Q0.0 and M9.0\n"
      "//@ prove real: never Q0.0 and Q0.1\n//@ prove word: VW200 < 5\n//@ prove timer: never T40\n",
      "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\nAN Q0.0\n= Q0.1\n");
  EXPECT_EQ(outcomeOf(run, "typo"), Outcome::Vacuous);
  EXPECT_TRUE(hasNote(*resultNamed(run, "typo"), "no instruction writes M9.0"));
  EXPECT_EQ(outcomeOf(run, "lamp"), Outcome::Unreachable);
  EXPECT_TRUE(hasNote(*resultNamed(run, "lamp"), "no instruction writes Q0.7"));
  EXPECT_EQ(outcomeOf(run, "pair"), Outcome::Vacuous);
  EXPECT_EQ(outcomeOf(run, "real"), Outcome::Proved);
  EXPECT_FALSE(hasNote(*resultNamed(run, "real"), "no instruction writes"));
  EXPECT_EQ(outcomeOf(run, "word"), Outcome::Vacuous);
  EXPECT_EQ(outcomeOf(run, "timer"), Outcome::Vacuous);
}

/// The program decides it although one of its addresses is never written: no run has Q0.0 and not Q0.1.
TEST(Untouched, WhatTheProgramDecidesIsNotVacuous) {
  const ProofRun run = runOf("//@ prove p: Q0.0 and not M9.0 implies Q0.1\n",
                             "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD Q0.0\n= Q0.1\n");
  EXPECT_EQ(outcomeOf(run, "p"), Outcome::Proved);
  EXPECT_TRUE(hasNote(*resultNamed(run, "p"), "no instruction writes M9.0"));
}

/// An FB writes its instance, an open block and what its caller gives; nobody writes DB3.DBX2.1 and M9.0.
TEST(Untouched, DataBlocksAreWrittenThroughRegisters) {
  const ProgramInput input = test::inputOfSource(
      "FUNCTION_BLOCK FB 1\nVAR_INPUT x : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\nVAR n : INT; END_VAR\nBEGIN\n"
      "NETWORK\nA #x; = #y;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 3 FB 1\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 4\n"
      "STRUCT a : BOOL; END_STRUCT\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n//@ prove a: DB3.DBX2.0 implies "
      "I0.0\n//@ prove b: DB4.DBX0.0 implies I0.1\n//@ prove c: Q0.0 implies I0.0\n//@ prove d: never M9.0\nBEGIN\n"
      "NETWORK\nCALL FB 1, DB 3 (x := I 0.0, y := Q 0.0);\nOPN DB 4;\nA I 0.1;\n= DBX 0.0;\nEND_ORGANIZATION_BLOCK\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  for (const char* name : {"a", "b", "c"}) {
    EXPECT_EQ(outcomeOf(run, name), Outcome::Proved) << name;
    EXPECT_FALSE(hasNote(*resultNamed(run, name), "no instruction writes")) << name;
  }
  EXPECT_TRUE(hasNote(*resultNamed(run, "d"), "no instruction writes M9.0"));
}

TEST(Untouched, InputsSystemBitsBuffersAndExternalsHaveTheirWriters) {
  const ProofRun run = runOf(
      "//@ external VW300\n//@ reach a: I5.0\n//@ reach b: SM0.5\n//@ reach c: VW300 = 7\n//@ reach d: AIW4 = 9\n"
      "//@ reach e: VB1 = 1\n//@ reach f: VB403 = 3\n",
      "Network 1\nLD I0.0\nMOVW 257, VW0\nLDW> AIW4, 3\n= Q0.0\nNetwork 2\nLD I0.0\nTODR VB400\n");
  for (const char* name : {"a", "b", "c", "d", "e", "f"})
    EXPECT_FALSE(hasNote(*resultNamed(run, name), "no instruction writes")) << name;
}

/// `external V300.4` frees that bit and no other, in the encoder and in the run that repeats a counterexample.
TEST(External, ABitIsNotItsByte) {
  const std::string networks = "Network 1\nLD V300.4\nO V300.5\n= Q0.0\nNetwork 2\nLDB> VB300, 16\n= Q0.1\n";
  const ProofRun run = runOf(
      "//@ external V300.4\n//@ prove free: never V300.4\n//@ reach on: Q0.0\n//@ reach beside: V300.5\n"
      "//@ prove others: VB300 = 0 or VB300 = 16\n//@ prove output: never Q0.1\n",
      networks);
  EXPECT_EQ(outcomeOf(run, "free"), Outcome::Violated);
  EXPECT_EQ(outcomeOf(run, "on"), Outcome::Reachable);
  EXPECT_EQ(outcomeOf(run, "beside"), Outcome::Unreachable);
  EXPECT_EQ(outcomeOf(run, "others"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "output"), Outcome::Proved);
}

TEST(External, ARangeOfBitsBeginsAndEndsInsideItsBytes) {
  const ProofRun run = runOf(
      "//@ external V300.6..V301.1\n//@ reach a: V300.6\n//@ reach b: V301.1\n//@ reach c: V300.5\n//@ reach d: "
      "V301.2\n"
      "//@ prove word: VW300 = 0 or VB300 >= 64 or VB301 > 0\n",
      "Network 1\nLDW> VW300, 0\n= Q0.0\n");
  EXPECT_EQ(outcomeOf(run, "a"), Outcome::Reachable);
  EXPECT_EQ(outcomeOf(run, "b"), Outcome::Reachable);
  EXPECT_EQ(outcomeOf(run, "c"), Outcome::Unreachable);
  EXPECT_EQ(outcomeOf(run, "d"), Outcome::Unreachable);
}

/// A word of the program that lies half inside the range: VB299 stays what the program made it.
TEST(External, ARangeInsideADoubleWordOfTheProgram) {
  const ProofRun run =
      runOf("//@ external VW300\n//@ reach in: VB301 = 9\n//@ reach before: VB299 = 9\n//@ reach after: VB302 = 9\n",
            "Network 1\nLDD> VD298, 0\n= Q0.0\nNetwork 2\nLDD> VD300, 0\n= Q0.1\n");
  EXPECT_EQ(outcomeOf(run, "in"), Outcome::Reachable);
  EXPECT_EQ(outcomeOf(run, "before"), Outcome::Unreachable);
  EXPECT_EQ(outcomeOf(run, "after"), Outcome::Unreachable);
}

TEST(External, OnlyMemoryCanBeWrittenFromOutside) {
  for (const char* range : {"T37", "C1", "AC0", "HC0", "LB3", "VB9..VB3"}) {
    Program program = readText("t.awl", std::string("//@ external ") + range + "\nNetwork 1\nLD I0.0\n= Q0.0\n");
    readProperties(program, {}, lookupIn(program));
    ASSERT_EQ(program.findings.size(), 1U) << range;
    EXPECT_TRUE(program.findings[0].rule.starts_with("PRP")) << range;
  }
}

}  // namespace
}  // namespace rungproof
