// Organization blocks beside the cyclic ones: time-delay interrupts that SFC 32 starts, interrupts that SFC 41 delays,
// the cold restart, columns of start information. Each expectation is reasoned beside it.
#include "ir/s7300/start_information.hpp"
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::rowsOf;

const std::string countRuns = "L MW 12;L 1;+I;T MW 12";
const std::string start20 =
    "A I 0.0;FP M 1.0;JCN no;CALL SFC 32 (OB_NR := 20, DTIME := T#100MS, SIGN := W#16#1234, "
    "RET_VAL := MW 20);no: NOP 0";
const std::string info = "VAR_TEMP\n  info : ARRAY[0..19] OF BYTE;\nEND_VAR\n";

std::string columnOf(const std::vector<std::string>& rows) {
  std::string column;
  for (const std::string& row : rows) column += row.substr(row.rfind(',') + 1) + " ";
  return column;
}

// Started in the first scan, 100 ms later OB20 runs once: at the end of the tenth scan of 10 ms. The ms in which the
// call falls counts whole.
TEST(DelayBlocks, RunOnceAfterTheirTime) {
  const std::string blocks = block(1, start20) + block(20, countRuns);
  EXPECT_EQ(
      columnOf(rowsOf(blocks, "MW12", {"--scans", "30", "--scan-time", "10ms"}, "scan,I0.0\n1,1\n")).substr(0, 26),
      "0 0 0 0 0 0 0 0 0 1 1 1 1 ");
  EXPECT_TRUE(lastRow(blocks, "MW12", {"--scans", "30", "--scan-time", "10ms"}, "scan,I0.0\n1,1\n").ends_with(",1"));
  EXPECT_TRUE(lastRow(blocks, "MW12", {"--scans", "30", "--scan-time", "10ms"}, "scan,I0.0\n1,0\n").ends_with(",0"));
}

// A new call restarts the delay (002:1190-1212), SFC 33 cancels it.
TEST(DelayBlocks, AreRestartedAndCancelled) {
  const std::string cancel = "A I 0.1;JCN on;CALL SFC 33 (OB_NR := 20, RET_VAL := MW 22);on: NOP 0";
  const std::string blocks = block(1, start20 + ";" + cancel) + block(20, countRuns);
  const std::vector<std::string> run = {"--scans", "30", "--scan-time", "10ms"};
  const std::string again = columnOf(rowsOf(blocks, "MW12", run, "scan,I0.0,I0.1\n1,1,0\n5,0,0\n6,1,0\n"));
  EXPECT_EQ(again.substr(0, 36), "0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 1 1 ");  // ten scans from the sixth on
  EXPECT_TRUE(lastRow(blocks, "MW12", run, "scan,I0.0,I0.1\n1,1,0\n6,1,1\n").ends_with(",0"));
}

// One start is one run of OB20, and a second start is possible only while the input rises anew.
TEST(DelayBlocks, AreProvedToComeOnce) {
  const Output output = proofOf("assume held: prev(I0.0) implies I0.0\nprove once: MW12 <= 1\nreach comes: MW12 = 1\n",
                                block(1, start20) + block(20, countRuns), {"--scan-time", "20ms"});
  EXPECT_TRUE(output.has("PROVED  once") && output.has("REACHABLE  comes")) << output.text;
  EXPECT_FALSE(output.has("UNREACHABLE")) << output.text;
}

// 100 ms behind its call OB20 comes, not before. Scans take 20 ms; MW14 counts them from the one with the call on,
// which is scan 1. A call at the very start of that scan is 100 ms old at the end of scan 5, one at its end at that of
// scan 6.
TEST(DelayBlocks, AreProvedByTheirTime) {
  const std::string blocks =
      block(1,
            "A I 0.0;FP M 1.0;JCN no;CALL SFC 32 (OB_NR := 20, DTIME := T#100MS, SIGN := W#16#0, RET_VAL := MW 20);"
            "no: L MW 14;L 1;+I;T MW 14;A M 1.0;JC on;L 0;T MW 14;on: NOP 0") +
      block(20, "SET;= M 2.0");
  const Output output = proofOf(
      "assume held: not first_scan implies (prev(I0.0) implies I0.0)\n"
      "prove early: rises(M2.0) implies MW14 >= 5\nprove tooEarly: rises(M2.0) implies MW14 >= 6\n"
      "prove late: MW14 >= 6 and MW14 <= 100 implies M2.0\nprove tooLate: MW14 >= 5 and MW14 <= 100 implies M2.0\n",
      blocks, {"--scan-time", "20ms"});
  EXPECT_TRUE(output.has("PROVED  early") && output.has("PROVED  late")) << output.text;
  EXPECT_TRUE(output.has("VIOLATED  tooEarly") && output.has("VIOLATED  tooLate")) << output.text;
}

