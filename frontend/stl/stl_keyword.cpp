// Keyword table and headings.
#include "frontend/stl/stl_keyword.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

struct KeywordRow {
  std::string_view spelling;
  Keyword keyword;
};
/// NETZWERK and SEGMENTO stand in exports of the German and Spanish editor.
constexpr std::array<KeywordRow, 26> keywords = {{
    {"ORGANIZATION_BLOCK", Keyword::OrganizationBlock},
    {"SUBROUTINE_BLOCK", Keyword::SubroutineBlock},
    {"INTERRUPT_BLOCK", Keyword::InterruptBlock},
    {"END_ORGANIZATION_BLOCK", Keyword::EndOrganizationBlock},
    {"END_SUBROUTINE_BLOCK", Keyword::EndSubroutineBlock},
    {"END_INTERRUPT_BLOCK", Keyword::EndInterruptBlock},
    {"DATA_BLOCK", Keyword::DataBlock},
    {"DATA_BLOCK_TAB", Keyword::DataBlock},
    {"END_DATA_BLOCK", Keyword::EndDataBlock},
    {"END_DATA_BLOCK_TAB", Keyword::EndDataBlock},
    {"SYMBOL_TABLE", Keyword::SymbolTable},
    {"END_SYMBOL_TABLE", Keyword::EndSymbolTable},
    {"VAR_INPUT", Keyword::VarInput},
    {"VAR_IN_OUT", Keyword::VarInOut},
    {"VAR_OUTPUT", Keyword::VarOutput},
    {"VAR", Keyword::Var},
    {"VAR_TEMP", Keyword::Var},
    {"END_VAR", Keyword::EndVar},
    {"BEGIN", Keyword::Begin},
    {"NETWORK", Keyword::Network},
    {"NETZWERK", Keyword::Network},
    {"SEGMENTO", Keyword::Network},
    {"SEGMENT", Keyword::Network},
    {"NETWORK_COMMENT", Keyword::NetworkComment},
    {"NETWORK_TITLE", Keyword::NetworkTitle},
    {"TITLE", Keyword::Title},
}};

std::string_view prefixOf(PouKind kind) {
  return kind == PouKind::Main ? "OB" : kind == PouKind::Subroutine ? "SBR" : "INT";
}

/// Number behind the prefix: "SBR_3", "SBR 3", "SBR3", with O read as 0; -1 if there is none.
int numberAfter(std::string_view prefix, std::string_view text) {
  if (text.size() <= prefix.size() || !equalsIgnoringCase(text.substr(0, prefix.size()), prefix)) return -1;
  std::string_view digits = trimmed(text.substr(prefix.size()));
  if (!digits.empty() && digits[0] == '_') digits.remove_prefix(1);
  if (!digits.empty() && digits.back() == ':') digits.remove_suffix(1);
  if (digits.empty() || digits.size() > 5) return -1;
  int number = 0;
  for (const char c : digits) {
    if (!isDigit(c) && c != 'O') return -1;
    number = number * 10 + (c == 'O' ? 0 : c - '0');
  }
  return number;
}

}  // namespace

Keyword keywordOf(std::string_view word, std::size_t& length) {
  if (word.size() < 3) return Keyword::None;
  const char first = upper(word[0]);
  if (std::string_view("OSIEDVBNT").find(first) == std::string_view::npos) return Keyword::None;
  length = 0;
  while (length < word.size() && (isLetter(word[length]) || word[length] == '_')) ++length;
  if (length < 3) return Keyword::None;
  const std::string_view letters = word.substr(0, length);
  const auto row = std::find_if(keywords.begin(), keywords.end(),
                                [&](const KeywordRow& entry) { return equalsIgnoringCase(entry.spelling, letters); });
  if (row == keywords.end()) return Keyword::None;
  if (length == word.size()) return row->keyword;
  const char next = word[length];
  if (row->keyword == Keyword::Title) return next == '=' ? Keyword::Title : Keyword::None;
  if (row->keyword == Keyword::Network) return isDigit(next) ? Keyword::Network : Keyword::None;
  return Keyword::None;
}

std::string defaultName(PouKind kind, int number) {
  return kind == PouKind::Main ? "MAIN" : fmt::format("{}_{}", prefixOf(kind), number);
}

Heading readHeading(PouKind kind, std::string_view text) {
  Heading heading;
  heading.kind = kind;
  text = trimmed(text);
  const std::size_t colon = text.rfind(':');
  const std::string_view code = trimmed(colon == std::string_view::npos ? text : text.substr(colon + 1));
  std::string_view name = colon == std::string_view::npos ? std::string_view() : trimmed(text.substr(0, colon));
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  heading.number = numberAfter(prefixOf(kind), code);
  if (heading.number < 0 && kind == PouKind::Main && equalsIgnoringCase(code, "MAIN")) heading.number = 1;
  if (heading.number < 0 && colon == std::string_view::npos) name = code;
  heading.name = name.empty() && heading.number >= 0 ? defaultName(kind, heading.number) : std::string(name);
  return heading;
}

std::optional<Heading> readOlderHeading(std::string_view first, std::string_view second, std::size_t words) {
  if (words > 2) return std::nullopt;
  if (words == 1 && (equalsIgnoringCase(first, "MAIN") || equalsIgnoringCase(first, "OB1")))
    return Heading{PouKind::Main, "MAIN", 1};
  for (const PouKind kind : {PouKind::Subroutine, PouKind::Interrupt}) {
    const std::string_view prefix = prefixOf(kind);
    int number = -1;
    if (words == 2 && equalsIgnoringCase(first, prefix)) {
      number = numberAfter(prefix, std::string(prefix) + std::string(second));
      if (number < 0) return std::nullopt;
    } else if (words == 1 && !equalsIgnoringCase(first, prefix)) {
      number = numberAfter(prefix, first);
      if (number < 0) continue;
    } else if (words == 2 || !equalsIgnoringCase(first, prefix)) {
      continue;
    }
    return Heading{kind, number < 0 ? std::string() : defaultName(kind, number), number};
  }
  return std::nullopt;
}

}  // namespace rungproof
