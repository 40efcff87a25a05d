// Every rule's example, every program of the corpus and randomly damaged programs through every command: no signal, no
// abort, no disagreement of the tool with itself, no exit code 0 over code that was not read. RUNGPROOF_DAMAGED is the
// number of damaged programs (60 without it; 10000 is the whole campaign), RUNGPROOF_SEED the first seed; each program
// has a seed of its own, which a failure names.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "tests/damage/every_command.hpp"

namespace rungproof {
namespace {

using test::damaged;
using test::faultOf;
using test::SeedProgram;

std::uint64_t numberIn(const char* variable, std::uint64_t usual) {
  const char* text = std::getenv(variable);
  return text == nullptr ? usual : std::strtoull(text, nullptr, 10);
}

void expectAllWell(const std::vector<SeedProgram>& programs, std::size_t step) {
  std::size_t slow = 0;
  for (std::size_t i = 0; i < programs.size(); i += step) {
    bool isSlow = false;
    const std::string faults = faultOf(programs[i], {.seconds = 30, .timeout = "0.2s"}, isSlow);
    slow += isSlow ? 1 : 0;
    EXPECT_EQ(faults, "") << programs[i].name << "\n" << programs[i].text;
  }
  std::printf("%zu programs, %zu of them longer than their time\n", (programs.size() + step - 1) / step, slow);
}

TEST(EveryCommand, RunsTheExamplesOfEveryRule) { expectAllWell(test::ruleExamples(), 1); }

/// Without RUNGPROOF_DAMAGED every eighth program, as tests/corpus proves all of them anyway.
TEST(EveryCommand, RunsTheCorpus) {
  expectAllWell(test::corpusPrograms(), std::getenv("RUNGPROOF_DAMAGED") == nullptr ? 8 : 1);
}

TEST(EveryCommand, RunsDamagedPrograms) {
  std::vector<SeedProgram> seeds = test::ruleExamples();
  const std::vector<SeedProgram> corpus = test::corpusPrograms();
  seeds.insert(seeds.end(), corpus.begin(), corpus.end());
  ASSERT_GT(seeds.size(), 200U);
  const std::uint64_t count = numberIn("RUNGPROOF_DAMAGED", 60), first = numberIn("RUNGPROOF_SEED", 1);
  std::size_t slow = 0, bad = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    std::mt19937_64 random(seed);
    SeedProgram program = seeds[random() % seeds.size()];
    program.text = damaged(program, random);
    bool isSlow = false;
    const std::string faults = faultOf(program, {.seconds = 10, .timeout = "0.1s"}, isSlow);
    slow += isSlow ? 1 : 0;
    bad += faults.empty() ? 0 : 1;
    EXPECT_EQ(faults, "") << "seed " << seed << ", " << program.name << "\n" << program.text.substr(0, 3000);
  }
  std::printf("seeds %llu to %llu: %zu with faults, %zu longer than their time\n",
              static_cast<unsigned long long>(first), static_cast<unsigned long long>(first + count - 1), bad, slow);
}

}  // namespace
}  // namespace rungproof
