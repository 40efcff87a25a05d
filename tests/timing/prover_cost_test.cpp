// What a run of `prove` costs at least, as a whole process, and how that grows with properties and with networks that
// have no effect on them. Processor time, at the pace of a quiet machine.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/machine_pace.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/timing/measured_proof.hpp"
#include "tests/timing/stl_families.hpp"

namespace rungproof::test {
namespace {

constexpr double mostForTrivial = 0.008;      ///< s, of the whole process
constexpr double mostForIrrelevant = 0.1;     ///< s, that 10,000 networks may take more than 10
constexpr double mostGrowthOfProperties = 8;  ///< times, from 1 to 200 properties of one program
constexpr int mostProcesses = 20, motors = 200;

/// Processor seconds of `prove` on a file, all properties of which hold.
double secondsToProve(const std::string& file) {
  const double before = cpuSeconds();
  const pid_t child = ::fork();
  if (child == 0) {
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
    ::execl(RUNGPROOF_BINARY_DIR "/rungproof", "rungproof", "prove", "--isolated", file.c_str(), nullptr);
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << file;
  return cpuSeconds() - before;
}

double leastSeconds(const std::string& file, double enough) {
  double least = 1e9, before = machinePace();
  for (int i = 0; i < mostProcesses && least > enough; ++i) {
    const double seconds = secondsToProve(file), after = machinePace();
    least = std::min(least, seconds / ((before + after) / 2));
    before = after;
  }
  return least;
}

const std::string twoMotors = "Network 1\nLD I0.0\nAN Q0.1\n= Q0.0\nNetwork 2\nLD I0.1\nAN Q0.0\n= Q0.1\n";
const std::string apart = "//@ prove apart: never Q0.0 and Q0.1\n";

TEST(ProverCost, ATrivialProperty) {
  const TemporaryFolder folder;
  const std::string file = folder.file("two.awl", families::programOf(apart, twoMotors));
  const double seconds = leastSeconds(file, mostForTrivial);
  std::printf("%.1f ms of %.0f ms\n", seconds * 1000, mostForTrivial * 1000);
  EXPECT_LE(seconds, mostForTrivial);
}

/// Latches in a row, of which no two neighbours are on, and the first `properties` interlocks between them.
std::string interlocks(int properties) {
  std::string networks, asked = "//@ external VB1000..VB1063\n";
  for (int i = 0; i < motors; ++i) {
    networks += "Network " + std::to_string(i + 1) + "\nLD " + families::bitOf("V", 8000 + i) + "\nO " +
                families::bitOf("M", i) + "\nAN " + families::bitOf("V", 8256 + i) + "\n";
    if (i > 0) networks += "AN " + families::bitOf("M", i - 1) + "\n";
    if (i + 1 < motors) networks += "AN " + families::bitOf("M", i + 1) + "\n";
    networks += "= " + families::bitOf("M", i) + "\n";
    if (i < properties && i + 1 < motors)
      asked += "//@ prove interlock " + std::to_string(i) + ": never " + families::bitOf("M", i) + " and " +
               families::bitOf("M", i + 1) + "\n";
  }
  if (properties == motors) asked += "//@ prove ends: not (M0.0 and M0.1) or M1.0\n";
  return families::programOf(asked, networks);
}

TEST(ProverCost, TwoHundredPropertiesOfOneProgram) {
  const TemporaryFolder folder;
  const std::string one = folder.file("one.awl", interlocks(1)), all = folder.file("all.awl", interlocks(motors));
  const double small = leastSeconds(one, 0), large = leastSeconds(all, mostGrowthOfProperties * small);
  std::printf("%.1f and %.1f ms: x%.1f of x%.0f\n", small * 1000, large * 1000, large / small, mostGrowthOfProperties);
  EXPECT_LE(large, mostGrowthOfProperties * small);
}

std::string withIrrelevant(int networks) {
  std::string text = twoMotors;
  for (int i = 0; i < networks; ++i)
    text += "Network " + std::to_string(i + 3) + "\nLD " + families::bitOf("I", i % 112) + "\nA " +
            families::bitOf("V", i % 8000) + "\n= " + families::bitOf("V", (i + 9) % 8000) + "\n";
  return families::programOf(apart, text);
}

TEST(ProverCost, NetworksWithoutEffect) {
  const TemporaryFolder folder;
  const std::string few = folder.file("few.awl", withIrrelevant(10)),
                    many = folder.file("many.awl", withIrrelevant(10'000));
  const double small = leastSeconds(few, 0), large = leastSeconds(many, small + mostForIrrelevant);
  std::printf("%.1f and %.1f ms: %.1f ms more of %.0f\n", small * 1000, large * 1000, (large - small) * 1000,
              mostForIrrelevant * 1000);
  EXPECT_LE(large, small + mostForIrrelevant);
}

}  // namespace
}  // namespace rungproof::test
