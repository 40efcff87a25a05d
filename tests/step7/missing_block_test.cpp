// Events whose organization block the program does not have: which of them stop the CPU in a run (002:1102, 002:1158,
// 002:1278, 002:1338), and that proofs name them. Each expectation is reasoned beside it.
#include "ir/block_event.hpp"
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::run;

const std::string countUp = "L MW 12;L 1;+I;T MW 12";

/// What sim says of five scans with the event at the start of the third.
Output simOf(const std::string& blocks, const std::string& event) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", blocks);
  folder.file("in.csv", "scan,event\n1,\n2,\n3," + event + "\n4,\n5,\n");
  return run({"sim", folder.path("main.awl"), "--dialect", "s7-400", "--stimulus", folder.path("in.csv")});
}
std::string countOf(const std::string& blocks, const std::string& event) {
  return lastRow(blocks, "MW12", {"--dialect", "s7-400"}, "scan,event\n1,\n2,\n3," + event + "\n4,\n5,\n");
}

// An error without its block stops the CPU (002:1278) in front of the third run of OB1; with its block, be it empty,
// five scans are counted.
TEST(MissingBlocks, OfErrorsStopTheCpu) {
  for (const int number : {80, 82, 83, 84, 85, 86, 87}) {
    const std::string event = std::to_string(number), name = "OB" + event;
    const Output output = simOf(block(1, countUp), event);
    EXPECT_EQ(output.exit, 1) << name << output.text;
    EXPECT_TRUE(output.has("organization block is missing: " + name) && output.has("002:1278")) << output.text;
    EXPECT_TRUE(output.has("main.awl:1:1") && output.has("1 | ORGANIZATION_BLOCK OB 1")) << output.text;
    EXPECT_TRUE(countOf(block(1, countUp), event).ends_with(",2")) << countOf(block(1, countUp), event);
    const std::string loaded = block(1, countUp) + block(number, "NOP 0");
    EXPECT_EQ(simOf(loaded, event).exit, 0) << name;
    EXPECT_TRUE(countOf(loaded, event).ends_with(",5")) << countOf(loaded, event);
  }
}

// A fault of the power supply does not stop it (general knowledge), nor does a cyclic interrupt (002:1102).
TEST(MissingBlocks, OfPowerSupplyAndPeriodsDoNothing) {
  for (const char* event : {"81", "30", "35", "38"}) {
    EXPECT_EQ(simOf(block(1, countUp), event).exit, 0) << event;
    EXPECT_TRUE(countOf(block(1, countUp), event).ends_with(",5")) << event;
  }
}

// The start of a missing block is an error for OB85 (002:1158, 002:1338), which runs once here: 10 is added once.
TEST(MissingBlocks, OfInterruptsAreAnErrorOfTheProgram) {
  for (const char* event : {"10", "17", "20", "40", "47"}) {
    const Output output = simOf(block(1, countUp), event);
    EXPECT_EQ(output.exit, 1) << event;
    EXPECT_TRUE(output.has(std::string("organization block is missing: OB") + event)) << output.text;
    const std::string caught = block(1, countUp) + block(85, "L MW 12;L 10;+I;T MW 12");
    EXPECT_TRUE(countOf(caught, event).ends_with(",15")) << event << countOf(caught, event);
  }
}

// At a place in the scan: the instructions before it have run, those behind it have not. SET stands in
// line 4, CLR in line 6.
TEST(MissingBlocks, StopInTheMidstOfAScan) {
  const std::string blocks = block(1, "SET;= M 0.0;CLR;= M 0.0");
  EXPECT_TRUE(lastRow(blocks, "M0.0", {}, "scan,event\n1,\n2,83@6\n").ends_with(",1"));
  EXPECT_TRUE(lastRow(blocks, "M0.0", {}, "scan,event\n1,\n2,\n").ends_with(",0"));
}

// Proofs ask nothing of a CPU that has stopped, and say which errors stop it.
TEST(MissingBlocks, AreNamedByProofs) {
  const std::string any = "prove any: MW12 = MW12\n";
  EXPECT_TRUE(proofOf(any, block(1, countUp)).has("no block for an event: OB80, OB82 to OB87 (002:1278)"));
  EXPECT_TRUE(proofOf(any, block(1, countUp) + block(82, "NOP 0") + block(86, "NOP 0"))
                  .has("no block for an event: OB80, OB83 to OB85, OB87 (002:1278)"));
  std::string all = block(1, countUp);
  for (const int number : {80, 82, 83, 84, 85, 86, 87}) all += block(number, "NOP 0");
  EXPECT_FALSE(proofOf(any, all).has("no block for an event"));
}

// A block without statements may write any place, so that nothing is proved; the help says how to stand in for it. The
// stand-in gives any value of its output and writes nothing else.
TEST(MissingBlocks, ThatAreCalledHaveAStandIn) {
  const std::string head = "FUNCTION FC 7 : VOID\n", lists = "VAR_OUTPUT\n  y : INT;\nEND_VAR\nBEGIN\n";
  const std::string caller = block(1, "CALL FC 7 (y := MW 2);A I 0.0;= Q 0.0"), end = "END_FUNCTION\n";
  const std::string properties = "prove same: Q0.0 = I0.0\nprove none: MW2 = 0\nreach big: MW2 = 1234\n";
  const std::string hidden = head + "KNOW_HOW_PROTECT\n" + lists + end + caller;
  EXPECT_TRUE(proofOf(properties, hidden).has("NOT COVERED  same"));
  for (const std::string& blocks : {hidden, caller}) {
    const test::TemporaryFolder folder;
    folder.file("main.awl", blocks);
    const Output lint = run({"lint", folder.path("main.awl")});
    EXPECT_TRUE(lint.has("stand-in") && lint.has("L PIW 1000")) << lint.text;
  }
  const Output output = proofOf(properties, head + lists + "NETWORK\nL PIW 1000;\nT #y;\n" + end + caller);
  EXPECT_TRUE(output.has("PROVED  same") && output.has("VIOLATED  none") && output.has("REACHABLE  big"))
      << output.text;
}

TEST(MissingBlocks, AreExplained) {
  EXPECT_TRUE(run({"explain", "OB82"}).has("the CPU stops (002:1278)"));
  EXPECT_TRUE(run({"explain", "OB81"}).has("nothing happens"));
  EXPECT_TRUE(run({"explain", "OB40"}).has("OB85 runs"));
  EXPECT_FALSE(run({"explain", "OB1"}).has("Without it"));
}

}  // namespace
}  // namespace rungproof
