// Synchronous errors: what OB121 and OB122 find and give back, errors that SFC 36 masks, errors of the error blocks
// themselves, data blocks that may not be written or are not loaded. Each expectation is reasoned beside it.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::run;

const std::string info = "VAR_TEMP\n  info : ARRAY[0..19] OF BYTE;\nEND_VAR\n";

std::string dataBlock(int number, const std::string& attributes = "") {
  return "DATA_BLOCK DB " + std::to_string(number) + "\n" + attributes +
         "STRUCT\n  a : INT := 7;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
}

/// What sim says of three scans, and its exit code: 1 where the CPU stops.
Output simOf(const std::string& blocks) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", blocks);
  return run({"sim", folder.path("main.awl"), "--scans", "3"});
}

// OB121 finds which error it was (general knowledge): BCD is 16#21; an access beyond a data block, reading or writing,
// 16#22 or 16#23. What such a load leaves is not stated.
TEST(ErrorBlocks, StartInformation) {
  const std::string look = block(121, "L LB 1;T MB 30;L LB 4;T MB 31", info);
  const Output output =
      proofOf("prove kind: MB30 = 0 or MB30 = 16#21\nreach it: MB30 = 16#21\nprove type: MB31 = 0 or MB31 = 16#88\n",
              look + block(1, "L IW 4;BTI;T MW 6"));
  EXPECT_TRUE(output.has("PROVED  kind") && output.has("REACHABLE  it")) << output.text;
  EXPECT_FALSE(output.has("PROVED  type")) << output.text;  // not every CPU says it
  const Output length =
      proofOf("prove pair: MB30 = 16#22 or MB30 = 16#23\nprove read: MB30 = 16#22\nprove zero: MW6 = 0\n",
              dataBlock(10) + look + block(1, "OPN DB 10;L DBW 4;T MW 6"));
  EXPECT_TRUE(length.has("PROVED  pair") && length.has("VIOLATED  read")) << length.text;
  EXPECT_TRUE(length.has("VIOLATED  zero")) << length.text;
}

// SFC 44 in OB121 gives the value that stands in ACCU1 behind the instruction with the error (002:2342).
TEST(ErrorBlocks, AReplacedValue) {
  const std::string blocks = dataBlock(10) + block(121, "CALL SFC 44 (VAL := DW#16#4D2, RET_VAL := MW 20)") +
                             block(1, "OPN DB 10;L DBW 4;T MW 6");
  EXPECT_TRUE(proofOf("prove given: MW6 = 1234\n", blocks).has("PROVED  given"));
  EXPECT_TRUE(lastRow(blocks, "MW6", {"--scans", "1"}).ends_with(",1234"));
  // Outside of an error block it gives nothing.
  EXPECT_TRUE(proofOf("prove not: MW6 = 0\n", block(1, "CALL SFC 44 (VAL := DW#16#4D2, RET_VAL := MW 20);L 0;T MW 6"))
                  .has("PROVED  not"));
}

// A module that does not answer calls OB122 where the program has it (002:1292); what is read then is what SFC 44
// gives, or any value. Without OB122 modules answer.
TEST(ErrorBlocks, ModulesThatDoNotAnswer) {
  const std::string read = block(1, "L PIW 256;T MW 6;L 5;T PQW 260");
  const std::string given = block(122, "SET;= M 2.0;CALL SFC 44 (VAL := DW#16#4D2, RET_VAL := MW 20)");
  const std::string goals = "reach fails: M2.0\nprove never: not M2.0\nprove read: MW6 = PIW256 or MW6 = 1234\n";
  const Output output = proofOf(goals, read + given);
  EXPECT_TRUE(output.has("REACHABLE  fails") && output.has("VIOLATED  never")) << output.text;
  EXPECT_TRUE(output.has("PROVED  read")) << output.text;
  EXPECT_TRUE(proofOf("prove never: not M2.0\n", read).has("  never"));
  EXPECT_FALSE(proofOf("prove never: not M2.0\n", read).has("VIOLATED"));
  EXPECT_TRUE(lastRow(read + given, "M2.0,MW6", {"--scans", "1"}, "scan,PIW256\n1,77\n").ends_with(",0,77"));
}