// The example of the course book (002:1204-1212) with a delay of 20 ms: two calls 10 ms apart are one run, 30 ms behind
// the first; by scans of 10 ms the third.
TEST(DelayBlocks, TwoCallsAreOneRun) {
  const std::string blocks =
      block(1,
            "A I 0.0;JCN no;CALL SFC 32 (OB_NR := 20, DTIME := T#20MS, SIGN := W#16#0, RET_VAL := MW 20);no: NOP 0") +
      block(20, countRuns);
  const std::vector<std::string> run = {"--scans", "9", "--scan-time", "10ms"};
  EXPECT_EQ(columnOf(rowsOf(blocks, "MW12", run, "scan,I0.0\n1,1\n3,0\n")), "0 0 1 1 1 1 1 1 1 ");
  EXPECT_EQ(columnOf(rowsOf(blocks, "MW12", run, "scan,I0.0\n1,1\n2,0\n")), "0 1 1 1 1 1 1 1 1 ");
}

// A block that starts its own delay anew comes again and again.
TEST(DelayBlocks, MayStartThemselves) {
  const std::string again = "CALL SFC 32 (OB_NR := 20, DTIME := T#20MS, SIGN := W#16#0, RET_VAL := MW 20)";
  const std::string blocks = block(100, again) + block(1, "NOP 0") + block(20, countRuns + ";" + again);
  const std::string row = lastRow(blocks, "MW12", {"--duration", "405ms", "--scan-time", "5ms"});
  EXPECT_TRUE(row.ends_with(",20")) << row;
  const Output output = proofOf("reach three: MW12 = 3\nprove few: MW12 <= 2\n", blocks);
  EXPECT_TRUE(output.has("REACHABLE  three") && !output.has("UNREACHABLE")) << output.text;
  EXPECT_FALSE(output.has("PROVED  few")) << output.text;
}

// OB35 cancels the delay of 20 ms every 100 ms: OB20 may have come before, although OB35 has the higher priority and
// nothing of OB1 lies between them.
TEST(DelayBlocks, ComeBeforeAnotherBlockCancelsThem) {
  const std::string start = "CALL SFC 32 (OB_NR := 20, DTIME := T#20MS, SIGN := W#16#0, RET_VAL := MW 20)";
  const std::string blocks = block(100, start) + block(1, "NOP 0") + block(20, "SET;= M 2.0") +
                             block(35, "CALL SFC 33 (OB_NR := 20, RET_VAL := MW 22)");
  const Output output = proofOf("prove never: not M2.0\nreach comes: M2.0\n", blocks);
  EXPECT_FALSE(output.has("PROVED  never") || output.has("UNREACHABLE")) << output.text;
}

// Whether SFC 33 is in time for an interrupt that is due and waits behind SFC 41 is not stated: nothing is proved.
TEST(DelayBlocks, ThatWaitAreNotProvedToBeCancelled) {
  const std::string blocks =
      block(1,
            "CALL SFC 41 (RET_VAL := MW 24);A I 0.0;JCN no;CALL SFC 33 (OB_NR := 20, RET_VAL := MW 22);no: NOP 0;"
            "CALL SFC 42 (RET_VAL := MW 26);AN I 0.0;JCN on;CALL SFC 32 (OB_NR := 20, DTIME := T#5MS, SIGN := W#16#0, "
            "RET_VAL := MW 20);on: NOP 0") +
      block(20, "SET;= M 2.0");
  EXPECT_FALSE(proofOf("prove never: I0.0 implies not rises(M2.0)\n", blocks).has("PROVED  never"));
}

// The end of a delay without its block is an error of the CPU: NOT COVERED.
TEST(DelayBlocks, NeedTheirBlock) {
  const std::string one = block(20, "SET;= M 2.0");
  for (const char* number : {"21", "MW 30"}) {
    const std::string blocks = block(
        1, std::string("CALL SFC 32 (OB_NR := ") + number + ", DTIME := T#5MS, SIGN := W#16#0, RET_VAL := MW 20)");
    const Output output = proofOf("prove off: not Q0.0\n", blocks + one);
    EXPECT_TRUE(output.has("NOT COVERED  off")) << number << output.text;
  }
}

