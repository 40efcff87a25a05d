// Organization blocks that a CPU does not have are never started: of each kind of interrupt an S7-300 has one, OB10,
// OB20, OB35 and OB40 (002:787, 002:1096, 002:1202, 002:1222), an S7-400 up to nine.
#include <set>

#include "ir/s7300/organization_block.hpp"
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::Output, test7::proofOf, test7::run;

const std::string mark = "SET;= M 2.0";
const std::string asked = "prove never: not M2.0\nreach comes: M2.0\n";

/// A call that starts the delay of the block, where it is one that a delay starts.
std::string mainFor(int number) {
  if (number / 10 != 2) return "NOP 0";
  return "CALL SFC 32 (OB_NR := " + std::to_string(number) + ", DTIME := T#5MS, SIGN := W#16#0, RET_VAL := MW 20)";
}

TEST(StartedBlocks, AreThoseOfTheManual) {
  const std::set<int> of300 = {10, 20, 35, 40};
  const std::set<int> of318 = {10, 11, 20, 21, 32, 35, 40, 41};  // the second ones: general knowledge
  for (const auto& [first, last] : {std::pair(10, 17), {20, 23}, {30, 38}, {40, 47}}) {
    for (int number = first; number <= last; ++number) {
      for (const char* cpu : {"312", "314", "315-2", "319-3"})
        EXPECT_EQ(s7300::startsOn(number, *cpuNamed(cpu)), of300.contains(number)) << number << cpu;
      EXPECT_EQ(s7300::startsOn(number, *cpuNamed("318-2")), of318.contains(number)) << number;
      for (const char* cpu : {"412", "417"}) EXPECT_TRUE(s7300::startsOn(number, *cpuNamed(cpu))) << number;
    }
  }
  for (const int number : {1, 80, 82, 85, 100, 121, 122})
    EXPECT_TRUE(s7300::startsOn(number, *cpuNamed("314"))) << number;
}

// What the block writes is never written where no CPU 314 starts it, and the verdict says so; a CPU 417 starts it. A
// delay that SFC 32 asks for a block that the CPU has not is not stated: NOT COVERED.
TEST(StartedBlocks, AreProvedNeverToRunElsewhere) {
  for (const auto& [first, last] : {std::pair(10, 17), {20, 23}, {30, 38}, {40, 47}, {60, 60}, {90, 90}}) {
    for (int number = first; number <= last; ++number) {
      const std::string blocks = block(1, "NOP 0") + block(number, mark), name = "OB" + std::to_string(number);
      const Output small = proofOf(asked, blocks, {"--cpu", "314"});
      const bool isThere = number == 10 || number == 35 || number == 40;
      EXPECT_EQ(small.has("VIOLATED  never") && small.has("REACHABLE  comes"), isThere) << name << small.text;
      if (isThere) continue;
      EXPECT_TRUE(small.has("PROVED  never") && small.has("UNREACHABLE  comes")) << name << small.text;
      EXPECT_EQ(small.has(name + " never runs: a CPU 314 does not start it"), number != 20) << name << small.text;
    }
  }
  for (const int number : {17, 22, 30, 47}) {
    const std::string blocks = block(1, mainFor(number)) + block(number, mark);
    const Output large = proofOf(asked, blocks, {"--cpu", "417"});
    EXPECT_TRUE(large.has("VIOLATED  never") && large.has("runs: a CPU 417 starts it")) << number << large.text;
  }
  const Output asksFor = proofOf(asked, block(1, mainFor(21)) + block(21, mark), {"--cpu", "314"});
  EXPECT_TRUE(asksFor.has("NOT COVERED  never") && asksFor.has("a CPU 314 has no such block")) << asksFor.text;
}

// Where nobody names a CPU, a block that no S7-300 starts makes the program one of an S7-400; a named family stands.
TEST(StartedBlocks, DecideTheFamilyWhereNobodyDoes) {
  const test::TemporaryFolder folder;
  folder.file("a.awl", block(1, "NOP 0") + block(32, mark));
  folder.file("b.awl", block(1, "NOP 0"));
  folder.file("p.prop", asked);
  const auto prove = [&](const std::string& option, const std::string& value) {
    return run({"prove", folder.path("a.awl"), "--props", folder.path("p.prop"), option, value});
  };
  const Output open = prove("--dialect", "auto");
  EXPECT_TRUE(open.has("VIOLATED  never") && open.has("taken for a CPU 417") && open.has("CPU 417,")) << open.text;
  const Output named = prove("--dialect", "s7-300");
  EXPECT_TRUE(named.has("PROVED  never") && named.has("OB32 never runs: a CPU 319-3")) << named.text;
  const Output both =
      run({"equiv", folder.path("a.awl"), folder.path("b.awl"), "--observe", "M2.0", "--dialect", "auto"});
  EXPECT_TRUE(both.has("DIFFERENT") && both.has("CPU 417,") && !both.has("CPU 319-3,")) << both.text;
  const Output small = run({"equiv", folder.path("a.awl"), folder.path("b.awl"), "--observe", "M2.0", "--cpu", "314"});
  EXPECT_TRUE(small.has("EQUAL")) << small.text;
}

// sim: such an event is none of the CPU; a period that passes starts nothing. lint says that the block never runs, and
// nothing of what it would do.
TEST(StartedBlocks, AreNeitherRunNorAccused) {
  const test::TemporaryFolder folder;
  folder.file("a.awl", block(1, "A M 2.0;= Q 0.0") + block(32, mark) + block(41, "L 0;L MW 10;/I;T MW 12"));
  folder.file("in.csv", "scan,event\n1,41\n");
  const Output event = run({"sim", folder.path("a.awl"), "--stimulus", folder.path("in.csv"), "--cpu", "314"});
  EXPECT_EQ(event.exit, 2);
  EXPECT_TRUE(event.has("'41' is no interrupt event of CPU 314")) << event.text;
  const std::vector<std::string> scans = {"--scans", "60", "--scan-time", "100ms", "--cpu"};
  const std::string blocks = block(1, "NOP 0") + block(32, "L MW 12;L 1;+I;T MW 12");
  std::vector<std::string> on314 = scans, on417 = scans;
  on314.emplace_back("314");
  on417.emplace_back("417");
  EXPECT_TRUE(test7::lastRow(blocks, "MW12", on314).ends_with(",0")) << test7::lastRow(blocks, "MW12", on314);
  EXPECT_FALSE(test7::lastRow(blocks, "MW12", on417).ends_with(",0")) << test7::lastRow(blocks, "MW12", on417);
  const Output lint = run({"lint", "--prove", folder.path("a.awl"), "--cpu", "314"});
  EXPECT_TRUE(lint.has("nothing starts OB32: a CPU 314 has OB35 as its only cyclic interrupt")) << lint.text;
  EXPECT_TRUE(lint.has("nothing starts OB41")) << lint.text;
}

}  // namespace
}  // namespace rungproof
