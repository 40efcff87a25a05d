// Recording and trying.
#include "tests/mutation/trial.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ir/check.hpp"

namespace rungproof::mutation {

namespace {

class Recorder final : public testing::EmptyTestEventListener {
 public:
  explicit Recorder(std::vector<std::string>& names) : names_(names) {}
  void OnTestStart(const testing::TestInfo& info) override {
    Mutation::instance().recordInto(static_cast<int>(names_.size()));
    names_.push_back(std::string(info.test_suite_name()) + "." + info.name());
  }
  void OnTestEnd(const testing::TestInfo&) override { Mutation::instance().recordInto(-1); }

 private:
  std::vector<std::string>& names_;
};

/// Tests that reach a common site are tried a few at a time; most mutants fall in the first few.
constexpr std::size_t atOnce = 8;

constexpr int silent = 0, noticed = 1, unchecked = 77;  // exit codes

bool someTestFails(const std::set<int>& tests, const std::vector<std::string>& names) {
  std::string filter;
  std::size_t count = 0;
  for (auto test = tests.begin(); test != tests.end();) {
    filter += names[static_cast<std::size_t>(*test)] + ":";
    ++test;
    if (++count % atOnce != 0 && test != tests.end()) continue;
    testing::GTEST_FLAG(filter) = filter;
    if (RUN_ALL_TESTS() != 0) return true;
    filter.clear();
  }
  return false;
}

}  // namespace

std::vector<std::string> recordTests() {
  std::vector<std::string> names;
  auto& listeners = testing::UnitTest::GetInstance()->listeners();
  auto* recorder = new Recorder(names);
  listeners.Append(recorder);
  const bool passed = RUN_ALL_TESTS() == 0;
  delete listeners.Release(recorder);
  if (!passed) names.clear();
  return names;
}

Verdict tryMutant(const Mutant& mutant, const std::set<int>& tests, const std::vector<std::string>& names) {
  std::fflush(stdout);
  const pid_t child = fork();
  CHECK(child >= 0, "fork");
  if (child == 0) {
    const rlimit seconds{2, 2}, noCore{0, 0};
    setrlimit(RLIMIT_CPU, &seconds);
    setrlimit(RLIMIT_CORE, &noCore);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    testing::GTEST_FLAG(fail_fast) = true;
    Mutation::instance().activate(mutant);
    const bool fails = someTestFails(tests, names);
    _exit(fails ? noticed : Mutation::instance().outcomeDiffers ? unchecked : silent);
  }
  int status = 0;
  CHECK(waitpid(child, &status, 0) == child, "waitpid");
  if (!WIFEXITED(status)) return Verdict::Noticed;
  return WEXITSTATUS(status) == silent      ? Verdict::Silent
         : WEXITSTATUS(status) == unchecked ? Verdict::Unchecked
                                            : Verdict::Noticed;
}

}  // namespace rungproof::mutation
