// Malformed sources: each mistake has its exact place and message, what stands around it is read, and the network of a
// statement that cannot be read is not complete.
#include <gtest/gtest.h>

#include "tests/step7/read7.hpp"

namespace rungproof {
namespace {

struct Mistake {
  const char* what;
  const char* text;
  const char* findings;
};

/// Statements stand from line 4 on in the frame of readOb1.
const Mistake inStatements[] = {
    {"unknown instruction", "  FOO M 0.0;", "SYN044 4:3 unknown instruction FOO"},
    {"a mnemonic of the other set", "  A I 0.0;\n  AN I 0.1;\n  UN M 0.0;",
     "SYN044 6:3 UN is a mnemonic of the German set, the source is written in the international one"},
    {"no bit number", "  A M 10;", "SYN044 4:5 the bit number is missing, as in M 10.0"},
    {"bit 8", "  A M 10.8;", "SYN044 4:5 a byte has the bits 0 to 7"},
    {"bit number of a word", "  L MW 10.1;", "SYN044 4:5 only bits have a bit number"},
    {"two operands", "  A I 0.0 I 0.1;", "SYN044 4:11 text behind the end of the statement"},
    {"a word too large", "  L W#16#10000;", "SYN044 4:5 the value is larger than 16#FFFF"},
    {"a time too long", "  L S5T#3H;", "SYN044 4:5 an S5TIME is at most 2H46M30S"},
    {"a counter value too large", "  L C#1000;", "SYN044 4:5 a counter value is 0 to 999"},
    {"a day that is none", "  L D#2010-2-29;", "SYN044 4:5 there is no such day between 1990 and 2168"},
    {"constants of no kind", "  L FOO#1;", "SYN044 4:5 no constants begin with FOO#"},
    {"open text", "  L 'ab;", "SYN044 4:5 the text has no second apostrophe"},
    {"open name", "  A \"Motor;", "SYN044 4:5 the name has no second quotation mark"},
    {"a name that no table has", "  A \"Motor\";", "SYN046 4:5 nothing defines \"Motor\""},
    {"a local name that is not declared", "  A #motor;", "SYN046 4:6 nothing declares motor"},
    {"a block that is in no file", "  CALL FC 7;", "SYN049 4:8 FC7 is in none of the files"},
    {"a data block that is in no file", "  L DB9.DBW 0;", "SYN049 4:5 DB9 is in none of the files"},
    {"opening a block that is in no file", "  OPN DB 9;", "SYN049 4:7 DB9 is in none of the files"},
    {"a label that is missing", "  JC m1;", "SYN048 4:6 the block has no label m1"},
    {"a label that is there twice", "m1: SET;\nm1: CLR;", "SYN048 5:1 label m1 is there twice"},
    {"a label in other letters", "M1: SET;\n  JC m1;", "SYN048 5:6 the block has no label m1"},
    {"a jump without label", "  JC ;", "SYN048 4:3 JC needs a label"},
    {"a bit for L", "  L M 0.0;", "SYN045 4:5 L takes a byte, word or double word, not a bit"},
    {"a word for A", "  A MW 0;", "SYN045 4:5 A takes a bit, not a word"},
    {"a constant for =", "  = 5;", "SYN045 4:5 = takes no constant"},
    {"an operand for SET", "  SET M 0.0;", "SYN045 4:7 SET takes no operand"},
    {"no operand for L", "  L ;", "SYN045 4:3 L needs an operand"},
    {"a shift too far", "  SLW 17;", "SYN045 4:7 SLW takes 0 to 16"},
    {"a step too large", "  INC 256;", "SYN045 4:7 INC takes 0 to 255"},
    {"five characters", "  L 'abcde';", "SYN045 4:5 at most four characters fit into an accumulator"},
    {"a date and time", "  L DT#2000-1-1-0:0:0;", "SYN045 4:5 the constant is wider than an accumulator"},
    {"a pointer with a length", "  L P#M 0.0 BYTE 4;", "SYN045 4:5 the constant is wider than an accumulator"},
    {"a pointer with a block", "  L P#DB1.DBX0.0;", "SYN045 4:5 the constant is wider than an accumulator"},
    {"writing an input module", "  T PIW 256;", "SYN045 4:5 T does not take an operand of this area"},
    {"a pointer in a word", "  A M [MW 2];", "SYN045 4:8 the pointer stands in a double word"},
    {"a number in a double word", "  A T [MD 2];", "SYN045 4:8 the number stands in a word"},
    {"an open bracket", "  A M [MD 2;", "SYN044 4:5 the closing bracket is missing"},
    {"a register without offset", "  L W [AR1];", "SYN044 4:5 an offset such as P#0.0 is missing"},
    {"a bit in the offset of a word", "  L W [AR1,P#0.1];", "SYN045 4:5 the offset of a byte or word has no bit part"},
    {"no instruction at all", "  ?;\n  SET;", "SYN044 4:3 unknown instruction ?"},
    {"NOP 2", "  NOP 2;", "SYN045 4:7 NOP takes another operand"},
};

TEST(MalformedStatements, EachHasItsPlaceAndTheRestIsRead) {
  for (const Mistake& mistake : inStatements) {
    const Program program = readOb1(std::string(mistake.text) + "\nNETWORK\n  SET;\n");
    EXPECT_EQ(findings7(program), mistake.findings) << mistake.what;
    ASSERT_EQ(program.pous.size(), 1u) << mistake.what;
    ASSERT_EQ(program.pous[0].networks.size(), 2u) << mistake.what;
    const bool isOfLabels = std::string_view(mistake.findings).find("is there twice") != std::string_view::npos;
    EXPECT_EQ(program.pous[0].networks[0].complete, isOfLabels) << mistake.what;
    EXPECT_TRUE(program.pous[0].networks[1].complete) << mistake.what;
    EXPECT_EQ(program.findings.at(0).pou, "OB1") << mistake.what;
    EXPECT_EQ(program.findings.at(0).network, 1) << mistake.what;
  }
}

// The help says where the name is looked for: in the block, in a symbol table, in the source of a data block.
TEST(MalformedStatements, HelpNamesWhatDefines) {
  const std::pair<const char*, const char*> names[] = {{"A #motor;", "VAR section"},
                                                       {"A \"Motor\";", ".sdf"},
                                                       {"L \"Motor\".speed;", "source of the data block"},
                                                       {"L M 0.0;", "--dialect s7-300"}};
  for (const auto& [text, help] : names)
    EXPECT_NE(readOb1(std::string(text) + "\n").findings.at(0).help.find(help), std::string::npos) << text;
}

const char* const sum =
    "FUNCTION FC 5 : INT\nVAR_INPUT\n  A : INT ;\n  B : INT ;\nEND_VAR\nVAR_OUTPUT\n  Q : BOOL ;\nEND_VAR\nBEGIN\n"
    "NETWORK\n  L #A;\n  T #RET_VAL;\nEND_FUNCTION\n"
    "FUNCTION_BLOCK FB 2\nVAR_INPUT\n  IN : BOOL ;\n  T1 : TIMER ;\nEND_VAR\nBEGIN\nNETWORK\n  A #IN;\n"
    "END_FUNCTION_BLOCK\nDATA_BLOCK DB 2\n FB 2\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 3\nSTRUCT\n  x : INT ;\n"
    "END_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n";

/// The call stands in line 36.
const Mistake inCalls[] = {
    {"a parameter is missing", "CALL FC 5 (A := 1, Q := M 0.0, RET_VAL := MW 2);",
     "SYN047 36:6 FC5 needs a value for B"},
    {"a parameter that is none", "CALL FC 5 (A := 1, B := 2, C := 3, Q := M 0.0, RET_VAL := MW 2);",
     "SYN047 36:28 FC5 has no parameter C"},
    {"a parameter twice", "CALL FC 5 (A := 1, A := 2, B := 2, Q := M 0.0, RET_VAL := MW 2);",
     "SYN047 36:20 A is given twice"},
    {"a constant for an output", "CALL FC 5 (A := 1, B := 2, Q := TRUE, RET_VAL := MW 2);",
     "SYN047 36:33 Q of FC5 takes no constant: the block writes it"},
    {"a value of another type", "CALL FC 5 (A := 1.5, B := 2, Q := M 0.0, RET_VAL := MW 2);",
     "SYN047 36:17 the value for A is no INT"},
    {"another width", "CALL FC 5 (A := MD 4, B := 2, Q := M 0.0, RET_VAL := MW 2);",
     "SYN047 36:17 A of FC5 is INT: the operand has another width"},
    {"no comma", "CALL FC 5 (A := 1 B := 2, Q := M 0.0, RET_VAL := MW 2);",
     "SYN044 36:12 a comma is missing between two parameters"},
    {"no sign", "CALL FC 5 (A 1);", "SYN044 36:12 := is missing behind the name of the parameter"},
    {"an open list", "CALL FC 5 (A := 1,", "SYN044 36:1 the parameter list is not closed"},
    {"no instance", "CALL FB 2 (IN := M 0.0, T1 := T 1);", "SYN047 36:6 FB2 needs an instance data block"},
    {"a data block of another kind", "CALL FB 2 , DB 3 (IN := M 0.0, T1 := T 1);",
     "SYN047 36:13 DB3 is no instance of FB2"},
    {"no timer", "CALL FB 2 , DB 2 (IN := M 0.0);", "SYN047 36:6 FB2 needs a value for T1"},
    {"a counter for a timer", "CALL FB 2 , DB 2 (IN := M 0.0, T1 := C 1);", "SYN047 36:38 T1 of FB2 takes a TIMER"},
    {"an instance for an FC", "CALL FC 5 , DB 2 (A := 1, B := 2, Q := M 0.0, RET_VAL := MW 2);",
     "SYN045 36:13 FC5 has no instance data block"},
    {"UC of a block with parameters", "UC FC 5;", "SYN047 36:4 UC gives no parameters, but FC5 has some"},
    {"CALL of a data block", "CALL DB 3;", "SYN045 36:6 CALL takes an FC, FB, SFC or SFB"},
};

TEST(MalformedCalls, EachHasItsPlace) {
  for (const Mistake& mistake : inCalls) {
    const Program program = read7(std::string(sum) + mistake.text + "\nEND_ORGANIZATION_BLOCK\n");
    EXPECT_EQ(findings7(program), mistake.findings) << mistake.what;
    ASSERT_NE(program.main(), nullptr);
    EXPECT_FALSE(program.main()->networks.at(0).complete) << mistake.what;
  }
}

const Mistake inFrames[] = {
    {"no end", "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nSET;\n", "SYN020 1:1 END_FUNCTION is missing"},
    {"another end", "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION_BLOCK\n",
     "SYN020 5:1 END_FUNCTION_BLOCK ends a block that END_FUNCTION should end"},
    {"an end without a beginning", "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\nEND_FUNCTION\n",
     "SYN021 6:1 END_FUNCTION without its heading"},
    {"a line between blocks", "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\nhello there\n",
     "SYN025 6:1 \"hello there\" stands outside of any block"},
    {"a block twice",
     "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\nFUNCTION FC 1 : "
     "VOID\nBEGIN\nNETWORK\nCLR;\nEND_FUNCTION\n",
     "SYN022 6:1 FC1 is there twice: only the first one is read"},
    {"a block of another kind", "FUNCTION FB 1 : VOID\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n",
     "SYN039 1:10 FB 1 is no name of this kind of block"},
    {"a line of no meaning in the head", "FUNCTION FC 1 : VOID\nCOLOUR green\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n",
     "SYN039 2:1 \"COLOUR green\" is no line of a block's head"},
    {"no colon", "FUNCTION FC 1 : VOID\nVAR_INPUT\n  a BOOL ;\nEND_VAR\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n",
     "SYN040 3:5 a colon and a type are missing behind a"},
    {"no semicolon",
     "FUNCTION FC 1 : VOID\nVAR_INPUT\n  a : BOOL\n  b : INT ;\nEND_VAR\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n",
     "SYN040 3:10 a semicolon is missing behind the declaration"},
    {"a type that is none",
     "FUNCTION FC 1 : VOID\nVAR_INPUT\n  a : BOOLE ;\nEND_VAR\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n",
     "SYN042 3:7 nothing defines the type \"BOOLE\""},
    {"no END_VAR", "FUNCTION FC 1 : VOID\nVAR_INPUT\n  a : BOOL ;\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n",
     "SYN040 4:1 END_VAR is missing"},
    {"a name twice",
     "FUNCTION FC 1 : VOID\nVAR_INPUT\n  a : BOOL ;\n  A : INT ;\nEND_VAR\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n",
     "SYN040 4:3 A is declared twice"},
    {"bounds the wrong way",
     "DATA_BLOCK \"D\"\nSTRUCT\n  a : ARRAY[5..1] OF INT ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n",
     "SYN040 3:12 the bounds of an array are written [1..10] or [1..10,0..3]"},
    {"a text too long", "DATA_BLOCK \"D\"\nSTRUCT\n  a : STRING[300] ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n",
     "SYN040 3:13 a STRING has 0 to 254 characters, as in STRING[20]"},
    {"a value of another type", "DATA_BLOCK \"D\"\nSTRUCT\n  a : INT := 'x' ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n",
     "SYN043 3:14 the value is no INT"},
    {"too many values",
     "DATA_BLOCK \"D\"\nSTRUCT\n  a : ARRAY[1..2] OF INT := 1, 2, 3 ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n",
     "SYN043 3:35 a has fewer elements than values"},
    {"an assignment to nothing",
     "DATA_BLOCK \"D\"\nSTRUCT\n  a : INT ;\nEND_STRUCT ;\nBEGIN\n  b := 1 ;\nEND_DATA_BLOCK\n",
     "SYN046 6:3 D declares no b"},
    {"an index beyond",
     "DATA_BLOCK \"D\"\nSTRUCT\n  a : ARRAY[1..2] OF INT ;\nEND_STRUCT ;\nBEGIN\n  a[3] := 1 ;\nEND_DATA_BLOCK\n",
     "SYN046 6:3 a has no such element"},
    {"an assignment without value",
     "DATA_BLOCK \"D\"\nSTRUCT\n  a : INT ;\nEND_STRUCT ;\nBEGIN\n  a ;\nEND_DATA_BLOCK\n",
     "SYN041 6:3 := is missing behind a"},
    {"a UDT in itself", "TYPE UDT 1\nSTRUCT\n  a : UDT 1 ;\nEND_STRUCT ;\nEND_TYPE\n",
     "SYN042 3:7 UDT 1 contains itself"},
    {"a data block that is too large",
     "DATA_BLOCK \"D\"\nSTRUCT\n  a : ARRAY[1..32767] OF REAL ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n",
     "SYN051 3:3 a has more than 65535 bytes"},
};

TEST(MalformedFrames, EachHasItsPlace) {
  for (const Mistake& mistake : inFrames) EXPECT_EQ(findings7(read7(mistake.text)), mistake.findings) << mistake.what;
}

TEST(MalformedFrames, BothPlacesOfTwins) {
  const Program program =
      read7("FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\nFUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n");
  ASSERT_FALSE(program.findings.empty());
  ASSERT_EQ(program.findings[0].related.size(), 1u);
  EXPECT_EQ(program.sources->position(program.findings[0].related[0].span).line, 1u);
}

/// As many members as a data block holds; the twin of the first is found among them, whatever its capitals.
TEST(MalformedFrames, ATwinAmongManyMembers) {
  std::string text = "DATA_BLOCK \"D\"\nSTRUCT\n";
  for (int i = 0; i < 30'000; ++i) text += "  a" + std::to_string(i) + " : INT ;\n";
  const Program program = read7(text + "  A0 : INT ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n");
  EXPECT_EQ(findings7(program), "SYN040 30003:3 A0 is declared twice");
  ASSERT_EQ(program.findings[0].related.size(), 1u);
  EXPECT_EQ(program.sources->position(program.findings[0].related[0].span).line, 3u);
}

}  // namespace
}  // namespace rungproof
