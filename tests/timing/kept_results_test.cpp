// A second run over programs that have not changed: its results come from the cache, as a whole process by the wall.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "tests/corpus/corpus_program.hpp"
#include "tests/machine_pace.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

constexpr double mostForKeptResults = 0.2;  ///< s, for the timers of the corpus; all of the corpus may take 1 s

TEST(KeptResults, ASecondRunProvesNothing) {
  const TemporaryFolder folder;
  const std::string cache = folder.path("kept"), state = folder.path("state");
  std::vector<std::string> arguments = {"rungproof", "prove", "--isolated", "--quiet", "--cache", cache};
  for (const std::filesystem::path& file : corpusFiles("timers")) arguments.push_back(file.string());
  const auto prove = [&] {
    const pid_t child = ::fork();
    if (child == 0) {
      ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO);
      ::setenv("XDG_STATE_HOME", state.c_str(), 1);
      std::vector<char*> argv;
      for (std::string& argument : arguments) argv.push_back(argument.data());
      argv.push_back(nullptr);
      ::execv(RUNGPROOF_BINARY_DIR "/rungproof", argv.data());
      ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) <= 1) << WEXITSTATUS(status);
  };
  prove();
  ASSERT_TRUE(std::filesystem::exists(cache));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(cache), {}), 1);
  const double seconds = quietSeconds(prove, mostForKeptResults, 5, wallSeconds);
  std::printf("%.3f s of %.1f s\n", seconds, mostForKeptResults);
  EXPECT_LE(seconds, mostForKeptResults);
}

}  // namespace
}  // namespace rungproof::test
