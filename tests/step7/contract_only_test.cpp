// Blocks of the CPU of which only the contract is known, FBs that UC and CC call, and FC 106 by its formula.
#include "tests/step7/run7.hpp"

namespace rungproof::test7 {
namespace {

// What is written to a DP slave (SFC 15) or to outputs in the midst of a scan (SFC 27) changes no place of the program
// (002:2355-2357): Q0.0 is what I0.0 says, and RET_VAL is any value.
TEST(ContractOnly, WhatDoesNotDependOnItIsProved) {
  const std::string interlock = "A I 0.0;= Q 0.0;AN I 0.0;= Q 0.1;";
  const std::string properties = "prove apart: never Q0.0 and Q0.1\nprove result: MW100 = 0\n";
  const std::string calls[] = {"CALL SFC 15 (LADDR := W#16#3EA, RECORD := P#M 10.0 BYTE 8, RET_VAL := MW 100)",
                               "CALL SFC 27 (PART := B#16#0, RET_VAL := MW 100, FLADDR := MW 102)"};
  for (const std::string& call : calls) {
    const Output proof = proofOf(properties, block(1, interlock + call));
    EXPECT_TRUE(proof.has("PROVED  apart")) << proof.text;
    EXPECT_TRUE(proof.has("VIOLATED  result")) << proof.text;
    EXPECT_TRUE(proof.has("gives its outputs any value and writes nothing else")) << proof.text;
  }
  EXPECT_TRUE(proofOf(properties, block(1, interlock + calls[0])).has("sends to a DP slave is no output"));
  EXPECT_TRUE(proofOf(properties, block(1, interlock + calls[1])).has("looked at where the scan ends"));
}

// SFC 26 brings the inputs of the image up to date in the midst of a scan (002:2355): what was read before it may
// differ from what is read behind it, and two reads behind it agree.
TEST(ContractOnly, UpdatedInputs) {
  const std::string program =
      block(1,
            "A I 0.0;= M 0.0;CALL SFC 26 (PART := B#16#0, RET_VAL := MW 100, FLADDR := MW 102);A I 0.0;= M 0.1;"
            "A I 0.0;= Q 0.0");
  const Output proof =
      proofOf("prove unchanged: M0.0 = M0.1\nprove behind: Q0.0 = M0.1\nprove last: Q0.0 = I0.0\n", program);
  EXPECT_TRUE(proof.has("VIOLATED  unchanged")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  behind") && proof.has("PROVED  last")) << proof.text;
  EXPECT_TRUE(proof.has("every input of the image may change where it is called")) << proof.text;
  EXPECT_EQ(lastRow(program, "M0.0,Q0.0", {"--set", "I0.0=1", "--scans", "2"}), "2,20,10,1,1");
}

// SFC 79 sets and SFC 80 clears N bits of the outputs from SA on (002:2355). Four from Q4.6 on end with Q5.1.
TEST(ContractOnly, BitArraysOfOutputs) {
  const std::string program =
      block(1,
            "CALL SFC 79 (N := 4, RET_VAL := MW 100, SA := P#Q 4.6);CALL SFC 80 (N := 1, RET_VAL := "
            "MW 100, SA := P#Q 5.0);CALL SFC 79 (N := 0, RET_VAL := MW 100, SA := P#Q 6.0)");
  const Output proof = proofOf(
      "prove set: Q4.6 and Q4.7 and not Q5.0 and Q5.1\nprove others: QB6 = 0 and not Q4.5 and not "
      "Q5.2\nprove result: MW100 = 0\n",
      program);
  EXPECT_TRUE(proof.has("PROVED  set") && proof.has("PROVED  others")) << proof.text;
  EXPECT_TRUE(proof.has("VIOLATED  result")) << proof.text;
  EXPECT_TRUE(proof.has("the modules get that where the scan ends")) << proof.text;
  EXPECT_EQ(lastRow(program, "QB4,QB5,QB6", {"--scans", "2"}), "2,20,10,192,2,0");  // 2#11000000, 2#10
}

// A record of inputs is read, not written.
TEST(ContractOnly, SFC15DoesNotWriteItsRecord) {
  const Output proof =
      proofOf("prove kept: MB10 = 0\n",
              block(1, "CALL SFC 15 (LADDR := W#16#3EA, RECORD := P#M 10.0 BYTE 8, RET_VAL := MW 100)"));
  EXPECT_TRUE(proof.has("PROVED  kept")) << proof.text;
}

// BR is 0 where a function of the system has met an error (002:2387): both may be. A run without other word meets none.
TEST(ContractOnly, FunctionsOfTheSystemSetBr) {
  const std::string calls[] = {
      "CALL SFC 32 (OB_NR := 20, DTIME := T#1S, SIGN := W#16#0, RET_VAL := MW 100)",
      "CALL SFC 33 (OB_NR := 20, RET_VAL := MW 100)",
      "CALL SFC 36 (PRGFLT_SET_MASK := DW#16#0, ACCFLT_SET_MASK := DW#16#0, RET_VAL := MW 100, "
      "PRGFLT_MASKED := MD 104, ACCFLT_MASKED := MD 108)",
      "CALL SFC 41 (RET_VAL := MW 100)", "CALL SFC 42 (RET_VAL := MW 100)"};
  for (const std::string& call : calls) {
    const std::string text = block(1, call + ";A BR;= Q 0.0") + block(20, "NOP 0");
    EXPECT_EQ(lastRow(text, "Q0.0,MW100", {"--scans", "1"}), "1,10,10,1,0") << call;
    const Output proof = proofOf("prove always: Q0.0\nprove never: not Q0.0\n", text);
    EXPECT_TRUE(proof.has("VIOLATED  always")) << proof.text;
    EXPECT_TRUE(proof.has("VIOLATED  never")) << proof.text;
  }
}

TEST(ContractOnly, ARunSaysThatItsOutputsWereNotComputed) {
  const test::TemporaryFolder folder;
  const std::string program = folder.file("main.awl", block(1, "CALL SFC 41 (RET_VAL := MW 100)"));
  const Output said = run({"sim", program, "--scans", "2"});
  EXPECT_TRUE(said.has("what SFC41 DIS_AIRT gives is not computed")) << said.text;
  const std::string other = folder.file("other.awl", block(1, "A I 0.0;= Q 0.0"));
  EXPECT_FALSE(run({"sim", other, "--scans", "2"}).has("not computed"));
}

// UC and CC look at no parameters (002:246): the FB works on the data that DI names. CC needs RLO = 1.
TEST(ContractOnly, UcAndCcOfAnFb) {
  const std::string blocks =
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  x : BOOL ;\nEND_VAR\nVAR\n  n : INT ;\nEND_VAR\nBEGIN\nNETWORK\nA #x;\n= Q "
      "0.0;\n"
      "L #n;\nL 1;\n+I;\nT #n;\nEND_FUNCTION_BLOCK\nFUNCTION_BLOCK FB 2\nBEGIN\nNETWORK\nSET;\nS Q 1.0;\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string main = block(1, "OPN DI 1;A I 0.0;= DIX 0.0;UC FB 1;A I 0.1;CC FB 2");
  EXPECT_EQ(lastRow(blocks + main, "Q0.0,Q1.0,DB1.DBW2", {"--set", "I0.0=1", "--scans", "3"}), "3,30,10,1,0,3");
  EXPECT_EQ(lastRow(blocks + main, "Q0.0,Q1.0,DB1.DBW2", {"--set", "I0.1=1", "--scans", "1"}), "1,10,10,0,1,1");
  const Output proof = proofOf("prove follows: Q0.0 implies I0.0\nprove kept: I0.1 implies Q1.0\n", blocks + main);
  EXPECT_TRUE(proof.has("PROVED  follows")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  kept")) << proof.text;
  for (const char* command : {"lint", "xref", "show", "check"}) {
    const test::TemporaryFolder folder;
    EXPECT_LE(run({command, folder.file("main.awl", blocks + main)}).exit, 1) << command;
  }
}

// The number may be computed (003: memory-indirect operands); which FBs exist decides what may run.
TEST(ContractOnly, ComputedCallsOfAnFb) {
  const std::string blocks =
      "FUNCTION_BLOCK FB 1\nVAR\n  n : INT ;\nEND_VAR\nBEGIN\nNETWORK\nL #n;\nL 1;\n+I;\nT #n;\nEND_FUNCTION_BLOCK\n"
      "FUNCTION_BLOCK FB 2\nBEGIN\nNETWORK\nSET;\nS Q 1.0;\nEND_FUNCTION_BLOCK\nFUNCTION FC 2 : VOID\nBEGIN\n"
      "NETWORK\nSET;\nS Q 1.1;\nEND_FUNCTION\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string main = block(1, "OPN DI 1;L 1;T MW 20;UC FB [MW 20];L 2;T MW 20;A I 0.1;CC FB [MW 20]");
  EXPECT_EQ(lastRow(blocks + main, "Q1.0,Q1.1,DB1.DBW0", {"--set", "I0.1=1", "--scans", "3"}), "3,30,10,1,0,3");
  EXPECT_EQ(lastRow(blocks + main, "Q1.0,Q1.1,DB1.DBW0", {"--scans", "2"}), "2,20,10,0,0,2");
  const Output proof = proofOf("prove kept: I0.1 implies Q1.0\nprove other: not Q1.1\n", blocks + main);
  EXPECT_TRUE(proof.has("PROVED  kept")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  other")) << proof.text;
  // An input decides: FB 2 runs where it says so; a number without a block stops the CPU.
  const std::string chosen = block(1, "OPN DI 1;UC FB [IW 4]");
  const Output open =
      proofOf("prove off: not Q1.0\nprove only: IW4 <> 2 and prev(not Q1.0) implies not Q1.0\n", blocks + chosen);
  EXPECT_TRUE(open.has("VIOLATED  off")) << open.text;
  EXPECT_TRUE(open.has("PROVED  only")) << open.text;
  for (const char* command : {"lint", "xref", "show", "check"}) {
    const test::TemporaryFolder folder;
    EXPECT_LE(run({command, folder.file("main.awl", blocks + main)}).exit, 1) << command;
  }
}

// What an integrated function of the CPU drives is no output of the image; its outputs are any value (002:2367).
TEST(ContractOnly, IntegratedFunctions) {
  for (const char* number : {"47", "48", "49"}) {
    const std::string text = "DATA_BLOCK DB 5\nSFB " + std::string(number) + "\nBEGIN\nEND_DATA_BLOCK\n" +
                             block(1, "A I 0.0;= Q 0.0;CALL SFB " + std::string(number) +
                                          ", DB 5 (LADDR := W#16#300, CHANNEL := 0, JOB_DONE := M 4.0)");
    const Output proof = proofOf("prove apart: Q0.0 = I0.0\nprove done: not M4.0\n", text);
    EXPECT_TRUE(proof.has("PROVED  apart")) << proof.text;
    EXPECT_TRUE(proof.has("VIOLATED  done")) << proof.text;
    EXPECT_TRUE(proof.has("is not the one of the image")) << proof.text;
  }
}

// OUT = ((IN - LO_LIM) / (HI_LIM - LO_LIM)) * (K2 - K1) + K1 with K2 = 27648 and K1 = 0, or -27648 where BIPOLAR is 1
// (002:2625-2651). Half of 0 .. 100 is 13824 or 0, a quarter 6912 or -13824; beyond the limits OUT is the limit.
TEST(ContractOnly, Fc106GivesWhatItsFormulaSays) {
  const auto out = [](const std::string& in, bool isBipolar) {
    const std::string text = block(
        1, std::string(isBipolar ? "SET" : "CLR") + ";= M 0.0;CALL FC 106 (IN := " + in +
               ", HI_LIM := 1.0e+002, LO_LIM := 0.0, BIPOLAR := M 0.0, RET_VAL := MW 10, OUT := MW 4);A BR;= Q 0.0");
    return lastRow(text, "Q0.0,MW4,MW10", {"--scans", "1"});
  };
  EXPECT_EQ(out("5.0e+001", false), "1,10,10,1,13824,0");
  EXPECT_EQ(out("5.0e+001", true), "1,10,10,1,0,0");
  EXPECT_EQ(out("2.5e+001", false), "1,10,10,1,6912,0");
  EXPECT_EQ(out("2.5e+001", true), "1,10,10,1,-13824,0");
  EXPECT_EQ(out("0.0", true), "1,10,10,1,-27648,0");
  EXPECT_EQ(out("1.01e+002", false), "1,10,10,0,27648,8");
  EXPECT_EQ(out("-1.0", true), "1,10,10,0,-27648,8");
}

// 27648 / 100 * 33 = 9123.84: rounding up and down are both open, nothing else.
TEST(ContractOnly, Fc106RoundsEitherWay) {
  const std::string text = block(1,
                                 "CALL FC 106 (IN := 3.3e+001, HI_LIM := 1.0e+002, LO_LIM := 0.0, BIPOLAR := M 0.0, "
                                 "RET_VAL := MW 10, OUT := MW 4)");
  const Output proof =
      proofOf("prove either: MW4 = 9123 or MW4 = 9124\nprove up: MW4 = 9124\nprove down: MW4 = 9123\n", text);
  EXPECT_TRUE(proof.has("PROVED  either")) << proof.text;
  EXPECT_TRUE(proof.has("VIOLATED  up")) << proof.text;
  EXPECT_TRUE(proof.has("VIOLATED  down")) << proof.text;
}

// LB1 of OB100 is 16#81 after a manual restart and 16#82 after an automatic one (002:1377).
TEST(ContractOnly, StartInformationOfOb100) {
  const std::string text =
      block(1, "NOP 0") + block(100, "L LB 1;T MB 4;L LB 3;T MB 5", "VAR_TEMP\nh : ARRAY [0..19] OF BYTE;\nEND_VAR\n");
  EXPECT_EQ(lastRow(text, "MB4,MB5", {"--scans", "1"}), "1,10,10,129,100");
  EXPECT_EQ(lastRow(text, "MB4", {"--scans", "1"}, "scan,OB100_STRTUP\n1,130\n"), "1,10,10,130");
  const Output proof = proofOf("prove either: MB4 = 129 or MB4 = 130\nprove manual: MB4 = 129\n", text);
  EXPECT_TRUE(proof.has("PROVED  either")) << proof.text;
  EXPECT_TRUE(proof.has("VIOLATED  manual")) << proof.text;
}

}  // namespace
}  // namespace rungproof::test7
