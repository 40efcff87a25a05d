// Which rules a run selects and whether they can look: where none does, or a code of --select reaches none, nothing was
// checked, and the exit code says so (contract, section 1).
#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using test::mainBlock;
using test::ProgramRun;
using test::run;
using test::TemporaryFolder;

class RuleScope : public testing::Test {
 protected:
  ProgramRun lint(std::vector<std::string> options) const {
    options.insert(options.begin(), {"lint", "--isolated"});
    options.push_back(program_);
    return run(options);
  }
  TemporaryFolder folder_;
  std::string program_ = folder_.file("a.awl", mainBlock("Network 1\nLD I0.0\n= Q0.0\n"));
};

TEST_F(RuleScope, NoRuleIsLeft) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--ignore", "ALL"}, {"--select", "ADR", "--ignore", "ADR"}}) {
    const ProgramRun result = lint(options);
    EXPECT_EQ(result.exit, 2) << result.out;
    EXPECT_TRUE(result.says("no rule is left to look at the program")) << result.err;
    EXPECT_TRUE(result.says("exit 2: nothing was checked")) << result.out;
  }
  EXPECT_EQ(lint({"--select", "ADR,OUT", "--ignore", "ADR"}).exit, 0);  // one is left, and the other was not wanted
  EXPECT_EQ(lint({"--select", "ADR", "--ignore", "ALL"}).exit, 0);      // the longer code decides
  EXPECT_EQ(lint({"--ignore", "ALL", "--diff"}).exit, 2);
}

// Rules of IEC 61131-3 and of S5 timers know nothing of an S7-200.
TEST_F(RuleScope, RulesOfOtherFamilies) {
  for (const char* code : {"IEC", "S5T", "ADR,IEC", "iec001"}) {
    const ProgramRun result = lint({"--select", code});
    EXPECT_EQ(result.exit, 2) << code << result.out;
    EXPECT_TRUE(result.says("are for other programs than those of the")) << code << result.err;
  }
  const std::string text = folder_.file("i.st", "PROGRAM p VAR a AT %QX0.0 : BOOL; END_VAR a := TRUE; END_PROGRAM\n");
  EXPECT_NE(run({"lint", "--isolated", "--select", "IEC002", text}).exit, 2);
  // Of two programs one is enough.
  EXPECT_NE(lint({"--select", "IEC002", text}).exit, 2);
}

TEST_F(RuleScope, RulesOfTheProver) {
  for (const char* code : {"SAF", "SAF001", "SAF002", "SAF003", "SAF004", "TIM008", "OUT003"}) {
    const ProgramRun result = lint({"--select", code});
    EXPECT_EQ(result.exit, 2) << code << result.out;
    EXPECT_TRUE(result.says("need the prover")) << code << result.err;
    EXPECT_NE(lint({"--prove", "--select", code}).exit, 2) << code;
  }
}

// An empty baseline would say that there is nothing to find.
TEST_F(RuleScope, NoBaselineOfNothing) {
  const std::string file = folder_.path("known.json");
  EXPECT_EQ(run({"baseline", "--isolated", "--ignore", "ALL", program_, "-o", file}).exit, 2);
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace rungproof
