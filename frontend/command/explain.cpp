// `rungproof explain CODE`: the page of a rule, a group, a run-time error, an instruction, or one of the topics.
#include <fmt/core.h>

#include <algorithm>

#include "frontend/command.hpp"
#include "frontend/explain/address_page.hpp"
#include "frontend/explain/idea_page.hpp"
#include "frontend/explain/instruction_page.hpp"
#include "frontend/explain/manual_page.hpp"
#include "frontend/explain/rule_page.hpp"
#include "frontend/explain/step7_address_page.hpp"
#include "frontend/explain/step7_page.hpp"
#include "frontend/files/closest_word.hpp"
#include "frontend/files/json.hpp"
#include "frontend/settings/choice_bundle.hpp"
#include "frontend/settings/code_list.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "frontend/text/columns.hpp"
#include "ir/hazard.hpp"
#include "ir/manual.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7200/special_memory.hpp"
#include "ir/s7300/cpu.hpp"
#include "ir/s7300/dialect.hpp"

namespace rungproof {

namespace {

/// A page in both forms; nothing if the word is no topic.
struct Page {
  std::string text;
  Json json;
};

std::string_view hazardClassText(HazardClass kind) {
  switch (kind) {
    case HazardClass::Fatal: return "fatal: the CPU goes to STOP";
    case HazardClass::NonFatal: return "not fatal: SM4.3 is set, the program goes on";
    default: return "status bit only";
  }
}

Json hazardJson(const HazardInfo& info) {
  return {{"code", info.code}, {"class", hazardClassText(info.kind)}, {"text", info.text}, {"manual", info.manual}};
}

Page hazardsPage(const Paint& paint) {
  Page page{paint.bold("What can go wrong while an instruction runs") + "\n\n", Json::array()};
  std::vector<TextRow> rows;
  for (const HazardInfo& info : hazardTable) {
    rows.push_back({std::string(info.code.empty() ? "-" : info.code),
                    fmt::format("{} ({}; {})", info.text, hazardClassText(info.kind), info.manual)});
    page.json.push_back(hazardJson(info));
  }
  appendRows(page.text, rows, 10);
  return page;
}

Page choicesPage(const Paint& paint, const Settings& settings) {
  Page page{
      paint.bold("Points that the manual leaves open") +
          "\n\nsim reads each in one way, which --choice KEY=VALUE or [choices] changes; proofs cover all readings\n"
          "of a point that is not chosen so, except for facts of the plant.\n",
      Json::array()};
  for (const ChoiceInfo& info : choiceTable) {
    std::string values;
    Json names = Json::array();
    for (std::size_t i = 0; i < info.values.size() && !info.values[i].empty(); ++i) {
      const bool current = settings.choices()[info.choice] == i;
      values += fmt::format("{}{}{}", values.empty() ? "" : ", ", info.values[i], current ? " (chosen)" : "");
      names.push_back(info.values[i]);
    }
    page.text += fmt::format("\n  {}: {}\n", paint.bold(info.key), values);
    appendParagraph(page.text, fmt::format("{}; see {}", info.why, manualPlace(info.manual)), 4);
    page.json.push_back({{"key", info.key},
                         {"values", names},
                         {"chosen", info.values[settings.choices()[info.choice]]},
                         {"why", info.why},
                         {"manual", info.manual}});
  }
  page.text += "\nSeveral at once, as an implementation answers them; what is not known of it stays open:\n";
  for (const ChoiceBundle& one : choiceBundles) {
    std::string values;
    for (const auto& [key, value] : one.choices)
      values += fmt::format("{}{} = {}", values.empty() ? "" : ", ", key, value);
    page.text += fmt::format("\n  {}\n", paint.bold(fmt::format("{}={}", one.key, one.name)));
    appendParagraph(page.text, values, 4);
  }
  return page;
}

std::string_view sourceText(SmSource source) {
  switch (source) {
    case SmSource::Constant: return "always the same";
    case SmSource::Computed: return "set by the CPU from the run";
    case SmSource::FirstScan: return "as the surroundings say in the first scan, 0 in all others; proofs take both";
    case SmSource::Free: return "from outside; proofs take any value in every scan";
    case SmSource::Device: return "written by a device that the program has set going; proofs let it end at any time";
    case SmSource::Program: return "what the program writes";
  }
  return "";
}

std::string rowName(const SmRow& row) {
  const bool isWhole = row.low == 0 && row.high == 7;
  if (isWhole && row.first == row.last) return fmt::format("SMB{}", row.first);
  if (isWhole) return fmt::format("SMB{}-{}", row.first, row.last);
  if (row.low == row.high) return fmt::format("SM{}.{}", row.first, row.low);
  return fmt::format("SM{}.{}-{}", row.first, row.low, row.high);
}

Json rowJson(const SmRow& row) {
  return {{"address", rowName(row)},
          {"text", row.text},
          {"value", sourceText(row.source)},
          {"writable", row.isWritable()},
          {"manual", row.manual}};
}

Page specialMemoryPage(const Target& target, const Paint& paint) {
  Page page{paint.bold("Where the values of special memory come from") + "\n\n", Json::array()};
  std::vector<TextRow> rows;
  for (const SmRow& row : smTable(target)) {
    rows.push_back({rowName(row), fmt::format("{}: {} ({})", row.text, sourceText(row.source), row.manual)});
    page.json.push_back(rowJson(row));
  }
  appendRows(page.text, rows, 13);
  return page;
}

/// "SM0.3", "SMB28": the row of the bit, or of the first bit.
std::optional<Page> specialBitPage(const Target& target, const std::string& word, const Paint& paint) {
  Operand operand;
  if (!readAddress(word, Spelling::International, operand) || operand.area != Area::SM || operand.bit > 7)
    return std::nullopt;
  if (operand.offset > smTable(target).back().last) return std::nullopt;
  const SmRow& row = smRow(target, operand.offset, operand.width == Width::Bit ? operand.bit : 0);
  return Page{
      fmt::format("{}: {}\n\n  {}\n  {}; {}\n", paint.bold(rowName(row)), paint.bold(row.text), sourceText(row.source),
                  row.isWritable() ? "the program may write it" : "read-only", manualPlace(row.manual)),
      rowJson(row)};
}

std::optional<Page> groupPage(std::string_view word, const Paint& paint) {
  for (const RuleGroup& group : ruleGroups()) {
    if (group.prefix != word) continue;
    Page page{fmt::format("{} {}\n\n", paint.bold(group.prefix), paint.bold(group.title)), Json::array()};
    std::vector<TextRow> rows;
    for (const Rule* rule : allRules()) {
      if (rule->group() != word) continue;
      rows.push_back({std::string(rule->id), fmt::format("{}: {}", rule->title, rule->detects)});
      page.json.push_back(ruleJson(*rule));
    }
    appendRows(page.text, rows, 10);
    return page;
  }
  return std::nullopt;
}

/// Lines of at most 92 characters, indented.
std::string wrapped(std::string_view text) {
  std::string result, line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (line.size() + end > 90) {
      result += "  " + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + std::string(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result + "  " + line + "\n";
}

std::optional<Page> familyPage(const std::string& word, const Settings& settings, const Paint& paint) {
  const std::string_view set = settings.text(Opt::Mnemonics);
  const Mnemonics mnemonics = set == "german"          ? Mnemonics::German
                              : set == "international" ? Mnemonics::International
                                                       : Mnemonics::Auto;
  const auto page = step7Page(word, mnemonics, paint);
  return page ? std::optional(Page{page->text, page->json}) : std::nullopt;
}

/// --dialect or --cpu names the S7-300/400.
bool asksForStep7(const Settings& settings) {
  return settings.text(Opt::Dialect).starts_with("s7-3") || settings.text(Opt::Dialect).starts_with("s7-4") ||
         isStep7(settings.target());
}

/// The CPU that is named, or the largest of the family that --dialect names.
Target step7TargetOf(const Settings& settings) {
  if (isStep7(settings.target())) return settings.target();
  return (settings.text(Opt::Dialect) == s7400Dialect.name ? s7400Dialect : s7300Dialect).usual;
}

std::optional<Page> pageOf(const std::string& word, const Settings& settings, const Paint& paint) {
  std::string upper = word;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  if (const Rule* rule = ruleNamed(word)) return Page{rulePage(*rule, paint), ruleJson(*rule)};
  const Target target = asksForStep7(settings) ? step7TargetOf(settings) : settings.target();
  if (isStep7(target)) {
    if (auto page = familyPage(upper, settings, paint)) return page;
    if (auto page = step7AddressPage(target, upper, paint)) return Page{page->text, page->json};
  }
  if (auto page = manualPage(word, paint)) return Page{page->text, page->json};
  if (word == "hazards") return hazardsPage(paint);
  if (word == "choices") return choicesPage(paint, settings);
  if (upper == "SM") return specialMemoryPage(settings.target(), paint);
  if (auto page = specialBitPage(settings.target(), upper, paint)) return page;
  if (auto page = addressPage(target, upper, paint)) return Page{page->text, page->json};
  if (const Idea* idea = ideaNamed(word))
    return Page{fmt::format("{}\n\n{}", paint.bold(std::string(idea->name)), wrapped(idea->text)),
                {{"name", idea->name}, {"text", idea->text}}};
  if (auto page = groupPage(upper, paint)) return page;
  if (const auto code = codeNamed(upper)) {
    return Page{
        fmt::format("{}: {}\n\n  {} of the readers{}\n\n  {}\n    {}\n", paint.bold(code->id), paint.bold(code->title),
                    severityName(code->severity),
                    code->severity == Severity::Error ? "; it cannot be silenced, and the exit code is 2" : "",
                    paint.bold("Help"), code->help),
        {{"id", code->id}, {"title", code->title}, {"severity", severityName(code->severity)}, {"help", code->help}}};
  }
  for (const HazardInfo& info : hazardTable) {
    if (info.code != upper) continue;
    return Page{fmt::format("{}: {}\n\n  {}\n  {}\n", paint.bold(info.code), info.text, hazardClassText(info.kind),
                            manualPlace(info.manual)),
                hazardJson(info)};
  }
  const Desc* desc = s7200Instructions().named(upper);
  if (desc == nullptr) desc = s7200Instructions().alias(upper);
  if (desc == nullptr) desc = s7200Instructions().namedGerman(upper);
  if (desc == nullptr) return familyPage(upper, settings, paint);
  Page page{instructionPage(*desc, paint), instructionJson(*desc)};
  if (isStep7Instruction(upper)) {
    page.text +=
        fmt::format("\n  Not the same in the S7-300 and S7-400: rungproof explain '{}' --dialect s7-300\n", word);
    page.json["alsoIn"] = "s7-300";
  }
  return page;
}

Failure unknown(const std::string& word) {
  std::vector<std::string_view> words = {"hazards", "choices", "SM"};
  for (const Idea& idea : ideas()) words.push_back(idea.name);
  for (const Code& code : allCodes()) words.push_back(code.id);
  const std::string_view meant = closest(word, words);
  return {
      fmt::format("there is no page called '{}'", word),
      {},
      meant.empty()
          ? "give a rule (ADR001), a group (ADR), an instruction (TON), an address (T37), a verdict or method ('one "
            "scan'), a run-time error (0006), a place of the manual (001:4814), 'hazards' or 'choices'"
          : fmt::format("did you mean '{}'?", meant)};
}

Action setUpExplain(ArgumentTable& table) {
  auto word = std::make_shared<std::string>();
  table.argument(
      "CODE", *word,
      "rule (ADR001), group (ADR), instruction (TON), address (T37), verdict or method ('one scan'), run-time "
      "error (0006), place of the manual (001:4814), 'hazards' or 'choices'");
  return [word](Context& context) {
    Exit exit = Exit::Clean;
    for (const OutputRequest& output : context.outputs) {
      const auto page = pageOf(*word, context.settings, Paint{context.color && output.file.empty()});
      if (!page) return context.fail(unknown(*word));
      if (!context.write(output, output.name == "json" ? page->json.dump(2) + "\n" : page->text)) exit = Exit::Failed;
    }
    return exit;
  };
}

}  // namespace

extern constexpr Command explainCommand = {
    .name = "explain",
    .usage = "CODE",
    .summary = "show the page of a rule, an instruction, an address, a method or a run-time error",
    .details = "",
    .shows = option_group::Output,
    .needsNoConfig = true,
    .formats = "text|json",
    .setup = setUpExplain,
};

}  // namespace rungproof
