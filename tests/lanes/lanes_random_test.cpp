// Random programs with many traces. One on which a trace differs from the reference engine is shrunk before it is
// shown. RUNGPROOF_SEED chooses other programs, RUNGPROOF_PROGRAMS how many.
#include <gtest/gtest.h>

#include <cstdlib>

#include "ir/block_map.hpp"
#include "tests/compiled/random_step7.hpp"
#include "tests/differential/program_generator.hpp"
#include "tests/lanes/many_pair.hpp"

namespace rungproof::test {
namespace {

int programsOf(int byDefault) {
  const char* given = std::getenv("RUNGPROOF_PROGRAMS");
  return given == nullptr ? byDefault : std::atoi(given);
}

/// Every eighth program has scans that may be shorter than it is; every third is run as on a processor that has
/// registers of 256 bits only.
ManyOptions optionsFor(std::uint64_t seed) {
  ManyOptions options;
  if (seed % 3 == 0) options.most = lanes::Vectors::Bits256;
  options.isTight = seed % 8 == 0;
  return options;
}

std::string laneDifference(const RandomProgram& random, std::uint64_t seed) {
  RandomSource inputs(seed);
  return runBeside(random.program(), inputs, optionsFor(seed)).difference;
}

RandomProgram smallest(RandomProgram failing, std::uint64_t seed) {
  for (bool isSmaller = true; isSmaller;) {
    isSmaller = false;
    for (std::size_t i = failing.size(); i-- > 0;) {
      const RandomProgram smaller = failing.without(i);
      if (laneDifference(smaller, seed).empty()) continue;
      failing = smaller;
      isSmaller = true;
    }
  }
  return failing;
}

/// Of the scans of all traces at least `leastShare` percent must run side by side, or the test would compare the
/// reference engine with itself.
void compareMany(const GeneratorOptions& options, int count, std::size_t leastShare) {
  const std::uint64_t seed = testSeed();
  std::size_t scans = 0, sideBySide = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t own = seed + static_cast<std::uint64_t>(i);
    RandomSource random(own);
    const RandomProgram program = randomProgram(random, options);
    RandomSource inputs(own);
    const ManyOutcome outcome = runBeside(program.program(), inputs, optionsFor(own));
    scans += outcome.traceScans;
    sideBySide += outcome.sideBySide;
    if (outcome.difference.empty()) continue;
    const RandomProgram small = smallest(program, own);
    FAIL() << "seed " << own << "\n" << small.text() << laneDifference(small, own);
  }
  std::printf("%d programs from seed %llu, %zu of %zu trace-scans side by side\n", count,
              static_cast<unsigned long long>(seed), sideBySide, scans);
  EXPECT_GE(sideBySide * 100, scans * leastShare);
}

TEST(LanesOfRandomPrograms, StraightOnesAgree) {
  compareMany({.rungs = 8, .jumps = false, .loops = false, .subroutines = false}, programsOf(25), 20);
}
TEST(LanesOfRandomPrograms, WithJumpsAgree) {
  compareMany({.rungs = 8, .jumps = true, .loops = false, .subroutines = false}, programsOf(25), 20);
}
TEST(LanesOfRandomPrograms, WithLoopsAgree) {
  compareMany({.rungs = 8, .jumps = true, .loops = true, .subroutines = false}, programsOf(25), 20);
}
TEST(LanesOfRandomPrograms, WithCallsAgree) { compareMany({.rungs = 6}, programsOf(25), 20); }
TEST(LanesOfRandomPrograms, WithPointersAgree) { compareMany({.rungs = 6, .pointers = true}, programsOf(20), 20); }
/// They attach their routines in the first scan, with which every trace is set apart.
TEST(LanesOfRandomPrograms, WithInterruptsAgree) { compareMany({.rungs = 6, .interrupts = true}, programsOf(10), 0); }

void compareManyOfStep7(bool is400, bool anyTime, bool functions, std::size_t leastShare) {
  const std::uint64_t seed = testSeed();
  std::size_t scans = 0, sideBySide = 0;
  for (int i = 0; i < programsOf(functions ? 3 : 10); ++i) {
    const std::uint64_t own = seed + static_cast<std::uint64_t>(i);
    const auto [text, program] = randomStep7(own, is400, functions);
    ManyOptions options = optionsFor(own);
    options.words = Area::DB;
    options.firstByte = dataByte(1, 0);
    if (anyTime) options.engine.choices.set("s5-time", "any");
    RandomSource random(own);
    const ManyOutcome outcome = runBeside(program, random, options);
    scans += outcome.traceScans;
    sideBySide += outcome.sideBySide;
    ASSERT_EQ(outcome.difference, "") << "seed " << own << "\n" << text;
  }
  std::printf("from seed %llu: %zu of %zu trace-scans side by side\n", static_cast<unsigned long long>(seed),
              sideBySide, scans);
  EXPECT_GE(sideBySide * 100, scans * leastShare);
}

TEST(LanesOfRandomPrograms, OfAnS7300Agree) { compareManyOfStep7(false, false, false, 50); }
TEST(LanesOfRandomPrograms, OfAnS7400Agree) { compareManyOfStep7(true, false, true, 50); }
TEST(LanesOfRandomPrograms, OfAnS7300WhereTimePassesAnywhereAgree) { compareManyOfStep7(false, true, false, 50); }

}  // namespace
}  // namespace rungproof::test
