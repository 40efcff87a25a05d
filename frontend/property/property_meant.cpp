// Suggestions for words that were not understood.
#include "frontend/property/property_meant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "frontend/files/closest_word.hpp"
#include "frontend/property/property_message.hpp"
#include "frontend/property/property_types.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "ir/iec/syntax.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

namespace {

/// Signs of C, of TIA and of formal logic.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> foreignSigns = {{{"&&", "and"},
                                                                                         {"&", "and"},
                                                                                         {"||", "or"},
                                                                                         {"|", "or"},
                                                                                         {"^", "xor"},
                                                                                         {"!", "not"},
                                                                                         {"~", "not"},
                                                                                         {"->", "implies"},
                                                                                         {"=>", "implies"},
                                                                                         {"!=", "<>"},
                                                                                         {"/=", "<>"},
                                                                                         {"=<", "<="}}};

/// Words that may stand where an address may.
constexpr std::array<std::string_view, 13> wordsBeforeAddresses = {"not",   "never", "always",    "true", "false",
                                                                   "rises", "falls", "prev",      "once", "since",
                                                                   "held",  "value", "first_scan"};

bool isDecimalDigit(char c) { return c >= '0' && c <= '9'; }

/// With 0 for O and 1 for l or I behind the first letters, where that is an address.
std::string withDigits(std::string_view written, const OperandLookup& lookup) {
  for (std::size_t letters = 1; letters <= 3 && letters < written.size(); ++letters) {
    std::string candidate(written);
    for (char& c : std::span(candidate).subspan(letters))
      c = c == 'O' || c == 'o' ? '0' : c == 'l' || c == 'I' ? '1' : c;
    if (candidate != written && lookup(candidate)) return candidate;
  }
  return {};
}

/// T37.value, "Motor".Speed: the last part is misspelt.
std::string withLastPart(const Program& program, std::string_view written, const OperandLookup& lookup) {
  const std::size_t dot = written.rfind('.');
  if (dot == std::string_view::npos) return {};
  const std::string before(written.substr(0, dot + 1));
  const std::string_view part = written.substr(dot + 1);
  if (closest(part, std::array<std::string_view, 1>{"value"}) == "value" && lookup(before.substr(0, dot)))
    return before + "value";
  if (program.declarations == nullptr) return {};
  std::vector<std::string_view> names;
  for (const auto& [number, structure] : program.declarations->dataBlocks) {
    for (const s7300::Field& field : structure->fields) {
      if (lookup(before + field.name)) names.push_back(field.name);
    }
  }
  const std::string_view name = closest(part, names);
  return name.empty() ? std::string() : before + std::string(name);
}

std::string meantName(const Program& program, std::string_view written, const OperandLookup& lookup) {
  const std::string spelled = mendedOperand(written, Spelling::International, false);
  if (!spelled.empty() && (!spelled.starts_with('"') || lookup(spelled))) return spelled;
  if (const std::string mended = withDigits(written, lookup); !mended.empty()) return mended;
  std::vector<std::string_view> names;
  const std::string folded = iec::foldedName(written);
  for (const Symbol& symbol : program.symbols) {
    // Where several programs have a variable of that name, it is named with its program.
    const std::size_t dot = symbol.name.find('.');
    if (dot != std::string::npos && iec::foldedName(symbol.name.substr(dot + 1)) == folded) return symbol.name;
    names.emplace_back(symbol.name);
  }
  const bool isQuoted = written.size() > 1 && written.front() == '"' && written.back() == '"';
  const std::string_view name = closest(isQuoted ? written.substr(1, written.size() - 2) : written, names);
  if (!name.empty()) return isQuoted ? fmt::format("\"{}\"", name) : std::string(name);
  if (const std::string mended = withLastPart(program, written, lookup); !mended.empty()) return mended;
  return std::string(closest(written, wordsBeforeAddresses));
}

/// A comma for the point of an address, as in Q0,0: where the address ends, else nothing.
std::optional<Span> addressWithComma(const SourceFile& file, Span span) {
  const std::string_view text = file.text();
  std::size_t end = span.offset + span.length;
  if (end + 1 >= text.size() || text[end] != ',' || !isDecimalDigit(text[end - 1]) || !isDecimalDigit(text[end + 1]))
    return {};
  for (++end; end < text.size() && isDecimalDigit(text[end]);) ++end;
  return Span{span.file, span.offset, static_cast<std::uint32_t>(end - span.offset)};
}

/// The word of the language that was misspelt, or empty; a word that is right stands in a wrong place.
std::string meantWord(std::string_view written) {
  std::string word(written);
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (isKeyword(word)) return {};
  std::vector<std::string_view> words(propertyKeywords().begin(), propertyKeywords().end());
  words.insert(words.end(), wordsBeforeAddresses.begin(), wordsBeforeAddresses.end());
  return std::string(closest(word, words));
}

/// With a blank where the sign touches its neighbours.
std::string wordWithBlanks(std::string_view word, std::string_view text, std::size_t begin, std::size_t end) {
  const auto isBlank = [&](std::size_t at) { return at >= text.size() || text[at] == ' ' || text[at] == '\t'; };
  return fmt::format("{}{}{}", begin == 0 || isBlank(begin - 1) || text[begin - 1] == '(' ? "" : " ", word,
                     isBlank(end) ? "" : " ");
}

}  // namespace

void suggestMeant(Program& program, std::size_t first, const OperandLookup& lookup) {
  for (std::size_t i = first; i < program.findings.size(); ++i) {
    Finding& finding = program.findings[i];
    if (finding.fix || finding.span.length == 0) continue;
    const SourceFile& file = program.sources->file(finding.span.file);
    const std::string_view written = file.text(finding.span);
    const std::size_t end = finding.span.offset + finding.span.length;
    const auto sign = std::ranges::find(foreignSigns, written, &decltype(foreignSigns)::value_type::first);
    Span wrong = finding.span;
    std::string meant, replacement;
    if (finding.rule == propertyMessages[0].id && sign != foreignSigns.end()) {
      const std::size_t next = std::min(file.text().find_first_not_of(' ', end), file.text().size() - 1);
      meant = written == "=>" && isDecimalDigit(file.text()[next]) ? ">=" : sign->second;
      replacement = wordWithBlanks(meant, file.text(), finding.span.offset, end);
    } else if (finding.rule == propertyMessages[0].id) {
      replacement = meant = meantWord(written);
    } else if (finding.rule == propertyMessages[1].id && !finding.help.view().starts_with("write ")) {
      const std::optional<Span> whole = addressWithComma(file, finding.span);
      std::string pointed = whole ? std::string(file.text(*whole)) : std::string();
      std::ranges::replace(pointed, ',', '.');
      if (whole && lookup(pointed)) {
        wrong = *whole;
        replacement = meant = pointed;
      } else {
        replacement = meant = meantName(program, written, lookup);
      }
    }
    if (meant.empty() || meant == written) continue;
    finding.help = fmt::format("did you mean '{}'?", meant);
    finding.fix = Shared<Fix>({wrong, replacement, false});
  }
}

}  // namespace rungproof
