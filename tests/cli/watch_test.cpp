// --watch: a second run after a change, of the program, its properties or its configuration; the end and its exit code.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "frontend/cli/cli.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

using namespace std::chrono_literals;

/// The program as a child that writes its output into files.
class WatchedProgram {
 public:
  WatchedProgram(const TemporaryFolder& folder, const std::vector<std::string>& arguments)
      : out_(folder.path("out.log")), err_(folder.path("err.log")) {
    std::ofstream(out_).close();
    std::ofstream(err_).close();
    child_ = ::fork();
    if (child_ != 0) return;
    int exit = 0;
    {
      std::ofstream out(out_), err(err_);
      std::istringstream in;
      exit = runProgram(arguments, {in, out, err});
    }
    ::_exit(exit);
  }
  ~WatchedProgram() {
    if (child_ > 0) end(SIGKILL);
  }
  WatchedProgram(const WatchedProgram&) = delete;
  WatchedProgram& operator=(const WatchedProgram&) = delete;

  /// Whether the text stands in the output so many times within half a minute.
  bool shows(const std::string& text, int times, bool inErrors = false) const {
    for (int i = 0; i < 600; ++i) {
      int count = 0;
      const std::string all = contentNow(inErrors ? err_ : out_);
      for (std::size_t at = all.find(text); at != std::string::npos; at = all.find(text, at + 1)) ++count;
      if (count >= times) return true;
      std::this_thread::sleep_for(50ms);
    }
    return false;
  }
  /// How often the text stands among the errors now.
  int countOf(const std::string& text) const {
    int count = 0;
    const std::string all = contentNow(err_);
    for (std::size_t at = all.find(text); at != std::string::npos; at = all.find(text, at + 1)) ++count;
    return count;
  }
  bool waits(int runs) const { return shows("rungproof: watching", runs, true); }
  int end(int signal) {
    ::kill(child_, signal);
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  static std::string contentNow(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  std::string out_, err_;
  pid_t child_ = -1;
};

const std::string good = "Network 1\nLD I0.0\n= Q0.0\n";
const std::string bad = "Network 1\nLD SM0.0\nMOVW 1, VW20000\n";  // a word that the CPU 226 lacks (001:2697)

TEST(Watch, ASecondRunAfterAChangeOfTheProgram) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", good);
  WatchedProgram program(folder, {"lint", "--watch", file});
  ASSERT_TRUE(program.waits(1));
  EXPECT_TRUE(program.shows("no findings", 1));
  folder.file("p.awl", bad);
  EXPECT_TRUE(program.shows("ADR001", 1));
  ASSERT_TRUE(program.waits(2));
  EXPECT_TRUE(program.shows("p.awl has changed", 1, true));
  EXPECT_EQ(program.end(SIGTERM), 1);  // the last run has a finding
}

TEST(Watch, EditorsPutANewFileInTheOldOnesPlace) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", bad);
  WatchedProgram program(folder, {"lint", file, "--watch"});
  ASSERT_TRUE(program.waits(1));
  std::filesystem::rename(folder.file("p.awl~", good), file);
  ASSERT_TRUE(program.waits(2));
  EXPECT_TRUE(program.shows("no findings", 1));
  EXPECT_EQ(program.end(SIGINT), 0);
}

TEST(Watch, AChangeOfTheConfigurationCountsAlsoIfThereWasNone) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", bad);
  WatchedProgram program(folder, {"lint", file, "--watch"});
  ASSERT_TRUE(program.waits(1));
  folder.file("rungproof.toml", "ignore = [\"ADR001\"]\n");
  ASSERT_TRUE(program.waits(2));
  EXPECT_TRUE(program.shows("no findings", 1));
  folder.file("rungproof.toml", "nonsense = 1\n");
  ASSERT_TRUE(program.waits(3));
  EXPECT_EQ(program.end(SIGTERM), 2);
}

TEST(Watch, PropertyFilesAreWatchedByProve) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", good), properties = folder.file("p.prop", "reach on: Q0.0\n");
  WatchedProgram program(folder, {"prove", file, "--props", properties, "--watch"});
  ASSERT_TRUE(program.waits(1));
  EXPECT_TRUE(program.shows("REACHABLE", 1));
  folder.file("p.prop", "prove off: never Q0.0\n");
  ASSERT_TRUE(program.waits(2));
  EXPECT_TRUE(program.shows("VIOLATED", 1));
  EXPECT_EQ(program.end(SIGTERM), 1);
}

TEST(Watch, AFileThatIsMissingIsWaitedFor) {
  const TemporaryFolder folder;
  WatchedProgram program(folder, {"check", folder.path("late.awl"), "--watch"});
  ASSERT_TRUE(program.waits(1));
  folder.file("late.awl", good);
  ASSERT_TRUE(program.waits(2));
  EXPECT_TRUE(program.shows("1 network: 1 valid", 1));
  EXPECT_EQ(program.end(SIGTERM), 0);
}

TEST(Watch, OtherFilesOfTheFolderDoNotMatter) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", good);
  WatchedProgram program(folder, {"lint", file, "--watch"});
  ASSERT_TRUE(program.waits(1));
  folder.file("notes.txt", "nothing");
  std::this_thread::sleep_for(300ms);
  folder.file("p.awl", bad);
  ASSERT_TRUE(program.waits(2));
  EXPECT_EQ(program.countOf("has changed"), 1);  // that of the program
  EXPECT_EQ(program.end(SIGTERM), 1);
}

TEST(Watch, StandardInputCannotBeWatched) {
  std::istringstream in(good);
  std::ostringstream out, err;
  EXPECT_EQ(runProgram({"lint", "-", "--watch"}, {in, out, err}), 2);
  EXPECT_NE(err.str().find("standard input cannot be watched"), std::string::npos);
}

}  // namespace
}  // namespace rungproof::test
