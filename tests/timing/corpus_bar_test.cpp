// Motor starters, sequencers and two-hand controls of the corpus, each with all its properties on one core: no program
// may take longer than a single property may.
#include <gtest/gtest.h>

#include "tests/corpus/corpus_program.hpp"
#include "tests/timing/measured_proof.hpp"

namespace rungproof {
namespace {

constexpr double mostOfOne = 2;  ///< CPU seconds: the bar of one property
constexpr int attempts = 3;      ///< other work on the machine costs caches

double secondsOf(const std::filesystem::path& file) {
  const ProgramInput input = test::corpusInput(file);
  ProverOptions options = test::proverOptions(file);
  options.jobs = 1;
  const double begin = cpuSeconds();
  prove(input.program, input.properties, options);
  return cpuSeconds() - begin;
}

TEST(CorpusBar, EachProgramWithAllItsProperties) {
  std::size_t programs = 0;
  for (const char* folder : {"interlocks", "sequences"}) {
    for (const std::filesystem::path& file : test::corpusFiles(folder)) {
      double seconds = secondsOf(file);
      for (int i = 1; i < attempts && seconds > mostOfOne; ++i) seconds = std::min(seconds, secondsOf(file));
      EXPECT_LE(seconds, mostOfOne) << file;
      ++programs;
    }
  }
  EXPECT_GT(programs, 0U);
}

}  // namespace
}  // namespace rungproof
