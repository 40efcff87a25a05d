// Random programs with blocks, texts, structures and 64 bits against plain C++, at scans of random length.
// RUNGPROOF_IEC_SCANS: how many scans, for longer runs; RUNGPROOF_SEED: the first seed.
#include <cmath>

#include "tests/iec/random_block_program.hpp"
#include "tests/iec/random_campaign.hpp"

namespace rungproof {
namespace {

/// Presets and start values of variables that no statement has written yet.
iec_naive::State startOfBlocks() {
  iec_naive::State state;
  for (const char* const name : {"m0.by", "m1.by"}) state.whole[name] = 2;
  return state;
}

TEST(IecRandom, BlocksComputeWhatPlainCodeDoes) {
  const RandomCampaign campaign(6000, 30, 7100);
  for (std::uint64_t seed = campaign.firstSeed; seed < campaign.lastSeed; ++seed) {
    iec_naive::BlockProgram made(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, made.text()));
    IecRun run(made.text());
    if (testing::Test::HasFailure()) return;
    iec_naive::State state = startOfBlocks();
    for (std::uint64_t scan = 1; scan <= campaign.scansOfEach; ++scan) {
      for (const char* const name : iec_naive::BlockProgram::inputs) {
        state.whole[name] = made.pick(0, 1);
        run.set(name, static_cast<double>(state.whole[name]));
      }
      const std::int64_t ms = made.pick(0, 3) == 0 ? made.pick(1, 60) : 10;
      run.scan(static_cast<std::uint32_t>(ms));
      made.scan(state);
      state.now += ms;
      for (const char* const name : iec_naive::BlockProgram::truths)
        ASSERT_EQ(run.get(name), static_cast<double>(state.whole[name])) << name << " in scan " << scan;
      for (const char* const name : iec_naive::BlockProgram::wholes)
        ASSERT_EQ(
            static_cast<std::int64_t>(run.simulator.read(run.place(name)) << (64 - bits(run.place(name).width))) >>
                (64 - bits(run.place(name).width)),
            state.whole[name])
            << name << " in scan " << scan;
      for (const char* const name : iec_naive::BlockProgram::texts) ASSERT_EQ(textOf(run, name), state.text[name]);
      for (const char* const name : iec_naive::BlockProgram::reals) {
        const double ours = run.get(name), theirs = state.real[name];
        ASSERT_TRUE(ours == theirs || (std::isnan(ours) && std::isnan(theirs)))
            << name << " in scan " << scan << ": " << ours << ", plain " << theirs;
      }
    }
  }
}

}  // namespace
}  // namespace rungproof
