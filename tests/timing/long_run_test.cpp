// A long run with a trace: the rows go to the file while the run goes on, so that memory does not grow with it.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "tests/machine_pace.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

constexpr const char* scans = "1000000";
constexpr rlim_t mostBytes = 50'000'000;  ///< of data, as the system counts and limits them
constexpr double mostForTheRun = 2.3;     ///< by the wall; it was 5.1 with all rows kept and every tick taken

TEST(LongRun, AMillionScansWithATraceStayBelowFiftyMegabytes) {
  const TemporaryFolder folder;
  const std::string program = RUNGPROOF_SOURCE_DIR "/corpus/interlocks/press_two_hand.awl",
                    trace = folder.path("run.csv");
  const double seconds = quietSeconds(
      [&] {
        const pid_t child = ::fork();
        if (child == 0) {
          const rlimit limit{mostBytes, mostBytes};
          ::setrlimit(RLIMIT_DATA, &limit);
          ::execl(RUNGPROOF_BINARY_DIR "/rungproof", "rungproof", "sim", program.c_str(), "--scans", scans, "--trace",
                  trace.c_str(), "--quiet", "--isolated", static_cast<char*>(nullptr));
          ::_exit(127);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
      },
      mostForTheRun, 3, wallSeconds);
  std::printf("%.2f s of %.1f s\n", seconds, mostForTheRun);
  EXPECT_GT(std::filesystem::file_size(trace), 30'000'000U);
  EXPECT_LE(seconds, mostForTheRun);
}

}  // namespace
}  // namespace rungproof::test
