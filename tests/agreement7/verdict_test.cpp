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
ProofRun proofOf(const std::string& properties, const std::string& statements, const char* s5Time = "synchronous") {
  std::string lines;
  std::istringstream in(statements);
  for (std::string one; std::getline(in, one, ';');) lines += "  " + one + " ;\n";
  std::string faults;
  Program program = irOf(naive7::readProgram(naive7::organizationBlock(lines)), false, faults);
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

}  // namespace
}  // namespace rungproof::agreement7
