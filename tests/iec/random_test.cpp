// Random programs in ST against plain C++; the generator makes both.
#include "tests/iec/random_campaign.hpp"
#include "tests/iec/random_iec_program.hpp"

namespace rungproof {
namespace {

TEST(IecRandom, ProgramsComputeWhatPlainCodeDoes) {
  const RandomCampaign campaign(1800, 6, 5100);
  for (std::uint64_t seed = campaign.firstSeed; seed < campaign.lastSeed; ++seed) {
    iec_random::IecProgram made(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, made.text()));
    IecRun run(made.text());
    iec_random::State state;
    for (std::uint64_t scan = 1; scan <= campaign.scansOfEach; ++scan) {
      for (const auto& [name, type] : made.inputs_) {
        const std::int64_t value = iec_random::wrapped(made.pick(-40000, 40000), *type);
        run.set(name, static_cast<double>(value));
        state[name] = value;
      }
      run.scan();
      made.scan(state);
      for (const auto& [name, type] : made.variables_)
        ASSERT_EQ(run.get(name), static_cast<double>(state[name])) << name << " in scan " << scan;
      for (int i = 0; i < 4; ++i) {
        const std::string element = fmt::format("a[{}]", i);
        ASSERT_EQ(run.get(element), static_cast<double>(state[element])) << element << " in scan " << scan;
      }
    }
  }
}

}  // namespace
}  // namespace rungproof
