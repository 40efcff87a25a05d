// What everybody waits for who runs the program on save: its start, and the findings of 2,000 instructions, as whole
// processes by the clock on the wall. Most of a start is the system's: it loads libraries and maps pages, which takes
// several times as long on one machine as on another whose processor is as fast. So the fixed work beside a start is
// the start of a process that does nothing.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/machine_pace.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/timing/two_thousand.hpp"

namespace rungproof::test {
namespace {

constexpr double mostForStart = 0.005, mostForLint = 0.030;  ///< s, on a quiet machine
constexpr double quietStart = 0.0008;                        ///< s, /bin/true on that machine
constexpr int mostStarts = 20;

/// Runs `program` to its end, its output thrown away.
void runProcess(const char* program, const std::vector<std::string>& arguments) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::array<char*, 4> argv = {const_cast<char*>("rungproof"), nullptr, nullptr, nullptr};
    for (std::size_t i = 0; i < arguments.size(); ++i) argv[i + 1] = const_cast<char*>(arguments[i].c_str());
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
    ::execv(program, argv.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) <= 1);
}

constexpr const char* executable = RUNGPROOF_BINARY_DIR "/rungproof";

/// The least of the wall-clock seconds that runs of `program` take.
double leastSeconds(const char* program, const std::vector<std::string>& arguments) {
  double least = 1e9;
  for (int i = 0; i < mostStarts; ++i) {
    const double begin = wallSeconds();
    runProcess(program, arguments);
    least = std::min(least, wallSeconds() - begin);
  }
  return least;
}

TEST(StartUp, TheVersionIsToldAtOnce) {
  const double pace = std::max(1.0, leastSeconds("/bin/true", {}) / quietStart);
  const double seconds = leastSeconds(executable, {"--version"}) / pace;
  std::printf("%.1f ms of %.0f ms\n", seconds * 1000, mostForStart * 1000);
  EXPECT_LE(seconds, mostForStart);
}

TEST(StartUp, TwoThousandInstructionsAreCheckedOnSave) {
  const TemporaryFolder folder;
  const std::string file = folder.file("long.awl", twoThousandInstructions());
  const double seconds = quietSeconds(
      [&] {
        runProcess(executable, {"lint", file});
      },
      mostForLint, mostStarts, wallSeconds);
  std::printf("%.1f ms of %.0f ms\n", seconds * 1000, mostForLint * 1000);
  EXPECT_LE(seconds, mostForLint);
}

}  // namespace
}  // namespace rungproof::test
