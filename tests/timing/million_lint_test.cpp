// A million instructions, as a whole process: what a build server gives a generated program, or all programs of a works
// in one text. Processor time at the pace of a quiet machine.
#include <gtest/gtest.h>

#include "tests/bench/long_program.hpp"
#include "tests/machine_pace.hpp"
#include "tests/measured_process.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/timing/station_program.hpp"
#include "tests/timing/two_thousand.hpp"

namespace rungproof::test {
namespace {

constexpr double limit = 120;  ///< processor seconds, after which a run is ended
constexpr int attemptsOfAShape = 3;

/// Measured: 1.0 to 1.4 s; 236, 261 and 254 MiB, half of them the instructions with their operands, and the text.
struct Shape {
  const char* name;
  std::string (*text)();
  double mostSeconds;     ///< of the processor, at the pace of a quiet machine
  std::uint64_t mostMiB;  ///< at the peak
};

std::ostream& operator<<(std::ostream& out, const Shape& shape) { return out << shape.name; }

class MillionInstructions : public ::testing::TestWithParam<Shape> {};

TEST_P(MillionInstructions, AreLintedInSeconds) {
  const Shape& shape = GetParam();
  const TemporaryFolder folder;
  const std::string file = folder.file("long.awl", shape.text());
  ProcessRun run;
  double seconds = 1e9, before = machinePace();
  for (int i = 0; i < attemptsOfAShape && seconds > shape.mostSeconds; ++i) {
    run = runProcess({RUNGPROOF_BINARY_DIR "/rungproof", "lint", "--isolated", file}, limit);
    const double after = machinePace();
    seconds = std::min(seconds, run.seconds / ((before + after) / 2));
    before = after;
  }
  EXPECT_NE(run.output.find(" in 1000"), std::string::npos) << run.output.substr(run.output.size() - 200);
  std::printf("%.1f s of %.1f s, %d MiB of %d MiB\n", seconds, shape.mostSeconds,
              static_cast<int>(run.peakBytes >> 20U), static_cast<int>(shape.mostMiB));
  EXPECT_LE(seconds, shape.mostSeconds);
  EXPECT_LE(run.peakBytes, shape.mostMiB << 20U);
}

INSTANTIATE_TEST_SUITE_P(Lint, MillionInstructions,
                         ::testing::Values(Shape{"rungs", [] { return longProgram(1'000'000); }, 2.5, 260},
                                           Shape{"stations", [] { return stationProgram(695); }, 2.5, 280},
                                           Shape{"findings", [] { return tenInstructions(100'000); }, 2.5, 280}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace rungproof::test
