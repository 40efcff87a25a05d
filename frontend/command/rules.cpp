// `rungproof rules`: the list of rules as text, JSON or Markdown.
#include <fmt/core.h>

#include "frontend/command.hpp"
#include "frontend/explain/rule_page.hpp"
#include "frontend/files/json.hpp"
#include "frontend/settings/code_list.hpp"

namespace rungproof {

namespace {

std::vector<const Rule*> rulesOf(const RuleGroup& group) {
  std::vector<const Rule*> rules;
  for (const Rule* rule : allRules()) {
    if (rule->group() == group.prefix) rules.push_back(rule);
  }
  return rules;
}

std::string listTextOfRules(const Paint& paint) {
  std::string text;
  std::size_t count = 0;
  for (const RuleGroup& group : ruleGroups()) {
    const std::vector<const Rule*> rules = rulesOf(group);
    if (rules.empty()) continue;
    text += fmt::format("{} {}\n", paint.bold(group.prefix), paint.bold(group.title));
    for (const Rule* rule : rules) {
      text += fmt::format("  {}  {:<7}  {:<3}  {}{}\n", rule->id, severityName(rule->severity), needsName(rule->needs),
                          rule->title, rule->enabledByDefault ? "" : " (off by default)");
      ++count;
    }
    text += '\n';
  }
  text += paint.bold("SYN, PRP Reading programs and properties") + "\n";
  for (const Code& code : allCodes()) {
    if (!code.isRule)
      text += fmt::format("  {}  {:<7}  {:<3}  {}\n", code.id, severityName(code.severity), "", code.title);
  }
  text += '\n';
  text += fmt::format(
      "{} rules. Needs: T text and tables, F data flow, F>Z the solver confirms under --prove, Z solver only.\n"
      "'rungproof explain CODE' shows a rule's page.\n",
      count);
  return text;
}

std::string listMarkdown() {
  std::string text = "# Rules\n";
  for (const RuleGroup& group : ruleGroups()) {
    const std::vector<const Rule*> rules = rulesOf(group);
    if (rules.empty()) continue;
    text +=
        fmt::format("\n## {} {}\n\n| Id | Title | Severity | Needs | Detects | Manual |\n|---|---|---|---|---|---|\n",
                    group.prefix, group.title);
    for (const Rule* rule : rules) {
      text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", rule->id, rule->title, severityName(rule->severity),
                          needsName(rule->needs), rule->detects, rule->manual);
    }
  }
  return text;
}

std::string listJson() {
  Json json = Json::array();
  for (const RuleGroup& group : ruleGroups()) {
    for (const Rule* rule : rulesOf(group)) json.push_back(ruleJson(*rule));
  }
  return json.dump(2) + "\n";
}

Action setUpRules(ArgumentTable&) {
  return [](Context& context) {
    Exit exit = Exit::Clean;
    for (const OutputRequest& output : context.outputs) {
      const Paint paint{context.color && output.file.empty()};
      const std::string text = output.name == "json"       ? listJson()
                               : output.name == "markdown" ? listMarkdown()
                                                           : listTextOfRules(paint);
      if (!context.write(output, text)) exit = Exit::Failed;
    }
    return exit;
  };
}

}  // namespace

extern constexpr Command rulesCommand = {
    .name = "rules",
    .usage = "",
    .summary = "list the rules",
    .details = "",
    .shows = option_group::Output,
    .needsNoConfig = true,
    .formats = "text|json|markdown",
    .setup = setUpRules,
};

}  // namespace rungproof
