// The solver rules on the corpus: what they find on programs that are meant to be right, each with the reason why the
// finding is right nevertheless; everything else must be silent. Programs whose encoding takes long are left out.
#include <set>

#include "analysis/unread/unread_code.hpp"
#include "frontend/linting/solver_rules.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;
using RuleAddresses = std::multiset<std::string>;

/// Rule and address, by file name.
const std::map<std::string, RuleAddresses>& explainedFindings() {
  static const std::map<std::string, RuleAddresses> table{
      // Held hands count only from the moment at which both were off, which M0.0 remembers: pressed in the window while
      // the stop is active, they start the stroke when it is released.
      {"press_two_hand.awl", {"SAF006 Q0.0"}},
      // The level keeps the demand while the motor protection has tripped.
      {"pump_alternation.awl", {"SAF006 Q0.1"}},
      // The place in the row of valves is in V memory, which is retentive; the fan's contact lets the row go on.
      {"bag_filter.awl",
       {"SAF005 Q0.0", "SAF005 Q0.1", "SAF005 Q0.2", "SAF005 Q0.3", "SAF006 Q0.0", "SAF006 Q0.1", "SAF006 Q0.2",
        "SAF006 Q0.3"}},
      // The start command is remembered in front of the motor protection of each belt.
      {"conveyor.awl", {"SAF004 ", "SAF006 Q0.1", "SAF006 Q0.2"}},
      // Declared the wrong way round on purpose: the level closes the valve one scan later.
      {"filling.awl", {"SAF004 "}},
      // The stop only interrupts the step, whose bit stays.
      {"filling_same_scan.awl", {"SAF006 Q0.3"}},
      {"reversing_faulty.awl", {"SAF003 ", "SAF004 "}},
      // Variables of IEC 61131-3 without RETAIN are not kept while the power is off: no row for plcopen/. Data blocks
      // are.
      {"parcel_counter.xml", {"SAF005 Q0.0", "SAF005 Q0.1"}},
      // SimaticML is of an S7-300/400, which keeps data blocks and M0 to M15 while the power is off: running timers,
      // edges and faults. Q0.1 and Q0.3 of the valves are one finding.
      {"gate.xml", {"SAF005 Q0.1"}},
      {"simaticml/reversing.xml", {"SAF005 Q0.0", "SAF005 Q0.1"}},
      {"tank_pump.xml", {"SAF005 Q0.0", "SAF005 Q0.1"}},
      {"two_valves.xml", {"SAF005 Q0.1", "SAF005 Q0.2"}},
  };
  return table;
}

std::vector<fs::path> quickPrograms() {
  std::vector<fs::path> files;
  for (const char* folder : {"interlocks", "sequences", "plcopen", "simaticml"}) {
    for (const fs::path& file : corpusFiles(folder)) {
      if (file.stem() != "faulty_drawing") files.push_back(file);
    }
  }
  return files;
}

class CorpusRules : public testing::TestWithParam<fs::path> {};

TEST_P(CorpusRules, FindWhatIsExplained) {
  ProgramInput input = corpusInput(GetParam());
  // Properties that are no rule of their own are the business of tests/corpus.
  std::erase_if(input.properties.properties,
                [](const Property& p) { return p.isGoal() && ruleOfViolation(p)->id == "SAF001"; });
  ProverOptions options = proverOptions(GetParam());
  options.timeout = 10;
  std::vector<Finding> findings;
  const UnreadCode unread(input.program);
  options.unread = &unread;
  settleBySolver(
      {unread.executable(), input.properties}, options,
      [](std::string_view rule) { return rule != "SAF001" && rule != "OUT003"; }, findings);
  RuleAddresses found;
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::Note) found.insert(finding.rule + " " + finding.address);
  }
  // A name that stands in two folders is given with its folder.
  auto row = explainedFindings().find((GetParam().parent_path().filename() / GetParam().filename()).string());
  if (row == explainedFindings().end()) row = explainedFindings().find(GetParam().filename().string());
  EXPECT_EQ(found, row == explainedFindings().end() ? RuleAddresses{} : row->second);
}

INSTANTIATE_TEST_SUITE_P(Programs, CorpusRules, testing::ValuesIn(quickPrograms()),
                         [](const auto& info) { return testNameOf(info.param); });

}  // namespace
}  // namespace rungproof::test
