// Data blocks that a program never opens cost a proof, lint --prove and equiv less than a tenth, however long they are:
// processor time of whole processes, one beside the other.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

constexpr int runs = 12;
constexpr double mostMore = 0.005;  ///< s, of scatter between two runs of the same proof

/// Processor seconds of `rungproof ARGUMENTS`.
double secondsOf(const std::vector<std::string>& arguments) {
  std::vector<const char*> words{"rungproof"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  words.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
    ::execv(RUNGPROOF_BINARY_DIR "/rungproof", const_cast<char* const*>(words.data()));
    ::_exit(127);
  }
  int status = 0;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) <= 1);  // some of its properties are meant to be violated
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// The corpus program NAME of the S7-300/400, alone and with a hundred blocks of 16 KB that it never opens.
void compareWithBlocks(const std::string& name, const std::vector<std::string>& command, bool isTwice) {
  std::ifstream stream(RUNGPROOF_SOURCE_DIR "/corpus/s7300/" + name, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  ASSERT_FALSE(text.view().empty());
  std::string blocks;
  for (int i = 1; i <= 100; ++i) {
    blocks += fmt::format(
        "DATA_BLOCK DB {}\nVERSION : 0.1\nSTRUCT\n  Recipe : ARRAY [1 .. 16384] OF BYTE ;\nEND_STRUCT ;\nBEGIN\n"
        "END_DATA_BLOCK\n",
        i);
  }
  const TemporaryFolder folder;
  const std::string alone = folder.file("alone.awl", text.str());
  const std::string with = folder.file("with.awl", blocks + text.str());
  const auto seconds = [&](const std::string& file) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), isTwice ? 2 : 1, file);
    return secondsOf(arguments);
  };
  double least = 1e9, leastWith = 1e9;
  for (int i = 0; i < runs; ++i) {
    least = std::min(least, seconds(alone));
    leastWith = std::min(leastWith, seconds(with));
  }
  std::printf("%.1f ms, with data blocks %.1f ms\n", least * 1000, leastWith * 1000);
  EXPECT_LT(leastWith, 1.1 * least + mostMore);
}

TEST(IdleBlocksPace, AHundredCostAProofLessThanATenth) {
  compareWithBlocks("star_delta.awl", {"prove", "--jobs", "1"}, false);
}
TEST(IdleBlocksPace, AHundredCostTheRulesLessThanATenth) {
  compareWithBlocks("notaus.awl", {"lint", "--prove"}, false);
}
TEST(IdleBlocksPace, AHundredCostAComparisonLessThanATenth) {
  compareWithBlocks("notaus.awl", {"equiv", "--jobs", "1"}, true);
}

}  // namespace
}  // namespace rungproof::test
