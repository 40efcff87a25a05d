// Each technique switched off: a verdict may become UNKNOWN, it never becomes another one. On small programs of the
// corpus of several kinds - interlocks, timers, shift registers, counters - against what their heads say, which comes
// from reasoning. And what is counted of each technique.
#include <set>

#include "analysis/proof/prover.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

/// Programs that all techniques together settle within a second.
std::vector<fs::path> smallPrograms() {
  const fs::path corpus = fs::path(RUNGPROOF_SOURCE_DIR) / "corpus";
  std::vector<fs::path> files;
  for (const char* name : {"interlocks/reversing_faulty.awl", "timers/blinker.awl", "timers/staircase_light.awl",
                           "data/shift_track.awl", "simaticml/parcel_counter.xml"})
    files.push_back(corpus / name);
  return files;
}

std::string verdictOf(const ProofResult& result) {
  switch (result.outcome) {
    case Outcome::Proved: return "PROVED";
    case Outcome::Violated: return "VIOLATED";
    case Outcome::Reachable: return "REACHABLE";
    case Outcome::Unreachable: return "UNREACHABLE";
    case Outcome::Vacuous: return "VACUOUS";
    default: return "";  // undecided
  }
}

class WithoutTechnique : public testing::TestWithParam<TechniqueInfo> {};

TEST_P(WithoutTechnique, NoVerdictBecomesAnother) {
  std::size_t decided = 0, undecided = 0;
  for (const fs::path& file : smallPrograms()) {
    const std::map<std::string, std::string> expected = trueVerdicts(file);
    ASSERT_FALSE(expected.empty()) << file;
    const ProgramInput input = corpusInput(file);
    ProverOptions options = proverOptions(file);
    options.timeout = 1;
    options.techniques.leaveOut(GetParam().id);
    const ProofRun run = prove(input.program, input.properties, options);
    EXPECT_TRUE(run.disagreements.empty()) << file;
    EXPECT_EQ(run.techniques[static_cast<std::size_t>(GetParam().id)].asked, 0U) << file << ": it was used";
    for (const ProofResult& result : run.results) {
      const std::string verdict = verdictOf(result);
      (verdict.empty() ? undecided : decided) += 1;
      const auto known = expected.find(result.property.name);
      if (verdict.empty() || known == expected.end()) continue;
      EXPECT_EQ(verdict, known->second) << file << ": " << result.property.name;
    }
  }
  EXPECT_GT(decided, undecided) << "the other techniques settle most of these";
}

INSTANTIATE_TEST_SUITE_P(All, WithoutTechnique, testing::ValuesIn(techniqueTable().begin(), techniqueTable().end()),
                         [](const auto& info) {
                           std::string name(info.param.name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

// With every engine and every shortcut off nothing is settled, and the search comes to its end.
TEST(Techniques, NoneLeavesEverythingOpen) {
  const ProgramInput input = inputOf("//@ prove together: never Q0.0 and Q0.1\n",
                                     "Network 1\nLD I0.0\nO Q0.0\nAN Q0.1\n= Q0.0\nNetwork 2\nLD I0.1\nO "
                                     "Q0.1\nAN Q0.0\n= Q0.1\n");
  ProverOptions options = usualOptions(1);
  EXPECT_EQ(outcomeOf(prove(input.program, input.properties, options), "together"), Outcome::Proved);
  for (const TechniqueInfo& technique : techniqueTable()) options.techniques.leaveOut(technique.id);
  const ProofRun run = prove(input.program, input.properties, options);
  EXPECT_EQ(outcomeOf(run, "together"), Outcome::Unknown);
  for (const TechniqueUse& use : run.techniques) EXPECT_EQ(use.asked, 0U);
}

TEST(Techniques, AreKeptOnlyWhereTheyAreOn) {
  Techniques techniques;
  techniques.leaveOut(Technique::Bmc);
  techniques.keepOnly({Technique::Bmc, Technique::Simulation});
  for (const TechniqueInfo& technique : techniqueTable())
    EXPECT_EQ(techniques.has(technique.id), technique.id == Technique::Simulation) << technique.name;
}

// Somebody has settled what is settled.
TEST(Techniques, AreCounted) {
  const ProgramInput input = inputOf("//@ prove follows: Q0.0 implies I0.0\n//@ reach on: Q0.0\n",
                                     "Network 1\nLD I0.0\nO Q0.0\nA I0.0\n= Q0.0\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions(5));
  EXPECT_EQ(outcomeOf(run, "follows"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "on"), Outcome::Reachable);
  std::size_t settled = 0;
  for (const TechniqueUse& use : run.techniques) {
    settled += use.settled;
    EXPECT_TRUE(use.settled == 0 || use.asked > 0);
  }
  EXPECT_GE(settled, 2U);
}

TEST(Techniques, HaveNames) {
  std::set<std::string_view> names;
  for (const TechniqueInfo& technique : techniqueTable()) {
    EXPECT_TRUE(names.insert(technique.name).second) << technique.name;
    EXPECT_FALSE(technique.summary.empty()) << technique.name;
    EXPECT_EQ(techniqueNamed(technique.name)->id, technique.id);
  }
  EXPECT_EQ(techniqueNamed("IC3"), nullptr);
}

}  // namespace
}  // namespace rungproof::test
