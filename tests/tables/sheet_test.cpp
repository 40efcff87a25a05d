// The sheet for the machine, of tables written by hand: waits of people, outputs that are not compared.
#include <gtest/gtest.h>

#include "frontend/input/project.hpp"
#include "frontend/testing/table_reader.hpp"
#include "frontend/testing/test_sheet.hpp"

namespace rungproof {
namespace {

/// The lines of the steps: "1 | action | wait | must be seen | ☐ | remark".
std::string sheetOf(const std::string& rows, std::vector<bool> countsScans = {}, double highMs = 100) {
  const Program program = readText("p.awl", "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n");
  std::vector<Failure> failures;
  TestSheet sheet;
  sheet.table =
      readTestTable("t.csv", "test,step,wait,set I0.0,expect Q0.0,expect Q0.1,note\n" + rows, program, 0, failures);
  EXPECT_TRUE(failures.empty());
  sheet.purposes.emplace_back("none");
  sheet.networks.emplace_back();
  if (!countsScans.empty()) sheet.countsScans.push_back(std::move(countsScans));
  sheet.highMs = highMs;
  sheet.lowMs = 1;
  return sheetMarkdown(sheet);
}
void expectLine(const std::string& sheet, const std::string& line) {
  EXPECT_NE(sheet.find("| " + line + " |"), std::string::npos) << line << "\n" << sheet;
}

// Eight scans of 100 ms take 0.8 s; of 300 ms 2.4 s.
TEST(Sheet, WaitsForTheLongestScans) {
  expectLine(sheetOf("t,on,8 scans,1,1,0,\n"), "1 | on | 0.8 s | Q0.0 on; all else off | ☐ | ");
  expectLine(sheetOf("t,on,8 scans,1,1,0,\n", {}, 300), "1 | on | 2.4 s | Q0.0 on; all else off | ☐ | ");
  expectLine(sheetOf("t,on,1 scan,1,1,0,\n"), "1 | on | at once | Q0.0 on; all else off | ☐ | ");
}

TEST(Sheet, NamesTheScansThatARowCounts) {
  expectLine(sheetOf("t,on,6 scans,1,1,0,\n", {true}),
             "1 | on | 6 scans: 0.006 s to 0.6 s, by their length | Q0.0 on; all else off | ☐ | ");
  expectLine(sheetOf("t,on,6 scans,1,1,0,\n", {true}, 1), "1 | on | 6 scans: 0.006 s | Q0.0 on; all else off | ☐ | ");
}

// Of an output that is not compared nothing is said, also not among all.
TEST(Sheet, SaysNothingOfWhatIsNotCompared) {
  const std::string sheet = sheetOf(
      "t,off,1 scan,0,0,,Q0.1 not compared\nt,wait,1 scan,,0,,Q0.1 not compared\nt,on,1 scan,1,1,,timing: late\n");
  expectLine(sheet, "1 | off | at once | all other outputs off | ☐ | Q0.1 not compared");
  expectLine(sheet, "2 | wait | at once | no other output changes | ☐ | Q0.1 not compared");
  expectLine(sheet, "3 | on | at once | Q0.0 on; not compared: Q0.1 | ☐ | timing: late");
  const std::string all = sheetOf("t,off,1 scan,0,0,0,\nt,wait,1 scan,,0,0,\n");
  expectLine(all, "1 | off | at once | all outputs off | ☐ | ");
  expectLine(all, "2 | wait | at once | nothing changes | ☐ | ");
}

}  // namespace
}  // namespace rungproof
