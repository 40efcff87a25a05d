// The main function of the timing tests: a test that fails is run again, alone, and its limit is exceeded if all three
// runs say so. Other work on the machine can only make a run slower, never faster, and what it does to one test of
// a hundred says nothing about the program.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

constexpr int mostRuns = 3;
constexpr const char* runVariable = "RUNGPROOF_TIMING_RUN";

/// The failed tests as a filter, empty if all passed.
std::string failedTests() {
  std::string filter;
  const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const ::testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const ::testing::TestInfo& test = *suite.GetTestInfo(t);
      if (!test.result()->Failed()) continue;
      filter += (filter.empty() ? "" : ":") + std::string(suite.name()) + "." + test.name();
    }
  }
  return filter;
}

}  // namespace

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const int outcome = RUN_ALL_TESTS();
  const std::string failed = failedTests();
  const char* run = std::getenv(runVariable);
  const int next = (run == nullptr ? 1 : std::atoi(run)) + 1;
  if (failed.empty() || next > mostRuns) return outcome;
  std::printf("run %d of the failed ones\n", next);
  std::fflush(stdout);
  ::setenv(runVariable, std::to_string(next).c_str(), 1);
  const std::string filter = "--gtest_filter=" + failed;
  ::execl("/proc/self/exe", argv[0], filter.c_str(), static_cast<char*>(nullptr));
  std::perror("execl");
  return outcome;
}
