// A statement of the property language that cannot be read may be an assumption or name what is written from outside:
// nothing is settled beside it, in every format (contract, section 2: the verdict is NOT COVERED).
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using test::ProgramRun;
using test::run;
using test::TemporaryFolder;

// Q0.0 follows VB0, which only a panel could write: with `external` it comes on, without it never does.
const std::string drivenByV = test::mainBlock("Network 1\nLD V0.0\n= Q0.0\n");

struct Unread {
  const char* name;
  const char* line;
};

class UnreadStatement : public ::testing::TestWithParam<Unread> {};

TEST_P(UnreadStatement, LeavesEveryVerdictOpen) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.awl", drivenByV);
  const std::string props = folder.file("a.prop", std::string(GetParam().line) + "\nprove off: never Q0.0\n");
  const ProgramRun json = run({"prove", file, "--props", props, "--builtin", "--format", "json"});
  EXPECT_EQ(json.exit, 2) << json.out;
  const nlohmann::json report = nlohmann::json::parse(json.out);
  ASSERT_FALSE(report["properties"].empty());
  for (const nlohmann::json& property : report["properties"]) EXPECT_EQ(property["verdict"], "NOT COVERED") << property;
  EXPECT_EQ(report["summary"]["proved"], 0);
  const ProgramRun junit = run({"prove", file, "--props", props, "--format", "junit"});
  EXPECT_EQ(junit.exit, 2);
  EXPECT_NE(junit.out.find("<skipped message=\"NOT COVERED\""), std::string::npos) << junit.out;
  const ProgramRun human = run({"prove", file, "--props", props});
  EXPECT_EQ(human.out.find("PROVED "), std::string::npos) << human.out;
  EXPECT_NE(human.out.find("could not be read"), std::string::npos) << human.out;
}

const Unread unreadStatements[] = {
    {"Assumption", "assume guard: I0.0 andd I0.1"},
    {"AssumptionOfNobody", "assume guard: Nobody"},
    {"AssumptionTwice", "prove same: not Q0.7\nassume same: I0.0"},
    {"External", "external VB0..Q"},
    {"Misspelt", "externl VB0..VB9"},
    {"Initial", "initial retentiv"},
    {"Pulse", "pulse I0.0 at most every"},
    {"Unknown", "!"},
};
INSTANTIATE_TEST_SUITE_P(Statements, UnreadStatement, ::testing::ValuesIn(unreadStatements),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(UnreadStatements, StandInCommentsAsWell) {
  const TemporaryFolder folder;
  const std::string text =
      test::mainBlock("//@ externl VB0..VB9\n//@ prove off: never Q0.0\nNetwork 1\nLD V0.0\n= Q0.0\n");
  const ProgramRun result = run({"prove", folder.file("a.awl", text)});
  EXPECT_EQ(result.exit, 2);
  EXPECT_NE(result.out.find("NOT COVERED  off"), std::string::npos) << result.out;
}

TEST(UnreadStatements, AFileThatIsMissingMayHoldAssumptions) {
  const TemporaryFolder folder;
  const ProgramRun result =
      run({"prove", folder.file("a.awl", drivenByV), "--props", folder.file("a.prop", "prove off: never Q0.0\n"),
           "--props", folder.path("nowhere.prop")});
  EXPECT_EQ(result.exit, 2);
  EXPECT_NE(result.out.find("NOT COVERED  off"), std::string::npos) << result.out;
}

/// A question that cannot be read changes no run: the others keep their verdicts, and the exit code tells of it.
TEST(UnreadStatements, AQuestionLeavesTheOthers) {
  const TemporaryFolder folder;
  const std::string props =
      folder.file("a.prop", "prove wrong: never Q0.9\nreach wrong too: Nobody\nprove off: never Q0.0\n");
  const ProgramRun result =
      run({"prove", folder.file("a.awl", test::mainBlock("Network 1\nLD I0.0\nAN I0.0\n= Q0.0\n")), "--props", props});
  EXPECT_EQ(result.exit, 2);
  EXPECT_NE(result.out.find("PROVED  off"), std::string::npos) << result.out;
}

TEST(UnreadStatements, AreNoFaultOfTheProgram) {
  const TemporaryFolder folder;
  const ProgramRun result =
      run({"prove", folder.file("a.awl", drivenByV), "--props", folder.file("a.prop", "provee off: Q0.0\n")});
  EXPECT_EQ(result.exit, 2);
  EXPECT_EQ(result.err.find("declared in"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("no property could be read"), std::string::npos) << result.err;
  EXPECT_EQ((result.out + result.err).find("program is refused"), std::string::npos) << result.out << result.err;
}

/// `diff` compares without the assumption, and says so.
TEST(UnreadStatements, AreSaidByDiff) {
  const TemporaryFolder folder;
  const std::string wrong = "//@ assume I0.0 never both I0.1\n";
  const ProgramRun result =
      run({"diff", folder.file("old.awl", test::mainBlock(wrong + "Network 1\nLD I0.0\n= Q0.0\n")),
           folder.file("new.awl", test::mainBlock("Network 1\nLD I0.0\nA I0.1\n= Q0.0\n"))});
  EXPECT_EQ(result.exit, 2) << result.out << result.err;
  EXPECT_NE(result.err.find("'assume I0.0 never both I0.1'"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("is not assumed"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("can differ: Q0.0"), std::string::npos) << result.out;
}

/// `lint --diff` says what it could not look at; a safe fix beside it is shown all the same.
TEST(UnreadNetworks, AreNoSuccessOfLintDiff) {
  const TemporaryFolder folder;
  const ProgramRun network = run({"lint", "--diff", folder.file("a.awl", test::mainBlock("Network 1\nFROB Q0.0\n"))});
  EXPECT_EQ(network.exit, 2) << network.out << network.err;
  EXPECT_NE(network.err.find("a.awl:4"), std::string::npos) << network.err;
  EXPECT_EQ(run({"lint", "--diff", folder.file("b.awl", test::mainBlock("Network 1\nFROB Q0.0\n"))}).exit, 2);
  EXPECT_EQ(
      run({"lint", "--diff", folder.file("c.awl", test::mainBlock("//@ externl VB0\nNetwork 1\nLD I0.0\n= Q0.0\n"))})
          .exit,
      2);
  EXPECT_EQ(run({"lint", "--diff", folder.file("d.awl", test::mainBlock("Network 1\nLD I0.0\n= Q0.0\n"))}).exit, 0);
}

}  // namespace
}  // namespace rungproof
