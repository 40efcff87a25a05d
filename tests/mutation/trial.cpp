// Recording and trying.
#include "tests/mutation/trial.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <thread>

#include "ir/check.hpp"
#include "tests/machine_pace.hpp"

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
constexpr std::size_t atFirst = 2, atOnce = 8;

constexpr std::size_t triedAtOnePace = 1000;  ///< mutants between two looks at how fast the machine is

constexpr int silent = 0, noticed = 1, unchecked = 77;  // exit codes

/// From the last test to the first: the random tests of single mnemonics stand last and notice most.
bool someTestFails(const std::set<int>& tests, const std::vector<std::string>& names) {
  std::string filter;
  std::size_t count = 0, batch = atFirst;
  for (auto test = tests.rbegin(); test != tests.rend();) {
    filter += names[static_cast<std::size_t>(*test)] + ":";
    ++test;
    if (++count < batch && test != tests.rend()) continue;
    testing::GTEST_FLAG(filter) = filter;
    if (RUN_ALL_TESTS() != 0) return true;
    filter.clear();
    count = 0;
    batch = atOnce;
  }
  return false;
}

/// The process that tries a mutant. One that works longer than all its tests should is endless, and noticed.
pid_t start(const Candidate& candidate, const std::vector<std::string>& names, double pace) {
  const pid_t child = fork();
  CHECK(child >= 0, "fork");
  if (child != 0) return child;
  const auto limit = static_cast<rlim_t>(std::ceil(pace * (2 + static_cast<double>(candidate.tests->size()) / 20)));
  const rlimit seconds{limit, limit}, noCore{0, 0};
  setrlimit(RLIMIT_CPU, &seconds);
  setrlimit(RLIMIT_CORE, &noCore);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  testing::GTEST_FLAG(fail_fast) = true;
  Mutation::instance().activate(candidate.mutant);
  const bool fails = someTestFails(*candidate.tests, names);
  _exit(fails ? noticed : Mutation::instance().outcomeDiffers ? unchecked : silent);
}

Verdict verdictOf(int status) {
  if (!WIFEXITED(status)) return Verdict::Noticed;
  return WEXITSTATUS(status) == silent      ? Verdict::Silent
         : WEXITSTATUS(status) == unchecked ? Verdict::Unchecked
                                            : Verdict::Noticed;
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

std::vector<Verdict> tryMutants(const std::vector<Candidate>& candidates, const std::vector<std::string>& names) {
  std::fflush(stdout);
  const std::size_t processors = std::max(std::thread::hardware_concurrency(), 1U);
  std::vector<Verdict> verdicts(candidates.size());
  std::map<pid_t, std::size_t> running;
  double pace = 1;
  for (std::size_t next = 0; next < candidates.size() || !running.empty();) {
    if (next < candidates.size() && running.size() < processors) {
      if (next % triedAtOnePace == 0) pace = test::machinePace();
      running.emplace(start(candidates[next], names, pace), next);
      ++next;
      continue;
    }
    int status = 0;
    const pid_t child = waitpid(-1, &status, 0);
    CHECK(child > 0, "waitpid");
    const auto found = running.find(child);
    if (found == running.end()) continue;
    verdicts[found->second] = verdictOf(status);
    running.erase(found);
  }
  return verdicts;
}

bool triesEveryMutant() { return std::getenv("RUNGPROOF_EVERY_MUTANT") != nullptr; }

std::vector<Verdict> tryChosenMutants(const std::vector<Candidate>& candidates, const std::vector<std::string>& names) {
  if (triesEveryMutant()) return tryMutants(candidates, names);
  std::vector<Verdict> verdicts(candidates.size(), Verdict::LeftOut);
  std::set<std::uint16_t> noticedOpcodes;
  const auto tryThose = [&](const std::vector<std::size_t>& chosen) {
    std::vector<Candidate> tried;
    for (const std::size_t i : chosen) tried.push_back(candidates[i]);
    const std::vector<Verdict> answers = tryMutants(tried, names);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      verdicts[chosen[k]] = answers[k];
      if (answers[k] == Verdict::Noticed) noticedOpcodes.insert(candidates[chosen[k]].mutant.site.opcode);
    }
  };
  std::map<std::uint16_t, std::size_t> met;
  std::vector<std::size_t> chosen, others;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const std::size_t number = met[candidates[i].mutant.site.opcode]++;
    (number < 3 || number % 8 == 7 ? chosen : others).push_back(i);
  }
  tryThose(chosen);
  std::erase_if(others, [&](std::size_t i) { return noticedOpcodes.contains(candidates[i].mutant.site.opcode); });
  tryThose(others);
  return verdicts;
}

}  // namespace rungproof::mutation
