// A line that cannot be read: whatever it may have been, no rule speaks because it is missing. Each instruction of each
// good example, and of programs in the style of real ones, is spoilt in turn; what is found then must be found in the
// intact program too.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "analysis/lint/lint.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

std::set<std::string> rulesOn(const Linted& linted) {
  std::set<std::string> rules;
  for (const Finding& finding : runRules(*linted.facts, RuleSelection(), {})) rules.insert(finding.rule);
  return rules;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The program with one line replaced by something that is no instruction; empty if that line is none.
std::string spoilt(const std::vector<std::string>& lines, std::size_t at) {
  static const std::set<std::string> structure{
      "Network", "ORGANIZATION_BLOCK", "SUBROUTINE_BLOCK", "INTERRUPT_BLOCK", "BEGIN",
      "VAR",     "VAR_INPUT",          "VAR_OUTPUT",       "END_VAR"};
  std::string word;
  std::istringstream(lines[at]) >> word;
  const std::string head = word.substr(0, word.find('='));
  if (word.empty() || word.starts_with("//") || word.starts_with("END_") || structure.contains(word) ||
      head == "TITLE" || lines[at].find(':') != std::string::npos)
    return {};
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) text += (i == at ? "FROB I0.0" : lines[i]) + "\n";
  return text;
}

void expectSilence(const std::string& text, const std::function<std::unique_ptr<Linted>(const std::string&)>& read) {
  const std::set<std::string> intact = rulesOn(*read(text));
  const std::vector<std::string> lines = linesOf(text);
  for (std::size_t at = 0; at < lines.size(); ++at) {
    const std::string changed = spoilt(lines, at);
    if (changed.empty()) continue;
    for (const std::string& rule : rulesOn(*read(changed)))
      EXPECT_TRUE(intact.contains(rule)) << rule << " speaks once '" << lines[at] << "' cannot be read in\n" << text;
  }
}

class UnreadExample : public ::testing::TestWithParam<const Rule*> {};

TEST_P(UnreadExample, GivesNoRuleACause) {
  const Rule& rule = *GetParam();
  const Target target{*cpuNamed(rule.exampleCpu), Edition::Edition2004};
  expectSilence(std::string(rule.good),
                [&](const std::string& text) { return std::make_unique<Linted>(text, target, rule.exampleSymbols); });
}

std::vector<const Rule*> rulesWithGoodExamples() {
  std::vector<const Rule*> rules;
  for (const Rule* rule : allRules()) {
    if (rule->check != nullptr && !rule->good.empty()) rules.push_back(rule);
  }
  return rules;
}
INSTANTIATE_TEST_SUITE_P(Rules, UnreadExample, ::testing::ValuesIn(rulesWithGoodExamples()),
                         [](const auto& info) { return std::string(info.param->id); });

TEST(UnreadLine, GivesNoRuleACauseInWholePrograms) {
  for (const char* name : {"data/order_stack", "data/pallet_queue", "data/average", "data/tank_pid", "data/hsc_batch",
                           "interlocks/reversing", "interlocks/hoist", "sequences/bag_filter", "timers/blinker",
                           "defects/swapped_parameters", "defects/interrupt_byte"}) {
    std::ifstream stream(std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/" + name + ".awl");
    std::ostringstream text;
    text << stream.rdbuf();
    ASSERT_FALSE(text.str().empty()) << name;
    expectSilence(text.str(), [](const std::string& program) { return std::make_unique<Linted>(program); });
  }
}

}  // namespace
}  // namespace rungproof::testing