// SIGN reaches the block in its local data (002:1210); a delay of 0 ms is none, nor is one of a minute and 1 ms.
TEST(DelayBlocks, SignAndRange) {
  const std::string blocks = block(1, start20) + block(20, "L LW 6;T MW 30", info);
  EXPECT_TRUE(proofOf("prove sign: MW30 = 0 or MW30 = 16#1234\n", blocks).has("PROVED  sign"));
  for (const char* time : {"T#0MS", "T#1M1MS"}) {
    const std::string wrong =
        block(1, std::string("CALL SFC 32 (OB_NR := 20, DTIME := ") + time + ", SIGN := W#16#0, RET_VAL := MW 20)");
    EXPECT_TRUE(proofOf("prove none: MW12 = 0\n", wrong + block(20, countRuns)).has("PROVED  none")) << time;
  }
}

const std::string guarded = "A I 0.0;= M 0.0;A M 0.0;= Q 0.0;AN M 0.0;= Q 0.1";

// Between SFC 41 and SFC 42 no OB35 comes (002:2353), nor up to the end of OB1 without SFC 42; one call takes back one.
TEST(DelayedInterrupts, WaitForTheirEnd) {
  const std::string never = "prove apart: never Q0.0 and Q0.1\n", other = block(35, "A I 0.1;= M 0.0");
  const std::string lock = "CALL SFC 41 (RET_VAL := MW 20);", unlocked = ";CALL SFC 42 (RET_VAL := MW 22)";
  EXPECT_TRUE(proofOf(never, block(1, guarded) + other).has("VIOLATED  apart"));
  EXPECT_TRUE(proofOf(never, block(1, lock + guarded + unlocked) + other).has("PROVED  apart"));
  EXPECT_TRUE(proofOf(never, block(1, lock + guarded) + other).has("PROVED  apart"));
  EXPECT_TRUE(
      proofOf(never, block(1, lock + lock + "CALL SFC 42 (RET_VAL := MW 22);" + guarded) + other).has("PROVED  apart"));
  EXPECT_TRUE(
      proofOf(never, block(1, lock + "CALL SFC 42 (RET_VAL := MW 22);" + guarded) + other).has("VIOLATED  apart"));
  // They are late, not lost: ten in a second.
  const std::string row =
      lastRow(block(1, lock + guarded) + block(35, countRuns), "MW12", {"--duration", "1005ms", "--scan-time", "10ms"});
  EXPECT_TRUE(row.ends_with(",10")) << row;
}

// A scan longer than the cycle monitoring stops the CPU (002:1296); OB80 takes the first excess, not a second
// (002:1314). Proofs let a scan last as long.
TEST(CycleMonitoring, StopsOrCallsOb80) {
  const std::string plain = block(1, countRuns), taken = plain + block(80, "L MW 16;L 1;+I;T MW 16");
  const auto last = [&](const std::string& blocks, const char* length, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"--scans", "3", "--scan-time", length};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return lastRow(blocks, "MW12,MW16", arguments);
  };
  EXPECT_TRUE(last(plain, "140ms").ends_with(",3,0")) << last(plain, "140ms");
  EXPECT_FALSE(last(plain, "160ms").ends_with(",3,0")) << last(plain, "160ms");
  EXPECT_TRUE(last(plain, "160ms", {"--cycle-monitoring", "200ms"}).ends_with(",3,0"));
  EXPECT_TRUE(last(taken, "160ms").ends_with(",3,3")) << last(taken, "160ms");
  EXPECT_FALSE(last(taken, "310ms").ends_with(",3,3")) << last(taken, "310ms");
  const std::string any = "prove any: MW12 = MW12\n";
  EXPECT_TRUE(proofOf(any, plain).has("every scan lasts 1 to 150 ms"));
  EXPECT_TRUE(proofOf(any, plain, {"--cycle-monitoring", "80ms"}).has("every scan lasts 1 to 80 ms"));
  EXPECT_TRUE(proofOf(any, taken).has("every scan lasts 1 to 300 ms"));
  EXPECT_TRUE(test7::run({"sim", "none.awl", "--cycle-monitoring", "7s"}).has("no time of the cycle monitoring"));
}

// The cold restart runs OB102 instead of OB100, says 4 in OB1's first scan and retains nothing (002:1383).
TEST(ColdRestart, IsOneOfTheProject) {
  const std::string blocks = block(100, "SET;= M 1.0") + block(102, "SET;= M 1.1") + block(1, "L LB 1;T MB 30", info);
  const std::string warm = lastRow(blocks, "M1.0,M1.1,MB30", {"--scans", "1"});
  const std::string cold = lastRow(blocks, "M1.0,M1.1,MB30", {"--scans", "1", "--start", "cold"});
  EXPECT_TRUE(warm.ends_with(",1,0,1")) << warm;
  EXPECT_TRUE(cold.ends_with(",0,1,4")) << cold;
  const std::string retained = "initial retentive\nprove zero: MW0 = 0\n", read = block(1, "L MW 0;T MW 0");
  EXPECT_TRUE(proofOf(retained, read).has("VIOLATED  zero"));
  EXPECT_TRUE(proofOf(retained, read, {"--start", "cold"}).has("PROVED  zero"));
  EXPECT_TRUE(proofOf("prove one: M1.0\n", blocks).has("runs begin with a warm restart"));
}

