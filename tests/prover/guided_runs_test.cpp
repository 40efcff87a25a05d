// Runs of the engine: they show what waits for timers, however long, and give witnesses that the judge repeats.
#include "analysis/proof/guided_runs.hpp"

#include "analysis/encoding/obligation.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

struct Setting {
  explicit Setting(const std::string& properties, const std::string& networks)
      : input(inputOf(properties, networks)), options(usualOptions()) {
    for (const Property& property : input.properties.properties)
      (property.isGoal() ? goals : assumptions).push_back(property);
    obligations = std::make_unique<Obligations>(input.program, input.properties, goals, encoderOptionsOf(options));
  }
  std::vector<std::optional<Witness>> search() {
    std::vector<const Property*> wanted;
    for (const Property& goal : goals) wanted.push_back(&goal);
    return guidedRuns(input.program, obligations->encoding(), assumptions, wanted, 1, {20});
  }
  bool isRepeated(std::size_t goal, const Witness& witness) const {
    return Judge(input.program, options.choices, assumptions, goals[goal])
        .witness(witness.scans, witness.initial)
        .has_value();
  }
  ProgramInput input;
  ProverOptions options;
  std::vector<Property> goals, assumptions;
  std::unique_ptr<Obligations> obligations;
};

TEST(GuidedRuns, LongTimersOneBehindTheOther) {
  // 10 min, then 20 min in scans of 500 ms (the watchdog's limit). T101 is enabled in the scan that T37 ends in; it
  // counts the intervals that pass after that (001:6590), so the ticks of the scan before are not among them.
  Setting s("//@ reach first: T37\n//@ reach second: T101\n",
            "Network 1\nLD I0.0\nTON T37, 6000\nLD T37\nTON T101, 12000\n");
  const std::vector<std::optional<Witness>> found = s.search();
  for (std::size_t g = 0; g < 2; ++g) {
    ASSERT_TRUE(found[g].has_value());
    EXPECT_TRUE(s.isRepeated(g, *found[g]));
  }
  // The first scan brings no tick: 600 s in scans of 0.5 s need 1,200 more.
  EXPECT_EQ(found[0]->scanCount, 1201U);
  EXPECT_EQ(found[1]->milliseconds, 500U * (1 + 1200 + 2400));
}

TEST(GuidedRuns, InputsThatMustBeOffAndWordsThatMatter) {
  Setting s("//@ reach off: T37\n//@ reach mixed: Q0.0\n",
            "Network 1\nLDN I0.0\nAN I0.1\nTON T37, 100\nNetwork 2\nLD I0.2\nAN I0.3\nTON T38, 30\nLD T38\n= Q0.0\n");
  const std::vector<std::optional<Witness>> found = s.search();
  ASSERT_TRUE(found[0] && found[1]);
  EXPECT_TRUE(s.isRepeated(0, *found[0]));
  EXPECT_TRUE(s.isRepeated(1, *found[1]));
}

TEST(GuidedRuns, WhatCannotBeIsNotFoundAndAssumptionsHold) {
  Setting s("//@ assume never both: not (I0.0 and I0.1)\n//@ reach both: Q0.0\n//@ reach never: Q0.1\n",
            "Network 1\nLD I0.0\nA I0.1\n= Q0.0\nNetwork 2\nLD SM0.0\nR Q0.1, 1\n");
  for (const std::optional<Witness>& witness : s.search()) EXPECT_FALSE(witness.has_value());
}

}  // namespace
}  // namespace rungproof::test
