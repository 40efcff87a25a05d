// Random charts against the token game. RUNGPROOF_IEC_SCANS: how many scans, for longer runs.
#include "tests/iec/random_chart.hpp"

#include "tests/iec/random_campaign.hpp"

namespace rungproof {
namespace {

using iec_chart::TokenAction;
using iec_chart::TokenGame;

TEST(IecRandomChart, ChartsPlayTheTokenGame) {
  const RandomCampaign campaign(3600, 12, 9100);
  for (std::uint64_t seed = campaign.firstSeed; seed < campaign.lastSeed; ++seed) {
    TokenGame game(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, game.text()));
    IecRun run(game.text(), 10, game.choices());
    for (std::uint64_t scan = 1; scan <= campaign.scansOfEach; ++scan) {
      std::vector<bool> inputs;
      for (int i = 0; i < 3; ++i) {
        inputs.push_back(game.pick(0, 1) == 1);
        run.set(fmt::format("x{}", i), inputs.back() ? 1 : 0);
      }
      run.scan();
      game.scan(inputs);
      for (std::size_t step = 0; step < game.steps().size(); ++step) {
        ASSERT_EQ(run.get(fmt::format("S{}.X", step)), game.steps()[step].isActive ? 1 : 0)
            << "S" << step << ".X in scan " << scan;
        ASSERT_EQ(run.get(fmt::format("S{}.T", step)), static_cast<double>(game.steps()[step].time))
            << "S" << step << ".T in scan " << scan;
      }
      for (const TokenAction& action : game.actions()) {
        const std::string name = action.isBody ? action.name + "v" : action.name;
        ASSERT_EQ(run.get(name), static_cast<double>(action.value)) << name << " in scan " << scan;
      }
      ASSERT_EQ(run.get("last"), static_cast<double>(game.last())) << "last in scan " << scan;
    }
  }
}

}  // namespace
}  // namespace rungproof
