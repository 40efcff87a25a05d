// Every program of the corpus with all its properties on one core: no program may take longer than a single property
// may, and all together a minute.
#include <gtest/gtest.h>

#include "tests/corpus/corpus_program.hpp"
#include "tests/timing/measured_proof.hpp"

namespace rungproof {
namespace {

constexpr double mostOfOne = 2;   ///< CPU seconds: the bar of one property
constexpr double mostOfAll = 60;

double secondsOf(const std::filesystem::path& file) {
  const ProgramInput input = test::corpusInput(file);
  ProverOptions options = test::proverOptions(file);
  options.jobs = 1;
  const double begin = cpuSeconds();
  prove(input.program, input.properties, options);
  return cpuSeconds() - begin;
}

TEST(CorpusBar, EachProgramAndAllTogether) {
  double sum = 0;
  for (const std::filesystem::path& file : test::corpusFiles()) {
    double seconds = secondsOf(file);
    sum += seconds;
    if (seconds > mostOfOne) seconds = std::min(seconds, secondsOf(file));  // other work on the machine costs caches
    EXPECT_LE(seconds, mostOfOne) << file;
  }
  std::printf("%.1f s\n", sum);
  EXPECT_GT(sum, 0);
  EXPECT_LE(sum, mostOfAll);
}

}  // namespace
}  // namespace rungproof
