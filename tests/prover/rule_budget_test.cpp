// What a question of a rule gets of the processor: runs with held inputs first, which find what waits for a long count,
// then engines for a moment.
#include <gtest/gtest.h>

#include "frontend/linting/solver_rules.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

// The comparison makes a difference when VW0 is 32000 and I0.0 comes once more. Each count takes an edge, which takes
// two scans, so the run has more than 64,000; inputs that take turns make it.
TEST(RuleBudget, WaitsForALongCount) {
  const ProgramInput input = inputOf("",
                                     "Network 1\nLD I0.0\nEU\nAW< VW4, 6\nAW< VW0, 32000\nINCW VW0\nINCW VW4\n"
                                     "Network 2\nLD I0.1\nEU\nAW> VW4, 0\nDECW VW4\n"
                                     "Network 3\nLDW< VW0, 32000\n= Q0.0\n");
  std::vector<Finding> findings;
  const OpenQuestions open = settleBySolver(
      input, usualOptions(10), [](std::string_view rule) { return rule == "LOG002"; }, findings);
  EXPECT_EQ(open.count, 0U) << (open.lines.empty() ? "" : open.lines.front());
  EXPECT_TRUE(findings.empty());
  EXPECT_GT(open.techniques[static_cast<std::size_t>(Technique::HeldInputs)].settled, 0U);
}

}  // namespace
}  // namespace rungproof::test
