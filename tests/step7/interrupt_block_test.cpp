// Organization blocks that interrupt OB1: verdicts with and without them, the times at which cyclic ones come, events
// of a stimulus. Each expectation is reasoned beside it.
#include "ir/block_event.hpp"
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::run;

const std::string exclusive = "A I 0.0;= M 0.0;A M 0.0;= Q 0.0;AN M 0.0;= Q 0.1";
const std::string countUp = "L MW 12;L 1;+I;T MW 12";

// Both outputs come from M0.0. Alone, OB1 makes them exclusive; an OB35 that writes M0.0 may come between them.
TEST(InterruptBlocks, ComeBetweenInstructions) {
  const std::string never = "prove apart: never Q0.0 and Q0.1\n";
  EXPECT_TRUE(proofOf(never, block(1, exclusive)).has("PROVED  apart"));
  const std::string foreign = block(35, "A I 0.1;= M 1.0"), shared = block(35, "A I 0.1;= M 0.0");
  EXPECT_TRUE(proofOf(never, block(1, exclusive) + foreign).has("PROVED  apart"));
  EXPECT_TRUE(proofOf(never, block(1, exclusive) + shared).has("VIOLATED  apart"));
  for (const int number : {10, 40, 82, 86}) {
    const Output output = proofOf(never, block(1, exclusive) + block(number, "A I 0.1;= M 0.0"));
    EXPECT_TRUE(output.has("VIOLATED  apart") && output.has(std::to_string(number) + "@")) << number << output.text;
  }
}

// OB35 asks every 100 ms, OB1 counts scans of 20 ms and begins anew when it sees that. It sees it in the scan in which
// the interrupt comes, or in the next: six scans at most are counted.
TEST(InterruptBlocks, CyclicOnesKeepTheirPeriod) {
  const std::string blocks =
      block(1, "A M 2.0;JCN inc;CLR;= M 2.0;L 0;T MW 10;inc: L MW 10;L 1;+I;T MW 10") + block(35, "SET;= M 2.0");
  const std::string properties = "prove within: MW10 <= 6\nprove few: MW10 <= 3\nreach five: MW10 = 5\n";
  const Output output = proofOf(properties, blocks, {"--scan-time", "20ms"});
  EXPECT_TRUE(output.has("PROVED  within") && output.has("VIOLATED  few") && output.has("REACHABLE  five"))
      << output.text;
  const Output slower = proofOf(properties, blocks, {"--scan-time", "20ms", "--ob35", "200ms"});
  EXPECT_TRUE(slower.has("VIOLATED  within")) << slower.text;
}

// In a scan of 30 ms OB34 (20 ms) is due for longer than OB35 (30 ms). Both can come behind OB1, in that order,
// although OB35 has the higher priority.
TEST(InterruptBlocks, ThatAreDueTogetherAllCome) {
  const std::string blocks = block(1, "CLR;= M 0.0;= M 0.1") + block(34, "SET;= M 0.1") + block(35, "SET;= M 0.0");
  const Output output = proofOf("reach both: first_scan and M0.0 and M0.1\n", blocks,
                                {"--cpu", "417", "--scan-time", "30ms", "--ob34", "20ms", "--ob35", "30ms"});
  EXPECT_TRUE(output.has("REACHABLE  both") && !output.has("UNREACHABLE")) << output.text;
}

// Four may come in the first scan, more than are followed one by one: what they leave is not that of two, wherever the
// word lies. DB40 lies behind where 24 bits of a bit's number end.
TEST(InterruptBlocks, MoreThanAreFollowedCountInEveryBlock) {
  for (const char* block40 : {"DB 1", "DB 40", "DB 300"}) {
    const std::string name(block40), place = "DB" + name.substr(3) + ".DBW 0";
    const std::string data = "DATA_BLOCK " + name + "\nSTRUCT\n  n : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
    const std::string blocks = data + block(1, "NOP 0") + block(40, "L " + place + ";L 1;+I;T " + place);
    const Output output = proofOf("prove few: first_scan implies DB" + name.substr(3) + ".DBW0 <= 3\n", blocks);
    EXPECT_FALSE(output.has("PROVED  few")) << block40 << output.text;
  }
}

