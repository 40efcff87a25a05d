// Planted faults of corpus programs as pairs: a fault that changes the outputs is DIFFERENT, with a run that the engine
// has made on both; one that is called EQUAL drives the same outputs in random runs of the engine as well.
#include <filesystem>
#include <random>

#include "analysis/proof/fault.hpp"
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

}  // namespace

class FaultsOf : public testing::TestWithParam<const char*> {};

TEST_P(FaultsOf, AreDifferentOrDoNothing) {
  const std::string file = std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/" + GetParam();
  ASSERT_TRUE(std::filesystem::exists(file));
  const Program program = readProgram({file});
  EquivalenceOptions options;
  options.prover.timeout = 20;
  options.prover.time = {1, 500};
  int different = 0, same = 0, open = 0;
  for (const Fault& fault : faultsOf(program)) {
    Program mutant = planted(program, fault);
    mutant.number();
    const Equivalence found = compareBehaviour({&program, {}}, {&mutant, {}}, options);
    EXPECT_TRUE(found.disagreements.empty()) << fault.text;
    if (found.equality == Equality::Different) {
      EXPECT_TRUE(found.run.has_value());
      ++different;
    } else if (found.equality == Equality::Equal) {
      ++same;
      for (std::uint32_t seed = 1; seed <= randomRuns; ++seed)
        ASSERT_EQ(randomRun(program, options.prover.choices, seed), randomRun(mutant, options.prover.choices, seed))
            << fault.text << ", seed " << seed;
    } else {
      ++open;
      ADD_FAILURE() << "undecided: " << fault.text;
    }
  }
  EXPECT_GT(different, 0);
  EXPECT_EQ(open, 0) << different << " different, " << same << " without effect";
}

INSTANTIATE_TEST_SUITE_P(Corpus, FaultsOf,
                         testing::Values("interlocks/star_delta.awl", "interlocks/reversing.awl",
                                         "interlocks/press_two_hand.awl"),
                         [](const testing::TestParamInfo<const char*>& info) {
                           std::string name = info.param;
                           for (char& c : name) {
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           }
                           return name;
                         });

}  // namespace rungproof::test
