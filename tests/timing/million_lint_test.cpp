// A million instructions, as a whole process: what a build server gives a generated program, or all programs of a works
// in one text. Processor time at the pace of a quiet machine.
#include <gtest/gtest.h>

#include "tests/machine_pace.hpp"
#include "tests/measured_process.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/timing/two_thousand.hpp"

namespace rungproof::test {
namespace {

/// Processor seconds at the pace of a quiet machine; 1.4 to 2.1 measured, a fifth for 200,000 findings.
constexpr double mostSeconds = 3.5;
/// 253 MiB measured: half of them are the instructions with their operands, and the text.
constexpr std::uint64_t mostBytes = 280ULL << 20U;
constexpr double limit = 120;  ///< processor seconds, after which a run is ended
constexpr int attempts = 3;

TEST(MillionInstructions, AreLintedInSeconds) {
  const TemporaryFolder folder;
  const std::string file = folder.file("long.awl", tenInstructions(100'000));
  ProcessRun run;
  double seconds = 1e9, before = machinePace();
  for (int i = 0; i < attempts && seconds > mostSeconds; ++i) {
    run = runProcess({RUNGPROOF_BINARY_DIR "/rungproof", "lint", "--isolated", file}, limit);
    const double after = machinePace();
    seconds = std::min(seconds, run.seconds / ((before + after) / 2));
    before = after;
  }
  EXPECT_NE(run.output.find(" in 1000000 instructions"), std::string::npos);
  std::printf("%.1f s of %.0f s, %d MiB of %d MiB\n", seconds, mostSeconds, static_cast<int>(run.peakBytes >> 20U),
              static_cast<int>(mostBytes >> 20U));
  EXPECT_LE(seconds, mostSeconds);
  EXPECT_LE(run.peakBytes, mostBytes);
}

}  // namespace
}  // namespace rungproof::test
