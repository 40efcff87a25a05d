// Whoever runs rules leaves out those that do not know the program's dialect.
#include <gtest/gtest.h>

#include "analysis/lint/lint.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

void alwaysSpeaks(const Facts& facts, FindingSink& sink) { sink.report(facts.instruction(0).span, "here"); }

TEST(RuleDialects, OnlyRulesThatKnowTheDialectAreRun) {
  const Linted linted("Network 1\nLD I0.0\n= Q0.0\n");
  const Rule ours{
      .id = "OUR001", .title = "ours", .detects = "", .why = "", .dialects = dialect::S7200, .check = alwaysSpeaks};
  const Rule theirs{
      .id = "OUR002", .title = "theirs", .detects = "", .why = "", .dialects = dialect::S7300, .check = alwaysSpeaks};
  const Rule both{
      .id = "OUR003", .title = "both", .detects = "", .why = "", .dialects = dialect::Every, .check = alwaysSpeaks};
  const std::vector<const Rule*> rules = {&ours, &theirs, &both};
  const std::vector<Finding> findings = runRules(*linted.facts, {}, {}, rules);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].rule, "OUR001");
  EXPECT_EQ(findings[1].rule, "OUR003");
}

}  // namespace
}  // namespace rungproof::testing
