// Instruction lists: what each operator and modifier does, jumps, calls, and what is said against lists that are wrong.
// Expected values follow from the meaning of the operators; the reason stands beside each where it is not plain.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

std::string listProgram(const std::string& declarations, const std::string& lines) {
  return "PROGRAM main\n" + declarations + "\n" + lines + "\nEND_PROGRAM\n";
}

TEST(IecList, Parentheses) {  // q := a AND (b OR c)
  IecRun run(listProgram("VAR_INPUT a, b, c : BOOL; END_VAR VAR q : BOOL; END_VAR", "LD a\nAND( b\nOR c\n)\nST q"));
  EXPECT_EQ(run.follow("q", {{"a", {1, 1, 0}}, {"b", {0, 1, 1}}, {"c", {1, 0, 1}}}), (Row{1, 1, 0}));
}

TEST(IecList, ConditionalJump) {  // 2 where n is greater than 20, otherwise 1
  IecRun run(listProgram("VAR_INPUT n : INT; END_VAR VAR y : INT; END_VAR",
                         "LD n\nGT 20\nJMPC big\nLD 1\nST y\nRET\nbig: LD 2\nST y"));
  EXPECT_EQ(run.follow("y", {{"n", {1, 21}}}), (Row{1, 2}));
}

struct BooleanRow {
  const char* lines;
  Row expected;  ///< of q with (a, b) = 00, 01, 10, 11
};

TEST(IecList, OperatorsOfTruthValues) {
  const BooleanRow rows[] = {
      {"LD a\nST q", {0, 0, 1, 1}},
      {"LDN a\nST q", {1, 1, 0, 0}},
      {"LD a\nSTN q", {1, 1, 0, 0}},
      {"LD a\nNOT\nST q", {1, 1, 0, 0}},
      {"LD a\nAND b\nST q", {0, 0, 0, 1}},
      {"LD a\n& b\nST q", {0, 0, 0, 1}},
      {"LD a\nANDN b\nST q", {0, 0, 1, 0}},
      {"LD a\n&N b\nST q", {0, 0, 1, 0}},
      {"LD a\nOR b\nST q", {0, 1, 1, 1}},
      {"LD a\nORN b\nST q", {1, 0, 1, 1}},
      {"LD a\nXOR b\nST q", {0, 1, 1, 0}},
      {"LD a\nXORN b\nST q", {1, 0, 0, 1}},
      {"LD a\nANDN( b\n)\nST q", {0, 0, 1, 0}},                  // N negates the result of the parentheses
      {"LD a\nORN( b\nAND a\n)\nST q", {1, 1, 1, 1}},            // a OR NOT (b AND a)
      {"LD a\nXOR(\nLD b\nOR a\n)\nST q", {0, 1, 0, 0}},         // a XOR (b OR a)
      {"LD a\nOR( b\nAND( a\nXOR b\n)\n)\nST q", {0, 1, 1, 1}},  // a OR (b AND (a XOR b))
      {"LD a\nEQ b\nST q", {1, 0, 0, 1}},
      {"LD a\nNE b\nST q", {0, 1, 1, 0}},
      {"LD a\nLT b\nST q", {0, 1, 0, 0}},
  };
  for (const BooleanRow& row : rows) {
    SCOPED_TRACE(row.lines);
    IecRun run(listProgram("VAR_INPUT a, b : BOOL; END_VAR VAR q : BOOL; END_VAR", row.lines));
    EXPECT_EQ(run.follow("q", {{"a", {0, 0, 1, 1}}, {"b", {0, 1, 0, 1}}}), row.expected);
  }
}

TEST(IecList, SetAndResetOnlyWhereTheResultIsTrue) {
  IecRun run(listProgram("VAR_INPUT a, b : BOOL; END_VAR VAR q, r : BOOL; END_VAR",
                         "LD a\nS q\nST r\nLD b\nR q"));  // S keeps the current result
  EXPECT_EQ(run.follow("q", {{"a", {0, 1, 0, 0, 1}}, {"b", {0, 0, 0, 1, 1}}}), (Row{0, 1, 1, 0, 0}));
  EXPECT_EQ(run.get("r"), 1);
}

struct NumberRow {
  const char* lines;
  double expected;  ///< of y with x = 17, z = -5
};

