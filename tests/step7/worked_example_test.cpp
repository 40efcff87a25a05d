// Worked examples of the two course documents as projects: the first character of a string by a POINTER, and the
// heating whose time stands on thumbwheels, with the runs and errors of its properties.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::rowsOf, test7::run;

// 002:2198-2229: the block finds the data block and the place of a STRING behind its POINTER and puts a question mark
// over the first character; the two bytes of its lengths stay.
TEST(WorkedExamples, FirstCharacterOfAString) {
  const std::string blocks =
      "DATA_BLOCK DB 1\nSTRUCT\n  before : INT;\n  names : STRING [10] := 'Siemens';\nEND_STRUCT;\nBEGIN\n"
      "END_DATA_BLOCK\n"
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  address : POINTER;\nEND_VAR\nVAR_TEMP\n  db : WORD;\nEND_VAR\nBEGIN\n"
      "NETWORK\nL P##address;\nLAR1;\nL W [AR1,P#0.0];\nT #db;\nOPN DB [#db];\nL D [AR1,P#2.0];\nLAR1;\nL '?';\n"
      "T B [AR1,P#2.0];\nEND_FUNCTION\n" +
      block(1, "CALL FC 1 (address := DB1.names)");
  // 10 and 7 are the lengths; 16#3F is '?', 16#69 'i', 16#73 's'.
  EXPECT_TRUE(lastRow(blocks, "DB1.DBB2,DB1.DBB3,DB1.DBB4,DB1.DBB5,DB1.DBB10,DB1.DBW0", {"--scans", "2"})
                  .ends_with(",10,7,63,105,115,0"));
  EXPECT_TRUE(
      proofOf("prove mark: DB1.DBB4 = 63\nprove rest: DB1.DBB2 = 10 and DB1.DBB5 = 105\n", blocks).has("PROVED  mark"));
}

// 003:804-837.
const std::string oven =
    "A T 1;= Q 4.0;A T 1;BEC;L IW 0;AW W#16#0FFF;T MW 1;L MW 1;OW W#16#2000;T MW 2;L MW 2;A I 0.7;SE T 1";

// P2: MW1 and MW2 share MB2, so that MW1 ends with the upper byte of MW2 behind its own, 16#0121 for 16#0127.
TEST(WorkedExamples, OvenOverlappingWords) {
  const std::string row = lastRow(block(1, oven), "MW1,MW2", {"--scans", "1"}, "scan,IB0,IB1\n1,1,39\n");
  EXPECT_TRUE(row.ends_with(",289,8487")) << row;  // 16#0121, 16#2127
}

// P4: 3 s in scans of 500 ms are six scans; the heating follows the timer one scan late and is on for five.
TEST(WorkedExamples, OvenIsOnForOneScanLess) {
  std::string column;
  for (const std::string& row :
       rowsOf(block(1, oven), "Q4.0", {"--scans", "9", "--scan-time", "500ms", "--cycle-monitoring", "1s"},
              "scan,I0.7,IB1\n1,1,3\n"))
    column += row.back();
  EXPECT_EQ(column, "011111000");
}

// P5: the button pressed anew while it heats for 2 s, and held to the end, does not start it again; let go behind the
// end and pressed once more, it does.
TEST(WorkedExamples, OvenButtonPressedWhileItHeats) {
  std::string column;
  for (const std::string& row :
       rowsOf(block(1, oven), "Q4.0", {"--scans", "14", "--scan-time", "500ms", "--cycle-monitoring", "1s"},
              "scan,I0.7,IB1\n1,1,2\n2,0,2\n3,1,2\n7,0,2\n9,1,2\n"))
    column += row.back();
  EXPECT_EQ(column, "01110000011100");
}

// P6: a digit above 9 is no time; without OB121 the CPU stops, with it the heating stays off.
TEST(WorkedExamples, OvenThumbwheelThatIsNoNumber) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", block(1, oven));
  folder.file("in.csv", "scan,I0.7,IB1\n1,1,10\n");
  const Output output = run({"sim", folder.path("main.awl"), "--stimulus", folder.path("in.csv"), "--scans", "3"});
  EXPECT_EQ(output.exit, 1) << output.text;
  EXPECT_TRUE(output.has("BCD")) << output.text;
  const std::string wrong = "assume wrong: I1.3 and I1.1\nprove off: not Q4.0\n";
  EXPECT_TRUE(proofOf(wrong, block(1, oven) + block(121, "NOP 0")).has("PROVED  off"));
}

}  // namespace
}  // namespace rungproof
