// Views with AT: another type over the place of a variable. The high byte of a word comes first in memory, and bit 0 of
// a byte is its lowest, so that element 8 of an ARRAY[0..15] OF BOOL over a WORD is the lowest bit of the word.
#include "tests/scl/scl_run.hpp"

namespace rungproof {
namespace {

using testscl::commandOn;
using testscl::lastRow;
using testscl::mainOf;
using testscl::Output;

std::string blockOf(const std::string& declarations, const std::string& body) {
  return "FUNCTION_BLOCK FB 1\n" + declarations + "BEGIN\n" + body +
         "\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";
}

// W#16#0180: bit 0 of the high byte is element 0, bit 7 of the low byte is element 15.
TEST(SclViews, BitsOfAWord) {
  const std::string program =
      mainOf("#w := W#16#0180; M20.0 := #bit[0]; M20.1 := #bit[8]; M20.2 := #bit[15]; #bit[8] := TRUE; MW22 := #w;",
             "VAR_TEMP\n w : WORD; bit AT w : ARRAY[0..15] OF BOOL;\nEND_VAR\n");
  EXPECT_EQ(lastRow(program, "M20.0,M20.1,M20.2,MW22"), "1,1,0,1,385");
}

// Eight bits lie over a byte, although an array takes an even number of bytes where it stands by itself.
TEST(SclViews, BitsOfAByte) {
  const std::string program = mainOf("#b := B#16#81; M20.0 := #bit[0]; M20.1 := #bit[6]; #bit[7] := FALSE; MB22 := #b;",
                                     "VAR_TEMP\n b : BYTE; bit AT b : ARRAY[0..7] OF BOOL;\nEND_VAR\n");
  EXPECT_EQ(lastRow(program, "M20.0,M20.1,MB22"), "1,1,0,1");
}

// 16#1234_5678: the high word 16#1234 = 4660 comes first. Written through the view the whole changes.
TEST(SclViews, PartsOfADoubleWord) {
  const std::string views =
      "VAR_TEMP\n d : DWORD;\n part AT d : STRUCT\n  high : WORD;\n  low : WORD;\n END_STRUCT;\n"
      " byte AT part : ARRAY[1..4] OF BYTE;\nEND_VAR\n";
  EXPECT_EQ(lastRow(mainOf("#d := DW#16#12345678; MW20 := #part.high; MB22 := #byte[4];", views), "MW20,MB22"),
            "1,4660,120");
  EXPECT_EQ(lastRow(mainOf("#d := 0; #part.low := W#16#0102; #byte[1] := B#16#7F; MD20 := #d;", views), "MD20"),
            "1,2130706690");  // 16#7F00_0102
}

// Inputs and static data of an FB lie in its instance. The view is no parameter, and the start value stays that of the
// variable: characters would be blanks.
TEST(SclViews, InAnInstance) {
  const std::string program =
      blockOf(
          "VAR_INPUT\n x : INT; y : INT;\n xs AT x : ARRAY[0..1] OF BYTE;\nEND_VAR\n"
          "VAR\n w : WORD := W#16#4142;\n text AT w : ARRAY[0..1] OF CHAR;\nEND_VAR\n",
          " MB20 := #xs[1]; MW22 := #y; MW24 := #w;\n IF #text[0] = 'A' THEN MB26 := 1; END_IF;") +
      mainOf("FB1.DB1(x := 258, y := 7);");
  EXPECT_EQ(lastRow(program, "MB20,MW22,MW24,MB26"), "1,2,7,16706,1");
  const Output handed = commandOn(
      "lint", blockOf("VAR_INPUT\n x : INT;\n xs AT x : ARRAY[0..1] OF BYTE;\nEND_VAR\n", " MB20 := #xs[1];") +
                  mainOf("FB1.DB1(x := 258, xs := 7);"));
  EXPECT_TRUE(handed.has("FB1 has no parameter xs")) << handed.text;
}

// What is written through one name is read through the other, in every state.
TEST(SclViews, ProofsSeeOnePlace) {
  const std::string program =
      blockOf("VAR\n w : WORD;\n bit AT w : ARRAY[0..15] OF BOOL;\nEND_VAR\n",
              " #bit[8] := I0.0; #bit[9] := NOT I0.0;\n M20.0 := (#w AND W#16#0003) = W#16#0001;") +
      mainOf("FB1.DB1();");
  const Output output = testscl::proofOf("prove same: M20.0 = I0.0\nprove other: M20.0\n", program);
  EXPECT_TRUE(output.has("PROVED  same") && output.has("VIOLATED  other")) << output.text;
}

TEST(SclViews, Refused) {
  const auto errorOf = [](const std::string& text) { return commandOn("lint", text); };
  const Output before = errorOf(mainOf("MW20 := #w;", "VAR_TEMP\n b AT w : WORD; w : WORD;\nEND_VAR\n"));
  EXPECT_TRUE(before.has("b: nothing declares w before its view")) << before.text;
  const Output longer = errorOf(mainOf("MW20 := #w;", "VAR_TEMP\n w : WORD; d AT w : DWORD;\nEND_VAR\n"));
  EXPECT_TRUE(longer.has("d has 32 bits, more than w with 16")) << longer.text;
  const Output ofBit = errorOf(mainOf("M20.0 := #f;", "VAR_TEMP\n f : BOOL; b AT f : BYTE;\nEND_VAR\n"));
  EXPECT_TRUE(ofBit.has("b has 8 bits, more than f with 1")) << ofBit.text;
  const Output start = errorOf(blockOf("VAR\n w : WORD;\n b AT w : INT := 5;\nEND_VAR\n", " MW20 := #w;"));
  EXPECT_TRUE(start.has("b: a view has no start value")) << start.text;
  const Output function = errorOf(
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n x : WORD; b AT x : ARRAY[0..1] OF BYTE;\nEND_VAR\n"
      "BEGIN\n MB20 := #b[0];\nEND_FUNCTION\n");
  EXPECT_TRUE(function.has("b: a view of a parameter that its caller holds is not covered")) << function.text;
  const Output inOut =
      errorOf(blockOf("VAR_IN_OUT\n a : ARRAY[0..3] OF BYTE;\n d AT a : DWORD;\nEND_VAR\n", " MD20 := #d;"));
  EXPECT_TRUE(inOut.has("d: a view of a parameter that its caller holds is not covered")) << inOut.text;
  for (const Output* output : {&before, &longer, &ofBit, &start, &function, &inOut}) EXPECT_EQ(output->exit, 2);
}

}  // namespace
}  // namespace rungproof