TEST(IecList, OperatorsOfNumbers) {
  const NumberRow rows[] = {
      {"LD x\nADD z\nST y", 12},
      {"LD x\nSUB z\nST y", 22},
      {"LD x\nMUL z\nST y", -85},
      {"LD x\nDIV z\nST y", -3},  // cut towards zero
      {"LD x\nMOD z\nST y", 2},   // 17 - (-5) * (-3)
      {"LD 10\nSUB( x\nMUL 2\n)\nST y", -24},
      {"LD x\nADD( z\nMUL( z\nADD 1\n)\n)\nST y", 37},  // 17 + (-5) * (-5 + 1)
      {"LD 7\nST y", 7},
      {"LD -7\nADD x\nST y", 10},
      {"LD x\nST y\nADD 1\nST x\nLD y\nST y", 17},  // ST keeps the result, and what was stored is no longer x
      {"LD x\nADD 1\nST x\nST y", 18},
      {"LD x\nADD 1\nST x\nADD x\nST y", 36},
      {"LD x\nGT z\nJMPC one\nLD 0\nST y\nRET\none:\nLD 1\nST y", 1},
      {"LD x\nGE 17\nJMPC one\nLD 0\nST y\nRET\none:\nLD 1\nST y", 1},
      {"LD x\nLE 16\nJMPC one\nLD 0\nST y\nRET\none:\nLD 1\nST y", 0},
      {"LD x\nLT z\nJMPCN one\nLD 0\nST y\nRET\none:\nLD 1\nST y", 1},
      {"LD x\nNE 17\nJMPCN one\nLD 0\nST y\nRET\none:\nLD 1\nST y", 1},
      {"LD x\nEQ( z\nADD 22\n)\nJMPC one\nLD 0\nST y\nRET\none:\nLD 1\nST y", 1},
      {"LD x\nMAX z, 40\nST y", 40},
      {"LD 3\nLIMIT x, 9\nST y", 9},  // LIMIT(3, 17, 9)
      {"LD z\nABS\nST y", 5},
      {"LIMIT(MN := 3, IN := x, MX := 9)\nST y", 9},
      {"ADD(IN1 := x, IN2 := z)\nST y", 12},
      {"LD x\nADD z, 1, 2\nST y", 15},  // a function of four inputs
      {"LD x\nINT_TO_DINT\nDINT_TO_INT\nST y", 17},
      {"JMP there\nLD 1\nST y\nthere: LD 2\nST y", 2},
  };
  for (const NumberRow& row : rows) {
    SCOPED_TRACE(row.lines);
    IecRun run(listProgram("VAR x : INT := 17; z : INT := -5; y : INT; END_VAR", row.lines));
    run.scan();
    EXPECT_EQ(run.get("y"), row.expected);
  }
}

TEST(IecList, BitStringsShiftedByAFunction) {
  IecRun run(listProgram("VAR w : BYTE := 16#81; v : BYTE; END_VAR", "LD w\nSHL 2\nOR 1\nANDN 4\nST v"));
  run.scan();
  EXPECT_EQ(run.get("v"), 1);  // 16#81 by two bits to the left is 4, with bit 0 5, without bit 2 1
}

TEST(IecList, ReturnWithACondition) {
  const std::string declared = "VAR_INPUT a : BOOL; END_VAR VAR n : INT; END_VAR";
  const std::string rest = "\nLD n\nADD 1\nST n";
  EXPECT_EQ(IecRun(listProgram(declared, "LD a\nRETC" + rest)).follow("n", {{"a", {0, 1, 0}}}), (Row{1, 1, 2}));
  EXPECT_EQ(IecRun(listProgram(declared, "LD a\nRETCN" + rest)).follow("n", {{"a", {0, 1, 0}}}), (Row{0, 1, 1}));
  EXPECT_EQ(IecRun(listProgram(declared, "LD a\nRET" + rest)).follow("n", {{"a", {0, 1, 0}}}), (Row{0, 0, 0}));
}

TEST(IecList, TheResultIsKeptOverAJump) {  // at the label it is a, from both sides
  IecRun run(listProgram("VAR_INPUT a : BOOL; END_VAR VAR q, r : BOOL; END_VAR", "LD a\nJMPC on\nST r\non: ST q"));
  EXPECT_EQ(run.follow("q", {{"a", {0, 1, 0}}}), (Row{0, 1, 0}));
}

TEST(IecList, ALoop) {  // 1 + 2 + ... + k
  IecRun run(listProgram("VAR_INPUT k : INT; END_VAR VAR i, s : INT; END_VAR",
                         "LD 0\nST i\nST s\nagain:\nLD i\nGE k\nJMPC done\nLD i\nADD 1\nST i\nADD s\nST s\nJMP again\n"
                         "done:"));
  EXPECT_EQ(run.follow("s", {{"k", {0, 1, 4, 10}}}), (Row{0, 1, 10, 55}));
}

