// Random programs over all elementary types against plain C++. RUNGPROOF_IEC_SCANS: how many scans, for longer runs;
// RUNGPROOF_SEED: the first seed.
#include <bit>

#include "tests/iec/random_campaign.hpp"
#include "tests/iec/random_library_program.hpp"
#include "tests/iec/random_type_program.hpp"

namespace rungproof {
namespace {

using iec_types::TypeProgram;

constexpr std::uint64_t lowBitsOf(int width) { return ~std::uint64_t{0} >> (64 - width); }
std::uint64_t patternOf(const IecRun& run, const std::string& name) { return run.simulator.read(run.place(name)); }

void expectAllTypes(const IecRun& run, iec_types::State& state) {
  const auto expectWhole = [&](const std::string& name, int width) {
    ASSERT_EQ(patternOf(run, name), static_cast<std::uint64_t>(state.whole[name]) & lowBitsOf(width)) << name;
  };
  for (const iec_types::Kind& kind : iec_types::kinds) {
    for (const char which : {'0', '1'}) expectWhole(TypeProgram::nameOf(kind, which), kind.bits);
  }
  for (const auto& [name, kind] : TypeProgram::others()) expectWhole(name, kind->bits);
  for (const char* const name : TypeProgram::truths) expectWhole(name, 1);
  for (const char* const name : TypeProgram::reals)
    ASSERT_EQ(patternOf(run, name), std::bit_cast<std::uint32_t>(static_cast<float>(state.real[name]))) << name;
  for (const char* const name : TypeProgram::longReals)
    ASSERT_EQ(patternOf(run, name), std::bit_cast<std::uint64_t>(state.real[name])) << name;
  for (const char* const name : TypeProgram::texts) ASSERT_EQ(textOf(run, name), state.text[name]) << name;
}

TEST(IecRandom, AllTypesComputeWhatPlainCodeDoes) {
  const RandomCampaign campaign(3000, 20, 12100);
  for (std::uint64_t seed = campaign.firstSeed; seed < campaign.lastSeed; ++seed) {
    TypeProgram made(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, made.text()));
    IecRun run(made.text());
    if (testing::Test::HasFailure()) return;
    iec_types::State state;
    for (std::uint64_t scan = 1; scan <= campaign.scansOfEach; ++scan) {
      SCOPED_TRACE(fmt::format("scan {}", scan));
      for (const char* const name : {"x0", "x1"}) {
        state.whole[name] = made.pick(0, 1);
        run.set(name, static_cast<double>(state.whole[name]));
      }
      for (const iec_types::Kind& kind : iec_types::kinds) {
        const std::string name = TypeProgram::nameOf(kind, 'x');
        state.whole[name] = made.valueOf(kind);
        run.simulator.write(run.place(name), static_cast<std::uint64_t>(state.whole[name]) & lowBitsOf(kind.bits));
      }
      run.scan();
      made.scan(state);
      expectAllTypes(run, state);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(IecRandom, TheLibraryComputesWhatPlainCodeDoes) {
  const RandomCampaign campaign(3000, 30, 14100);
  for (std::uint64_t seed = campaign.firstSeed; seed < campaign.lastSeed; ++seed) {
    iec_naive::LibraryProgram made(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, made.text()));
    IecRun run(made.text());
    if (testing::Test::HasFailure()) return;
    iec_naive::LibraryState state;
    state.whole["tw.by"] = 3;
    for (std::uint64_t scan = 1; scan <= campaign.scansOfEach; ++scan) {
      for (const char* const name : iec_naive::LibraryProgram::inputs) {
        state.whole[name] = made.pick(0, 1);
        run.set(name, static_cast<double>(state.whole[name]));
      }
      for (const char* const name : iec_naive::LibraryProgram::realInputs) {
        state.real[name] = static_cast<float>(made.pick(-80, 80)) / 8;
        run.set(name, state.real[name]);
      }
      const std::int64_t ms = made.pick(0, 3) == 0 ? made.pick(1, 60) : 10;
      run.scan(static_cast<std::uint32_t>(ms));
      made.scan(state);
      state.now += ms;
      for (const auto& [name, width] : iec_naive::LibraryProgram::wholes())
        ASSERT_EQ(patternOf(run, name), static_cast<std::uint64_t>(state.whole[name]) & lowBitsOf(width))
            << name << " in scan " << scan;
      for (const char* const name : iec_naive::LibraryProgram::reals)
        ASSERT_EQ(patternOf(run, name), std::bit_cast<std::uint32_t>(state.real[name])) << name << " in scan " << scan;
    }
  }
}

}  // namespace
}  // namespace rungproof
