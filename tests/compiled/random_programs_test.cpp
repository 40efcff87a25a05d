// Random programs on both engines. A program on which they differ is shrunk before it is shown. RUNGPROOF_SEED chooses
// other programs, RUNGPROOF_PROGRAMS how many.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/compiled/engine_pair.hpp"
#include "tests/differential/program_generator.hpp"

namespace rungproof::test {
namespace {

int programCount(int byDefault) {
  const char* given = std::getenv("RUNGPROOF_PROGRAMS");
  return given == nullptr ? byDefault : std::atoi(given);
}

std::string differenceOf(const RandomProgram& random, std::uint64_t seed, const PairOptions& pair) {
  RandomSource inputs(seed);
  return runBoth(random.program(), inputs, pair).difference;
}

RandomProgram shrunk(RandomProgram failing, std::uint64_t seed, const PairOptions& pair) {
  for (bool isSmaller = true; isSmaller;) {
    isSmaller = false;
    for (std::size_t i = failing.size(); i-- > 0;) {
      const RandomProgram smaller = failing.without(i);
      if (differenceOf(smaller, seed, pair).empty()) continue;
      failing = smaller;
      isSmaller = true;
    }
  }
  return failing;
}

/// Runs programs made with these options; at least `leastShare` percent of the scans must be compiled ones, or the
/// test would compare the reference engine with itself.
void compareAll(const GeneratorOptions& options, int count, int leastShare, const PairOptions& pair = {}) {
  const std::uint64_t seed = testSeed();
  std::uint64_t scans = 0, compiled = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t own = seed + static_cast<std::uint64_t>(i);
    RandomSource random(own);
    const RandomProgram program = randomProgram(random, options);
    RandomSource inputs(own);
    const PairOutcome outcome = runBoth(program.program(), inputs, pair);
    scans += static_cast<std::uint64_t>(outcome.scans);
    compiled += outcome.compiled;
    if (outcome.difference.empty()) continue;
    const RandomProgram small = shrunk(program, own, pair);
    FAIL() << "seed " << own << "\n" << small.text() << differenceOf(small, own, pair);
  }
  std::printf("%d programs, %llu scans, %llu compiled\n", count, static_cast<unsigned long long>(scans),
              static_cast<unsigned long long>(compiled));
  EXPECT_GE(compiled * 100, scans * static_cast<std::uint64_t>(leastShare));
}

TEST(RandomPrograms, StraightOnesAgree) {
  compareAll({.rungs = 8, .jumps = false, .loops = false, .subroutines = false}, programCount(200), 20);
}
TEST(RandomPrograms, WithJumpsAgree) {
  compareAll({.rungs = 8, .jumps = true, .loops = false, .subroutines = false}, programCount(150), 20);
}
TEST(RandomPrograms, WithLoopsAgree) {
  compareAll({.rungs = 8, .jumps = true, .loops = true, .subroutines = false}, programCount(150), 20);
}
TEST(RandomPrograms, WithCallsAgree) { compareAll({.rungs = 6}, programCount(150), 20); }
TEST(RandomPrograms, WithPointersAgree) { compareAll({.rungs = 6, .pointers = true}, programCount(150), 20); }
TEST(RandomPrograms, WithInterruptsAgree) { compareAll({.rungs = 6, .interrupts = true}, programCount(150), 10); }
TEST(RandomPrograms, UnderScriptsThatNameNoPlaceAgree) {
  compareAll({.rungs = 6, .pointers = true}, programCount(150), 20, {.isScripted = true});
}
TEST(RandomPrograms, WithInterruptsUnderSuchScriptsAgree) {
  compareAll({.rungs = 6, .interrupts = true}, programCount(150), 5, {.isScripted = true});
}

}  // namespace
}  // namespace rungproof::test