TEST(IecList, BlocksAreCalled) {
  const std::string declared = "VAR_INPUT i : BOOL; END_VAR VAR t : TON; q : BOOL; p : TIME := T#30ms; END_VAR";
  const std::vector<std::pair<std::string, Row>> inputs = {{"i", {1, 1, 1, 1, 0}}};
  const Row expected = {0, 0, 0, 1, 0};
  EXPECT_EQ(IecRun(listProgram(declared, "CAL t(IN := i, PT := T#30ms, Q => q)")).follow("q", inputs), expected);
  EXPECT_EQ(IecRun(listProgram(declared, "CAL t(\n  IN := i,\n  PT := p\n)\nLD t.Q\nST q")).follow("q", inputs),
            expected);
  EXPECT_EQ(IecRun(listProgram(declared, "LD i\nST t.IN\nLD T#30ms\nST t.PT\nCAL t\nLD t.Q\nST q")).follow("q", inputs),
            expected);
}

TEST(IecList, CallsWithACondition) {
  const std::string text =
      "FUNCTION_BLOCK calls VAR_OUTPUT n : INT; END_VAR\nLD n\nADD 1\nST n\nEND_FUNCTION_BLOCK\n" +
      listProgram("VAR_INPUT e : BOOL; END_VAR VAR a, b, c : calls; END_VAR", "CAL a\nLD e\nCALC b\nCALCN c");
  EXPECT_EQ(IecRun(text).follow("a.n", {{"e", {0, 1, 1}}}), (Row{1, 2, 3}));
  EXPECT_EQ(IecRun(text).follow("b.n", {{"e", {0, 1, 1}}}), (Row{0, 1, 2}));
  EXPECT_EQ(IecRun(text).follow("c.n", {{"e", {0, 1, 1}}}), (Row{1, 1, 1}));
}

TEST(IecList, InputsOfBlocksAsOperators) {  // sets that input and calls
  IecRun edge(
      listProgram("VAR_INPUT x : BOOL; END_VAR VAR r : R_TRIG; q : BOOL; END_VAR", "LD x\nCLK r\nLD r.Q\nST q"));
  EXPECT_EQ(edge.follow("q", {{"x", {1, 1, 0, 1}}}), (Row{1, 0, 0, 1}));
  IecRun latch(listProgram("VAR_INPUT a, b : BOOL; END_VAR VAR s : SR; END_VAR", "LD a\nS1 s\nLD b\nR s"));
  EXPECT_EQ(latch.follow("s.Q1", {{"a", {0, 1, 0, 0}}, {"b", {0, 0, 0, 1}}}), (Row{0, 1, 1, 0}));
}

TEST(IecList, FunctionsInAList) {
  IecRun run("FUNCTION twice : INT VAR_INPUT x : INT; y : INT; END_VAR\nLD x\nMUL 2\nADD y\nST twice\nEND_FUNCTION\n" +
             listProgram("VAR a : INT := 4; b : INT := 1; r : INT; END_VAR", "LD a\ntwice b\nST r"));
  run.scan();
  EXPECT_EQ(run.get("r"), 9);
}

/// Numbers take the type of what the result goes into, however late that is seen, and what chooses is asked at once.
TEST(IecList, ChosenNumbersTakeTheTypeOfTheirTarget) {
  const auto seen = [](const std::string& type, const std::string& lines) {
    IecRun run(listProgram("VAR_INPUT a : BOOL; k : INT; END_VAR VAR n : " + type + "; END_VAR", lines));
    return run.follow("n", {{"a", {0, 1}}, {"k", {0, 2}}});
  };
  for (const char* const type : {"SINT", "INT", "UINT", "LINT", "ULINT"}) {
    EXPECT_EQ(seen(type, "LD a\nSEL 7, 9\nST n"), (Row{7, 9})) << type;
    EXPECT_EQ(seen(type, "LD k\nMUX 5, 6, 8\nST n"), (Row{5, 8})) << type;
    EXPECT_EQ(seen(type, "LD a\nSEL 7, 9\nADD 1\nST n"), (Row{8, 10})) << type;
    EXPECT_EQ(seen(type, "LD 3\nADD( a\nSEL 7, 9\n)\nST n"), (Row{10, 12})) << type;
  }
  EXPECT_EQ(seen("INT", "LD a\nSEL 7, 9\nGT 8\nJMPC on\nLD 1\nST n\nRET\non: LD 2\nST n"), (Row{1, 2}));
  EXPECT_EQ(seen("INT", "SEL(G := a, IN0 := 7, IN1 := 9)\nST n"), (Row{7, 9}));
}

