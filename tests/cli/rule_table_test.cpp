// The table of rules: ids are unique and well formed, pages complete, selection by prefixes, every list names them all.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/lint/lint.hpp"
#include "frontend/settings/code_list.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

TEST(RuleTable, IdsAreUniqueAndSorted) {
  std::set<std::string_view> ids;
  for (const Code& code : allCodes()) EXPECT_TRUE(ids.insert(code.id).second) << code.id;
  EXPECT_TRUE(
      std::is_sorted(allRules().begin(), allRules().end(), [](const Rule* a, const Rule* b) { return a->id < b->id; }));
}

TEST(RuleTable, PagesAreComplete) {
  for (const Rule* rule : allRules()) {
    SCOPED_TRACE(rule->id);
    ASSERT_EQ(rule->id.size(), 6u);
    const auto& groups = ruleGroups();
    EXPECT_TRUE(std::any_of(groups.begin(), groups.end(),
                            [&](const RuleGroup& group) { return group.prefix == rule->group(); }));
    EXPECT_FALSE(rule->title.empty());
    EXPECT_FALSE(rule->detects.empty());
    EXPECT_FALSE(rule->why.empty());
    EXPECT_NE(rule->title.back(), '.');
    EXPECT_NE(rule->dialects, 0);
    if (rule->check != nullptr) {
      EXPECT_FALSE(rule->bad.empty());
      EXPECT_FALSE(rule->good.empty());
    }
    for (const RuleOption& option : rule->options) {
      EXPECT_LE(option.low, option.initial) << option.name;
      EXPECT_LE(option.initial, option.high) << option.name;
    }
  }
}

// What a rule asks and what becomes of the answers fits together, and an explanation names a rule that exists.
TEST(RuleTable, QuestionsAndAnswersFitTogether) {
  for (const Rule* rule : allRules()) {
    SCOPED_TRACE(rule->id);
    const RuleAsks& ask = rule->ask;
    const int ways = (ask.program != nullptr ? 1 : 0) + (ask.box != nullptr ? 1 : 0) + (ask.hazards.empty() ? 0 : 1);
    EXPECT_EQ(ways, ask.in == 0 ? 0 : 1);
    EXPECT_TRUE(ask.cost >= 1 && ask.cost <= 5) << ask.cost;
    EXPECT_TRUE(!ask.wantsYes || !rule->tell.advice.empty()) << "'proved for every run' and no advice";
    EXPECT_TRUE(!ask.onlySettles || rule->check != nullptr) << "nothing to be settled";
    const bool speaks = ask.in != 0 || rule->tell.property != nullptr;
    EXPECT_TRUE(rule->needs != Needs::Solver || speaks) << "only the prover can answer, and it is not asked";
    for (const Explanation& explanation : rule->explainedBy)
      EXPECT_NE(ruleNamed(explanation.rule), nullptr) << explanation.rule;
  }
}

TEST(RuleTable, EveryRuleHasAPageAndStandsInEveryList) {
  const std::string text = test::run({"rules"}).out;
  const std::string markdown = test::run({"rules", "--format", "markdown"}).out;
  const nlohmann::json json = nlohmann::json::parse(test::run({"rules", "--format", "json"}).out);
  EXPECT_EQ(json.size(), allRules().size());
  for (const Rule* rule : allRules()) {
    const std::string id(rule->id);
    EXPECT_NE(text.find("  " + id + "  "), std::string::npos) << id;
    EXPECT_NE(markdown.find("| " + id + " |"), std::string::npos) << id;
    EXPECT_TRUE(std::any_of(json.begin(), json.end(), [&](const nlohmann::json& row) { return row["id"] == id; }))
        << id;
    const test::ProgramRun page = test::run({"explain", id});
    EXPECT_EQ(page.exit, 0) << id;
    EXPECT_TRUE(page.out.starts_with(id + ": " + std::string(rule->title) + "\n")) << page.out;
  }
}

TEST(RuleTable, EveryReaderMessageHasAPage) {
  for (const Code& code : allCodes()) EXPECT_EQ(test::run({"explain", std::string(code.id)}).exit, 0) << code.id;
}

TEST(RuleSelection, TheLongerPrefixDecides) {
  EXPECT_TRUE(RuleSelection().includes("ADR001", true));
  EXPECT_FALSE(RuleSelection().includes("STY001", false));
  EXPECT_TRUE(RuleSelection({"ADR"}, {}).includes("ADR001", true));
  EXPECT_FALSE(RuleSelection({"ADR"}, {}).includes("OUT001", true));
  EXPECT_TRUE(
      RuleSelection({"STY"}, {}).includes("STY001", false));  // named rules run although they are off by default
  EXPECT_FALSE(RuleSelection({}, {"ADR"}).includes("ADR001", true));
  EXPECT_FALSE(RuleSelection({}, {"ADR"}).includes("STY001", false));
  EXPECT_FALSE(RuleSelection({"ADR"}, {"ADR001"}).includes("ADR001", true));
  EXPECT_TRUE(RuleSelection({"ADR001"}, {"ADR"}).includes("ADR001", true));
  EXPECT_TRUE(RuleSelection({"ALL"}, {"ADR"}).includes("STY001", false));
  EXPECT_FALSE(RuleSelection({"ALL"}, {"ADR"}).includes("ADR001", true));
  EXPECT_FALSE(RuleSelection({"ADR001"}, {"ADR001"}).includes("ADR001", true));
}

}  // namespace
}  // namespace rungproof
