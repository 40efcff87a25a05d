// Text in two columns with the right one wrapped between words: help pages, pages of rules, lists.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rungproof {

struct TextRow {
  std::string left;
  std::string right;
};

/// Widest line of a page, in characters.
inline constexpr std::size_t pageWidth = 100;

/// Appends the rows, indented by two; a left part that reaches the column gets a line of its own.
void appendRows(std::string& text, const std::vector<TextRow>& rows, std::size_t column);
/// Appends a paragraph wrapped to the page, each line indented.
void appendParagraph(std::string& text, std::string_view paragraph, std::size_t indent);

}  // namespace rungproof