TEST(IecList, BodiesInAListAreWrittenOutToo) {  // IN_OUT: the body stands where it is called, its RET leaves it alone
  IecRun run(
      "FUNCTION_BLOCK inc VAR_INPUT e : BOOL; END_VAR VAR_IN_OUT z : INT; END_VAR\nLD e\nRETCN\nLD z\nADD 1\nST "
      "z\nEND_FUNCTION_BLOCK\n" +
      listProgram("VAR_INPUT e : BOOL; END_VAR VAR a : inc; v, n : INT; END_VAR",
                  "CAL a(e := e, z := v)\nCAL a(e := e, z := v)\nLD n\nADD 1\nST n"));
  EXPECT_EQ(run.follow("v", {{"e", {0, 1, 0}}}), (Row{0, 2, 2}));
  EXPECT_EQ(run.get("n"), 3);
}

struct WrongList {
  const char* lines;
  const char* message;
  std::uint32_t line, column;
};

/// The lines begin in line 3.
constexpr WrongList wrongLists[] = {
    {"LD a\nADD", "ADD needs a value", 4, 1},
    {"LD a\nST a;", "a line of IL ends without ';'", 4, 5},
    {"LD a\nST a b", "'b' does not belong into this line", 4, 6},
    {"AND q\nST q", "there is no current result here, which LD would load", 3, 1},
    {"LD a\nAND q\nST q", "INT and BOOL do not go together", 4, 1},
    {"LD a\nST q", "INT does not fit into BOOL: write INT_TO_BOOL", 4, 1},
    {"LD q\n)\nST q", "this parenthesis closes nothing", 4, 1},
    {"LD q\nAND( q\nST q", "the parenthesis of AND is not closed", 4, 1},
    {"LD q\nJMPC nowhere", "there is no label nowhere", 4, 6},
    {"one: LD q\none: ST q", "two lines have the label one", 4, 1},
    {"LD a\nJMPC on\non: ST a", "INT does not fit into BOOL", 4, 1},
    {"LD q\nAND( q\nJMP on\n)\non: ST q", "JMP stands within parentheses", 5, 1},
    {"LD q\nAND(\non: LD q\n)\nST q", "a label stands within parentheses", 4, 1},
    {"LD q\nJMPC on\nLD a\non: ST a", "the current result has different types on the ways that lead here", 6, 5},
    {"LD q\nJMP in\nback: JMP out\nin: LD a\nJMP back\nout: ST q",
     "the current result has another type at the label back", 7, 1},
    {"LD q\nback: JMP out\nin: LD a\nJMP back\nout: ST q", "the current result has another type at the label", 6, 1},
    {"LD a\nST 5", "this is no variable", 4, 4},
    {"CAL a", "a is no instance of a function block", 3, 5},
    {"LD q\nCAL", "CAL needs an instance", 4, 1},
    {"LD q\nJMP 5", "JMP needs a name, not '5'", 4, 5},
    {"LD q\nFROB a\nST a", "there is no function and no instance FROB", 4, 1},
    {"LD a, a", "LD takes one value", 3, 7},
    {"LD q\nLIMIT(1, 2)", "LIMIT in parentheses needs the names of its inputs", 4, 6},
    {"LD q\nLD(q", "LD has no parentheses", 4, 3},
    {"LD NOT q\nST q", "a value is needed here, not 'NOT'", 3, 4},
    {"LD q\nTX t", "block TON has no input TX", 4, 1},
    {"LD q\n5 a", "a line of IL cannot begin with '5'", 4, 1},
    {"LD missing\nST a\nST q", "there is no variable missing", 3, 4},
    {"LD q\nAND a[\nST q", "']' is needed here, not 'q'", 5, 4},
};

TEST(IecList, WrongListsAreNamedAtTheirPlaces) {
  for (const WrongList& wrong : wrongLists) {
    SCOPED_TRACE(wrong.lines);
    expectErrorAt(readIecText(listProgram("VAR a : INT; q : BOOL; t : TON; END_VAR", wrong.lines)), wrong.message,
                  wrong.line, wrong.column);
  }
}

