// Timers, counters and data blocks as parameters: what a call gives is worked by the statements of the block, and a
// data block is no access to its first byte.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::run;

const std::string delay =
    "FUNCTION FC 1 : VOID\nVAR_INPUT\n  on : BOOL;\n  t : TIMER;\n  c : COUNTER;\nEND_VAR\nBEGIN\nNETWORK\n"
    "A #on;\nL S5T#1S;\nSD #t;\nA #on;\nCU #c;\nEND_FUNCTION\n";

// The time of the timer is 1 s, and a counter goes up to 999: both hold because of what FC 1 does.
TEST(ParameterKinds, TimersAndCountersOfACallAreWritten) {
  const Output proof =
      proofOf("prove time: T5.value <= 1000\nprove count: C6.value <= 999\nprove short: T5.value < 500\n",
              delay + block(1, "CALL FC 1 (on := I 0.0, t := T 5, c := C 6)"));
  EXPECT_TRUE(proof.has("PROVED  time")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  count")) << proof.text;
  EXPECT_TRUE(proof.has("VIOLATED  short")) << proof.text;
  EXPECT_FALSE(proof.has("no instruction writes")) << proof.text;
}

// MW10 says which timer is started: any of them may be.
TEST(ParameterKinds, TimersThatAWordNamesAreWritten) {
  const Output proof = proofOf("prove time: T5.value <= 1000\n", block(1, "L 5;T MW 10;A I 0.0;L S5T#1S;SD T [MW 10]"));
  EXPECT_TRUE(proof.has("PROVED  time")) << proof.text;
}

TEST(ParameterKinds, ATimerNeedsOneNumber) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", delay + block(1, "CALL FC 1 (on := I 0.0, t := T 5, c := C 6)"));
  const Output list = run({"xref", folder.path("main.awl"), "T5"});
  EXPECT_TRUE(list.has("write")) << list.text;
  EXPECT_FALSE(list.has("T6")) << list.text;
}

// Formal parameters stand in the list as what the calls give, and M[AR1,P#0.0] leads to no timer.
TEST(ParameterKinds, PointersThatLeadElsewhereAreNotListed) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", delay + block(1,
                                        "CALL FC 1 (on := I 0.0, t := T 5, c := C 6);LAR1 P#0.0;L MW [AR1,P#0.0];"
                                        "T MW 20"));
  EXPECT_FALSE(run({"xref", folder.path("main.awl"), "T5"}).has("Through pointers"));
  const Output list = run({"xref", folder.path("main.awl"), "MW10"});
  EXPECT_TRUE(list.has("Through pointers") && list.has("L MW[AR1,P#0.0]")) << list.text;
  EXPECT_FALSE(list.has("#on")) << list.text;
}

const std::string reader =
    "DATA_BLOCK DB 3\nSTRUCT\n  a : INT := 33;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
    "FUNCTION FC 2 : VOID\nVAR_INPUT\n  d : BLOCK_DB;\nEND_VAR\nVAR_OUTPUT\n  v : INT;\nEND_VAR\nBEGIN\nNETWORK\n"
    "OPN #d;\nL DBW 0;\nT #v;\nEND_FUNCTION\n" +
    block(1, "OPN DB 3;CALL FC 2 (d := DB 3, v := MW 0);L DBW 0;T MW 2");

// The caller's block is still open behind the call, and its first byte, a part of a, is not what is meant.
TEST(ParameterKinds, ADataBlockIsNoAccessToIt) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", reader);
  const Output found = run({"lint", folder.path("main.awl")});
  EXPECT_TRUE(found.has("no findings")) << found.text;
  const Output trace = run({"sim", folder.path("main.awl"), "--scans", "1", "--trace", "-"});
  EXPECT_TRUE(trace.has("MW0,MW2\n1,10,10,33,33")) << trace.text;
}

// The value is 2 s and 1 s of it are left after ten scans of 100 ms: a number of ms, whatever the property calls it.
TEST(ParameterKinds, TheValueOfATimerIsInMilliseconds) {
  const std::string timer = block(1, "A I 0.0;L S5T#2S;SD T 2");
  const Output proof = proofOf("prove bit: T2 <= 2000\nprove less: T2 <= 1500\n", timer);
  EXPECT_TRUE(proof.has("PROVED  bit")) << proof.text;
  EXPECT_TRUE(proof.has("VIOLATED  less")) << proof.text;
  EXPECT_TRUE(proof.has("T2.value")) << proof.text;
  EXPECT_FALSE(proof.has("     0\n")) << proof.text;  // the run shows what is left, not 0
}

// A name that TIA Portal has put into marks stands in properties as in the source; a place in no data block is none.
TEST(ParameterKinds, PlacesOfDataInProperties) {
  const std::string data =
      "DATA_BLOCK DB 4\nSTRUCT\n  \"stop nc\" : BOOL;\n  v : INT;\nEND_STRUCT;\nBEGIN\n"
      "END_DATA_BLOCK\n" +
      block(1, "A I 0.0;= DB4.\"stop nc\";L IW 4;T DB4.v");
  const Output proof = proofOf("prove nc: DB4.\"stop nc\" = I0.0\nprove v: DB4.v = IW4\n", data);
  EXPECT_TRUE(proof.has("PROVED  nc") && proof.has("PROVED  v")) << proof.text;
  for (const char* place : {"DB4.DBW100 = 0", "DB4.DBD2 = 0", "DB9.DBW0 = 0"}) {
    const Output refused = proofOf(std::string("prove none: ") + place + "\n", data);
    EXPECT_EQ(refused.exit, 2) << place;
    EXPECT_TRUE(refused.has("is in no data block of the program")) << refused.text;
  }
}

}  // namespace
}  // namespace rungproof
