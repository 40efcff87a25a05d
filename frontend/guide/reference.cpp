// Reference pages: commands, rules, configuration, CPUs, choices, words.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/rule.hpp"
#include "frontend/acceptance/page_text.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/cli/help.hpp"
#include "frontend/explain/idea_page.hpp"
#include "frontend/explain/rule_page.hpp"
#include "frontend/guide/site.hpp"
#include "frontend/settings/code_list.hpp"
#include "frontend/text/safe_text.hpp"
#include "ir/machine/choices.hpp"

namespace rungproof {

namespace {

/// The text of a table as a sentence, with manual references by title.
std::string sentenceOf(std::string_view text) {
  std::string result = withManualTitles(text);
  const bool isWord = result.size() > 1 && std::islower(static_cast<unsigned char>(result[0])) != 0;
  if (isWord) result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
  if (!result.empty() && result.back() != '.') result += '.';
  return xmlText(result);
}

std::string rowsHtml(const std::vector<TextRow>& rows) {
  std::string text = "<table class=\"wide cards\"><tbody>\n";
  for (const TextRow& row : rows)
    text += fmt::format("<tr><td><code>{}</code></td><td>{}</td></tr>\n", xmlText(row.left), xmlText(row.right));
  return text + "</tbody></table>\n";
}

ReferencePage commandsPage() {
  std::string html =
      "<p>Every command shows the same with <code>rungproof COMMAND --help</code>, and has a page for man.</p>\n<ul>\n";
  for (const Command* command : allCommands())
    html += fmt::format("<li><a href=\"#{0}\">{0}</a>: {1}</li>\n", command->name, xmlText(command->summary));
  html += "</ul>\n<h2 id=\"exit-codes\">Exit codes</h2>\n" + rowsHtml(exitCodeRows());
  for (const Command* command : allCommands()) {
    ArgumentTable table;
    const Action action = command->setup(table);
    html += fmt::format("<h2 id=\"{0}\">{0}</h2>\n<p>{1}</p>\n<pre>rungproof {0} [OPTIONS] {2}</pre>\n", command->name,
                        sentenceOf(command->summary), xmlText(command->usage));
    if (!command->details.empty()) {
      html += "<pre>" + xmlText(command->details) + (command->details.ends_with('\n') ? "" : "\n") + "</pre>\n";
    }
    for (const HelpSection& section : helpSections(*command, table))
      html += fmt::format("<h3>{}</h3>\n", xmlText(section.title)) + rowsHtml(section.rows);
  }
  return {"commands", "Commands", html};
}

std::string preformatted(std::string_view title, std::string_view program) {
  if (program.empty()) return {};
  std::string text = fmt::format("<p class=\"quiet\">{}</p>\n<pre>", title);
  return text + xmlText(program) + "</pre>\n";
}

std::string ruleHtml(const Rule& rule) {
  std::string html = fmt::format("<h3 id=\"{0}\">{0}: {1}</h3>\n<p>{2}</p>\n<p>{3}</p>\n", rule.id, xmlText(rule.title),
                                 sentenceOf(rule.detects), sentenceOf(rule.why));
  std::vector<TextRow> rows = {{"severity", std::string(severityName(rule.severity))},
                               {"needs", std::string(needsText(rule.needs))},
                               {"dialects", dialectsText(rule.dialects)},
                               {"by default", rule.enabledByDefault ? "on" : "off"}};
  if (!rule.manual.empty()) rows.push_back({"manual", withManualTitles(rule.manual)});
  if (!rule.falsePositives.empty()) rows.push_back({"false positives", withManualTitles(rule.falsePositives)});
  for (const RuleOption& option : rule.options)
    rows.push_back(
        {fmt::format("[rules.{}] {}", rule.id, option.name),
         fmt::format("{} (from {} to {}, default {})", option.meaning, option.low, option.high, option.initial)});
  html += "<dl class=\"facts\">\n";
  for (const TextRow& row : rows)
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", xmlText(row.left), xmlText(row.right));
  html += "</dl>\n";
  const std::string where = rule.namesCpu() ? fmt::format(" (CPU {})", rule.exampleCpu) : "";
  return html + preformatted("Symbol table of the examples", rule.exampleSymbols) +
         preformatted("Reported" + where, rule.bad) + preformatted("Not reported" + where, rule.good);
}

ReferencePage rulesPage() {
  std::string html =
      "<p>The same page of one rule: <code>rungproof explain CODE</code>. A finding is silenced at its place by a "
      "comment "
      "<code>// rungproof: allow CODE REASON</code>.</p>\n";
  for (const RuleGroup& group : ruleGroups()) {
    html += fmt::format("<h2 id=\"{0}\">{0}: {1}</h2>\n", group.prefix, xmlText(group.title));
    for (const Rule* rule : allRules()) {
      if (rule->group() == group.prefix) html += ruleHtml(*rule);
    }
  }
  html += "<h2 id=\"messages-of-the-readers\">Messages of the readers</h2>\n";
  std::vector<TextRow> rows;
  for (const Code& code : allCodes()) {
    if (!code.isRule) rows.push_back({std::string(code.id), fmt::format("{}. {}", code.title, code.help)});
  }
  return {"rules", "Rules", html + rowsHtml(rows)};
}

ReferencePage configurationPage() {
  std::string html =
      "<p>The file <code>rungproof.toml</code> in the folder of a project, or above it, holds its options. Each option "
      "of "
      "the command line that this table names is a key; <code>rungproof config</code> shows every value with the place "
      "it "
      "comes from. The command line wins over the file. Paths in the file start at the file.</p>\n"
      "<table class=\"wide "
      "cards\"><thead><tr><th>Key</th><th>Values</th><th>Default</th><th>Meaning</th></tr></thead><tbody>\n";
  for (const OptionInfo& info : optionTable()) {
    if (!info.inConfig || info.group == option_group::Hidden) continue;
    const std::string values = info.arity == Arity::Flag ? "true, false"
                               : permittedWords(info.value).empty()
                                   ? std::string(info.value)
                                   : fmt::format("{}", fmt::join(permittedWords(info.value), ", "));
    html += fmt::format(
        "<tr><td><code>{}</code></td><td data-label=\"Values\">{}{}</td><td "
        "data-label=\"Default\">{}</td><td>{}</td></tr>\n",
        info.name, xmlText(values), info.arity == Arity::List ? " (list)" : "", xmlText(info.initial),
        xmlText(info.help));
  }
  html += "</tbody></table>\n<h2 id=\"tables\">Tables and other keys</h2>\n";
  html += rowsHtml({{"inputs", "programs of a command line that names none"},
                    {"extend", "a configuration that is read first"},
                    {"[properties] files", "property files that belong to every program of the project"},
                    {"[per-file-ignores]", "\"legacy/*\" = [\"STY\"]: codes that do not count in these files"},
                    {"[rules.CODE] severity", "error, warning or note in place of the rule's own"},
                    {"[rules.CODE] OPTION", "an option of the rule; see its page"},
                    {"[external]", "ranges that a panel or a network writes, by who writes them"},
                    {"[choices] KEY", "a reading of a point that the manual leaves open; see Choices"}});
  return {"configuration", "Configuration", html};
}

ReferencePage cpusPage() {
  std::string html =
      "<p>The CPU is chosen with <code>--cpu</code> or the key <code>cpu</code>. The figures decide which addresses, "
      "instructions and interrupt events a program may use; <code>rungproof explain ADDRESS --cpu NAME</code> shows "
      "one "
      "address on one CPU.</p>\n<div "
      "class=\"scroll\"><table><thead><tr><th>CPU</th><th>Family</th><th>Inputs</th><th>Outputs</th>"
      "<th>Subroutines</th><th>PID loops</th><th>Ports</th><th>Pulse outputs</th><th>Clock</th><th>Logic "
      "stack</th><th>Editions</th>"
      "</tr></thead><tbody>\n";
  for (const CpuRow& row : cpu_rows::rows) {
    std::string editions(editionName(row.editions[0]));
    if (row.editions[1] != row.editions[0]) editions += fmt::format(", {}", editionName(row.editions[1]));
    const CpuFeatures& f = row.features;
    html += fmt::format(
        "<tr id=\"{0}\"><td>{0}</td><td>{1}</td><td class=\"number\">{2}</td><td class=\"number\">{3}</td><td "
        "class=\"number\">{4}</td><td class=\"number\">{5}</td><td class=\"number\">{6}</td><td "
        "class=\"number\">{7}</td>"
        "<td>{8}</td><td class=\"number\">{9}</td><td>{10}</td></tr>\n",
        row.name, row.series == Series::Smart ? "S7-200 SMART" : "S7-200", row.onBoard.inputs, row.onBoard.outputs,
        f.subroutines, f.pidLoops, f.ports, f.pulseOutputs, f.clockBuiltIn ? "built in" : "module or none",
        f.stackLevels, editions);
  }
  return {"cpus", "CPUs", html + "</tbody></table></div>\n"};
}

ReferencePage choicesPageOfGuide() {
  std::string html =
      "<p>The manual leaves these points open. <code>sim</code> takes the first reading; a proof covers every reading "
      "of "
      "a point that nobody chose, except for facts of the plant, of which it takes the value in force. A choice is "
      "made "
      "with <code>--choice KEY=VALUE</code> or under <code>[choices]</code>.</p>\n"
      "<table class=\"wide cards\"><thead><tr><th>Key</th><th>Readings</th><th>What is open</th></tr></thead><tbody>\n";
  for (const ChoiceInfo& info : choiceTable) {
    std::string values;
    for (const std::string_view value : info.values) {
      if (!value.empty()) values += fmt::format("{}<code>{}</code>", values.empty() ? "" : ", ", value);
    }
    html += fmt::format("<tr id=\"{0}\"><td><code>{0}</code>{1}</td><td>{2}</td><td>{3} ({4})</td></tr>\n", info.key,
                        info.kind == ChoiceKind::Fact ? " (fact)" : "", values, xmlText(withManualTitles(info.why)),
                        xmlText(withManualTitles(info.manual)));
  }
  return {"choices", "Choices", html + "</tbody></table>\n"};
}

ReferencePage wordsPage() {
  std::string html =
      "<p>Verdicts, methods and other words of the reports; <code>rungproof explain \"one scan\"</code> shows "
      "one.</p>\n<dl>\n";
  for (const Idea& idea : ideas())
    html += fmt::format("<dt id=\"{}\"><b>{}</b></dt><dd>{}</dd>\n", xmlText(placeName(idea.name)), xmlText(idea.name),
                        xmlText(withManualTitles(idea.text)));
  return {"words", "Words of the reports", html + "</dl>\n"};
}

}  // namespace

std::vector<ReferencePage> referencePages() {
  return {commandsPage(), rulesPage(), configurationPage(), cpusPage(), choicesPageOfGuide(), wordsPage()};
}

}  // namespace rungproof
