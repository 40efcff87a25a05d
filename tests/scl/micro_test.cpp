// Micro programs in SCL with the values that reasoning gives. Each one is OB1 alone; the reason stands beside it.
#include "tests/scl/scl_run.hpp"

namespace rungproof {
namespace {

using testscl::lastRow;
using testscl::mainOf;

struct MicroCase {
  const char* name;
  const char* declarations;
  const char* body;
  const char* signal;
  const char* value;
};

constexpr const char* ints =
    "VAR_TEMP\n a : INT; b : INT; d : DINT; r : REAL; t : TIME; f : BOOL; g : BOOL; w : WORD;\nEND_VAR\n";

constexpr MicroCase microCases[] = {
    {"assignment", "", "MW20 := 5;", "MW20", "5"},
    {"negative number", "", "MW20 := -5;", "MW20", "-5"},
    {"product before sum", ints, "#a := 3; MW20 := 2 + #a * 4;", "MW20", "14"},
    {"parentheses", ints, "#a := 3; MW20 := (2 + #a) * 4;", "MW20", "20"},
    {"differences bind to the left", ints, "#a := 10; MW20 := #a - 3 - 2;", "MW20", "5"},
    {"right side in parentheses", ints, "#a := 10; MW20 := #a - (3 - 2);", "MW20", "9"},
    {"both sides computed", ints, "#a := 10; #b := 3; MW20 := (#a + #b) * (#a - #b);", "MW20", "91"},
    // 7 / 2 is 3 with remainder 1; the quotient is cut towards zero: -7 / 2 is -3, remainder -1.
    {"quotient of INT", ints, "#a := -7; MW20 := #a / 2;", "MW20", "-3"},
    {"DIV is the same", ints, "#a := 7; MW20 := #a DIV 2;", "MW20", "3"},
    {"remainder", ints, "#a := -7; MW20 := #a MOD 2;", "MW20", "-1"},
    {"sign of a value", ints, "#a := 7; MW20 := -#a + 1;", "MW20", "-6"},
    // 300 * 300 = 90000 does not fit an INT, but a DINT.
    {"INT beside DINT", ints, "#a := 300; #d := 300; MD20 := #a * #d;", "MD20", "90000"},
    // 90000 - 65536 = 24464: the lower half stays.
    {"INT overflows", ints, "#a := 300; MW20 := #a * 300;", "MW20", "24464"},
    {"negative INT into DINT", ints, "#a := -2; #d := #a; MD20 := #d;", "MD20", "-2"},
    {"INT into REAL", ints, "#a := 7; #r := #a; MD20 := ROUND(#r * 2.5);", "MD20", "18"},  // 17.5: to the even one
    {"quotient of REAL", ints, "#r := 7; MD20 := TRUNC(#r / 2);", "MD20", "3"},
    {"literal beside REAL", ints, "#r := 1.5; MD20 := TRUNC(#r + 1);", "MD20", "2"},
    {"REAL_TO_INT rounds", ints, "#r := 2.6; MW20 := REAL_TO_INT(#r);", "MW20", "3"},
    {"INT_TO_REAL", ints, "#a := 9; MD20 := ROUND(SQRT(INT_TO_REAL(#a)));", "MD20", "3"},
    // Of 70000 = 16#11170 the lower half is 16#1170 = 4464.
    {"DINT_TO_INT", ints, "#d := 70000; MW20 := DINT_TO_INT(#d);", "MW20", "4464"},
    {"WORD_TO_INT", ints, "#w := W#16#FFFF; MW20 := WORD_TO_INT(#w) + 1;", "MW20", "0"},
    {"INT_TO_WORD", ints, "#a := -1; #w := INT_TO_WORD(#a); IF #w = W#16#FFFF THEN MW20 := 1; END_IF;", "MW20", "1"},
    {"BCD_TO_INT", ints, "#w := W#16#0123; MW20 := BCD_TO_INT(#w);", "MW20", "123"},
    {"INT_TO_BCD", ints, "#a := 123; MW20 := INT_TO_BCD(#a);", "MW20", "291"},  // 16#123
    {"BOOL_TO_INT", ints, "#f := TRUE; MW20 := 4 + BOOL_TO_INT(#f);", "MW20", "5"},
    {"ABS of INT", ints, "#a := -9; MW20 := ABS(#a);", "MW20", "9"},
    {"ABS of REAL", ints, "#r := -2.5; MD20 := TRUNC(ABS(#r));", "MD20", "2"},
    {"MIN", ints, "#a := 4; MW20 := MIN(#a, 7, 3);", "MW20", "3"},
    {"MAX with names", ints, "#a := 4; MW20 := MAX(IN1 := #a, IN2 := 7);", "MW20", "7"},
    {"LIMIT below", ints, "#a := -4; MW20 := LIMIT(MN := 0, IN := #a, MX := 9);", "MW20", "0"},
    {"LIMIT above", ints, "#a := 40; MW20 := LIMIT(0, #a, 9);", "MW20", "9"},
    {"LIMIT within", ints, "#a := 4; MW20 := LIMIT(0, #a, 9);", "MW20", "4"},
    {"SEL chooses the first with FALSE", ints, "#f := FALSE; MW20 := SEL(G := #f, IN0 := 1, IN1 := 2);", "MW20", "1"},
    {"SEL chooses the second with TRUE", ints, "#f := TRUE; MW20 := SEL(#f, 1, 2);", "MW20", "2"},
    {"MUX", ints, "#a := 2; MW20 := MUX(K := #a, IN0 := 5, IN1 := 6, IN2 := 7);", "MW20", "7"},
    {"SHL", ints, "#w := W#16#0011; MW20 := SHL(IN := #w, N := 4);", "MW20", "272"},  // 16#110
    {"SHR", ints, "#w := W#16#8000; MW20 := SHR(#w, 15);", "MW20", "1"},
    {"ROL of a word", ints, "#w := W#16#8001; MW20 := ROL(#w, 1);", "MW20", "3"},
    {"ROR of a byte", "VAR_TEMP\n b : BYTE;\nEND_VAR\n", "#b := B#16#03; MB20 := ROR(#b, 1);", "MB20", "129"},
    {"AND of words", ints, "#w := W#16#0F0F; MW20 := #w AND W#16#00FF;", "MW20", "15"},
    {"XOR and NOT of words", ints, "#w := W#16#00FF; MW20 := NOT (#w XOR W#16#FF00);", "MW20", "0"},
    {"NOT of a byte", "VAR_TEMP\n b : BYTE;\nEND_VAR\n", "#b := B#16#F0; MB20 := NOT #b;", "MB20", "15"},
    {"AND before XOR before OR", ints, "M20.0 := TRUE OR TRUE XOR TRUE AND FALSE;", "M20.0", "1"},
    {"AND of comparisons", ints, "#a := 5; M20.0 := #a > 4 AND #a < 6 AND NOT (#a = 7);", "M20.0", "1"},
    {"OR of comparisons", ints, "#a := 5; M20.0 := #a < 4 OR #a >= 6;", "M20.0", "0"},
    {"XOR", ints, "#f := TRUE; #g := TRUE; M20.0 := #f XOR #g;", "M20.0", "0"},
    {"BOOL compared", ints, "#f := TRUE; #g := FALSE; M20.0 := #f = #g; M20.1 := #f <> #g;", "M20.1", "1"},
    {"BOOL against FALSE", ints, "#f := FALSE; M20.0 := #f = FALSE;", "M20.0", "1"},
    {"ampersand", ints, "#f := TRUE; #g := TRUE; M20.0 := #f & #g;", "M20.0", "1"},
    {"words have no sign in comparisons", ints, "#w := W#16#8000; M20.0 := #w > W#16#0001;", "M20.0", "1"},
    {"INT has a sign in comparisons", ints, "#a := -1; M20.0 := #a < 1;", "M20.0", "1"},
    {"REAL compared with INT", ints, "#r := 1.5; #a := 1; M20.0 := #r > #a;", "M20.0", "1"},
    {"TIME", ints, "#t := T#2s; MD20 := TIME_TO_DINT(#t + T#500ms);", "MD20", "2500"},
    {"TIME times INT", ints, "#t := T#2s; #a := 3; MD20 := TIME_TO_DINT(#t * #a / 2);", "MD20", "3000"},
    {"TIME compared", ints, "#t := T#2s; M20.0 := #t >= T#2000ms;", "M20.0", "1"},
    {"IF", ints, "#a := 5; IF #a > 3 THEN MW20 := 1; ELSE MW20 := 2; END_IF;", "MW20", "1"},
    {"ELSIF", ints, "#a := 5; IF #a > 7 THEN MW20 := 1; ELSIF #a > 4 THEN MW20 := 2; ELSE MW20 := 3; END_IF;", "MW20",
     "2"},
    {"ELSE", ints, "#a := 1; IF #a > 7 THEN MW20 := 1; ELSIF #a > 4 THEN MW20 := 2; ELSE MW20 := 3; END_IF;", "MW20",
     "3"},
    {"CASE value", ints, "#a := 2; CASE #a OF 1: MW20 := 10; 2: MW20 := 20; ELSE MW20 := 30; END_CASE;", "MW20", "20"},
    {"CASE list and range", ints,
     "#a := 6; CASE #a OF 1, 3: MW20 := 10; 5..7, 9: MW20 := 20; ELSE: MW20 := 30; END_CASE;", "MW20", "20"},
    {"CASE behind the range", ints, "#a := 9; CASE #a OF 5..7, 9: MW20 := 20; ELSE MW20 := 30; END_CASE;", "MW20",
     "20"},
    {"CASE else", ints, "#a := 8; CASE #a OF 5..7, 9: MW20 := 20; ELSE MW20 := 30; END_CASE;", "MW20", "30"},
    {"CASE of a negative number", ints, "#a := -2; CASE #a OF -3..-1: MW20 := 7; END_CASE;", "MW20", "7"},
    {"CASE does not look twice", ints, "#a := 1; CASE #a OF 1: #a := 2; 2: MW20 := 9; END_CASE; MW22 := #a;", "MW22",
     "2"},
    {"FOR", ints, "#b := 0; FOR #a := 1 TO 4 DO #b := #b + #a; END_FOR; MW20 := #b;", "MW20", "10"},
    {"FOR down", ints, "#b := 0; FOR #a := 9 TO 1 BY -3 DO #b := #b + #a; END_FOR; MW20 := #b;", "MW20", "18"},
    {"FOR without a pass", ints, "#b := 7; FOR #a := 2 TO 1 DO #b := 0; END_FOR; MW20 := #b;", "MW20", "7"},
    // The limit is computed before the first pass.
    {"FOR keeps its limit", ints, "#b := 3; #d := 0; FOR #a := 1 TO #b DO #b := 9; #d := #d + 1; END_FOR; MD20 := #d;",
     "MD20", "3"},
    {"FOR with EXIT", ints, "FOR #a := 1 TO 9 DO IF #a = 4 THEN EXIT; END_IF; END_FOR; MW20 := #a;", "MW20", "4"},
    {"FOR with CONTINUE", ints,
     "#b := 0; FOR #a := 1 TO 5 DO IF #a = 3 THEN CONTINUE; END_IF; #b := #b + #a; END_FOR; MW20 := #b;", "MW20", "12"},
    {"WHILE", ints, "#a := 1; WHILE #a < 100 DO #a := #a * 2; END_WHILE; MW20 := #a;", "MW20", "128"},
    {"REPEAT runs once", ints, "#a := 5; REPEAT #a := #a + 1; UNTIL #a > 0 END_REPEAT; MW20 := #a;", "MW20", "6"},
    {"loops in loops", ints,
     "#d := 0; FOR #a := 1 TO 3 DO FOR #b := 1 TO #a DO IF #b = 3 THEN EXIT; END_IF; #d := #d + 1; END_FOR; END_FOR; "
     "MD20 := #d;",
     "MD20", "5"},
    {"RETURN", ints, "MW20 := 1; RETURN; MW20 := 2;", "MW20", "1"},
    {"GOTO", ints, "MW20 := 1; GOTO over; MW20 := 2; over: MW22 := 3;", "MW20", "1"},
    {"label with a statement", ints, "#a := 0; again: #a := #a + 1; IF #a < 5 THEN GOTO again; END_IF; MW20 := #a;",
     "MW20", "5"},
    {"a constant of the block", "CONST\n LIMIT := 5; TWICE := LIMIT * 2;\nEND_CONST\n", "MW20 := TWICE + 1;", "MW20",
     "11"},
    {"typed numbers", ints, "#a := INT#5; #w := WORD#16#00FF; #d := DINT#70000; MD20 := #d + #a;", "MD20", "70005"},
    {"hexadecimal numbers", ints, "#a := 16#1F; MW20 := #a;", "MW20", "31"},
    {"names without a sign", "VAR_TEMP\n level : INT;\nEND_VAR\n", "level := 4; MW20 := level;", "MW20", "4"},
    {"German addresses", ints, "A 4.0 := NOT E0.0; AW6 := 7;", "QW6", "7"},
    {"addresses with blanks and %", ints, "M 20.1 := TRUE; %M20.2 := M 20.1;", "M20.2", "1"},
    {"local arrays", "VAR_TEMP\n x : ARRAY [1..3] OF INT; i : INT;\nEND_VAR\n",
     "FOR #i := 1 TO 3 DO #x[#i] := #i * 10; END_FOR; MW20 := #x[2] + #x[#i - 1];", "MW20", "50"},
    {"arrays of two dimensions", "VAR_TEMP\n x : ARRAY [0..1, 1..3] OF INT; i : INT; j : INT;\nEND_VAR\n",
     "FOR #i := 0 TO 1 DO FOR #j := 1 TO 3 DO #x[#i, #j] := #i * 10 + #j; END_FOR; END_FOR; MW20 := #x[1, 2];", "MW20",
     "12"},
    {"arrays of bits", "VAR_TEMP\n x : ARRAY [0..15] OF BOOL; i : INT;\nEND_VAR\n",
     "FOR #i := 0 TO 15 DO #x[#i] := #i = 9; END_FOR; M20.0 := #x[9]; M20.1 := #x[8]; #i := 9; M20.2 := #x[#i];",
     "M20.2", "1"},
    {"arrays of structures", "VAR_TEMP\n x : ARRAY [1..2] OF STRUCT a : BOOL; n : INT; END_STRUCT; i : INT;\nEND_VAR\n",
     "#i := 2; #x[#i].n := 8; #x[1].n := 1; MW20 := #x[2].n;", "MW20", "8"},
    {"whole arrays", "VAR_TEMP\n x : ARRAY [1..3] OF INT; y : ARRAY [1..3] OF INT;\nEND_VAR\n",
     "#x[1] := 1; #x[2] := 2; #x[3] := 3; #y := #x; MW20 := #y[3];", "MW20", "3"},
    // The byte is computed, and the bit.
    {"address with a computed byte, written", ints, "#a := 10; MW[#a * 2] := 7;", "MW20", "7"},
    {"address with a computed byte, read", ints, "MW12 := 5; #a := 12; MW20 := WORD_TO_INT(MW[#a]) + 1;", "MW20", "6"},
    {"address with a computed bit", ints, "#a := 3; M[20, #a] := TRUE;", "MB20", "8"},
    {"address with a computed bit, read", ints, "MB10 := B#16#08; #a := 3; IF M[10, #a] THEN MW20 := 4; END_IF;",
     "MW20", "4"},
    {"output with a computed byte", ints, "#a := 4; QB[#a + 1] := B#16#09;", "QB5", "9"},
    {"regions are for the reader", ints, "REGION any name here\n MW20 := 6;\nEND_REGION", "MW20", "6"},
    {"comments", ints, "(* MW20 := 1; *) MW20 := 2; // MW20 := 3;", "MW20", "2"},
};

TEST(SclMicro, EveryProgramGivesTheReasonedValue) {
  for (const MicroCase& one : microCases)
    EXPECT_EQ(lastRow(mainOf(one.body, one.declarations), one.signal), std::string("1,") + one.value) << one.name;
}

}  // namespace
}  // namespace rungproof
