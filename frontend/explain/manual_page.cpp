// Sections by their title: what cites another line of the section belongs to it too.
#include "frontend/explain/manual_page.hpp"

#include <fmt/ranges.h>

#include <set>

#include "analysis/rule.hpp"
#include "frontend/text/columns.hpp"
#include "ir/dialect.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

/// Whether a list such as "001:6611, 004:4596" has a reference to the section of that title.
bool cites(std::string_view references, const std::string& title) {
  while (!references.empty()) {
    const std::size_t end = std::min(references.find(','), references.size());
    std::string_view one = references.substr(0, end);
    one.remove_prefix(std::min(one.find_first_not_of(' '), one.size()));
    if (!one.empty() && withManualTitles(one) == title) return true;
    references.remove_prefix(std::min(end + 1, references.size()));
  }
  return false;
}

}  // namespace

std::optional<ManualPage> manualPage(std::string_view word, const Paint& paint) {
  if (word.find(':') != 3) return std::nullopt;
  const std::string title = withManualTitles(word);
  if (title == word) return std::nullopt;
  std::vector<std::string> rules;
  std::set<std::string> instructions;
  for (const Rule* rule : allRules()) {
    if (cites(rule->manual, title)) rules.emplace_back(rule->id);
  }
  for (const Dialect* dialect : dialects()) {
    for (const Desc& desc : dialect->instructions().all()) {
      if (cites(desc.manual, title)) instructions.emplace(desc.stl);
    }
  }
  ManualPage page{fmt::format("{}\n\n  {}\n", paint.bold(word), title),
                  {{"reference", word}, {"title", title}, {"rules", rules}}};
  std::vector<TextRow> rows;
  if (!rules.empty()) rows.push_back({"Rules", fmt::format("{}", fmt::join(rules, ", "))});
  if (!instructions.empty()) rows.push_back({"Instructions", fmt::format("{}", fmt::join(instructions, ", "))});
  if (!rows.empty()) page.text += '\n';
  appendRows(page.text, rows, 16);
  page.json["instructions"] = std::vector<std::string>(instructions.begin(), instructions.end());
  return page;
}

}  // namespace rungproof
