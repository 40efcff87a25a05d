// Start information that a run determines: lengths of scans, periods, delays, priorities, date and time; that machine
// code does not take it for 0 and that proofs leave it open. Each expectation is reasoned beside it.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::rowsOf;

const std::string info = "VAR_TEMP\n  info : ARRAY[0..19] OF BYTE;\nEND_VAR\n";
const std::string takeTimes = "L LW 6;T MW 20;L LW 8;T MW 22;L LW 10;T MW 24";

// Previous, shortest and longest scan since the start (002:2000-2011), in ms. The first scan has none before it.
TEST(BlockStart, OfOb1TellsTheLengthsOfScans) {
  const std::vector<std::string> rows =
      rowsOf(block(1, takeTimes, info), "MW20,MW22,MW24", {}, "scan,scan_ms\n1,20\n2,30\n3,10\n4,20\n5,20\n");
  const char* const wanted[] = {",0,0,0", ",20,20,20", ",30,20,30", ",10,10,30", ",20,10,30"};
  ASSERT_EQ(rows.size(), std::size(wanted));
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_TRUE(rows[i].ends_with(wanted[i])) << rows[i];
}

// By their usual names, as the editor declares them.
TEST(BlockStart, HasTheNamesOfTheEditor) {
  const std::string declared =
      "VAR_TEMP\n  OB1_EV_CLASS : BYTE;\n  OB1_SCAN_1 : BYTE;\n  OB1_PRIORITY : BYTE;\n  OB1_OB_NUMBR : BYTE;\n"
      "  OB1_RESERVED_1 : BYTE;\n  OB1_RESERVED_2 : BYTE;\n  OB1_PREV_CYCLE : INT;\n  OB1_MIN_CYCLE : INT;\n"
      "  OB1_MAX_CYCLE : INT;\n  OB1_DATE_TIME : DATE_AND_TIME;\nEND_VAR\n";
  const std::string blocks = block(1, "L #OB1_PREV_CYCLE;L MW 20;+I;T MW 20", declared);
  // 24 scans of 10 ms are over when the 25th begins.
  EXPECT_TRUE(lastRow(blocks, "MW20", {"--scans", "25", "--scan-time", "10ms"}).ends_with(",240"));
  // A stimulus that says otherwise is believed.
  const std::string given = "scan,OB1_PREV_CYCLE\n1,3\n2,3\n3,3\n";
  EXPECT_TRUE(lastRow(blocks, "MW20", {"--scan-time", "10ms"}, given).ends_with(",9"));
}

// 1990-01-01 was a Monday, day 2 of the week from Sunday on (002:1980-1996). The second scan begins 1.234 s later.
TEST(BlockStart, TellsDateAndTime) {
  const std::vector<std::string> rows =
      rowsOf(block(1, "L LD 12;T MD 20;L LD 16;T MD 24", info), "MB20,MB21,MB22,MB25,MB26,MB27",
             {"--cycle-monitoring", "2s"}, "scan,scan_ms\n1,1234\n2,10\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_TRUE(rows[0].ends_with(",144,1,1,0,0,2")) << rows[0];    // 16#90, 16#01, 16#01; 0 s, 16#00, 16#02
  EXPECT_TRUE(rows[1].ends_with(",144,1,1,1,35,66")) << rows[1];  // 1 s, 16#23, 16#42
}

// OB35 has its period in ms, no phase and priority 12 (002:1116); OB20 the delay that SFC 32 was given, and priority 3
// (002:1198).
TEST(BlockStart, OfInterruptsTellsTheirTimes) {
  const std::string cyclic = block(1, "NOP 0") + block(35, "L LW 10;T MW 20;L LW 6;T MW 22;L LB 2;T MB 24", info);
  const std::vector<std::string> second = {"--duration", "1s", "--scan-time", "10ms"};
  EXPECT_TRUE(lastRow(cyclic, "MW20,MW22,MB24", second).ends_with(",100,0,12"));
  std::vector<std::string> set = second;
  set.insert(set.end(), {"--ob35", "250ms"});
  EXPECT_TRUE(lastRow(cyclic, "MW20,MW22,MB24", set).ends_with(",250,0,12"));
  const std::string delayed =
      block(1,
            "A I 0.0;FP M 1.0;JCN no;CALL SFC 32 (OB_NR := 20, DTIME := T#70S, SIGN := W#16#7, RET_VAL := MW 30);"
            "CALL SFC 32 (OB_NR := 20, DTIME := T#40MS, SIGN := W#16#9, RET_VAL := MW 30);no: NOP 0") +
      block(20, "L LD 8;T MD 20;L LW 6;T MW 24;L LB 2;T MB 26", info);
  EXPECT_TRUE(lastRow(delayed, "MD20,MW24,MB26", second, "scan,I0.0\n1,1\n").ends_with(",40,9,3"));
}

// Machine code, which takes fresh local memory for 0, does not run such a program: by name, by a pointer of each kind,
// and as what a call hands over.
TEST(BlockStart, IsThereInLongRuns) {
  const std::string take =
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  v : INT;\nEND_VAR\nBEGIN\nNETWORK\nL #v;\nT MW 20;\n"
      "END_FUNCTION\n";
  const std::string ways[] = {block(1, "L LW 6;T MW 20", info), block(1, "L P#6.0;LAR1;L LW [AR1,P#0.0];T MW 20", info),
                              block(1, "L P#6.0;T MD 40;L LW [MD 40];T MW 20", info),
                              block(1, "L P#L 6.0;LAR1;L W [AR1,P#0.0];T MW 20", info),
                              take + block(1, "CALL FC 1 (v := LW 6)", info)};
  for (const std::string& blocks : ways) {
    const std::string row = lastRow(blocks, "MW20", {"--scans", "400", "--scan-time", "10ms"});
    EXPECT_TRUE(row.ends_with(",10")) << row << "\n" << blocks;
  }
}

// Proofs cover every length: what a run shows is among it.
TEST(BlockStart, IsOpenInProofs) {
  const Output output =
      proofOf("reach ten: MW20 = 10\nprove short: MW20 <= 150\n", block(1, takeTimes, info), {"--scan-time", "10ms"});
  EXPECT_TRUE(output.has("REACHABLE  ten") && !output.has("UNREACHABLE")) << output.text;
  EXPECT_FALSE(output.has("PROVED  short")) << output.text;
}

}  // namespace
}  // namespace rungproof
