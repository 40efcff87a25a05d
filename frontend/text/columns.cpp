// Text in two columns. Tested by the golden tests of help pages.
#include "frontend/text/columns.hpp"

#include <algorithm>

namespace rungproof {

namespace {

/// Breaks text between words so that no line is longer than `room`, unless a single word is.
std::vector<std::string_view> wrapped(std::string_view text, std::size_t room) {
  std::vector<std::string_view> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    std::size_t end = text.size();
    if (end - begin > room) {
      const std::size_t space = text.rfind(' ', begin + room);
      end = space == std::string_view::npos || space <= begin ? std::min(text.find(' ', begin), text.size()) : space;
    }
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

}  // namespace

void appendRows(std::string& text, const std::vector<TextRow>& rows, std::size_t column) {
  for (const TextRow& row : rows) {
    std::string line = "  " + row.left;
    const auto right = wrapped(row.right, pageWidth - column);
    if (line.size() + 2 > column && !right.empty()) {
      text += line + '\n';
      line.clear();
    }
    if (right.empty()) text += line + '\n';
    for (const std::string_view part : right) {
      line.resize(column, ' ');
      text += line.append(part) + '\n';
      line.clear();
    }
  }
}

void appendParagraph(std::string& text, std::string_view paragraph, std::size_t indent) {
  for (const std::string_view line : wrapped(paragraph, pageWidth - indent))
    text.append(indent, ' ').append(line) += '\n';
}

}  // namespace rungproof
