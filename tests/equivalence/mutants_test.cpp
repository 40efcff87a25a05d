// Planted faults of corpus programs as pairs: a fault that changes the outputs is DIFFERENT, with a run that the engine
// has made on both; one that is called EQUAL drives the same outputs in random runs of the engine as well.
#include <filesystem>
#include <random>

#include "analysis/proof/fault.hpp"
#include "analysis/read_errors.hpp"
#include "engine/replay.hpp"
#include "tests/equivalence/pair.hpp"

namespace rungproof::test {

namespace {

constexpr int randomScans = 400;
constexpr int randomRuns = 25;

/// The outputs at the end of every scan of one random run, the same inputs for the same seed.
std::vector<std::uint64_t> randomRun(const Program& program, const Choices& choices, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<ReplayScan> scans;
  std::uint64_t inputs = 0;
  for (int k = 0; k < randomScans; ++k) {
    ReplayScan& scan = scans.emplace_back();
    scan.lengthMs = random() % 4 == 0 ? 500 : 1 + random() % 60;
    if (random() % 3 == 0) inputs ^= std::uint64_t{1} << random() % 24;
    for (std::uint32_t bit = 0; bit < 24; ++bit)
      scan.inputs.push_back({direct(Area::I, Width::Bit, bit / 8, bit % 8), inputs >> bit & 1});
  }
  std::vector<std::uint64_t> outputs;
  replay(program, choices, scans, nullptr, [&](const Concrete::Store& state, std::size_t) {
    outputs.push_back(state.load(Area::Q, 0, 32) << 1 | state.get(Reg::Running, 0));
    return true;
  });
  return outputs;
}

/// What became of the faults of one program.
struct Tally {
  int different = 0, same = 0;
  std::vector<std::string> open;
};

Tally tallyOf(const std::filesystem::path& file, double seconds, int runs) {
  Tally tally;
  const Program program = readProgram({file.string()});
  EquivalenceOptions options;
  options.prover.timeout = seconds;
  for (const Fault& fault : faultsOf(program)) {
    Program mutant = planted(program, fault);
    mutant.number();
    const Equivalence found = compareBehaviour({&program, {}}, {&mutant, {}}, options);
    const std::string where = file.filename().string() + ": " + fault.text;
    EXPECT_TRUE(found.disagreements.empty()) << where;
    if (found.equality == Equality::Unknown) tally.open.push_back(where);
    if (found.equality == Equality::Different) {
      EXPECT_TRUE(found.run.has_value()) << where;
      ++tally.different;
    }
    if (found.equality != Equality::Equal) continue;
    ++tally.same;
    for (int seed = 1; seed <= runs; ++seed) {
      const auto one = static_cast<std::uint32_t>(seed);
      EXPECT_EQ(randomRun(program, options.prover.choices, one), randomRun(mutant, options.prover.choices, one))
          << where << ", seed " << seed;
    }
  }
  return tally;
}

}  // namespace

class FaultsOf : public testing::TestWithParam<const char*> {};

TEST_P(FaultsOf, AreDifferentOrDoNothing) {
  const std::filesystem::path file = std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/" + GetParam();
  ASSERT_TRUE(std::filesystem::exists(file));
  const Tally tally = tallyOf(file, 30, randomRuns);
  EXPECT_GT(tally.different, 0);
  for (const std::string& fault : tally.open) ADD_FAILURE() << "undecided: " << fault;
}

INSTANTIATE_TEST_SUITE_P(Corpus, FaultsOf,
                         testing::Values("interlocks/star_delta.awl", "interlocks/reversing.awl",
                                         "interlocks/press_two_hand.awl"),
                         [](const testing::TestParamInfo<const char*>& info) {
                           return std::filesystem::path(info.param).stem().string();
                         });

/// RUNGPROOF_FAULTS=all: the faults of every program of the corpus, each one that is called EQUAL with 100,000 random
/// scans. Otherwise of a few small ones.
TEST(FaultsOfTheCorpus, AreDifferentOrDoNothing) {
  const char* given = std::getenv("RUNGPROOF_FAULTS");
  const bool isFull = given != nullptr && std::string(given) == "all";
  const std::vector<std::string> few = {"guard_door.awl", "blinker.awl", "hoist.awl"};
  int different = 0, same = 0, programs = 0;
  std::vector<std::string> open;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(RUNGPROOF_SOURCE_DIR) + "/corpus")) {
    const std::filesystem::path& file = entry.path();
    const bool isWanted =
        isFull ? file.extension() == ".awl" : std::ranges::find(few, file.filename().string()) != few.end();
    if (!isWanted || hasReadErrors(readProgram({file.string()}))) continue;
    const Tally tally = tallyOf(file, isFull ? 4 : 10, isFull ? 100'000 / randomScans : randomRuns);
    ++programs;
    different += tally.different;
    same += tally.same;
    open.insert(open.end(), tally.open.begin(), tally.open.end());
    if (isFull)
      std::printf("%s: %d different, %d equal, %zu undecided\n", file.filename().c_str(), tally.different, tally.same,
                  tally.open.size());
    std::fflush(stdout);
  }
  std::printf("%d programs: %d different, %d equal, %zu undecided\n", programs, different, same, open.size());
  for (const std::string& fault : open) std::printf("  undecided: %s\n", fault.c_str());
  EXPECT_GE(programs, 3);
  EXPECT_GT(different, 0);
  if (!isFull) {
    EXPECT_TRUE(open.empty());
  }
}

}  // namespace rungproof::test
