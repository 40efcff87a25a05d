// The beginning of a file decides whether reading it is worth the time.
#include "frontend/input/program_text.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "analysis/read_errors.hpp"
#include "engine/platform/names.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/input/project.hpp"
#include "frontend/step7/cursor.hpp"
#include "frontend/step7/step7_likeness.hpp"
#include "frontend/step7/symbol_list.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/stl_likeness.hpp"
#include "frontend/xml/xml_text.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof {

namespace {

constexpr std::size_t beginningBytes = 65536;
constexpr int shareOfStatements = 75;  ///< per cent of the lines, without a heading

std::string beginningOf(const std::string& name) {
  if (confinedAgainst(name)) return {};
  if (const HeldText* held = heldText(name)) return held->text.substr(0, beginningBytes);
  std::string text(beginningBytes, '\0');
  std::ifstream stream(name, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  std::erase(text, '\0');  // of UTF-16, whose words are looked for only
  return text;
}

/// Whether a line begins with the word and has more behind it, as the heading of a block has.
bool hasHeadingLine(std::string_view text, std::string_view word) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    if (line.size() > word.size() && step7::equalsWord(line.substr(0, word.size()), word) &&
        std::string_view(" \t:\"").find(line[word.size()]) != std::string_view::npos)
      return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

/// A heading that no prose has, or one that prose may have together with the word that ends such a block.
bool hasBlockHeading(std::string_view text) {
  using Pair = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Pair, 7> headings = {{{"ORGANIZATION_BLOCK", ""},
                                                    {"SUBROUTINE_BLOCK", ""},
                                                    {"INTERRUPT_BLOCK", ""},
                                                    {"FUNCTION_BLOCK", ""},
                                                    {"FUNCTION", "END_FUNCTION"},
                                                    {"DATA_BLOCK", "END_DATA_BLOCK"},
                                                    {"PROGRAM", "END_PROGRAM"}}};
  return std::ranges::any_of(headings, [&](const Pair& pair) {
    return hasHeadingLine(text, pair.first) && text.find(pair.second) != std::string_view::npos;
  });
}

/// What the readers make of it: blocks with code, and more of it read than not.
bool readsAsProgram(const std::string& name, bool hasHeading) {
  const Program alone = readProgram({name});
  if (alone.syntax != nullptr) return !alone.syntax->blocks.empty();
  if (hasHeading && alone.declarations != nullptr) return true;  // a data block is a source of the S7-300/400 too
  if (alone.pous.empty()) return false;
  if (hasHeading && stlLikeness(alone.sources->file(0).text()).hasHeading) return true;
  const auto lost = static_cast<std::size_t>(std::ranges::count_if(alone.findings, isReadError));
  return alone.instructionCount() >= 2 && lost * 4 <= alone.instructionCount();
}

}  // namespace

bool hasSharedEnding(const std::string& name) {
  return endsInAny(name, {".csv", ".txt", ".sdf", ".tsv", ".asc", ".seq", ".dif"});
}

bool isProgramText(const std::string& name) {
  const std::string text = beginningOf(name);
  if (text.starts_with("scan") || text.starts_with("time_ms")) return false;
  if (looksLikeXml(text))
    return text.find("plcopen") != std::string::npos || text.find("<SW.Blocks.") != std::string::npos;
  const bool hasHeading = hasBlockHeading(text);
  if (!hasHeading && step7::isSymbolList(text)) return false;
  if (!hasHeading && stlLikeness(text).share < shareOfStatements && !step7::step7Likeness(text).isStep7()) return false;
  return readsAsProgram(name, hasHeading);
}

std::vector<std::string> programTextsIn(const std::string& folder) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    std::string name = pathName(entry->path());
    if (entry->is_regular_file(error) && hasSharedEnding(name) && isProgramText(name)) names.push_back(std::move(name));
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace rungproof
