// What a run of the prover costs that has little to prove, and what many properties of one program cost together: a
// property that one look decides, as a process of its own, and two hundred properties beside one. And `lint --prove`
// over the corpus. Processor time, check of the certificates included.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/machine_pace.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/timing/measured_proof.hpp"
#include "tests/timing/stl_families.hpp"

namespace rungproof::test {
namespace {

constexpr int mostProcesses = 20;

/// Processor seconds of a process that proves `file`; the least of several.
double leastOfProof(const std::string& file) {
  double least = 1e9;
  for (int i = 0; i < mostProcesses; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      const int nothing = ::open("/dev/null", O_WRONLY);
      ::dup2(nothing, STDOUT_FILENO);
      ::execl(RUNGPROOF_BINARY_DIR "/rungproof", "rungproof", "prove", "--isolated", file.c_str(), nullptr);
      ::_exit(127);
    }
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "not proved";
    double seconds = 0;
    for (const timeval& t : {used.ru_utime, used.ru_stime})
      seconds += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    least = std::min(least, seconds);
  }
  return least;
}

TEST(PropertyPace, ATrivialPropertyIsProvedInEightMilliseconds) {
  constexpr double most = 0.008;
  const TemporaryFolder folder;
  const std::string file =
      folder.file("trivial.awl",
                  families::programOf("//@ prove lamp follows switch: Q0.0 = I0.0\n", "Network 1\nLD I0.0\n= Q0.0\n"));
  // A process of some ms is disturbed by whatever else the machine does, for seconds on end.
  constexpr int mostRounds = 20;
  double seconds = 1e9;
  for (int round = 0; round < mostRounds && seconds > most; ++round) {
    const double pace = machinePace();
    seconds = std::min(seconds, leastOfProof(file) / pace);
  }
  std::printf("%.1f ms of %.0f ms\n", seconds * 1000, most * 1000);
  EXPECT_LE(seconds, most);
}

/// So many latches and one more, started from outside, no two neighbours of which are on.
std::string neighbours(std::size_t properties) {
  std::string asked = "//@ external VB1000..VB1031\n", networks;
  for (int i = 0; i <= static_cast<int>(properties); ++i) {
    const std::string own = families::bitOf("M", i), next = families::bitOf("M", i + 1);
    networks += "Network " + std::to_string(i + 1) + "\nLD " + families::bitOf("V", 8000 + i) + "\nO " + own + "\n";
    if (i > 0) networks += "AN " + families::bitOf("M", i - 1) + "\n";
    networks += "AN " + next + "\n= " + own + "\n";
    if (i < static_cast<int>(properties))
      asked += "//@ prove apart " + std::to_string(i) + ": never " + own + " and " + next + "\n";
  }
  return families::programOf(asked, networks);
}

/// All properties but the first taken out.
std::string withOneProperty(const std::string& program) {
  std::istringstream lines(program);
  std::string result;
  bool isFirst = true;
  for (std::string line; std::getline(lines, line);) {
    const bool isProperty = line.starts_with("//@ prove");
    if (!isProperty || isFirst) result += line + "\n";
    isFirst = isFirst && !isProperty;
  }
  return result;
}

TEST(PropertyPace, TwoHundredPropertiesCostLittleMoreThanOne) {
  constexpr std::size_t many = 200;
  constexpr double mostGrowth = 8;
  const std::string program = neighbours(many);
  const MeasuredProof all = measureProof(program, {}, 5), one = measureProof(withOneProperty(program), {}, 5);
  EXPECT_EQ(all.verdicts.size(), many);
  EXPECT_EQ(one.verdicts.size(), 1U);
  for (const auto& [name, verdict] : all.verdicts) EXPECT_EQ(verdict, "PROVED") << name;
  std::printf("%.3f s for one, %.3f s for %zu: x%.1f of x%.0f\n", one.cpuSeconds, all.cpuSeconds, many,
              all.cpuSeconds / one.cpuSeconds, mostGrowth);
  EXPECT_LE(all.cpuSeconds, mostGrowth * one.cpuSeconds);
}

/// So many networks, each with a property of its own; or with properties of addresses that nobody writes.
std::string networksOfTheirOwn(int count, bool areWritten) {
  std::string asked, networks;
  for (int i = 0; i < count; ++i) {
    const std::string input = families::bitOf("I", i % 64), own = families::bitOf("V", i);
    networks += "Network " + std::to_string(i + 1) + "\nLD " + input + "\n= " + own + "\n";
    asked += "//@ prove p" + std::to_string(i) + ": " +
             (areWritten ? own + " implies " + input : "not " + families::bitOf("V", 40'000 + i)) + "\n";
  }
  return families::programOf(asked, networks);
}

// Each question costs what its own networks cost: ten times as many cost ten times as much.
TEST(PropertyPace, TenTimesThePropertiesCostTenTimesTheTime) {
  constexpr double mostGrowth = 13;
  for (const bool areWritten : {true, false}) {
    const MeasuredProof few = measureProof(networksOfTheirOwn(500, areWritten), {}, 5);
    const MeasuredProof many = measureProof(networksOfTheirOwn(5000, areWritten), {}, 2);
    EXPECT_EQ(many.verdicts.size(), 5000U);
    std::printf("%.3f s for 500, %.3f s for 5,000: x%.1f of x%.0f\n", few.cpuSeconds, many.cpuSeconds,
                many.cpuSeconds / few.cpuSeconds, mostGrowth);
    EXPECT_LE(many.cpuSeconds, mostGrowth * few.cpuSeconds);
  }
}

// Most of it is what `prove` takes as well, then some thirty questions that run into their limits.
TEST(PropertyPace, LintProveOverTheCorpus) {
  constexpr double most = 45;  // CPU seconds; 21 to 26 were measured, 35 where others have the caches
  double seconds = 0;
  std::size_t programs = 0;
  for (const std::filesystem::path& file : corpusFiles()) {
    std::vector<std::string> arguments{"lint", "--prove", "--isolated", file.string()};
    for (const auto& [name, value] : optionsOf(file)) arguments.insert(arguments.end(), {name, value});
    std::istringstream in;
    std::ostringstream out, err;
    const double own = quietSeconds([&] { runProgram(arguments, {in, out, err}); }, 0, 1, cpuSeconds);
    EXPECT_EQ(err.str(), "") << file;
    seconds += own;
    ++programs;
  }
  EXPECT_GE(programs, 150U);
  std::printf("%.1f s of %.0f s\n", seconds, most);
  EXPECT_LE(seconds, most);
}

}  // namespace
}  // namespace rungproof::test