// The 318-2 and the S7-400 have a cold restart, other CPUs of the S7-300 have not (002:1355, 002:1387).
TEST(ColdRestart, ExistsOnSomeCpus) {
  const std::string blocks = block(100, "SET;= M 1.0") + block(102, "SET;= M 1.1") + block(1, "NOP 0");
  for (const char* cpu : {"318-2", "412"}) {
    const Output output = proofOf("prove cold: M1.1\n", blocks, {"--start", "cold", "--cpu", cpu});
    EXPECT_TRUE(output.has("PROVED  cold") && !output.has("has no cold restart")) << cpu << output.text;
  }
  const Output output = proofOf("prove warm: M1.0\n", blocks, {"--start", "cold", "--cpu", "315-2"});
  EXPECT_TRUE(output.has("PROVED  warm") && output.has("a CPU 315-2 has no cold restart")) << output.text;
}

// Only an S7-400 has a hot restart (002:1391), and what it leaves of images, outputs and timers is not stated
// (002:1389-1415): beside OB101 nothing is proved there unless it is excluded. On an S7-300 OB101 never runs; without
// a name of the family OB101 itself says which is meant.
TEST(HotRestart, IsNotCoveredWhereItMayCome) {
  const std::string blocks = block(1, "CLR;= Q 0.0") + block(101, "SET;= Q 0.0"), property = "prove off: not Q0.0\n";
  const Output s7400 = proofOf(property, blocks, {"--dialect", "s7-400"});
  EXPECT_TRUE(s7400.has("NOT COVERED  off") && s7400.has("whether timers run on")) << s7400.text;
  EXPECT_FALSE(s7400.has("no hot restart comes")) << s7400.text;
  const Output excluded = proofOf(property, blocks, {"--dialect", "s7-400", "--choice", "hot-restart=excluded"});
  EXPECT_TRUE(excluded.has("PROVED  off") && excluded.has("no hot restart comes")) << excluded.text;
  const Output s7300 = proofOf(property, blocks, {"--cpu", "315-2"});
  EXPECT_TRUE(s7300.has("PROVED  off")) << s7300.text;
  const Output open = proofOf(property, blocks, {"--dialect", "auto"});
  EXPECT_TRUE(open.has("NOT COVERED  off") && open.has("whether timers run on")) << open.text;  // OB101: a 417
}

// Fields of the start information are columns of a stimulus (002:1242).
TEST(StartInformationColumns, ReachTheBlock) {
  const std::string blocks =
      block(1, "NOP 0") + block(40, "L LD 8;T MD 20;L LW 6;T MW 24", info) + block(82, "A L 8.2;= M 0.0", info);
  const std::string stimulus =
      "scan,event,OB40_POINT_ADDR,ob40_mdl_addr,OB82_EXT_FAULT\n1,,0,0,0\n2,40,70000,256,0\n3,82,0,0,1\n";
  const std::string row = lastRow(blocks, "MD20,MW24,M0.0", {}, stimulus);
  EXPECT_TRUE(row.ends_with(",70000,256,1")) << row;
  EXPECT_NE(lastRow(blocks, "MD20", {}, "scan,OB40_SPEED\n1,0\n").find("OB40_SPEED"), std::string::npos);
}

TEST(StartInformationColumns, Places) {
  const auto at = [](const char* name) { return s7300::startFieldNamed(name); };
  EXPECT_EQ(at("OB40_POINT_ADDR")->byte, 8U);
  EXPECT_EQ(at("OB40_POINT_ADDR")->width, Width::DWord);
  EXPECT_EQ(at("OB1_PREV_CYCLE")->byte, 6U);
  EXPECT_EQ(at("ob35_exc_freq")->byte, 10U);
  EXPECT_EQ(at("OB82_CONFIG_ERR")->bit, 7U);
  EXPECT_EQ(at("OB121_SW_FLT")->byte, 1U);
  EXPECT_FALSE(at("OB35_POINT_ADDR") || at("OB_1") || at("X40_POINT_ADDR") || at("OB40"));
}

}  // namespace
}  // namespace rungproof
