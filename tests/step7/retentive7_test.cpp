// What of an S7-300/400 keeps its value: MB0 to MB15, C0 to C7 and every data block without NON_RETAIN, unless the
// project says otherwise. `initial retentive` and `external` in property files. The numbers are those of section 14 of
// the machine's description: general knowledge but for the data blocks (002:563).
#include "engine/simulator.hpp"
#include "frontend/step7/name_lookup.hpp"
#include "ir/block_map.hpp"
#include "tests/step7/read7.hpp"
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::Output, test7::proofOf, test7::run;

const std::string twoBlocks =
    "DATA_BLOCK DB 10\nSTRUCT\n  a : INT := 7;\n  b : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
    "DATA_BLOCK DB 11\nNON_RETAIN\nSTRUCT\n  a : INT := 7;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

/// Copies a place to a flag in the first scan, so that a property can ask for its start.
std::string copying(const std::string& place) {
  return twoBlocks + block(1, "A M 100.0;JC done;SET;= M 100.0;L " + place + ";T MW 102;done: NOP 0");
}

Output startsWithSeven(const std::string& place, const std::vector<std::string>& more = {}) {
  return proofOf("initial retentive\nreach five: MW102 = 5\n", copying(place), more);
}

TEST(Retentive7, DefaultsOfTheFamily) {
  for (const char* kept : {"MW 0", "MW 14", "C 0", "C 7", "DB10.DBW 0", "DB10.DBW 2"}) {
    const Output output = startsWithSeven(kept);
    EXPECT_TRUE(output.has("REACHABLE  five") && !output.has("UNREACHABLE")) << kept << output.text;
  }
  for (const char* lost : {"MW 16", "C 8", "DB11.DBW 0"}) {
    const Output output = startsWithSeven(lost);
    EXPECT_TRUE(output.has("UNREACHABLE  five")) << lost << output.text;
  }
}

TEST(Retentive7, RangesOfTheProject) {
  const std::vector<std::string> set = {"--retentive", "MB16..MB17,C8..C9,DB10.DBB2..DBB3"};
  for (const char* kept : {"MW 16", "C 9", "DB10.DBW 2"}) EXPECT_TRUE(startsWithSeven(kept, set).has("  five")) << kept;
  for (const char* kept : {"MW 16", "C 9", "DB10.DBW 2"})
    EXPECT_FALSE(startsWithSeven(kept, set).has("UNREACHABLE")) << kept;
  for (const char* lost : {"MW 0", "C 0", "DB10.DBW 0", "DB11.DBW 0"})
    EXPECT_TRUE(startsWithSeven(lost, set).has("UNREACHABLE  five")) << lost;
  // Named ranges of other areas leave the data blocks as their attribute says.
  EXPECT_FALSE(startsWithSeven("DB10.DBW 0", {"--retentive", "MB16"}).has("UNREACHABLE"));
}

// A counter begins with 0 to 999, and its bit says whether it is 0 (002:2869-2880; limits: general knowledge).
TEST(Retentive7, CountersStartAsTheyCanBe) {
  const Output output = proofOf(
      "initial retentive\nprove most: C1.value <= 999\nprove bit: M100.1 = M100.2\nreach two: first_scan and M100.1\n",
      block(1, "A C 1;= M 100.1;L C 1;L 0;>I;= M 100.2"));
  EXPECT_TRUE(output.has("PROVED  most") && output.has("PROVED  bit") && output.has("REACHABLE  two")) << output.text;
}

// A retentive timer may be running when the CPU starts: its bit comes although nothing has started it.
TEST(Retentive7, TimersOnlyWhereTheProjectSaysSo) {
  const std::string blocks = block(1, "A I 0.0;L S5T#1S;SS T 3;A T 3;= Q 0.0");
  const std::string goals =
      "initial retentive\nprove off: not (first_scan and Q0.0)\nprove most: T3.value <= 9990000\n";
  const Output usual = proofOf(goals, blocks);
  EXPECT_TRUE(usual.has("PROVED  off") && usual.has("PROVED  most")) << usual.text;
  const Output kept =
      proofOf("initial retentive\nprove off: not (first_scan and Q0.0)\n", blocks, {"--retentive", "T0..T9"});
  EXPECT_TRUE(kept.has("VIOLATED  off")) << kept.text;
}

