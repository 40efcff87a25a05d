// Calls in SCL: functions with a value, instances, multi-instances, EN and ENO, S5 timers and counters, IEC timers.
#include "tests/scl/scl_run.hpp"

namespace rungproof {
namespace {

using testscl::lastRow;
using testscl::mainOf;

const std::string half =
    "FUNCTION FC 5 : INT\nVAR_INPUT\n x : INT;\nEND_VAR\nVAR_OUTPUT\n odd : BOOL;\nEND_VAR\nBEGIN\n"
    " odd := x MOD 2 <> 0;\n FC5 := x / 2;\nEND_FUNCTION\n";

TEST(SclCalls, FunctionWithAValue) {
  // 9 / 2 = 4; 4 + 1 = 5.
  EXPECT_EQ(lastRow(half + mainOf("MW20 := FC5(x := 9, odd := M30.0) + 1;"), "MW20,M30.0"), "1,5,1");
  // The value of the inner call is the input of the outer one: 9 / 2 / 2 = 2.
  EXPECT_EQ(lastRow(half + mainOf("MW20 := FC5(x := FC5(x := 9, odd := M30.0), odd := M30.1);"), "MW20,M30.0,M30.1"),
            "1,2,1,0");
  // As a statement the value is dropped.
  EXPECT_EQ(lastRow(half + mainOf("FC5(x := 8, odd => M30.0);"), "M30.0"), "1,0");
}

// BLKMOV is SFC 20 of the CPU: three bytes are copied, 1 2 3 is 16#0102_03.
TEST(SclCalls, BlocksOfTheCpuByTheirNames) {
  const std::string arrays = "VAR_TEMP\n a : ARRAY[0..2] OF BYTE; b : ARRAY[0..2] OF BYTE; r : INT;\nEND_VAR\n";
  const std::string fill = "#a[0] := 1; #a[1] := 2; #a[2] := 3;\n";
  for (const char* call : {"#r := BLKMOV(SRCBLK := #a, DSTBLK => #b);", "#r := SFC20(SRCBLK := #a, DSTBLK := #b);"})
    EXPECT_EQ(lastRow(mainOf(fill + call + std::string(" MB20 := #b[0]; MB21 := #b[2]; MW22 := #r;"), arrays),
                      "MB20,MB21,MW22"),
              "1,1,3,0")
        << call;
}

// LEN is FC 21 of the library: 'abc' has three characters.
TEST(SclCalls, LengthOfAText) {
  const std::string program =
      "FUNCTION_BLOCK FB 1\nVAR\n s : STRING[10] := 'abc';\nEND_VAR\nBEGIN\n MW20 := LEN(#s);\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n" +
      mainOf("FB1.DB1();");
  EXPECT_EQ(lastRow(program, "MW20"), "1,3");
}

TEST(SclCalls, ValueNamedAfterTheFunction) {
  const std::string scale =
      "FUNCTION \"Scale\" : REAL\nVAR_INPUT\n x : INT;\nEND_VAR\nBEGIN\n #Scale := #x * 1.5;\nEND_FUNCTION\n";
  EXPECT_EQ(lastRow(scale + mainOf("MD20 := ROUND(\"Scale\"(4));"), "MD20"), "1,6");
  EXPECT_EQ(lastRow(scale + mainOf("MD20 := ROUND(Scale(x := 2));"), "MD20"), "1,3");
}

// A call may write what stands on the left of the operator: it was read before.
TEST(SclCalls, LeftSideIsReadBeforeTheCall) {
  const std::string counts = "FUNCTION FC 6 : INT\nBEGIN\n MW40 := WORD_TO_INT(MW40) + 1;\n FC6 := 10;\nEND_FUNCTION\n";
  EXPECT_EQ(lastRow(counts + mainOf("MW20 := WORD_TO_INT(MW40) + FC6();"), "MW20,MW40"), "1,10,1");
}

const std::string counter =
    "FUNCTION_BLOCK FB 1\nVAR_INPUT\n up : BOOL; by : INT := 1;\nEND_VAR\nVAR_OUTPUT\n sum : INT; isFull : BOOL;\n"
    "END_VAR\nVAR\n last : BOOL;\nEND_VAR\nBEGIN\n IF #up AND NOT #last THEN #sum := #sum + #by; END_IF;\n"
    " #last := #up;\n #isFull := #sum >= 3;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 3\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";

TEST(SclCalls, InstanceKeepsItsData) {
  const std::string program = counter + mainOf("FB1.DB3(up := I0.0, sum => MW20); M30.0 := DB3.isFull;");
  EXPECT_EQ(lastRow(program, "MW20,M30.0", "5", "scan,I0.0\n1,1\n2,0\n3,1\n4,0\n5,1\n"), "5,3,1");
  EXPECT_EQ(lastRow(program, "MW20,M30.0", "5", "scan,I0.0\n1,1\n2,1\n3,1\n4,0\n5,1\n"), "5,2,0");
}

TEST(SclCalls, MultiInstances) {
  const std::string program =
      counter +
      "FUNCTION_BLOCK FB 2\nVAR\n first : FB 1; second : FB 1;\nEND_VAR\nBEGIN\n #first(up := I0.0, by := 2);\n"
      " #second(up := I0.1, by := 5);\n MW20 := #first.sum + #second.sum;\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 4\nFB 2\nBEGIN\nEND_DATA_BLOCK\n" +
      mainOf("FB2.DB4();");
  EXPECT_EQ(lastRow(program, "MW20", "3", "scan,I0.0,I0.1\n1,1,0\n2,0,1\n3,1,0\n"), "3,9");
}

TEST(SclCalls, EnableSkipsTheCall) {
  const std::string program =
      half + mainOf("MW20 := 0; FC5(EN := I0.0, x := 8, odd := M30.1, RET_VAL := MW20, ENO => M30.0);");
  EXPECT_EQ(lastRow(program, "MW20,M30.0", "1", "scan,I0.0\n1,1\n"), "1,4,1");
  EXPECT_EQ(lastRow(program, "MW20,M30.0", "1", "scan,I0.0\n1,0\n"), "1,0,0");
}

TEST(SclCalls, OkIsHandedBackAsEno) {
  const std::string checks =
      "FUNCTION FC 7 : VOID\nVAR_INPUT\n x : INT;\nEND_VAR\nBEGIN\n IF x < 0 THEN OK := FALSE; END_IF;\nEND_FUNCTION\n";
  EXPECT_EQ(lastRow(checks + mainOf("FC7(x := -1, ENO => M30.0); FC7(x := 1, ENO => M30.1);"), "M30.0,M30.1"), "1,0,1");
}

TEST(SclCalls, OutputsToElementsAndOtherTypes) {
  const std::string program =
      counter +
      mainOf("FB1.DB3(up := TRUE, by := 7, sum => #x[#i + 1]); MW20 := #x[2]; FB1.DB3(sum => #d); MD24 := #d;",
             "VAR_TEMP\n x : ARRAY[0..3] OF INT; i : INT; d : DINT;\nEND_VAR\n");
  // #i is a temporary that nothing wrote: the index must not be computed from it before it has a value.
  const std::string whole = program.substr(0, program.find("BEGIN\nFB1.DB3(up")) + "BEGIN\n#i := 1;\n" +
                            program.substr(program.find("FB1.DB3(up"));
  EXPECT_EQ(lastRow(whole, "MW20,MD24"), "1,7,7");
}

// S_ODT as the box of that name: the timer runs 1 s after S, R resets it.
TEST(SclCalls, OnDelayTimer) {
  const std::string program =
      mainOf("#left := S_ODT(T_NO := T1, S := I0.0, TV := S5T#1s, R := I0.1, BI := MW20, Q := Q4.0);",
             "VAR_TEMP\n left : S5TIME;\nEND_VAR\n");
  const test::TemporaryFolder folder;
  folder.file("main.scl", program);
  folder.file("in.csv", "scan,I0.0,I0.1\n1,1,0\n");
  const auto stateAfter = [&](const std::string& scans) {
    const testscl::Output output =
        test7::run({"sim", folder.path("main.scl"), "--stimulus", folder.path("in.csv"), "--trace",
                    folder.path("r.csv"), "--signals", "Q4.0", "--scans", scans, "--scan-time", "100ms"});
    std::ifstream file(folder.path("r.csv"));
    std::string last;
    for (std::string row; std::getline(file, row);) last = row;
    return last.substr(last.rfind(',') + 1) + (output.exit > 1 ? output.text : "");
  };
  EXPECT_EQ(stateAfter("9"), "0");   // 0.8 s behind the edge, at most one tick more
  EXPECT_EQ(stateAfter("13"), "1");  // 1.2 s
}

// T#... is taken where a timer takes an S5TIME: 1 s is 100 units of 10 ms, and 16#0100 the word of them; what does not
// fit the base is cut off.
TEST(SclCalls, TimesOfS5TimersAreWrittenAsTime) {
  const auto timer = [](const std::string& time) {
    return mainOf("#left := S_ODT(T_NO := T1, S := I0.0, TV := " + time + ", BI := MW20); MW22 := #left;",
                  "VAR_TEMP\n left : S5TIME;\nEND_VAR\n");
  };
  const std::string on = "scan,I0.0\n1,0\n2,1\n";
  EXPECT_EQ(lastRow(timer("T#1s"), "MW22", "2", on), lastRow(timer("S5T#1s"), "MW22", "2", on));
  EXPECT_EQ(lastRow(timer("T#1s"), "MW20,MW22", "2", on), "2,100,256");
  EXPECT_EQ(lastRow(timer("TIME#12s345ms"), "MW22", "2", on), lastRow(timer("S5T#12s300ms"), "MW22", "2", on));
  const testscl::Output tooLong = testscl::commandOn("lint", timer("T#3h"));
  EXPECT_TRUE(tooLong.has("T#3h is no S5TIME: that is 0MS to 2H46M30S")) << tooLong.text;
}

TEST(SclCalls, UpDownCounter) {
  const std::string program = mainOf(
      "MW22 := S_CUD(C_NO := C1, CU := I0.0, CD := I0.1, S := I0.2, PV := W#16#0010, R := I0.3, CV := MW20, Q := "
      "M30.0);");
  // Set to 10 (three digits of BCD), up once: 11, as a value of the function in BCD 16#11 = 17.
  EXPECT_EQ(lastRow(program, "MW20,MW22,M30.0", "2", "scan,I0.0,I0.2\n1,0,1\n2,1,0\n"), "2,11,17,1");
  EXPECT_EQ(lastRow(program, "MW20,M30.0", "3", "scan,I0.0,I0.2,I0.3\n1,0,1,0\n2,1,0,0\n3,0,0,1\n"), "3,0,0");
}

TEST(SclCalls, IecTimer) {
  const std::string program =
      "DATA_BLOCK DB 5\nSFB 4\nBEGIN\nEND_DATA_BLOCK\n" + mainOf("TON.DB5(IN := I0.0, PT := T#1s); Q4.0 := DB5.Q;");
  EXPECT_EQ(lastRow(program, "Q4.0", "50", "scan,I0.0\n1,1\n"), "50,0");    // 10 ms each: 0.49 s
  EXPECT_EQ(lastRow(program, "Q4.0", "120", "scan,I0.0\n1,1\n"), "120,1");  // 1.19 s
}

// Arrays as parameters come by pointer; an array of a multi-instance lies where AR2 says.
TEST(SclCalls, ArraysOfParametersAndInstances) {
  const std::string table =
      "DATA_BLOCK DB 9\nSTRUCT\n t : ARRAY[0..3] OF INT := 4, 5, 6, 7;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string reads =
      "FUNCTION FC 8 : INT\nVAR_INPUT\n a : ARRAY[0..3] OF INT; n : INT;\nEND_VAR\nBEGIN\n FC8 := "
      "a[n];\nEND_FUNCTION\n";
  EXPECT_EQ(lastRow(reads + table + mainOf("MW20 := FC8(a := DB9.t, n := 2);"), "MW20"), "1,6");
  const std::string fills =
      "FUNCTION_BLOCK FB 8\nVAR_IN_OUT\n a : ARRAY[0..3] OF INT;\nEND_VAR\nVAR\n b : ARRAY[1..4] OF REAL; i : INT;\n"
      "END_VAR\nBEGIN\n FOR i := 0 TO 3 DO a[i] := i * 2; b[i + 1] := i; END_FOR;\n MD24 := TRUNC(b[4] + b[3]);\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 8\nFB 8\nBEGIN\nEND_DATA_BLOCK\n";
  // 3 * 2 = 6; 3 + 2 = 5.
  EXPECT_EQ(lastRow(fills + table + mainOf("FB8.DB8(a := DB9.t); MW20 := DB9.t[3];"), "MW20,MD24"), "1,6,5");
  const std::string inner =
      "FUNCTION_BLOCK FB 9\nVAR_INPUT\n n : INT;\nEND_VAR\nVAR_OUTPUT\n sum : INT;\nEND_VAR\nVAR\n kept : ARRAY[1..3] "
      "OF INT; "
      "i : INT;\nEND_VAR\nBEGIN\n kept[n] := n * 10;\n sum := 0;\n FOR i := 1 TO 3 DO sum := sum + kept[i]; END_FOR;\n"
      "END_FUNCTION_BLOCK\nFUNCTION_BLOCK FB 10\nVAR\n x : FB 9; y : FB 9;\nEND_VAR\nBEGIN\n x(n := 1); y(n := 2); y(n "
      ":= 3);\n"
      " MW20 := x.sum; MW22 := y.sum;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 10\nFB 10\nBEGIN\nEND_DATA_BLOCK\n";
  // x keeps 10; y keeps 20 and 30.
  EXPECT_EQ(lastRow(inner + mainOf("FB10.DB10();"), "MW20,MW22"), "1,10,50");
}

// The place of an element and the value may lie in different data blocks.
TEST(SclCalls, ElementsOfOneBlockFromAnother) {
  const std::string data =
      "DATA_BLOCK DB 20\nSTRUCT\n t : ARRAY[0..3] OF INT; b : ARRAY[0..3] OF "
      "BOOL;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 21\nSTRUCT\n n : INT := 9; i : INT := 2; f : BOOL := TRUE; u : ARRAY[0..3] OF INT := 1, 2, 3, 4;\n"
      "END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  EXPECT_EQ(lastRow(data + mainOf("DB20.t[DB21.i] := DB21.n; MW20 := DB20.t[2]; MW22 := DB21.i;"), "MW20,MW22"),
            "1,9,2");
  EXPECT_EQ(lastRow(data + mainOf("DB20.b[DB21.i] := DB21.f; M30.0 := DB20.b[2]; M30.1 := DB20.b[0];"), "M30.0,M30.1"),
            "1,1,0");
  // 3 + 4.
  EXPECT_EQ(lastRow(data + mainOf("DB20.t[DB21.i] := DB21.u[DB21.i] + DB21.u[DB21.i + 1]; MW20 := DB20.t[2];"), "MW20"),
            "1,7");
}

// DB20.DW[4] is word 4: the third element; DB20.DX[5, 0] is the last bit of it.
TEST(SclCalls, DataByComputedAddresses) {
  const std::string data =
      "DATA_BLOCK DB 20\nSTRUCT\n t : ARRAY[0..3] OF INT := 1, 2, 3, 4;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string index = "VAR_TEMP\n i : INT; j : INT;\nEND_VAR\n";
  EXPECT_EQ(lastRow(data + mainOf("#i := 4; MW20 := DB20.DW[#i]; #j := 0; M30.0 := DB20.DX[#i + 1, #j];", index),
                    "MW20,M30.0"),
            "1,3,1");
  EXPECT_EQ(lastRow(data + mainOf("#i := 6; DB20.DW[#i] := 9; MW20 := DB20.t[3];", index), "MW20"), "1,9");
}

// Blocks in statement lists and in SCL call each other.
TEST(SclCalls, CalledFromAStatementList) {
  const test::TemporaryFolder folder;
  folder.file("half.scl", half);
  folder.file("main.awl", test7::block(1, "CALL FC 5 (x := 9, odd := M 30.0, RET_VAL := MW 20)"));
  folder.file("p.prop", "prove value: MW20 == 4\nprove odd: M30.0\n");
  const testscl::Output proof =
      test7::run({"prove", folder.path("half.scl"), folder.path("main.awl"), "--props", folder.path("p.prop")});
  EXPECT_EQ(proof.exit, 0) << proof.text;
}

// D0 without a bit is no address, so it can be a name.
TEST(SclCalls, DataMayHaveTheNamesOfAddressesWithoutABit) {
  const std::string data = "DATA_BLOCK DB 1\nSTRUCT\n d0 : INT;\n dx1 : INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";
  EXPECT_EQ(
      lastRow(data + mainOf("DB1.d0 := 3; DB1.dx1 := DB1.d0 + 1; MW20 := DB1.dx1; M30.0 := DB1.D1.0;"), "MW20,M30.0"),
      "1,4,1");  // 3 in the first word: bit 0 of byte 1 is 1
}

}  // namespace
}  // namespace rungproof