// An instruction with an error may leave anything in the accumulators: BTI of no BCD number with an OB121 that does
// nothing, and the second accumulator behind a load that fails.
TEST(ErrorBlocks, AccumulatorsBehindAnErrorAreNotKnown) {
  const std::string taken = block(121, "NOP 0");
  EXPECT_TRUE(
      proofOf("prove kept: MW6 = 0 or MW6 = 16#A\n", taken + block(1, "L W#16#A;BTI;T MW 6")).has("VIOLATED  kept"));
  EXPECT_TRUE(proofOf("prove second: MW6 = 5\n", dataBlock(10) + taken + block(1, "L 5;OPN DB 10;L DBW 4;TAK;T MW 6"))
                  .has("VIOLATED  second"));
}

// A CALL is several statements: two of its parameters that fail call OB121 twice.
TEST(ErrorBlocks, EachParameterOfACallIsAStatement) {
  const std::string fb =
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  x : INT;\n  y : INT;\nEND_VAR\nBEGIN\nNETWORK\nNOP 0;\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string blocks = fb + dataBlock(10) + block(121, "L MW 12;L 1;+I;T MW 12") +
                             block(1, "CALL FB 1, DB 1 (x := DB10.DBW 4, y := DB10.DBW 8)");
  EXPECT_TRUE(lastRow(blocks, "MW12", {"--scans", "1"}).ends_with(",2"));
  EXPECT_FALSE(proofOf("prove one: MW12 <= 1\n", blocks).has("PROVED  one"));
}

// How deep errors of OB121 nest is not stated: in sim the first of them stops the CPU, and proofs leave it open.
TEST(ErrorBlocks, ErrorsOfTheirOwn) {
  const std::string blocks = dataBlock(10) + block(121, "SET;= M 2.0;OPN DB 10;L DBW 8;SET;= M 2.1") +
                             block(1, "A I 0.0;JCN no;OPN DB 10;L DBW 4;no: NOP 0");
  const Output output = proofOf("prove never: not M2.1\nprove quiet: not I0.0 implies not rises(M2.0)\n", blocks);
  EXPECT_FALSE(output.has("PROVED  never")) << output.text;
  EXPECT_TRUE(output.has("synchronous error in the block that takes such errors")) << output.text;
  const Output stopped = simOf(dataBlock(10) + block(121, "OPN DB 10;L DBW 8") + block(1, "OPN DB 10;L DBW 4"));
  EXPECT_EQ(stopped.exit, 1) << stopped.text;
  EXPECT_TRUE(stopped.has("OB121")) << stopped.text;
}

// Blocks that call themselves without end stop the CPU, whether or not it has OB121 (general knowledge).
TEST(ErrorBlocks, DoNotTakeNestingThatIsTooDeep) {
  const std::string endless = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nUC FC 1;\nEND_FUNCTION\n";
  const Output output = simOf(endless + block(121, "NOP 0") + block(1, "UC FC 1"));
  EXPECT_EQ(output.exit, 1) << output.text;
  EXPECT_TRUE(output.has("nested too deeply")) << output.text;
}

const std::string mask =
    "CALL SFC 36 (PRGFLT_SET_MASK := DW#16#FFFFFFFF, ACCFLT_SET_MASK := DW#16#FFFFFFFF, RET_VAL := MW 40, "
    "PRGFLT_MASKED := MD 42, ACCFLT_MASKED := MD 46);";
const std::string unmask =
    "CALL SFC 37 (PRGFLT_RESET_MASK := DW#16#FFFFFFFF, ACCFLT_RESET_MASK := DW#16#FFFFFFFF, RET_VAL := MW 40, "
    "PRGFLT_MASKED := MD 42, ACCFLT_MASKED := MD 46);";