// DBW0 may be written by a panel, DBW2 is written by nobody and keeps its 0.
TEST(Retentive7, DataBlocksWrittenFromOutside) {
  const std::string blocks = twoBlocks + block(1, "L DB10.DBW 0;T MW 20;L DB10.DBW 2;T MW 22");
  const std::string goals = "reach panel: MW20 = 1234\nprove quiet: MW22 = 0\n";
  const Output declared = proofOf("external DB10.DBW0..DB10.DBW0\n" + goals, blocks);
  EXPECT_TRUE(declared.has("REACHABLE  panel") && declared.has("PROVED  quiet")) << declared.text;
  const Output wide = proofOf("external DB10.DBW0..DB10.DBW2\n" + goals, blocks);
  EXPECT_TRUE(wide.has("REACHABLE  panel") && wide.has("VIOLATED  quiet")) << wide.text;
  const Output set = proofOf(goals, blocks, {"--external", "DB10.DBW0"});
  EXPECT_TRUE(set.has("REACHABLE  panel") && set.has("PROVED  quiet")) << set.text;
  const Output none = proofOf(goals, blocks);
  EXPECT_TRUE(none.has("UNREACHABLE  panel") && none.has("PROVED  quiet")) << none.text;
}

TEST(Retentive7, WrongRangesSayWhatIsRight) {
  for (const char* wrong : {"DB10.DBB2..DB11.DBB3", "DB10.DBB3..DB10.DBB2", "DBB2", "DB10.DBX0.0", "QB4", "T"}) {
    const Output output = run({"sim", "none.awl", "--retentive", wrong});
    EXPECT_EQ(output.exit, 2);
    EXPECT_TRUE(output.has("no retentive range") && output.has("DB10.DBB0..DBB19")) << wrong << output.text;
  }
  EXPECT_TRUE(run({"sim", "none.awl", "--external", "DB10.DBW0..DB11.DBW8"}).has("written from outside"));
  EXPECT_TRUE(proofOf("external DB10.DBW0..DB11.DBW0\nprove a: not Q0.0\n", twoBlocks + block(1, "NOP 0"))
                  .has("same area (or data block)"));
}

// Power off and on in the engine: a download gives DB10.a its 7, the program makes it 8; that is kept, DB11's is not.
TEST(Retentive7, TheEngineKeepsWhatIsRetentive) {
  const Program program =
      read7(twoBlocks + block(1, "L 8;T DB10.DBW 0;T DB11.DBW 0;T MW 14;T MW 16;A I 0.0;CU C 7;CU C 8"));
  ASSERT_TRUE(program.findings.empty());
  const auto value = [&](const Simulator& simulator, const char* name) {
    return simulator.read(*step7::placeNamed(program, name));
  };
  Simulator simulator(program);
  EXPECT_EQ(value(simulator, "DB10.DBW0"), 7U);
  simulator.write(*step7::placeNamed(program, "I0.0"), 1);
  simulator.scan();
  for (const char* name : {"DB10.DBW0", "DB11.DBW0", "MW14", "MW16"}) EXPECT_EQ(value(simulator, name), 8U) << name;
  const auto isAsAfterRestart = [&] {
    EXPECT_EQ(value(simulator, "DB10.DBW0"), 8U);
    EXPECT_EQ(value(simulator, "DB11.DBW0"), 7U);
    EXPECT_EQ(value(simulator, "MW14"), 8U);
    EXPECT_EQ(value(simulator, "MW16"), 0U);
    EXPECT_EQ(simulator.store().get(Reg::CounterCurrent, 7), 1U);
    EXPECT_EQ(simulator.store().get(Reg::CounterBit, 7), 1U);
    EXPECT_EQ(simulator.store().get(Reg::CounterCurrent, 8), 0U);
    EXPECT_EQ(simulator.store().get(Reg::CounterUp, 7), 0U);  // the first RLO of 1 is an edge again
  };
  simulator.powerCycle();
  isAsAfterRestart();
  simulator.write(*step7::placeNamed(program, "I0.0"), 1);
  simulator.scan();
  simulator.stop();
  simulator.scan();
  simulator.run();  // a warm restart too (002:1367-1375): C7 has counted a second edge
  EXPECT_EQ(simulator.store().get(Reg::CounterCurrent, 7), 2U);
  EXPECT_EQ(value(simulator, "MW16"), 0U);
  EXPECT_EQ(value(simulator, "DB11.DBW0"), 7U);
}

}  // namespace
}  // namespace rungproof
