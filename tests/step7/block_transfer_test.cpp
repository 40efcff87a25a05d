// SFC 20 BLKMOV and SFC 21 FILL on the engine: the shorter side counts, from the lower end (002:2412-2424 and general
// knowledge); a range that does not exist is an error: ENO 0 and RET_VAL 16#8xxx.
#include "tests/step7/step7_run.hpp"

namespace rungproof {
namespace {

constexpr const char* store =
    "DATA_BLOCK DB 5\nSTRUCT\n  a : ARRAY [0 .. 9] OF BYTE := B#16#1, B#16#2, B#16#3, B#16#4, B#16#5;\n"
    "  w : ARRAY [1 .. 3] OF WORD := W#16#1122, W#16#3344, W#16#5566;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
    "DATA_BLOCK DB 6\nREAD_ONLY\nSTRUCT\n  a : ARRAY [0 .. 9] OF BYTE;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

std::string moved(const std::string& source, const std::string& target) {
  return "CALL SFC 20 (SRCBLK := " + source + ", RET_VAL := MW 90, DSTBLK := " + target + "); A BR; = M 92.0;";
}

TEST(BlockTransfer, CopiesTheShorterSide) {
  const Step7Run run(store, "L 9; T MB 14; T MB 3; " + moved("DB5.a", "P#M 10.0 BYTE 4") +
                                moved("P#DB5.DBX 0.0 BYTE 3", "P#M 0.0 BYTE 8"));
  EXPECT_EQ(run.bytes(10, 5), "01 02 03 04 09");
  EXPECT_EQ(run.bytes(0, 4), "01 02 03 09");
  EXPECT_EQ(run.word(90), 0U);
  EXPECT_TRUE(run.bit(92, 0));
}

TEST(BlockTransfer, CountsElementsInBytes) {
  const Step7Run run(store, moved("P#DB5.DBX 10.0 WORD 2", "P#M 10.0 DWORD 1") + moved("DB5.w", "P#M 20.0 BOOL 16"));
  EXPECT_EQ(run.bytes(10, 4), "11 22 33 44");
  EXPECT_EQ(run.bytes(20, 3), "11 22 00");
}

TEST(BlockTransfer, LocalDataAndImages) {
  const Step7Run run(
      store,
      "L DW#16#01020304; T #x; " + moved("#x", "P#Q 0.0 BYTE 4") + moved("P#Q 0.0 BYTE 2", "#y") + "L #y; T MW 0;",
      "  x : DWORD;\n  y : WORD;\n");
  EXPECT_EQ(run.bytes(Area::Q, 0, 4), "01 02 03 04");
  EXPECT_EQ(run.word(0), 0x0102U);
}

// An ANY that the program makes: number of bytes and place are computed.
TEST(BlockTransfer, PointersThatTheProgramMakes) {
  const Step7Run run(store,
                     "L P##from; LAR1; L W#16#1002; T W [AR1,P#0.0]; L 3; T W [AR1,P#2.0]; L 5; T W [AR1,P#4.0]; "
                     "L 1; SLD 3; L DW#16#84000000; OD; T D [AR1,P#6.0]; " +
                         moved("#from", "P#M 10.0 BYTE 8"),
                     "  from : ANY;\n");
  EXPECT_EQ(run.bytes(10, 4), "02 03 04 00");
}

TEST(BlockTransfer, ARangeThatIsMissingIsAnError) {
  for (const char* target : {"P#DB5.DBX 10.0 BYTE 8", "P#DB77.DBX 0.0 BYTE 2", "P#M 8190.0 BYTE 4", "P#M 1.1 BYTE 2",
                             "P#P 256.0 BYTE 2", "DB6.a"}) {
    const Step7Run run(store, moved("P#M 0.0 BYTE 8", target));
    EXPECT_NE(run.word(90) & 0x8000U, 0U) << target;
    EXPECT_FALSE(run.bit(92, 0)) << target;
  }
  const Step7Run run(store, moved("P#DB5.DBX 10.0 BYTE 8", "P#M 0.0 BYTE 2"));
  EXPECT_NE(run.word(90) & 0x8000U, 0U);
}

TEST(BlockTransfer, FillRepeatsItsPattern) {
  const Step7Run run(store,
                     "L W#16#ABCD; T MW 0; L 7; T MB 15; "
                     "CALL SFC 21 (BVAL := P#M 0.0 BYTE 2, RET_VAL := MW 90, BLK := P#M 10.0 BYTE 5); A BR; = M 92.0;");
  EXPECT_EQ(run.bytes(10, 6), "AB CD AB CD AB 07");
  EXPECT_EQ(run.word(90), 0U);
  EXPECT_TRUE(run.bit(92, 0));
}

}  // namespace
}  // namespace rungproof
