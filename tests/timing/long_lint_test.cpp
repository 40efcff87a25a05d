// Lint of very long programs as a process of its own: processor time at the pace of a quiet machine, and memory. And
// two files on two processors, with the report of one.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/bench/long_program.hpp"
#include "tests/machine_pace.hpp"
#include "tests/measured_process.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

std::vector<std::string> lintOf(const std::string& report, const std::vector<std::string>& more) {
  std::vector<std::string> command{
      RUNGPROOF_BINARY_DIR "/rungproof", "lint", "--isolated", "--quiet", "--format", "concise=" + report};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

std::string contentOf(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

constexpr double most = 60;  ///< s of processor time, so that a run that does not end is none

TEST(LongLint, AMillionInstructions) {
  constexpr double mostSeconds = 2.4;
  constexpr double mostMebibytes = 400;
  const test::TemporaryFolder folder;
  const std::string program = folder.file("long.awl", testing::longProgram(1'000'000));
  double seconds = 1e9, mebibytes = 0;
  for (int attempt = 0; attempt < 4 && seconds > mostSeconds; ++attempt) {
    const double before = test::machinePace();
    const test::ProcessRun run = test::runProcess(lintOf(folder.path("report"), {program}), most);
    ASSERT_FALSE(run.isCut) << run.output;
    seconds = std::min(seconds, run.seconds / ((before + test::machinePace()) / 2));
    mebibytes = static_cast<double>(run.peakBytes) / (1 << 20);
  }
  std::printf("%.2f s of %.1f s, %.0f MiB of %.0f MiB\n", seconds, mostSeconds, mebibytes, mostMebibytes);
  EXPECT_GT(contentOf(folder.path("report")).size(), 1'000'000u) << "the report of so long a program is long";
  EXPECT_LE(seconds, mostSeconds);
  EXPECT_LE(mebibytes, mostMebibytes);
}

TEST(LongLint, TwoFilesOnTwoProcessors) {
  const test::TemporaryFolder folder;
  const std::string a = folder.file("a.awl", testing::longProgram(150'000)),
                    b = folder.file("b.awl", testing::longProgram(140'000));
  const auto secondsOf = [&](const std::string& jobs) {
    const double begin = test::wallSeconds();
    test::runProcess(lintOf(folder.path("report" + jobs), {"--jobs", jobs, a, b}), most);
    return test::wallSeconds() - begin;
  };
  double one = 1e9, two = 1e9;
  for (int attempt = 0; attempt < 8; ++attempt) {
    one = std::min(one, secondsOf("1"));
    two = std::min(two, secondsOf("2"));
    if (attempt >= 1 && two <= 0.8 * one) break;
  }
  const std::string report = contentOf(folder.path("report1"));
  EXPECT_EQ(report, contentOf(folder.path("report2")));
  EXPECT_NE(report.find("a.awl"), std::string::npos);
  EXPECT_NE(report.find("b.awl"), std::string::npos);
  std::printf("%.2f s with one job, %.2f s with two\n", one, two);
  if (std::thread::hardware_concurrency() >= 2) {
    EXPECT_LE(two, 0.8 * one);
  }
}

}  // namespace
}  // namespace rungproof
