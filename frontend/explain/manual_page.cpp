// Sections by their title: what cites another line of the section belongs to it too.
#include "frontend/explain/manual_page.hpp"

#include <fmt/ranges.h>

#include <cctype>
#include <set>

#include "analysis/rule.hpp"
#include "frontend/text/columns.hpp"
#include "ir/dialect.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

/// Calls visit(reference) for each of a list.
template <class Visit>
void forEachReference(std::string_view references, Visit&& visit) {
  while (!references.empty()) {
    const std::size_t end = std::min(references.find(','), references.size());
    std::string_view one = references.substr(0, end);
    one.remove_prefix(std::min(one.find_first_not_of(' '), one.size()));
    if (!one.empty()) visit(one);
    references.remove_prefix(std::min(end + 1, references.size()));
  }
}

/// Whether a list such as "001:6611, 004:4596" has a reference to the section of that title.
bool cites(std::string_view references, const std::string& title) {
  bool isCited = false;
  forEachReference(references, [&](std::string_view one) { isCited = isCited || withManualTitles(one) == title; });
  return isCited;
}

/// "system manual, chapter 6, timers": without the year where `hasYear` is false.
std::string comparable(std::string_view title, bool hasYear) {
  std::string text;
  for (const char c : title) text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t comma = std::min(text.find(','), text.size());
  if (!hasYear && comma > 5 && text.find_first_not_of("0123456789", comma - 4) >= comma && text[comma - 5] == ' ')
    text.erase(comma - 5, 5);
  return text;
}

/// The title of a section that rules or instructions rest on, as it was written; of several editions the newest.
std::string titleNamed(std::string_view word) {
  std::string found;
  const auto see = [&](std::string_view reference) {
    std::string title = withManualTitles(reference);
    const bool isMeant =
        comparable(title, true) == comparable(word, true) || comparable(title, false) == comparable(word, true);
    if (title != reference && isMeant && title > found) found = std::move(title);
  };
  for (const Rule* rule : allRules()) forEachReference(rule->manual, see);
  for (const Dialect* dialect : dialects()) {
    for (const Desc& desc : dialect->instructions().all()) forEachReference(desc.manual, see);
  }
  return found;
}

}  // namespace

std::optional<ManualPage> manualPage(std::string_view word, const Paint& paint) {
  const bool isReference = word.find(':') == 3;
  const std::string title = isReference ? withManualTitles(word) : titleNamed(word);
  if (title.empty() || (isReference && title == word)) return std::nullopt;
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