TEST(IecList, AllErrorsAreToldInOneRun) {  // what follows from an error is not told again
  const Program program =
      readIecText(listProgram("VAR a : INT; q : BOOL; END_VAR", "LD b\nADD 1\nST a\nLD q\nST q\nLD c\nST q"));
  EXPECT_EQ(program.findings.size(), 2U) << findingsIec(program);
}

TEST(IecList, DamagedTextsEndInMessages) {  // each prefix of a list, and each list without one character
  const std::string whole =
      listProgram("VAR a : INT; t : TON; x, q : BOOL; END_VAR",
                  "LD x\nAND( q\nORN x\n)\nJMPC on\nLD a\nADD( 3\nMUL a\n)\nST a\non:\nCAL t(\nIN "
                  ":= x,\nPT := T#5s\n)\nLD t.Q\nCLK t\nS q\nLIMIT(MN := 1, IN := a, MX := 4)\nRETC");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    static_cast<void>(readIecText(whole.substr(0, i)));
    const Program program = readIecText(whole.substr(0, i) + whole.substr(i + 1));
    EXPECT_GT(program.sources->size(), 0U);
  }
}

std::string proved(const std::string& declarations, const std::string& lines, const std::string& properties) {
  return "PROGRAM main\n" + declarations + "\n" + properties + "\n" + lines + "\nEND_PROGRAM\n";
}

TEST(IecList, WhatAnUnreadLineWritesIsNotCovered) {  // r is not touched by what could not be read
  const IecOutput output =
      proofOfIec(proved("VAR_INPUT x : BOOL; END_VAR VAR q, r, s : BOOL; END_VAR",
                        "LD x\nST r\nLD missing\nAND x\nST q\nLD r\nST s", "//@ prove q: not q\n//@ prove s: s = x"));
  EXPECT_TRUE(output.has("NOT COVERED  q") && output.has("PROVED  s")) << output.text;
}

TEST(IecList, AnUnreadJumpLeavesNothingProved) {
  const IecOutput output = proofOfIec(proved("VAR_INPUT x : BOOL; END_VAR VAR q : BOOL; END_VAR",
                                             "LD missing\nJMPC on\nLD FALSE\nST q\non:", "//@ prove q: not q"));
  EXPECT_TRUE(output.has("NOT COVERED  q")) << output.text;
}

TEST(IecList, ListsAreProved) {
  const IecOutput output = proofOfIec(proved("VAR_INPUT start, stop : BOOL; END_VAR VAR run : BOOL; END_VAR",
                                             "LD start\nOR run\nANDN stop\nST run",
                                             "//@ prove stopped: stop implies not run\n//@ prove never: not run"));
  EXPECT_TRUE(output.has("PROVED  stopped") && output.has("VIOLATED  never")) << output.text;
}

TEST(IecList, ALoopThatMayNotEndIsNoScan) {  // with k = 5 the counter never meets it
  const IecOutput output =
      proofOfIec(proved("VAR_INPUT k : BOOL; END_VAR VAR i : INT; q : BOOL; END_VAR",
                        "LD 0\nST i\non:\nLD i\nADD 2\nST i\nLD k\nJMPC on\nLD k\nST q", "//@ prove q: not q"));
  EXPECT_FALSE(output.has("VIOLATED  q")) << output.text;
}

std::string listInXml(const std::string& body) {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0201" xmlns:xhtml="http://www.w3.org/1999/xhtml"><types><dataTypes/><pous>
<pou name="light" pouType="program"><interface><inputVars><variable name="x"><type><BOOL/></type></variable></inputVars>
<localVars><variable name="n"><type><INT/></type></variable><variable name="q"><type><BOOL/></type></variable></localVars></interface>
<body><IL><xhtml:p>)" +
         body + "</xhtml:p></IL></body></pou></pous></types></project>";
}

TEST(IecList, PlcopenWithAList) {
  const IecOutput output = runIec({"sim", "--scans", "2", "--trace", "-", "--signals", "n", "--dialect", "iec"},
                                  listInXml("<![CDATA[LD n\nADD 2\nST n\nGT 3\nST q]]>"), "light.xml");
  EXPECT_EQ(output.exit, 0) << output.text;
  EXPECT_TRUE(output.has("4")) << output.text;
  const IecOutput wrong = runIec({"lint", "--dialect", "iec"}, listInXml("LD x\nST q\nLD y\nST q"), "light.xml");
  EXPECT_TRUE(wrong.has("there is no variable y") && wrong.has("light.xml:7:4")) << wrong.text;
}

}  // namespace
}  // namespace rungproof
