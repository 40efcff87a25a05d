// Every rule with a check is run on its own examples: the bad one must give the rule, the good one must not, and
// both must be readable programs. A bad example may break other rules too, a good one must be free of errors.
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

class RuleExample : public ::testing::TestWithParam<const Rule*> {};

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "\n  " + line;
  return text;
}

TEST_P(RuleExample, BadExampleGivesTheRule) {
  const Rule& rule = *GetParam();
  const Linted bad = Linted::example(rule, rule.bad);
  EXPECT_FALSE(bad.of(rule.id).empty()) << rule.bad;
}

TEST_P(RuleExample, GoodExampleIsSilent) {
  const Rule& rule = *GetParam();
  const Linted good = Linted::example(rule, rule.good);
  EXPECT_FALSE(hasReadErrors(good.program)) << rule.good;
  EXPECT_TRUE(good.of(rule.id).empty()) << rule.good << joined(good.messages(rule.id));
  const std::vector<std::string> errors = good.all(Severity::Error);
  EXPECT_TRUE(errors.empty()) << rule.good << joined(errors);
}

TEST_P(RuleExample, FindingsAreComplete) {
  const Rule& rule = *GetParam();
  const Linted bad = Linted::example(rule, rule.bad);
  for (const Finding& finding : bad.of(rule.id)) {
    EXPECT_FALSE(finding.message.empty());
    EXPECT_FALSE(finding.help.empty()) << finding.message;
    EXPECT_GT(finding.span.length, 0U) << finding.message;
    EXPECT_EQ(finding.message.find("????"), std::string::npos) << finding.message;
  }
}

std::vector<const Rule*> rulesWithExamples() {
  std::vector<const Rule*> rules;
  for (const Rule* rule : allRules()) {
    if (rule->check != nullptr) rules.push_back(rule);
  }
  return rules;
}

INSTANTIATE_TEST_SUITE_P(Rules, RuleExample, ::testing::ValuesIn(rulesWithExamples()),
                         [](const auto& info) { return std::string(info.param->id); });

}  // namespace
}  // namespace rungproof::testing
