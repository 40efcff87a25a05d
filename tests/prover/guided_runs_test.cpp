// Runs of the engine: they show what waits for timers, however long, and give witnesses that the judge repeats.
#include "analysis/witness/guided_runs.hpp"

#include "analysis/encoding/asked_properties.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

struct Setting {
  explicit Setting(const std::string& properties, const std::string& networks)
      : input(inputOf(properties, networks)), options(usualOptions()) {
    for (const Property& property : input.properties.properties)
      (property.isGoal() ? goals : assumptions).push_back(property);
    askedProperties =
        std::make_unique<AskedProperties>(input.program, input.properties, goals, encoderOptionsOf(options));
  }
  /// The last `alsoWatched` goals keep no run going.
  std::vector<std::optional<Witness>> search(std::size_t alsoWatched = 0) {
    std::vector<const Property*> wanted;
    for (const Property& goal : goals) wanted.push_back(&goal);
    GuidedLimits limits{20};
    limits.alsoWatched = alsoWatched;
    std::vector<std::optional<Witness>> found;
    for (const std::optional<GuidedRun>& run :
         guidedRuns(input.program, askedProperties->encoding(), assumptions, wanted, 1, limits))
      found.push_back(run ? std::optional(run->witness()) : std::nullopt);
    return found;
  }
  bool isRepeated(std::size_t goal, const Witness& witness) const {
    return Judge(input.program, options.choices, assumptions, goals[goal])
        .witness(witness.scans, witness.initial)
        .has_value();
  }
  ProgramInput input;
  ProverOptions options;
  std::vector<Property> goals, assumptions;
  std::unique_ptr<AskedProperties> askedProperties;
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

TEST(GuidedRuns, ShowOnTheWayWhatElseIsWatched) {
  // The lamp comes on in the scan in which T37 ends, so the run that shows the timer shows the lamp; T38 ends later,
  // when nobody waits for it any more.
  Setting s("//@ reach time: T37\n//@ prove dark: never Q0.0\n//@ reach later: T38\n",
            "Network 1\nLD I0.0\nTON T37, 6000\nTON T38, 9000\nLD T37\n= Q0.0\n");
  const std::vector<std::optional<Witness>> found = s.search(2);
  ASSERT_TRUE(found[0] && found[1]);
  EXPECT_EQ(found[1]->scanCount, found[0]->scanCount);
  EXPECT_TRUE(s.isRepeated(1, *found[1]));
  EXPECT_FALSE(found[2].has_value());
}

TEST(GuidedRuns, InputsThatMustBeOffAndWordsThatMatter) {
  Setting s("//@ reach off: T37\n//@ reach mixed: Q0.0\n",
            "Network 1\nLDN I0.0\nAN I0.1\nTON T37, 100\nNetwork 2\nLD I0.2\nAN I0.3\nTON T38, 30\nLD T38\n= Q0.0\n");
  const std::vector<std::optional<Witness>> found = s.search();
  ASSERT_TRUE(found[0] && found[1]);
  EXPECT_TRUE(s.isRepeated(0, *found[0]));
  EXPECT_TRUE(s.isRepeated(1, *found[1]));
}

TEST(GuidedRuns, CountersThatNeedEveryEdgeOfOneInput) {
  Setting s("//@ reach full: C5\n", "Network 1\nLD I0.0\nLD I0.1\nCTU C5, 32767\n");
  const std::vector<std::optional<Witness>> found = s.search();
  ASSERT_TRUE(found[0].has_value());
  EXPECT_TRUE(s.isRepeated(0, *found[0]));
  EXPECT_EQ(found[0]->scanCount, 65535U);  // on in the first scan is no edge; then one in every other scan
}

TEST(GuidedRuns, HoursThatOneInputAloneBringsAbout) {
  // Seconds by a timer that starts itself, minutes and an hour by counters; the second input holds the hours at 0.
  Setting s("//@ reach hour: C2\n",
            "Network 1\nLD I0.0\nAN T37\nTON T37, 10\nNetwork 2\nLD T37\nLD C1\nCTU C1, 60\n"
            "Network 3\nLD C1\nLD I0.1\nCTU C2, 60\n");
  const std::vector<std::optional<Witness>> found = s.search();
  ASSERT_TRUE(found[0].has_value());
  EXPECT_TRUE(s.isRepeated(0, *found[0]));
  EXPECT_GE(found[0]->milliseconds, 3'600'000U);
}

TEST(GuidedRuns, WhatCannotBeIsNotFoundAndAssumptionsHold) {
  Setting s("//@ assume never both: not (I0.0 and I0.1)\n//@ reach both: Q0.0\n//@ reach never: Q0.1\n",
            "Network 1\nLD I0.0\nA I0.1\n= Q0.0\nNetwork 2\nLD SM0.0\nR Q0.1, 1\n");
  for (const std::optional<Witness>& witness : s.search()) EXPECT_FALSE(witness.has_value());
}

TEST(OwnRuns, CountWhereTheSolversRunRestsOnEstimates) {
  // Event 10 comes every 10 ms, up to 50 times in one scan; more than two at one place are estimated, so what solvers
  // find is no run. In 20 scans of 500 ms the engine counts to 1000 (001:5470).
  const ProgramInput input =
      inputOf("//@ reach full: VW0 = 1000\n//@ reach half: VW0 = 500\n//@ reach negative: VW0 < 0\n",
              "Network 1\nLD SM0.1\nMOVB 10, SMB34\nATCH INT0, 10\nNetwork 2\nLD I0.0\nENI\n",
              "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLDW< VW0, +1000\nINCW VW0\nEND_INTERRUPT_BLOCK\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions(8));
  EXPECT_TRUE(run.disagreements.empty());
  EXPECT_EQ(outcomeOf(run, "full"), Outcome::Reachable);
  EXPECT_EQ(outcomeOf(run, "half"), Outcome::Reachable);
  EXPECT_EQ(outcomeOf(run, "negative"), Outcome::Unreachable);
}

/// 18 blocks: MAIN, twelve subroutines of string and REAL instructions, two interrupt routines that write what others
/// read, and three subroutines of bits.
std::string demoBlocks() {
  std::string text;
  for (int i = 0; i < 15; ++i) {
    const std::string n = std::to_string(i), b = std::to_string(100 + 400 * i);
    const auto v = [&](int offset) { return std::to_string(100 + 400 * i + offset); };
    text += "SUBROUTINE_BLOCK SBR_" + n + ":SBR" + n + "\nBEGIN\nNetwork 1\nLD SM0.0\n";
    if (i % 5 == 4)
      text += "A I1.0\n= M10." + std::to_string(i / 5) + "\n";
    else if (i % 2 == 0)
      text += "ITD AIW" + std::to_string(2 * i) + ", VD" + b + "\nDTR VD" + b + ", VD" + b + "\n/R 32000.0, VD" + b +
              "\nMOVR VD" + b + ", VD" + v(4) + "\nSQRT VD" + v(4) + ", VD" + v(8) + "\n*R VD" + v(4) + ", VD" + v(8) +
              "\n+R VD" + v(8) + ", VD" + v(12) + "\nNetwork 2\nLDR> VD" + v(12) + ", 50.0\nS M" + n + ".0, 1\n";
    else
      text += "ITA IW0, VB" + b + ", 0\nSCPY VB" + v(40) + ", VB" + v(100) + "\nSCAT VB" + v(40) + ", VB" + v(100) +
              "\nSLEN VB" + v(100) + ", VB" + v(300) + "\nNetwork 2\nLDS= VB" + v(100) + ", VB" + v(40) + "\n= M" + n +
              ".1\n";
    text += "END_SUBROUTINE_BLOCK\n";
  }
  for (int i = 0; i < 2; ++i) {
    const std::string n = std::to_string(i);
    text += "INTERRUPT_BLOCK INT_" + n + ":INT" + n + "\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW" +
            std::to_string(8000 + 2 * i) + "\n+R 1.5, VD" + std::to_string(112 + 800 * i) + "\nEND_INTERRUPT_BLOCK\n";
  }
  return text;
}

TEST(OwnRuns, ComeInTimeWhateverHasToBeEncoded) {
  // Q0.3 is on in the first scan. The limit is what users give to a first look.
  std::string calls =
      "Network 1\nLD SM0.0\n= Q0.3\nNetwork 2\nLD SM0.1\nATCH INT0, 0\nATCH INT1, 10\nMOVB 50, "
      "SMB34\nENI\n";
  for (int i = 0; i < 15; ++i)
    calls += "Network " + std::to_string(3 + i) + "\nLD SM0.0\nCALL SBR" + std::to_string(i) + "\n";
  const ProgramInput input = inputOf("//@ reach lamp: Q0.3\n", calls, demoBlocks());
  for (const double limit : {2.0, 8.0, 12.0}) {
    const ProofRun run = prove(input.program, input.properties, usualOptions(limit));
    EXPECT_EQ(outcomeOf(run, "lamp"), Outcome::Reachable) << limit;
  }
}

}  // namespace
}  // namespace rungproof::test
