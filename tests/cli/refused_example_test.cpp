// What lint refuses no other command executes: the bad example of every rule that refuses goes through sim, prove,
// export and equiv. A rule of severity error says whether the editor and the CPU take such a program: it refuses, or
// it stands in the list below.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/rule.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using test::ProgramRun;
using test::run;
using test::TemporaryFolder;

class RefusedExample : public ::testing::TestWithParam<const Rule*> {};

TEST_P(RefusedExample, IsExecutedByNoCommand) {
  const Rule& rule = *GetParam();
  const TemporaryFolder folder;
  const std::string file = folder.file("a.awl", std::string(rule.bad));
  std::vector<std::string> files = {file};
  if (!rule.exampleSymbols.empty()) files.push_back(folder.file("symbols.csv", std::string(rule.exampleSymbols)));
  const std::vector<std::string> cpu = {"--cpu", std::string(rule.exampleCpu)};
  const auto exitOf = [&](std::vector<std::string> line, bool isPair = false) {
    line.insert(line.end(), files.begin(), isPair ? files.begin() + 1 : files.end());
    if (isPair) line.push_back(file);
    line.insert(line.end(), cpu.begin(), cpu.end());
    const ProgramRun result = run(line);
    if (result.exit != 2) ADD_FAILURE() << line.front() << ": exit " << result.exit << '\n' << result.out << result.err;
    return result;
  };
  exitOf({"sim", "--scans", "1"});
  const ProgramRun proof = exitOf({"prove", "--builtin"});
  EXPECT_NE((proof.out + proof.err).find("is not executed"), std::string::npos) << proof.out << proof.err;
  exitOf({"export", "--builtin", "--format", "btor2"});
  exitOf({"equiv"}, true);
}

std::vector<const Rule*> refusingRules() {
  std::vector<const Rule*> rules;
  std::ranges::copy_if(allRules(), std::back_inserter(rules), [](const Rule* rule) {
    const bool takesExample = rule->id == "SCR001";  // its step without an exit is taken by the CPU
    return rule->refuses && rule->severity == Severity::Error && !takesExample;
  });
  return rules;
}

INSTANTIATE_TEST_SUITE_P(Rules, RefusedExample, ::testing::ValuesIn(refusingRules()),
                         [](const auto& info) { return std::string(info.param->id); });

/// Errors of programs that the editor and the CPU take: they stop a running CPU or do what nobody means, so that the
/// other commands run them and show it.
constexpr std::string_view executed[] = {
    "PRT001", "STK001", "ARI003", "CTL009", "DBA002", "DBA006", "HSP001", "HSP005",
    "LIB003", "NST001", "OBL002", "PTR001", "PTR004", "SAF001", "IEC011", "SAF002",
    "SAF003", "SAF004", "SCR002", "SUB002", "SUB006", "TIM001", "TIM002",
};

TEST(ErrorRules, SayWhetherTheProgramIsExecuted) {
  for (const Rule* rule : allRules()) {
    if (rule->severity != Severity::Error || rule->check == nullptr) continue;
    EXPECT_NE(rule->refuses, std::ranges::find(executed, rule->id) != std::end(executed)) << rule->id;
  }
}

TEST(RefusedBoxes, TooFewInputsAreRefusedAndTooManyAreNot) {
  const TemporaryFolder folder;
  for (const char* box : {"CTD C1, 5", "CTU C1, 5", "SR M0.0, Q0.0", "RS M0.0, Q0.0"}) {
    const std::string text = test::mainBlock(std::string("Network 1\nLD I0.0\n") + box + "\n");
    EXPECT_EQ(run({"sim", "--scans", "1", folder.file("a.awl", text)}).exit, 2) << box;
  }
  const std::string shortBy2 = test::mainBlock("Network 1\nLD I0.0\nCTUD C1, 5\n");
  EXPECT_EQ(run({"sim", "--scans", "1", folder.file("a.awl", shortBy2)}).exit, 2);
  const std::string tooMany = test::mainBlock("Network 1\nLD I0.0\nLD I0.1\nLD I0.2\nCTU C1, 5\n");
  EXPECT_EQ(run({"sim", "--scans", "1", folder.file("a.awl", tooMany)}).exit, 0);
}

}  // namespace
}  // namespace rungproof
