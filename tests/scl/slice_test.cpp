// Parts of values (.%X3, .%B1, .%W0), assignments such as n += 1, and ENO in a body in SCL: what TIA Portal writes.
// Each value is reasoned beside its program.
#include "tests/scl/scl_run.hpp"

namespace rungproof {
namespace {

using testscl::commandOn;
using testscl::lastRow;
using testscl::mainOf;
using testscl::proofOf;

constexpr const char* words =
    "VAR_TEMP\n w : WORD; d : DWORD; b : BYTE; f : BOOL; n : INT; i : INT;\n"
    " a : ARRAY[0..3] OF WORD; k : ARRAY[0..3] OF INT;\nEND_VAR\n";

struct SliceCase {
  const char* name;
  const char* body;
  const char* signal;
  const char* value;
};

constexpr SliceCase sliceCases[] = {
    // 16#8108 has the bits 15, 8 and 3; %X0 is the least significant one.
    {"bit that is 1", "#w := W#16#8108; M20.0 := #w.%X3;", "M20.0", "1"},
    {"highest bit", "#w := W#16#8108; M20.0 := #w.%X15;", "M20.0", "1"},
    {"bit that is 0", "#w := W#16#8108; M20.0 := #w.%X7;", "M20.0", "0"},
    {"bit in a condition", "#w := W#16#0100; MW20 := 1; IF #w.%X8 AND NOT #w.%X0 THEN MW20 := 2; END_IF;", "MW20", "2"},
    {"bit of a byte", "#b := B#16#40; M20.0 := #b.%X6;", "M20.0", "1"},
    {"bit of a double word", "#d := DW#16#80000000; M20.0 := #d.%X31;", "M20.0", "1"},
    // 16#12345678: the bytes from the least significant one are 78, 56, 34, 12, the words 5678 and 1234.
    {"byte of a word", "#w := W#16#1234; MB20 := #w.%B1;", "MB20", "18"},
    {"lowest byte of a word", "#w := W#16#1234; MB20 := #w.%B0;", "MB20", "52"},
    {"byte of a double word", "#d := DW#16#12345678; MB20 := #d.%B2;", "MB20", "52"},
    {"word of a double word", "#d := DW#16#12345678; MW20 := #d.%W1;", "MW20", "4660"},
    {"lowest word", "#d := DW#16#12345678; MW20 := #d.%W0;", "MW20", "22136"},
    {"bit of an address", "MW20 := W#16#0004; M30.0 := MW20.%X2;", "M30.0", "1"},
    // The first byte of a word is its more significant one: bit 0 of MW20 is M21.0.
    {"bit is written at its place", "MW20 := 0; MW20.%X0 := TRUE;", "M21.0", "1"},
    {"others stay", "#w := W#16#00FF; #w.%X4 := FALSE; MW20 := #w;", "MW20", "239"},
    {"bit is set", "#w := W#16#0001; #f := TRUE; #w.%X15 := #f; MW20 := #w;", "MW20", "-32767"},
    // 16#1234 with B0 = 16#FF is 16#12FF = 4863, with B1 = 1 16#0134 = 308.
    {"low byte is written", "#w := W#16#1234; #w.%B0 := B#16#FF; MW20 := #w;", "MW20", "4863"},
    {"high byte is written", "#w := W#16#1234; #w.%B1 := B#16#01; MW20 := #w;", "MW20", "308"},
    {"word is written", "#d := DW#16#12345678; #d.%W1 := W#16#0001; MD20 := #d;", "MD20", "87672"},  // 16#15678
    {"two parts of one value", "#w := W#16#0001; #w.%X1 := #w.%X0; MW20 := #w;", "MW20", "3"},
    {"behind an index that is computed", "#i := 2; #a[2] := 0; #a[#i].%X1 := TRUE; MW20 := #a[2];", "MW20", "2"},
    {"read behind such an index", "#i := 2; #a[2] := W#16#0102; MB20 := #a[#i].%B1;", "MB20", "1"},
    {"beside another operand", "#w := W#16#0304; #b := #w.%B1 XOR #w.%B0; MB20 := #b;", "MB20", "7"},  // 3 XOR 4
    {"sum", "#n := 5; #n += 2 * 3; MW20 := #n;", "MW20", "11"},
    // 20 - (1 + 2) and not 20 - 1 + 2.
    {"difference of all that stands behind", "#n := 20; #n -= 1 + 2; MW20 := #n;", "MW20", "17"},
    {"product and quotient", "#n := 7; #n *= 3; #n /= 2; MW20 := #n;", "MW20", "10"},
    {"sum of an element", "#i := 1; #k[1] := 4; #k[#i] += 1; MW20 := #k[1];", "MW20", "5"},
};

TEST(SclSlices, Values) {
  for (const SliceCase& one : sliceCases)
    EXPECT_EQ(lastRow(mainOf(one.body, words), one.signal), std::string("1,") + one.value) << one.name;
}

TEST(SclSlices, ProofsKnowThem) {
  // Whatever comes in, the part that was written is what is read, and the rest of the word stays.
  const test7::Output proof =
      proofOf("prove part: M30.0 = I0.0\nprove rest: M30.1 = I1.1\nprove byte: MB31 = IB3\n",
              mainOf("MW20 := IW0; MW20.%X3 := I0.0; M30.0 := MW20.%X3; M30.1 := MW20.%X1;\n#w := IW2; MB31 := #w.%B0;",
                     words));
  EXPECT_EQ(proof.exit, 0) << proof.text;
}

TEST(SclSlices, WhatHasNoSuchPart) {
  for (const char* body : {"#f := #w.%X16;", "#b := #b.%B0;", "#w := #w.%W0;", "#f := #n.%X1;", "#w.%B2 := 1;"}) {
    const test7::Output lint = commandOn("lint", mainOf(body, words));
    EXPECT_TRUE(lint.has("error[SYN075]")) << body << '\n' << lint.text;
  }
}

TEST(SclSlices, EnoIsHandedBack) {
  const std::string block = "FUNCTION FC 1 : VOID\nVAR_INPUT f : BOOL; END_VAR\nBEGIN\n ENO := #f;\nEND_FUNCTION\n";
  const std::string caller = "VAR_TEMP\n e : BOOL;\nEND_VAR\n";
  EXPECT_EQ(lastRow(block + mainOf("FC1(f := FALSE, ENO => #e); M20.0 := #e;", caller), "M20.0"), "1,0");
  EXPECT_EQ(lastRow(block + mainOf("FC1(f := TRUE, ENO => #e); M20.0 := #e;", caller), "M20.0"), "1,1");
}

}  // namespace
}  // namespace rungproof
