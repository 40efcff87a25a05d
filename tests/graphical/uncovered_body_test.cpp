// Bodies in languages that the S7-200 does not have: nothing that depends on them is decided.
#include <gtest/gtest.h>

#include "frontend/cli/cli.hpp"
#include "tests/graphical/plcopen_text.hpp"
#include "tests/reader/read.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

struct ProofRunText {
  int exit = 0;
  std::string out;
};
ProofRunText prove(const std::string& text) {
  const test::TemporaryFolder folder;
  std::istringstream in;
  std::ostringstream out, err;
  ProofRunText run;
  run.exit = static_cast<int>(runProgram(
      {"prove", folder.file("program.xml", text), "--isolated", "--format", "concise", "--dialect", "s7-200"},
      {in, out, err}));
  run.out = out.str() + err.str();
  return run;
}

TEST(NotCovered, WhatDependsOnStructuredTextIsNotDecided) {
  const std::string fb = pouText("F", "functionBlock",
                                 "<inputVars>" + declarations({"x:BOOL"}) + "</inputVars><outputVars>" +
                                     declarations({"q:BOOL"}) + "</outputVars>",
                                 "ST", "<xhtml:p>q := x;</xhtml:p>");
  const std::string body = inElement(1, "a") + blockElement(2, "F", "f", {{"x", {"1"}}}, {"q"}) +
                           outElement(3, {"2.q"}, "y", "", 0, 0) + inElement(4, "a", "", 0, 90) +
                           outElement(5, {"4"}, "z", "", 0, 90) +
                           "<comment localId=\"9\"><position x=\"0\" y=\"0\"/><content><xhtml:p>//@ prove one: y "
                           "implies a\n//@ prove two: z = a\n//@ reach three: y</xhtml:p></content></comment>\n";
  const ProofRunText run = prove(projectText(
      fb +
      pouText("Main", "program",
              "<localVars>" + declarations({"a:BOOL@%IX0.0", "y:BOOL@%QX0.0", "z:BOOL@%QX0.1", "f:F"}) + "</localVars>",
              "FBD", body)));
  EXPECT_NE(run.out.find("NOT COVERED one"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("PROVED two"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("NOT COVERED three"), std::string::npos) << run.out;
  EXPECT_EQ(run.exit, 3);
}

TEST(NotCovered, TwoHandsOnOneVariableLeaveNothingCertain) {
  const std::string text =
      pouText("F", "functionBlock", "<externalVars>" + declarations({"g:BOOL"}) + "</externalVars>", "ST",
              "<xhtml:p>g := FALSE;</xhtml:p>");
  const std::string body = inElement(1, "a") + outElement(2, {"1"}, "y") + blockElement(3, "F", "f", {}, {}) +
                           "<comment localId=\"9\"><position x=\"0\" y=\"0\"/><content><xhtml:p>//@ prove one: y = "
                           "a</xhtml:p></content></comment>\n";
  // The text writes y itself, by its address.
  std::string both = text;
  both.replace(both.find("g := FALSE"), 10, "%QX0.0 := FALSE");
  const ProofRunText run = prove(projectText(
      both + pouText("Main", "program",
                     "<localVars>" + declarations({"a:BOOL@%IX0.0", "y:BOOL@%QX0.0", "f:F"}) + "</localVars>", "FBD",
                     body)));
  EXPECT_NE(run.out.find("NOT COVERED one"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace rungproof
