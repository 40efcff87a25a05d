// Clock memory: the bits of a byte of M flash with the periods 0.1, 0.2, 0.4, 0.5, 0.8, 1, 1.6 and 2 s from bit 0 to
// bit 7, half of the period each way; where they are at the start nobody knows.
#include "ir/s7300/clock_memory.hpp"

#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::rowsOf, test7::run;

const std::vector<std::string> clocked = {"--clock-memory", "MB100"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Counts the rising edges of a bit of MB100 in MW10.
std::string edges(int bit) {
  return block(1, "A M 100." + std::to_string(bit) + ";FP M 1.0;JCN end;L MW 10;L 1;+I;T MW 10;end: NOP 0");
}

// A bit of period p that begins low rises after p/2, and every p after that: in 4 s (4000 - p/2) / p + 1 times.
TEST(ClockMemory, FlashesWithItsPeriods) {
  for (int bit = 0; bit < 8; ++bit) {
    const int period = clockPeriods[static_cast<std::size_t>(bit)], rises = (4000 - period / 2) / period + 1;
    const std::string row = lastRow(edges(bit), "MW10", with({"--duration", "4010ms", "--scan-time", "10ms"}, clocked));
    EXPECT_TRUE(row.ends_with("," + std::to_string(rises))) << bit << ": " << row;
  }
}

// CLOCK.bit5 = 500 begins with the second half of the second: on in the first scan, which a rising edge counts too.
TEST(ClockMemory, AStimulusSaysWhereItBegins) {
  const std::vector<std::string> rows =
      rowsOf(edges(5), "M100.5", with({"--scans", "3", "--scan-time", "10ms"}, clocked), "scan,CLOCK.bit5\n1,485\n");
  ASSERT_EQ(rows.size(), 3U) << rows[0];
  EXPECT_TRUE(rows[0].ends_with(",0") && rows[1].ends_with(",0") && rows[2].ends_with(",1")) << rows[2];
}

// It may be high or low at the start. High for half a second at a time: with scans of 100 ms, five in a row, or six
// where it is seen at the place of the program and changes between the scans; never seven.
TEST(ClockMemory, ProofsCoverEveryPhase) {
  const std::string blocks = block(1, "A M 100.5;JCN low;L MW 10;L 1;+I;T MW 10;BEU;low: L 0;T MW 10");
  const Output output = proofOf(
      "reach on: first_scan and M100.5\nreach off: first_scan and not M100.5\n"
      "prove seven: MW10 < 7\nprove four: MW10 < 5\n",
      blocks, with({"--scan-time", "100ms"}, clocked));
  EXPECT_TRUE(output.has("REACHABLE  on") && output.has("REACHABLE  off")) << output.text;
  EXPECT_TRUE(output.has("PROVED  seven") && output.has("VIOLATED  four")) << output.text;
}

// Two scans of one bit in one scan of the program can differ: it changes beside the program. By the reading that time
// passes between the scans they cannot.
TEST(ClockMemory, ChangesBesideTheProgram) {
  const std::string blocks = block(1, "A M 100.5;= M 0.0;A M 100.5;= M 0.1");
  const std::string same = "prove same: M0.0 = M0.1\n";
  EXPECT_TRUE(proofOf(same, blocks, clocked).has("VIOLATED  same"));
  EXPECT_TRUE(proofOf(same, blocks, with({"--choice", "s5-time=synchronous"}, clocked)).has("PROVED  same"));
  EXPECT_TRUE(proofOf(same, blocks).has("PROVED  same"));
}

// Nobody writes M100.5 in the program; that does not make it constant, whether the program reads it or not.
TEST(ClockMemory, IsNoMemoryThatNobodyWrites) {
  const std::string blocks = block(1, "A M 100.5;= Q 0.0");
  const Output output =
      proofOf("prove off: not Q0.0\nprove low: not M100.5\nprove other: not M100.4\n", blocks, clocked);
  EXPECT_TRUE(output.has("VIOLATED  off") && output.has("VIOLATED  low") && output.has("VIOLATED  other"))
      << output.text;
}

// Two programs see one clock.
TEST(ClockMemory, IsTheSameForBothPrograms) {
  const test::TemporaryFolder folder;
  folder.file("old.awl", block(1, "A M 100.5;A I 0.0;= Q 0.0"));
  folder.file("new.awl", block(1, "A I 0.0;A M 100.5;= Q 0.0"));
  folder.file("slower.awl", block(1, "A I 0.0;A M 100.7;= Q 0.0"));
  const auto verdict = [&](const char* after) {
    return run({"equiv", folder.path("old.awl"), folder.path(after), "--clock-memory", "MB100", "--choice",
                "s5-time=synchronous", "--scan-time", "100ms"})
        .exit;
  };
  EXPECT_EQ(verdict("new.awl"), 0);
  EXPECT_EQ(verdict("slower.awl"), 1);
}

TEST(ClockMemory, IsAByteOfM) {
  for (const char* wrong : {"100", "MW100", "QB4", "M100.0", "MB0..MB1", "DB1.DBB0"}) {
    const Output output = run({"sim", "none.awl", "--clock-memory", wrong});
    EXPECT_EQ(output.exit, 2);
    EXPECT_TRUE(output.has("no byte for clock memory")) << wrong << output.text;
  }
  const test::TemporaryFolder folder;
  folder.file("main.awl", block(1, "A M 10.5;= Q 0.0"));
  const Output output =
      run({"sim", folder.path("main.awl"), "--cpu", "314", "--clock-memory", "MB300", "--scans", "1"});
  EXPECT_TRUE(output.has("no clock memory")) << output.text;
}

}  // namespace
}  // namespace rungproof
