// Random programs with blocks, texts, structures and 64 bits against plain C++, at scans of random length.
// RUNGPROOF_IEC_SCANS: how many scans, for longer runs; RUNGPROOF_SEED: the first seed.
#include <cmath>

#include "tests/iec/iec_run.hpp"
#include "tests/iec/random_block_program.hpp"

namespace rungproof {
namespace {

/// Presets and start values of variables that no statement has written yet.
iec_naive::State startOfBlocks() {
  iec_naive::State state;
  for (const char* const name : {"m0.by", "m1.by"}) state.whole[name] = 2;
  return state;
}

/// Behind the length of a text its characters lie.
std::string textOf(const IecRun& run, const std::string& name) {
  Operand at = run.place(name + ".length");
  std::string characters(run.simulator.read(at), ' ');
  for (char& c : characters) {
    ++at.offset;
    c = static_cast<char>(run.simulator.read(at));
  }
  return characters;
}

TEST(IecRandom, BlocksComputeWhatPlainCodeDoes) {
  const char* const asked = std::getenv("RUNGPROOF_IEC_SCANS");
  const char* const first = std::getenv("RUNGPROOF_SEED");
  const std::uint64_t scans = asked == nullptr ? 6000 : std::strtoull(asked, nullptr, 10);
  const std::uint64_t seed = first == nullptr ? 7100 : std::strtoull(first, nullptr, 10);
  constexpr std::uint64_t each = 30;
  for (std::uint64_t i = 0; i < (scans + each - 1) / each; ++i) {
    iec_naive::BlockProgram made(seed + i);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed + i, made.text()));
    IecRun run(made.text());
    if (testing::Test::HasFailure()) return;
    iec_naive::State state = startOfBlocks();
    for (std::uint64_t scan = 1; scan <= each; ++scan) {
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
