// Random lists against plain C++. RUNGPROOF_IEC_SCANS: how many scans, for longer runs.
#include "tests/iec/random_list.hpp"

#include "tests/iec/random_campaign.hpp"

namespace rungproof {
namespace {

using iec_list::Accumulators;
using iec_list::RandomList;

TEST(IecRandomList, ListsComputeWhatPlainCodeDoes) {
  const RandomCampaign campaign(1500, 5, 7300);
  for (std::uint64_t seed = campaign.firstSeed; seed < campaign.lastSeed; ++seed) {
    RandomList made(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, made.text()));
    IecRun run(made.text());
    Accumulators state;
    for (std::uint64_t scan = 1; scan <= campaign.scansOfEach; ++scan) {
      for (const char* const name : {"x0", "x1", "y0", "y1"}) {
        state.variables[name] = name[0] == 'y' ? made.pick(0, 1) : made.pick(-40, 40) * made.pick(1, 600);
        run.set(name, static_cast<double>(state.variables[name]));
      }
      run.scan();
      made.scan(state);
      for (const char* const name : {"i0", "i1", "i2", "b0", "b1", "b2"})
        ASSERT_EQ(run.get(name), static_cast<double>(state.variables[name])) << name << " in scan " << scan;
    }
  }
}

}  // namespace
}  // namespace rungproof
