// The GitHub Action, step by step, in a workspace of its own: what it names, what it runs, with what it ends.
#include <gtest/gtest.h>

#include "tests/ci/action_runner.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

class ActionTest : public testing::Test {
 protected:
  /// A checkout of the action with a program that is built, and a workspace beside it. `.ci/install` only says that it
  /// was called: packages are the machine's.
  ActionTest() {
    sources_ = folder_.path("actions/checkout");
    for (const char* part : {"ir", "engine", "analysis", "build/release"})
      fs::create_directories(fs::path(sources_) / part);
    folder_.file("actions/checkout/ir/a.hpp", "// of the key\n");
    folder_.file("actions/checkout/CMakeLists.txt", "\n");
    folder_.file("actions/checkout/CMakePresets.json", "{}\n");
    folder_.file("actions/checkout/.ci/install", "echo packages are installed\n");
    folder_.file("actions/checkout/frontend/ci/action.yml", yaml_);
    fs::create_symlink(RUNGPROOF_EXECUTABLE, fs::path(sources_) / "build/release/rungproof");
    fs::create_directories(folder_.path("workspace"));
  }
  ActionRun runWith(const std::map<std::string, std::string>& inputs) {
    return runAction(actionOf(yaml_), inputs, sources_ + "/frontend/ci", folder_.path("workspace"));
  }
  void program(const std::string& name, const std::string& networks) {
    folder_.file("workspace/" + name, mainBlock(networks));
  }
  std::string content(const std::string& name) { return contentOf(folder_.path("workspace/" + name)); }

  const std::string yaml_ = contentOf(RUNGPROOF_SOURCE_DIR "/frontend/ci/action.yml");
  TemporaryFolder folder_;
  std::string sources_;
};

const std::string good = "Network 1\nLD I0.0\nAN I0.1\n= Q0.0\n";
const std::string twoCoils = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.0\n";

TEST_F(ActionTest, LintsAndEndsWithTheExitCode) {
  program("good.awl", good);
  const ActionRun run = runWith({{"files", "good.awl"}});
  EXPECT_EQ(run.exit, 0) << run.failedStep << "\n" << run.log;
  EXPECT_EQ(run.outputs.at("exit-code"), "0");
  EXPECT_NE(run.log.find("packages are installed"), std::string::npos);
  EXPECT_NE(content("rungproof.sarif").find("\"version\": \"2.1.0\""), std::string::npos);

  program("bad.awl", twoCoils);
  const ActionRun found = runWith({{"files", "bad.awl"}});
  EXPECT_EQ(found.exit, 1) << found.log;
  EXPECT_EQ(found.failedStep, "Exit code") << "what was found is written before the job fails";
  EXPECT_NE(found.log.find("::warning file=bad.awl,line=8"), std::string::npos) << found.log;
  EXPECT_NE(content("rungproof.sarif").find("OUT001"), std::string::npos);
}

TEST_F(ActionTest, ProvesWithFurtherArgumentsAndReports) {
  program("press.awl", "//@ prove stop: never Q0.0 and I0.1\n" + good);
  const ActionRun run = runWith({{"command", "prove"},
                                 {"files", "press.awl"},
                                 {"arguments", "--timeout 20s --seed 3"},
                                 {"sarif", ""},
                                 {"junit", "proofs.xml"}});
  EXPECT_EQ(run.exit, 0) << run.failedStep << "\n" << run.log;
  EXPECT_NE(content("proofs.xml").find("<testcase"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_.path("workspace/rungproof.sarif")));
}

TEST_F(ActionTest, PatternsAreExpandedAndMissingFilesAreTwo) {
  program("one.awl", good);
  program("two.awl", good);
  EXPECT_EQ(runWith({{"files", "*.awl"}}).exit, 0);
  const ActionRun run = runWith({{"files", "nowhere.awl"}});
  EXPECT_EQ(run.exit, 2) << run.log;
  EXPECT_EQ(run.outputs.at("exit-code"), "2");
}

// The cache is found again by the same sources and by no others; path and key name nothing outside the checkout.
TEST_F(ActionTest, TheCacheFollowsTheSources) {
  program("good.awl", good);
  const ActionRun first = runWith({{"files", "good.awl"}});
  const ActionRun again = runWith({{"files", "good.awl"}});
  ASSERT_EQ(first.used.size(), 1U) << "no upload unless it is asked for";
  EXPECT_EQ(first.used, again.used);
  EXPECT_EQ(first.used[0].find(".."), std::string::npos) << first.used[0];
  EXPECT_NE(first.used[0].find("path=" + sources_ + "/build/release/rungproof"), std::string::npos) << first.used[0];
  folder_.file("actions/checkout/ir/a.hpp", "// another text\n");
  EXPECT_NE(runWith({{"files", "good.awl"}}).used, first.used);
}

TEST_F(ActionTest, UploadsWhatWasFoundWhenAsked) {
  program("bad.awl", twoCoils);
  const ActionRun run = runWith({{"files", "bad.awl"}, {"upload", "true"}});
  ASSERT_EQ(run.used.size(), 2U);
  EXPECT_EQ(run.used[1], "github/codeql-action/upload-sarif@v3 sarif_file=rungproof.sarif");
  EXPECT_EQ(run.exit, 1);
}

}  // namespace
}  // namespace rungproof::test