// 1 s at 10 ms a scan: OB35 comes every 100 ms, the last time at the very end; OB34 every 200 ms; as set.
TEST(InterruptBlocks, RunWithTheirPeriod) {
  const std::string blocks = block(1, "NOP 0") + block(35, countUp) + block(34, "L MW 14;L 1;+I;T MW 14");
  const std::vector<std::string> second = {"--cpu", "417", "--duration", "1005ms", "--scan-time", "10ms"};
  EXPECT_TRUE(lastRow(blocks, "MW12,MW14", second).ends_with(",10,5")) << lastRow(blocks, "MW12,MW14", second);
  std::vector<std::string> set = second;
  set.insert(set.end(), {"--ob35", "250ms"});
  EXPECT_TRUE(lastRow(blocks, "MW12,MW14", set).ends_with(",4,5")) << lastRow(blocks, "MW12,MW14", set);
  const Output wrong = run({"sim", "none.awl", "--ob35", "0ms"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_TRUE(wrong.has("period of a cyclic interrupt")) << wrong.text;
}

// A stimulus names blocks by their number. A cyclic interrupt without its block is not called (002:1102).
TEST(InterruptBlocks, ComeFromAStimulus) {
  const std::string blocks = block(1, "NOP 0") + block(40, countUp);
  const std::string twice = "scan,event\n1,\n2,40\n3,35\n4,40\n5,\n";
  EXPECT_TRUE(lastRow(blocks, "MW12", {}, twice).ends_with(",2")) << lastRow(blocks, "MW12", {}, twice);
  EXPECT_NE(lastRow(blocks, "MW12", {}, "scan,event\n1,50\n").find("no interrupt event"), std::string::npos);
}

// The start information of OB40 is any value (002:1242), its number is known.
TEST(InterruptBlocks, StartInformationIsFree) {
  const std::string blocks = block(1, "NOP 0") + block(40, "L LD 8;T MD 20;L LB 3;T MB 30",
                                                       "VAR_TEMP\n  info : ARRAY[0..19] OF BYTE;\nEND_VAR\n");
  const Output output = proofOf("prove zero: MD20 = 0\nprove number: MB30 = 0 or MB30 = 40\n", blocks);
  EXPECT_TRUE(output.has("VIOLATED  zero") && output.has("PROVED  number")) << output.text;
}

// Registers of OB1 are as before behind an interrupt (002:817): the string that it breaks goes on.
TEST(InterruptBlocks, LeaveTheRegistersAlone) {
  const std::string blocks =
      block(1, "A I 0.0;A I 0.1;= Q 0.0;L MW 2;L MW 4;+I;T MW 6") + block(35, "L 5;L 7;+I;SET;CLR;T MW 8");
  const Output output = proofOf("prove both: Q0.0 implies I0.0 and I0.1\nprove sum: MW6 = 0\n", blocks);
  EXPECT_TRUE(output.has("PROVED  both") && output.has("PROVED  sum")) << output.text;
}

// OB100 runs before anything can interrupt: what it sets is there in the first interrupt.
TEST(InterruptBlocks, DoNotComeDuringTheStart) {
  const std::string blocks = block(100, "CLR;= M 1.0;SET;= M 1.0") + block(1, "NOP 0") + block(35, "AN M 1.0;= Q 0.0");
  EXPECT_TRUE(proofOf("prove set: not Q0.0\n", blocks).has("PROVED  set"));
}

// OB40 has priority 16 and interrupts OB35 (12): it clears M1.0 between two of its instructions. One after the other,
// Q0.3 would never be on; with that left open nothing is proved.
TEST(InterruptBlocks, NothingIsProvedWhereOneInterruptsAnother) {
  const std::string high = block(40, "CLR;= M 1.0"), low = block(35, "SET;= M 1.0;AN M 1.0;= Q 0.3");
  const Output output = proofOf("prove never: not Q0.3\n", block(1, "NOP 0") + high + low);
  EXPECT_FALSE(output.has("PROVED  never")) << output.text;
  EXPECT_TRUE(output.has("OB40 inside OB35")) << output.text;
  EXPECT_TRUE(proofOf("prove never: not Q0.3\n", block(1, "NOP 0") + low).has("PROVED  never"));
  EXPECT_TRUE(
      proofOf("prove never: not Q0.3\n", block(1, "NOP 0") + low + block(40, "CLR;= M 2.0")).has("PROVED  never"));
}

// An error in an interrupt block stops the CPU unless OB121 takes it (002:1278).
TEST(InterruptBlocks, ErrorsStopTheCpu) {
  const std::string blocks = block(1, "SET;= Q 0.0") + block(40, "L 99;T MW 4;OPN DB [MW 4];L DBW 0;T MW 6");
  const test::TemporaryFolder folder;
  folder.file("main.awl", blocks);
  folder.file("in.csv", "scan,event\n1,\n2,40\n3,\n");
  const Output output = run({"sim", folder.path("main.awl"), "--stimulus", folder.path("in.csv")});
  EXPECT_EQ(output.exit, 1);
  EXPECT_TRUE(output.has("OB40")) << output.text;
  folder.file("in.csv", "scan,event\n1,\n2,\n3,\n");
  EXPECT_EQ(run({"sim", folder.path("main.awl"), "--stimulus", folder.path("in.csv")}).exit, 0);
}

}  // namespace
}  // namespace rungproof
