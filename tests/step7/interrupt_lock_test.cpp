// SFC 39 and SFC 40 beside organization blocks that interrupt OB1 (002:2353): what is locked is lost, what is not comes
// as ever. Each expectation is reasoned beside it.
#include "ir/s7300/interrupt_lock.hpp"

#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf;

std::string call(int function, int mode, const std::string& block) {
  return "CALL SFC " + std::to_string(function) + " (MODE := B#16#" + std::to_string(mode) + ",OB_NR := " + block +
         ",RET_VAL := MW 50)";
}
std::string lock(int mode, const std::string& block) { return call(39, mode, block); }
std::string unlock(int mode, const std::string& block) { return call(40, mode, block); }
std::string count(int word) {
  const std::string place = "MW " + std::to_string(word);
  return "L " + place + ";L 1;+I;T " + place;
}

// The first event comes before the lock, which the second scan sets behind its own; those of scans 3 and 4 are lost,
// though scan 4 unlocks; that of scan 5 comes: three of five.
TEST(InterruptLock, LosesWhatComesMeanwhile) {
  const std::string main = "A I 0.0;JCN a;" + lock(2, "40") + ";a: A I 0.1;JCN b;" + unlock(2, "40") + ";b: NOP 0";
  const std::string blocks = block(1, main) + block(40, count(12)) + block(41, count(14));
  const std::string events =
      "scan,I0.0,I0.1,event\n1,0,0,40 41\n2,1,0,40 41\n3,0,0,40 41\n4,0,1,40 41\n5,0,0,40 41\n6,0,0,\n";
  const std::string row = lastRow(blocks, "MW12,MW14", {"--cpu", "417"}, events);
  EXPECT_TRUE(row.ends_with(",3,5")) << row;
}

// MODE 0 names all, 1 the class of OB_NR, 2 the block; 16#80 more keeps the diagnostic buffer as it is. What the start
// locks is lost from the first scan on.
TEST(InterruptLock, NamesAllAClassOrOne) {
  const std::string events = "scan,event\n1,40 41 10\n2,40 41 10\n3,\n";
  const auto counts = [&](int mode, const std::string& which) {
    const std::string blocks = block(100, lock(mode, which)) + block(1, "NOP 0") + block(40, count(12)) +
                               block(41, count(14)) + block(10, count(16));
    const std::string row = lastRow(blocks, "MW12,MW14,MW16", {"--cpu", "417"}, events);
    return row.substr(row.size() - std::min<std::size_t>(row.size(), 5));
  };
  EXPECT_EQ(counts(0, "0"), "0,0,0");
  EXPECT_EQ(counts(80, "0"), "0,0,0");
  EXPECT_EQ(counts(1, "40"), "0,0,2");
  EXPECT_EQ(counts(81, "10"), "2,2,0");
  EXPECT_EQ(counts(2, "41"), "2,0,2");
  EXPECT_EQ(counts(2, "42"), "2,2,2");
  EXPECT_EQ(counts(7, "40"), "2,2,2");
}

// The period goes on while OB35 is locked. Scan 46 begins after 450 ms: of ten in a second the first four are lost.
TEST(InterruptLock, KeepsThePeriod) {
  const std::string main = count(10) + ";L MW 10;L 46;==I;JCN e;" + unlock(1, "30") + ";e: NOP 0";
  const std::string blocks = block(100, lock(1, "30")) + block(1, main) + block(35, count(12));
  const std::string row = lastRow(blocks, "MW12", {"--duration", "1005ms", "--scan-time", "10ms"});
  EXPECT_TRUE(row.ends_with(",6")) << row;
}

const std::string fromOneBit = "A I 0.0;= M 0.0;A M 0.0;= Q 0.0;AN M 0.0;= Q 0.1";

