// The stated properties of the worked examples, proved and refuted over statement lists of the S7-300.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/agreement7/ir_of_text.hpp"
#include "tests/naive7/case_table.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::agreement7 {
namespace {

using test::resultNamed;

/// Statements with ; between them as OB1, property lines without //@.
ProofRun proofOf(const std::string& properties, const std::string& statements, const char* s5Time = "synchronous",
                 const std::string& blocks = {}) {
  std::string lines;
  std::istringstream in(statements);
  for (std::string one; std::getline(in, one, ';');) lines += "  " + one + " ;\n";
  std::string faults;
  Program program = irOf(naive7::readProgram(blocks + naive7::organizationBlock(lines)), false, faults);
  EXPECT_EQ(faults, "");
  const std::uint32_t file = program.sources->add("example.awl", properties);
  std::uint32_t offset = 0;
  std::istringstream each(properties);
  for (std::string one; std::getline(each, one);) {
    program.directives.push_back({one, Span{file, offset, static_cast<std::uint32_t>(one.size())}, -1, 0});
    offset += static_cast<std::uint32_t>(one.size()) + 1;
  }
  const PropertySet set = readProperties(program, {}, lookupIn(program));
  for (const Finding& finding : program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  ProverOptions options = test::usualOptions(60);
  options.time.high = 150;  // cycle monitoring of an S7-300
  EXPECT_TRUE(options.choices.set("s5-time", s5Time));
  return prove(program, set, options);
}

/// Outcome of a property and, where a run breaks or reaches it, its scans.
std::string verdict(const ProofRun& run, const std::string& name) {
  const ProofResult* result = resultNamed(run, name);
  if (result == nullptr) return "missing";
  switch (result->outcome) {
    case Outcome::Proved: return "proved";
    case Outcome::Violated: return fmt::format("violated in {}", result->witness ? result->witness->scanCount : 0);
    case Outcome::Reachable: return "reachable";
    case Outcome::Unreachable: return "unreachable";
    default: return "unknown";
  }
}

// 003:572-616, P1 to P3, and P5: with the networks exchanged a held start button beats the stop button.
TEST(Verdicts7, ConveyorBelt) {
  const std::string properties =
      "prove stop: I1.2 or I1.4 or I1.5 implies not Q4.0\n"
      "prove starts: rises(Q4.0) implies I1.1 or I1.3\n"
      "prove keeps: not (I1.1 or I1.3 or I1.2 or I1.4 or I1.5) implies not rises(Q4.0) and not falls(Q4.0)\n";
  const std::string set = "A I 1.1;O I 1.3;S Q 4.0", reset = "A I 1.2;O I 1.4;O I 1.5;R Q 4.0";
  const ProofRun run = proofOf(properties, set + ";" + reset);
  for (const char* name : {"stop", "starts", "keeps"}) EXPECT_EQ(verdict(run, name), "proved") << name;
  EXPECT_EQ(verdict(proofOf(properties, reset + ";" + set), "stop"), "violated in 1");
}

// 003:618-662: both directions after two scans; not if one sensor changes at a time.
TEST(Verdicts7, DirectionOfMotion) {
  const std::string properties =
      "prove apart: never Q4.0 and Q4.1\n"
      "prove free: not I0.0 and not I0.1 implies not Q4.0 and not Q4.1\n"
      "prove left: rises(Q4.1) implies I0.0 and not I0.1\n";
  const std::string statements =
      "A I 0.0;FP M 0.0;AN I 0.1;S Q 4.1;A I 0.1;FP M 0.1;AN I 0.0;S Q 4.0;AN I 0.0;AN I 0.1;R Q 4.0;R Q 4.1";
  const ProofRun run = proofOf(properties, statements);
  EXPECT_EQ(verdict(run, "apart"), "violated in 2");
  EXPECT_EQ(verdict(run, "free"), "proved");
  EXPECT_EQ(verdict(run, "left"), "proved");
  const std::string oneAtATime =
      "assume one at a time: not ((rises(I0.0) or falls(I0.0)) and (rises(I0.1) or falls(I0.1)))\n";
  EXPECT_EQ(verdict(proofOf(oneAtATime + properties, statements), "apart"), "proved");
}

// 003:666-756: which bit network 1 scans decides whether anything is counted; for T1 the reading of the time does.
TEST(Verdicts7, ClockGenerator) {
  const std::string rest = ";L S5T#250MS;SE T 1;A T 1;= M 0.2;A M 0.2;JC n001;SET;= M 0.5;n001: NOP 0";
  const std::string properties = "reach counts: M0.5 and not first_scan\n";
  const std::string fresh = "CLR;= M 0.5;";
  EXPECT_EQ(verdict(proofOf(properties, fresh + "AN M 0.2" + rest), "counts"), "reachable");
  EXPECT_EQ(verdict(proofOf(properties, fresh + "AN T 1" + rest), "counts"), "unreachable");
  EXPECT_EQ(verdict(proofOf(properties, fresh + "AN T 1" + rest, "any"), "counts"), "reachable");
}

// 003:758-787: the counter stays within 0 and 999, moves by one where nothing sets or resets it, and lights the lamps
// in their order; the first count at which the half lamp is on is 50.
TEST(Verdicts7, StorageArea) {
  const ProofRun run = proofOf(
      "prove one lamp: Q12.0 xor Q12.1\n"
      "prove order: (Q15.4 implies Q15.3) and (Q15.3 implies Q15.2)\n"
      "prove range: MW110 >= 0 and MW110 <= 999\n"
      "prove step: not first_scan and not I12.2 and not I12.3 implies MW110 - prev(MW110) <= 1 and prev(MW110) - MW110 "
      "<= 1\n"
      "prove half: Q15.2 = (MW110 >= 50)\n"
      "prove reset: I12.3 implies Q12.0\n"
      "reach fifty: Q15.2 and MW110 = 50\n"
      "reach empty: Q12.0 and once(Q12.1)\n",
      "A I 12.0;CU C 1;A I 12.1;CD C 1;A I 12.2;L C#10;S C 1;A I 12.3;R C 1;L C 1;T MW 110;A C 1;= Q 12.1;AN Q 12.1;"
      "= Q 12.0;L 50;L MW 110;<=I;= Q 15.2;L MW 110;L 90;>=I;= Q 15.3;L MW 110;L 100;>=I;= Q 15.4");
  for (const char* name : {"one lamp", "order", "range", "step", "half", "reset"})
    EXPECT_EQ(verdict(run, name), "proved") << name;
  for (const char* name : {"fifty", "empty"}) EXPECT_EQ(verdict(run, name), "reachable") << name;
}

// 003:789-802: ENO is 1 only where every step is exact; what comes behind a step that is not keeps its value. The
// border of the product is 2184 * 15 = 32760.
TEST(Verdicts7, IntegerArithmetic) {
  const ProofRun run = proofOf(
      "prove product: M20.0 implies MW102 = (IW0 + IW8) * 15\n"
      "prove border: M20.0 implies IW0 + IW8 <= 2184 and IW0 + IW8 >= -2184\n"
      "prove zero: MW0 = 0 implies not M20.0\n"
      "prove sum: not first_scan and IW0 + IW8 > 32767 implies MW4 = prev(MW4) and MW102 = prev(MW102)\n"
      "prove wrapped: IW0 + IW8 > 32767 implies MW100 = IW0 + IW8 - 65536\n"
      "reach full: M20.0 and IW0 + IW8 = 2184\n",
      "OPN DB 1;L IW 6;T MW 0;L IW 8;T DBW 3;L IW 0;L DBW 3;+I;T MW 100;AN OV;SAVE;CLR;A BR;JNB e1;L MW 100;L 15;*I;"
      "T MW 102;AN OV;SAVE;CLR;A BR;JNB e1;L MW 102;L MW 0;/I;T MW 4;AN OV;SAVE;CLR;e1: A BR;= M 20.0",
      "synchronous", "DATA_BLOCK DB 1\nSTRUCT\n  b : ARRAY [0 .. 99] OF BYTE ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n");
  for (const char* name : {"product", "border", "zero", "sum", "wrapped"})
    EXPECT_EQ(verdict(run, name), "proved") << name;
  EXPECT_EQ(verdict(run, "full"), "reachable");
}

// 003:804-837. P1: the time is the thumbwheel's digits with the base of 1 s; P3: while it heats, thumbwheel and button
// do nothing; P5: a button that is held never starts it twice; P7: the button is bit 15 of the thumbwheel's word.
TEST(Verdicts7, OvenHeating) {
  const std::string statements =
      "A T 1;= Q 4.0;A T 1;BEC;L IW 0;AW W#16#0FFF;T MW 1;L MW 1;OW W#16#2000;T MW 2;L MW 2;A I 0.7;SE T 1";
  const std::string digits =
      "assume digits: not (I0.3 and (I0.2 or I0.1) or I1.7 and (I1.6 or I1.5) or I1.3 and (I1.2 or I1.1))\n";
  const ProofRun run = proofOf(digits +
                                   "prove time: not Q4.0 implies not M2.7 and not M2.6 and M2.5 and not M2.4 and M2.3 "
                                   "= I0.3 and M2.0 = I0.0 and "
                                   "M3.7 = I1.7 and M3.0 = I1.0\n"
                                   "prove heating: Q4.0 and not first_scan implies MW2 = prev(MW2)\n"
                                   "prove button: rises(T1) implies I0.7\n"
                                   "reach heats: Q4.0\n",
                               statements);
  for (const char* name : {"time", "heating", "button"}) EXPECT_EQ(verdict(run, name), "proved") << name;
  EXPECT_EQ(verdict(run, "heats"), "reachable");
  const ProofRun held =
      proofOf(digits + "assume held: I0.7\nprove once: not rises(T1)\nreach ends: falls(T1)\n", statements);
  EXPECT_EQ(verdict(held, "once"), "proved");
  EXPECT_EQ(verdict(held, "ends"), "reachable");
}

}  // namespace
}  // namespace rungproof::agreement7
