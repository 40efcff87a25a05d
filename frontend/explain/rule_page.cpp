// The page of a rule.
#include "frontend/explain/rule_page.hpp"

#include <fmt/core.h>

#include "frontend/text/columns.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

void appendProgram(std::string& text, std::string_view program) {
  while (!program.empty()) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    text += end == 0 ? std::string("\n") : fmt::format("      {}\n", program.substr(0, end));
    program.remove_prefix(std::min(end + 1, program.size()));
  }
}

void appendSection(std::string& text, const Paint& paint, std::string_view title, std::string_view body) {
  if (body.empty()) return;
  text += fmt::format("\n  {}\n", paint.bold(title));
  appendParagraph(text, body, 4);
}

std::string_view fixText(FixClass fix) {
  return fix == FixClass::Safe ? "safe" : fix == FixClass::Unsafe ? "unsafe" : "none";
}

}  // namespace

std::string_view needsText(Needs needs) {
  switch (needs) {
    case Needs::Text: return "text and tables";
    case Needs::Flow: return "data flow";
    case Needs::FlowThenSolver: return "data flow; the solver confirms under --prove";
    default: return "the solver; runs under --prove";
  }
}

std::string dialectsText(Dialects dialects) {
  std::string text;
  for (const auto& [set, name] :
       {std::pair{dialect::S7200, "S7-200"}, {dialect::S7300, "S7-300/400"}, {dialect::Iec, "IEC 61131-3"}}) {
    if ((dialects & set) != 0) text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
  }
  return text;
}

std::string rulePage(const Rule& rule, const Paint& paint) {
  std::string text = fmt::format("{}: {}\n\n", paint.bold(rule.id), paint.bold(rule.title));
  std::vector<TextRow> rows = {
      {"Severity", std::string(severityName(rule.severity))},
      {"Needs", fmt::format("{} ({})", needsName(rule.needs), needsText(rule.needs))},
      {"Dialects", dialectsText(rule.dialects)},
      {"Status", fmt::format("{} since {}, {} by default", rule.status == RuleStatus::Stable ? "stable" : "preview",
                             rule.since, rule.enabledByDefault ? "on" : "off")}};
  if (rule.fix != FixClass::None) rows.push_back({"Fix", std::string(fixText(rule.fix))});
  if (!rule.manual.empty()) rows.push_back({"Manual", manualPlace(rule.manual)});
  if (!rule.peers.empty()) rows.push_back({"Elsewhere", std::string(rule.peers)});
  appendRows(text, rows, 14);
  appendSection(text, paint, "Detects", rule.detects);
  appendSection(text, paint, "Why it matters", rule.why);
  if (!rule.exampleSymbols.empty()) {
    text += fmt::format("\n  {}\n", paint.bold("Symbol table of the examples"));
    appendProgram(text, rule.exampleSymbols);
  }
  if (!rule.bad.empty()) {
    text += fmt::format(
        "\n  {}\n", paint.bold(rule.namesCpu() ? fmt::format("Reported on a CPU {}", rule.exampleCpu) : "Reported"));
    appendProgram(text, rule.bad);
  }
  if (!rule.good.empty()) {
    text += fmt::format("\n  {}\n", paint.bold("Not reported"));
    appendProgram(text, rule.good);
  }
  appendSection(text, paint, "Known false positives", rule.falsePositives);
  if (!rule.options.empty()) {
    text += fmt::format("\n  {}\n", paint.bold(fmt::format("Options, in rungproof.toml under [rules.{}]", rule.id)));
    for (const RuleOption& option : rule.options) {
      appendParagraph(
          text,
          fmt::format("{} = {} ({} to {}): {}", option.name, option.initial, option.low, option.high, option.meaning),
          4);
    }
  }
  if (rule.id.starts_with("SUP")) return text;
  text += fmt::format("\n  {}\n    // rungproof: allow {} REASON\n", paint.bold("To silence it at one place"), rule.id);
  return text;
}

Json ruleJson(const Rule& rule) {
  Json json = {{"id", rule.id},
               {"title", rule.title},
               {"group", rule.group()},
               {"severity", severityName(rule.severity)},
               {"needs", needsName(rule.needs)},
               {"dialects", dialectsText(rule.dialects)},
               {"status", rule.status == RuleStatus::Stable ? "stable" : "preview"},
               {"since", rule.since},
               {"default", rule.enabledByDefault},
               {"fix", fixText(rule.fix)},
               {"detects", rule.detects},
               {"why", rule.why},
               {"manual", rule.manual},
               {"bad", rule.bad},
               {"good", rule.good},
               {"example_cpu", rule.exampleCpu},
               {"example_symbols", rule.exampleSymbols},
               {"false_positives", rule.falsePositives},
               {"peers", rule.peers}};
  json["options"] = Json::array();
  for (const RuleOption& option : rule.options) {
    json["options"].push_back({{"name", option.name},
                               {"low", option.low},
                               {"high", option.high},
                               {"default", option.initial},
                               {"meaning", option.meaning}});
  }
  return json;
}

}  // namespace rungproof