// An error that SFC 36 masks neither stops the CPU nor calls OB121 (002:2352); which errors a bit of the mask stands
// for is not stated, so that proofs take it as masked or not. SFC 37 ends it.
TEST(MaskedErrors, NeitherStopNorCall) {
  const std::string wrong = "OPN DB 10;L DBW 4;T MW 6;SET;= M 3.0";
  const std::string never = "prove never: not M3.0\n";
  EXPECT_EQ(simOf(dataBlock(10) + block(1, wrong)).exit, 1);
  EXPECT_EQ(simOf(dataBlock(10) + block(1, mask + wrong)).exit, 0);
  EXPECT_EQ(simOf(dataBlock(10) + block(1, mask + unmask + wrong)).exit, 1);
  EXPECT_TRUE(proofOf(never, dataBlock(10) + block(1, wrong)).has("VACUOUS  never"));
  EXPECT_TRUE(proofOf(never, dataBlock(10) + block(1, mask + wrong)).has("VIOLATED  never"));
  const std::string taken = block(121, "SET;= M 2.0");
  EXPECT_TRUE(lastRow(dataBlock(10) + taken + block(1, mask + wrong), "M2.0,M3.0", {"--scans", "1"}).ends_with(",0,1"));
  EXPECT_TRUE(lastRow(dataBlock(10) + taken + block(1, wrong), "M2.0,M3.0", {"--scans", "1"}).ends_with(",1,1"));
  EXPECT_FALSE(proofOf("prove called: M2.0\n", dataBlock(10) + taken + block(1, mask + wrong)).has("PROVED  called"));
}

// How long a mask holds is not stated either: an error in front of the call may be masked from the scan before.
TEST(MaskedErrors, MayStayMasked) {
  const std::string first = "A M 1.0;JCN no;OPN DB 10;L DBW 4;SET;= M 3.0;no: SET;= M 1.0;";
  EXPECT_TRUE(proofOf("prove never: not M3.0\n", dataBlock(10) + block(1, first + mask)).has("VIOLATED  never"));
}

// A write into a block with READ_ONLY is an error, whichever way it goes (002:559, 002:1288); reading is none, and the
// block keeps its values.
TEST(DataBlockAttributes, ReadOnlyBlocksAreNotWritten) {
  const std::string fixed = dataBlock(10, "READ_ONLY\n");
  for (const char* write :
       {"L 1;T DB10.DBW 0", "OPN DB 10;L 1;T DBW 0", "OPN DI 10;L 1;T DIW 0",
        "OPN DB 10;LAR1 P#DBX 0.0;L 1;T W [AR1,P#0.0]", "OPN DB 10;L P#0.0;T MD 20;L 1;T DBB [MD 20]",
        "SET;S DB10.DBX 0.0", "CLR;= DB10.DBX 1.0", "SET;R DB10.DBX 1.0"}) {
    const Output output = simOf(fixed + block(1, write));
    EXPECT_EQ(output.exit, 1) << write << output.text;
    EXPECT_TRUE(output.has("write-protected")) << write << output.text;
    const Output taken = proofOf("prove kept: DB10.DBW0 = 7\nprove kind: MB30 = 16#30 or MB30 = 16#31\n",
                                 fixed + block(121, "L LB 1;T MB 30", info) + block(1, write));
    EXPECT_TRUE(taken.has("PROVED  kept") && taken.has("PROVED  kind")) << write << taken.text;
  }
  EXPECT_EQ(simOf(fixed + block(1, "L DB10.DBW 0;T MW 0;CLR;S DB10.DBX 0.0;R DB10.DBX 0.0")).exit, 0);
}

// UNLINKED: the block is in the load memory only; SFC 20 may copy it, an access is one to a block that is not loaded
// (002:537-563).
TEST(DataBlockAttributes, UnlinkedBlocksAreNotLoaded) {
  const std::string stored = dataBlock(10, "UNLINKED\n");
  for (const char* access : {"L DB10.DBW 0", "OPN DB 10;NOP 0", "L 1;T DB10.DBW 0"})
    EXPECT_EQ(simOf(stored + block(1, access)).exit, 1) << access;
  const std::string copied =
      stored + block(1, "CALL SFC 20 (SRCBLK := P#DB10.DBX 0.0 BYTE 2, RET_VAL := MW 20, DSTBLK := P#M 6.0 BYTE 2)");
  EXPECT_TRUE(lastRow(copied, "MW6", {"--scans", "1"}).ends_with(",7"));
}

// OPN of a block that is missing: which block is open behind the error is not stated.
TEST(DataBlockAttributes, AMissingBlockMayLeaveTheOtherOpen) {
  const std::string blocks =
      dataBlock(10) + block(121, "NOP 0") + block(1, "L 99;T MW 4;OPN DB 10;OPN DB [MW 4];L 1;T DBW 0");
  EXPECT_TRUE(proofOf("prove kept: DB10.DBW0 = 7\n", blocks).has("VIOLATED  kept"));
}

}  // namespace
}  // namespace rungproof
