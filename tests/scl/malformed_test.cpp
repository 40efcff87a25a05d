// What is wrong in a body in SCL is said at its place; nothing crashes, and nothing is proved of the block.
#include "tests/scl/scl_run.hpp"

namespace rungproof {
namespace {

using testscl::commandOn;
using testscl::mainOf;
using testscl::Output;
using testscl::proofOf;

struct MalformedCase {
  const char* body;     ///< begins in line 10, column 1
  const char* place;    ///< line:column
  const char* message;  ///< a part of it
};

constexpr const char* declared =
    "VAR_TEMP\n a : INT; d : DINT; r : REAL; f : BOOL; w : WORD; t : TIME; dw : DWORD;\n"
    " x : ARRAY[1..3] OF INT;\n s : STRING[10];\nEND_VAR\nVAR CONSTANT\n EDGE : INT := 4; END_VAR\n";

constexpr MalformedCase malformedCases[] = {
    {"#a := ;", "10:7", "a value is needed here, not ';'"},
    {"#a = 5;", "10:4", "':=' is needed here, not '='"},
    {"#a : = 5;", "10:4", "':=' is written without a blank"},
    {"#a := 5 #d := 6;", "10:9", "';' is needed here, not '#d'"},
    {"#a := (1 + 2;", "10:13", "')' is needed here, not ';'"},
    {"IF #f #a := 1; END_IF;", "10:7", "'THEN' is needed here, not '#a'"},
    {"IF #f THEN #a := 1;", "11:1", "'END_IF' is needed here"},
    {"CASE #a OF 1 #a := 1; END_CASE;", "10:14", "':' is needed here"},
    {"FOR #a := 1 DO END_FOR;", "10:13", "'TO' is needed here, not 'DO'"},
    {"WHILE #f #a := 1; END_WHILE;", "10:10", "'DO' is needed here"},
    {"REPEAT #a := 1; END_REPEAT;", "10:17", "'UNTIL' is needed here"},
    {"#x[1 := 5;", "10:6", "']' is needed here, not ':='"},
    {"END_IF;", "10:1", "'END_IF' does not belong here"},
    {"5 := #a;", "10:1", "a statement cannot begin with '5'"},
    {"#a := 'text", "10:7", "the text has no closing mark"},
    {"#nobody := 1;", "10:1", "nothing declares nobody"},
    {"nobody := 1;", "10:1", "nothing declares nobody"},
    {"\"Nobody\" := 1;", "10:1", "nothing defines \"Nobody\""},
    {"#a := 1.5;", "10:7", "1.5 is REAL, and INT is needed here"},
    {"#a := #d;", "10:7", "#d is DINT, and INT is needed here"},
    {"#a := #w;", "10:7", "#w is WORD, and INT is needed here"},
    {"#f := #a;", "10:7", "#a is INT, and BOOL is needed here"},
    {"#a := 40000;", "10:7", "40000 is no INT"},
    {"#a := #a + #f;", "10:12", "#f cannot be computed with +"},
    {"#a := #a AND #a;", "10:7", "AND takes BOOL, BYTE, WORD and DWORD"},
    {"#f := #r MOD #r = 0.0;", "10:7", "MOD takes INT and DINT"},
    {"#f := #f < TRUE;", "10:7", "BOOL has no order"},
    {"#f := #dw < DW#16#5;", "10:7", "the order of values of type DWORD is not modelled"},
    {"#a := MW10 + 1;", "10:7", "MW10 is an address, no number"},
    {"IF #a THEN #f := TRUE; END_IF;", "10:4", "#a is INT, and BOOL is needed here"},
    {"CASE #r OF 1: #a := 1; END_CASE;", "10:6", "#r is no INT or DINT"},
    {"CASE #a OF 70000: #a := 1; END_CASE;", "10:12", "70000 is no INT"},
    {"CASE #a OF #a: #a := 1; END_CASE;", "10:12", "#a is no constant number"},
    {"FOR #r := 1.0 TO 2.0 DO #a := 1; END_FOR;", "10:5", "#r is no variable of type INT or DINT"},
    {"FOR #a := 1 TO 5 BY #a DO #d := 1; END_FOR;", "10:21", "a step of FOR that is no constant is not covered"},
    {"FOR #a := 1 TO 32767 DO #d := 1; END_FOR;", "10:16", "whether FOR ends at a limit that its variable cannot pass"},
    {"EXIT;", "10:1", "EXIT stands in no loop"},
    {"CONTINUE;", "10:1", "CONTINUE stands in no loop"},
    {"GOTO nowhere;", "10:1", "the block has no label NOWHERE"},
    {"#x[4] := 1;", "10:1", "the index of x[4] is outside of its bounds"},
    {"#x[1, 2] := 1;", "10:1", "x has another number of dimensions"},
    {"#a[1] := 1;", "10:1", "a is no array"},
    {"#x[#r] := 1;", "10:4", "#r is REAL, and DINT is needed here"},
    {"#a := Unknown(5);", "10:7", "Unknown is in none of the files"},
    {"#a := ABS(#f);", "10:7", "ABS takes a number"},
    {"#a := ABS(1, 2);", "10:7", "ABS takes 1 value"},
    {"#r := SQRT(#f);", "10:12", "#f is BOOL, and REAL is needed here"},
    {"#w := SHL(#a, 2);", "10:11", "SHL takes BYTE, WORD and DWORD"},
    {"#r := DWORD_TO_REAL(#dw);", "10:7", "the conversion DWORD_TO_REAL is not covered"},
    {"#a := MOVE_BLK(#s);", "10:7", "the function MOVE_BLK is not covered"},
    {"#s := 'abc';", "10:1", "such a value is not covered"},
    {"#r := #r ** 2;", "10:7", "the operator ** is not modelled"},
    {"#a := S_ODT(T_NO := 5);", "10:7", "S_ODT needs T_NO"},
    {"#f := S_ODT(T_NO := T1, X := TRUE) = S5T#1s;", "10:25", "S_ODT has no parameter X"},
    {"EDGE := 5;", "10:1", "EDGE is a constant"},
    {"#f := OK;", "10:7", "it can only be written"},
    {"#a := M10.9;", "10:7", "a byte has the bits 0 to 7"},
    {"#f := #w.%X16;", "10:10", "a value of 16 bits has no part %X16"},
    {"FOR #w.%X3 := 0 TO 1 DO ; END_FOR;", "10:8", "parts of a value such as #w.%X3 are not covered here"},
};

TEST(SclMalformed, MistakesAreSaidAtTheirPlaces) {
  for (const MalformedCase& one : malformedCases) {
    const Output output = commandOn("lint", mainOf(one.body, declared));
    EXPECT_TRUE(output.has(one.message)) << one.body << "\n" << output.text;
    EXPECT_TRUE(output.has(std::string("main.scl:") + one.place + " ")) << one.body << "\n" << output.text;
    EXPECT_NE(output.exit, 0) << one.body << "\n" << output.text;
  }
}

// As in STEP 7. Without an end a call of 100,000 values becomes millions of statements.
TEST(SclMalformed, AlternativesAreAtMostThirtyTwo) {
  const auto callOf = [](const std::string& name, int values) {
    std::string text = "#a := " + name + "(";
    for (int i = 0; i < values; ++i) text += std::string(i == 0 ? "" : ", ") + "#a";
    return mainOf(text + ");", declared);
  };
  for (const std::string name : {"MAX", "MIN"}) {
    EXPECT_FALSE(commandOn("lint", callOf(name, 32)).has("at most")) << name;
    EXPECT_TRUE(commandOn("lint", callOf(name, 33)).has(name + " takes at most 32 values")) << name;
  }
  EXPECT_FALSE(commandOn("lint", callOf("MUX", 33)).has("at most"));
  EXPECT_TRUE(commandOn("lint", callOf("MUX", 34)).has("MUX takes at most 32 values"));
}

// What one statement says wrongly leaves the whole block open: the program may go on elsewhere.
TEST(SclMalformed, TheBlockIsNotCovered) {
  const std::string program = mainOf("#a := 1.5;\nQ4.0 := FALSE;", declared);
  const Output proof = testscl::proofOf("prove off: not Q4.0\n", program);
  EXPECT_TRUE(proof.has("NOT COVERED  off")) << proof.text;
  EXPECT_FALSE(proof.has("PROVED  off")) << proof.text;
}

// The other blocks are read, and all mistakes are told in one run.
TEST(SclMalformed, TheRestGoesOn) {
  const std::string program =
      "FUNCTION FC 1 : VOID\nVAR_TEMP\n a : INT;\nEND_VAR\nBEGIN\n a := 1.5;\n a := ;\n IF a THEN a := 1; "
      "END_IF;\nEND_FUNCTION\n" +
      mainOf("Q4.0 := I0.0;");
  const Output lint = commandOn("lint", program);
  EXPECT_TRUE(lint.has("main.scl:6:")) << lint.text;
  EXPECT_TRUE(lint.has("main.scl:7:")) << lint.text;
  EXPECT_TRUE(lint.has("main.scl:8:")) << lint.text;
  const Output proof = testscl::proofOf("prove same: Q4.0 = I0.0\n", program);
  EXPECT_TRUE(proof.has("PROVED  same")) << proof.text;
}

// Cut off at every byte: nothing crashes, and something is said.
TEST(SclMalformed, CutOffAnywhere) {
  const std::string whole =
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n x : INT;\nEND_VAR\nBEGIN\n CASE x OF\n 1..3: IF x > 2 AND NOT (x = 3) "
      "THEN \"A\".b[x + 1] := 'c'; END_IF;\n ELSE FOR x := 1 TO 3 DO S_ODT(T_NO := T1, S := TRUE, TV := "
      "S5T#1s); END_FOR;\n END_CASE;\nEND_FUNCTION_BLOCK\n";
  for (std::size_t length = 25; length + 1 < whole.size(); ++length)
    EXPECT_NE(commandOn("lint", whole.substr(0, length)).text, "") << length;
}

// A statement that cannot be read inside of others: the finding is about it, not about jumps that it was to lead to.
TEST(SclMalformed, NothingIsSaidOfJumpsThatNobodyWrote) {
  for (const char* body : {"IF #f THEN #a := #f; ELSIF #a = #f THEN #a := 2; END_IF;",
                           "CASE #a OF 1: #a := #f; 2: #a := 3; END_CASE;", "WHILE #f DO #a := #f; END_WHILE;"}) {
    const Output output = commandOn("lint", mainOf(body, declared));
    EXPECT_TRUE(output.has("error[SYN075]")) << body << output.text;
    EXPECT_FALSE(output.has("SYN048")) << body << output.text;
  }
}

// A statement that only stores leaves open what it stores, and nothing else; one that may leave the block, call or
// store nobody knows where leaves everything open.
TEST(MalformedScl, ARefusedStatementLeavesOpenWhatItStores) {
  const std::string properties = "prove same: Q0.1 = I0.2\nprove never: not Q0.0\n";
  const auto of = [&](const std::string& refused) {
    return proofOf(properties, mainOf("Q0.1 := I0.2;\n" + refused + "\nM5.0 := I0.4;\n"));
  };
  for (const char* refused :
       {"Q0.0 := nobody;", "Q0.0 := \"Nobody\";", "IF nobody THEN Q0.0 := TRUE; ELSE MW20 := 5; END_IF;",
        "IF I0.0 THEN Q0.0 := nobody AND I0.1; END_IF;", "M6.0 := nobody; Q0.0 := M6.0;",
        "CASE WORD_TO_INT(MW30) OF 1: Q0.0 := \"Nobody\".x; ELSE MW20 := 1; END_CASE;"}) {
    const Output output = of(refused);
    EXPECT_TRUE(output.has("PROVED  same")) << refused << "\n" << output.text;
    EXPECT_TRUE(output.has("NOT COVERED  never")) << refused << "\n" << output.text;
    EXPECT_EQ(output.exit, 2) << refused;
  }
  for (const char* refused : {"nobody := I0.0;", "IF nobody THEN RETURN; END_IF;", "nobody(x := 1);",
                              "MW20 := FC77(x := 1);", "IF nobody THEN FC77(); END_IF;"}) {
    const Output output = of(refused);
    EXPECT_TRUE(output.has("NOT COVERED  same")) << refused << "\n" << output.text;
    EXPECT_TRUE(output.has("NOT COVERED  never")) << refused << "\n" << output.text;
  }
}

}  // namespace
}  // namespace rungproof
