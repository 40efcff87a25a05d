// Blocks of libraries that no file has: their calls may leave any value where they can write, and nothing else.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

const std::string pump =
    "VAR_INPUT x : BOOL; END_VAR VAR p : PumpControl; q, other, given : BOOL; v : REAL; n : INT; END_VAR";

TEST(IecContract, ItIsANoteAndNoError) {
  const Program program = readIecText(iecProgram(pump, "p(start := x, speed => v); q := p.Ready; n := 3;"));
  ASSERT_EQ(program.findings.size(), 1U) << findingsIec(program);
  EXPECT_EQ(program.findings[0].severity, Severity::Note);
  EXPECT_NE(findingsIec(program).find("PumpControl is in no file: what its calls may write is any value"),
            std::string::npos);
}

TEST(IecContract, WhatDoesNotDependOnItIsProved) {
  const std::string text = iecProgram(pump, "p(start := x, speed => v); q := p.Ready; other := x; n := 3;");
  EXPECT_EQ(verdictOf(text, "always n = 3"), "PROVED");
  EXPECT_EQ(verdictOf(text, "always other = x"), "PROVED");
}

TEST(IecContract, WhatItMayWriteIsAnyValue) {
  const std::string text = iecProgram(pump, "p(start := x, speed => v); q := p.Ready;");
  EXPECT_EQ(verdictOf(text, "never q"), "VIOLATED");
  EXPECT_EQ(verdictOf(text, "always v < 1.0"), "VIOLATED");
  EXPECT_EQ(verdictOf(text, "always q or not q"), "PROVED");
}

TEST(IecContract, AVariableThatIsGivenMayBeWritten) {  // it may be an IN_OUT; an input of the program is none
  const std::string text = iecProgram(pump, "given := FALSE; p(axis := given, start := x); q := p.Ready; other := x;");
  EXPECT_EQ(verdictOf(text, "never given"), "VIOLATED");
  EXPECT_EQ(verdictOf(text, "always other = x"), "PROVED");
}

TEST(IecContract, OutputsKeepTheirValueBetweenCalls) {  // read twice behind one call
  const std::string text = iecProgram(pump, "p(start := x); q := p.Ready; other := p.Ready;");
  EXPECT_EQ(verdictOf(text, "always q = other"), "PROVED");
}

TEST(IecContract, AnOutputBeginsWithAnyValue) {  // it is read in front of the first call
  EXPECT_EQ(verdictOf(iecProgram(pump, "q := p.Ready; p(start := x);"), "first_scan implies not q"), "VIOLATED");
}

// A method of a block that no file has is like a call of the block: a result is any value, too.
TEST(IecContract, MethodsAreCalls) {
  const std::string log = "VAR_INPUT x : BOOL; END_VAR VAR log : Logger; q, other, given : BOOL; n : INT; END_VAR";
  const std::string text = iecProgram(log, "q := x; log.Write(1, given); n := log.Count(x);");
  const Program program = readIecText(text);
  ASSERT_EQ(program.findings.size(), 1U) << findingsIec(program);
  EXPECT_EQ(program.findings[0].severity, Severity::Note);
  EXPECT_NE(findingsIec(program).find("Logger is in no file: what its calls may write is any value"),
            std::string::npos);
  EXPECT_EQ(verdictOf(text, "always q = x"), "PROVED");
  EXPECT_EQ(verdictOf(text, "never given"), "VIOLATED");
  EXPECT_EQ(verdictOf(text, "always n < 5"), "VIOLATED");
  EXPECT_EQ(verdictOf(iecProgram(log, "IF log.Ready() AND x THEN q := TRUE; END_IF;"), "never q"), "VIOLATED");
  EXPECT_EQ(verdictOf(iecProgram(log, "IF log.Ready() AND x THEN q := TRUE; END_IF;"), "q implies once(x)"), "PROVED");
  // What it writes by name is any value as well, in an output of the block too.
  EXPECT_EQ(verdictOf(iecProgram(log, "log.Read(1, done => given); q := log.Busy;"), "never given"), "VIOLATED");
  EXPECT_EQ(verdictOf(iecProgram(log, "log.Read(1, done => given); q := log.Busy;"), "never q"), "VIOLATED");
}

TEST(IecContract, AnInstanceThatIsGivenIsNotCovered) {  // its state may change
  const IecOutput output =
      proofOfIec("//@ prove off: not d.Q1\n" +
                 iecProgram("VAR p : PumpControl; d : SR; END_VAR", "p(latch := d); d(S1 := FALSE, R := FALSE);"));
  EXPECT_TRUE(output.has("NOT COVERED  off")) << output.text;
}

TEST(IecContract, ATypeThatNobodyCallsIsAnError) {
  EXPECT_NE(findingsIec(readIecText(iecProgram("VAR a : INTT; END_VAR", "a := 3;"))).find("there is no type INTT"),
            std::string::npos);
}

TEST(IecContract, APinWhoseTypeNothingTellsIsNotCovered) {
  const IecOutput output = runIec({"lint"}, iecProgram(pump, "p(start := x); n := ABS(p.Some.Thing);"));
  EXPECT_TRUE(output.has("error")) << output.text;
}

TEST(IecContract, VariablesOfAPanelAreFree) {
  const std::string text = iecProgram("VAR level : HMI_INT; q : BOOL; END_VAR", "q := level > 5;");
  EXPECT_EQ(verdictOf(text, "never q"), "VIOLATED");
}

TEST(IecContract, CodeInCIsNotCovered) {  // it may write anything; a directive between braces is passed over
  const IecOutput output =
      proofOfIec("//@ prove off: not q\n" + iecProgram("VAR q : BOOL; END_VAR", "q := FALSE;\n{{ int a; q = 1; }}\n"));
  EXPECT_TRUE(output.has("NOT COVERED  off") && output.has("is not executed and may write anything")) << output.text;
  EXPECT_EQ(verdictOf(iecProgram("VAR {attribute 'hide'} q : BOOL; END_VAR", "{region 'x'} q := FALSE; {endregion}"),
                      "not q"),
            "PROVED");
}

// OpenPLC Editor and Beremiz put such blocks in front of each program. Nobody calls this one; where it is called, what
// it does is not known.
TEST(IecContract, CodeInCOfABlockThatNobodyCallsSpoilsNothing) {
  const std::string block =
      "FUNCTION_BLOCK Writer\nVAR_INPUT on : BOOL; END_VAR\nVAR last : BOOL; END_VAR\n"
      "IF on AND NOT last THEN\n{{ put(1); }}\nEND_IF;\nlast := on;\nEND_FUNCTION_BLOCK\n";
  const std::string variables = "VAR_INPUT a : BOOL; END_VAR VAR w : Writer; END_VAR VAR_OUTPUT q : BOOL; END_VAR";
  EXPECT_EQ(verdictOf(block + iecProgram(variables, "q := a;"), "q implies a"), "PROVED");
  EXPECT_EQ(verdictOf(block + iecProgram(variables, "q := a;"), "never q"), "VIOLATED");
  EXPECT_EQ(verdictOf(block + iecProgram(variables, "q := a; w(on := a);"), "q implies a"), "NOT COVERED");
}

}  // namespace
}  // namespace rungproof