// Both outputs come from M0.0, into which OB40 writes: fromOneBit only while nothing comes in between.
TEST(InterruptLock, ProtectsWhatStandsBetween) {
  const std::string never = "prove apart: never Q0.0 and Q0.1\n", hardware = block(40, "A I 0.1;= M 0.0");
  const auto verdict = [&](const std::string& before, const std::string& after) {
    return proofOf(never, block(1, before + ";" + fromOneBit + ";" + after) + hardware);
  };
  for (const auto& [mode, which] : {std::pair(0, "0"), std::pair(1, "40"), std::pair(2, "40"), std::pair(82, "40")}) {
    const Output output = verdict(lock(mode, which), mode == 82 ? unlock(2, which) : unlock(mode, which));
    EXPECT_TRUE(output.has("PROVED  apart")) << mode << output.text;
  }
  EXPECT_TRUE(verdict("NOP 0", "NOP 0").has("VIOLATED  apart"));
  EXPECT_TRUE(verdict(lock(1, "30"), "NOP 0").has("VIOLATED  apart"));
  EXPECT_TRUE(verdict(lock(2, "MW 60"), unlock(2, "40")).has("VIOLATED  apart"));
  EXPECT_TRUE(verdict(lock(0, "0") + ";" + unlock(2, "40"), "NOP 0").has("VIOLATED  apart"));
  // What MODE 0 with another number than 0 does is not stated.
  EXPECT_TRUE(verdict(lock(0, "40"), unlock(0, "0")).has("VIOLATED  apart"));
}

// OB35 tells OB1 every 100 ms. Unlocked for a moment in each scan it may still be lost for ever; locked from the start
// it never comes; unlocked all the time it comes within six scans of 20 ms.
TEST(InterruptLock, LosesCyclicOnes) {
  const std::string counting = "A M 2.0;JCN inc;CLR;= M 2.0;L 0;T MW 10;inc: L MW 10;L 1;+I;T MW 10";
  const std::string properties = "prove within: MW10 <= 6\nprove silent: not M2.0\n", cyclic = block(35, "SET;= M 2.0");
  const auto verdict = [&](const std::string& start, const std::string& main) {
    return proofOf(properties, block(100, start) + block(1, main) + cyclic, {"--scan-time", "20ms"});
  };
  const Output open = verdict(lock(1, "30") + ";" + unlock(1, "30"), counting);
  EXPECT_TRUE(open.has("PROVED  within") && open.has("VIOLATED  silent")) << open.text;
  const Output moment = verdict("NOP 0", lock(2, "35") + ";" + counting + ";" + unlock(2, "35"));
  EXPECT_TRUE(moment.has("VIOLATED  within") && moment.has("VIOLATED  silent")) << moment.text;
  const Output never = verdict(lock(2, "35"), counting);
  EXPECT_TRUE(never.has("VIOLATED  within") && never.has("PROVED  silent")) << never.text;
}

// A delay that ends while OB20 is locked is over; another one comes.
TEST(InterruptLock, LosesTheEndOfADelay) {
  const std::string start = "CALL SFC 32 (OB_NR := 20,DTIME := T#15MS,SIGN := W#16#0,RET_VAL := MW 52)";
  const std::string locked = block(100, start + ";" + lock(1, "20")), served = block(20, "SET;= M 2.0");
  const std::string silent = "prove silent: not M2.0\n";
  const std::string late = count(10) + ";L MW 10;L 5;==I;JCN e;" + unlock(1, "20") + ";e: NOP 0";
  const std::vector<std::string> scans = {"--scan-time", "10ms"};
  EXPECT_TRUE(proofOf(silent, locked + block(1, late) + served, scans).has("PROVED  silent"));
  const std::string again = count(10) + ";L MW 10;L 5;==I;JCN e;" + unlock(1, "20") + ";" + start + ";e: NOP 0";
  EXPECT_TRUE(proofOf(silent, locked + block(1, again) + served, scans).has("VIOLATED  silent"));
}

// What waits for SFC 42 when SFC 39 comes would still run: that is not followed.
TEST(InterruptLock, IsLeftOpenWhereAnInterruptMayWait) {
  const std::string delayed = "CALL SFC 41 (RET_VAL := MW 52);NOP 0;" + lock(2, "40") +
                              ";CALL SFC 42 (RET_VAL := MW 52);" + fromOneBit + ";" + unlock(2, "40");
  const Output output = proofOf("prove apart: never Q0.0 and Q0.1\n", block(1, delayed) + block(40, "A I 0.1;= M 0.0"));
  EXPECT_FALSE(output.has("PROVED  apart")) << output.text;
  EXPECT_TRUE(output.has("an interrupt may wait while it is locked")) << output.text;
}

}  // namespace
}  // namespace rungproof
