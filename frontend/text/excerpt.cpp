// Excerpts of source text.
#include "frontend/text/excerpt.hpp"

#include <fmt/core.h>
#include <unicode/uchar.h>
#include <unicode/utf8.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

constexpr int tabWidth = 4;
constexpr std::size_t mostLookedAt = 4096;  ///< bytes on either side of a mark's beginning
constexpr std::size_t near = excerptWidth;  ///< the same where each byte is a column

/// A character of the shown line: its text and its columns.
struct TextCell {
  std::string text;
  int width = 1;
};

int columnsOf(UChar32 c) {
  const auto category = u_charType(c);
  if (category == U_NON_SPACING_MARK || category == U_ENCLOSING_MARK || category == U_FORMAT_CHAR) return 0;
  const int eastAsian = u_getIntPropertyValue(c, UCHAR_EAST_ASIAN_WIDTH);
  return eastAsian == U_EA_WIDE || eastAsian == U_EA_FULLWIDTH ? 2 : 1;
}

/// Splits UTF-8 into cells; `cellOfByte` gets the cell index of each byte and one past the end.
std::vector<TextCell> textCells(std::string_view text, std::vector<std::size_t>& cellOfByte) {
  std::vector<TextCell> cells;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  const auto size = static_cast<std::int32_t>(text.size());
  for (std::int32_t i = 0; i < size;) {
    const std::int32_t begin = i;
    UChar32 c = 0;
    U8_NEXT(bytes, i, size, c);
    for (std::int32_t k = begin; k < i; ++k) cellOfByte.push_back(cells.size());
    if (c == '\t') {
      cells.push_back({std::string(tabWidth, ' '), tabWidth});
      continue;
    }
    const std::string_view character =
        text.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(i - begin));
    const bool isShown = c >= 0 && !isHazard(static_cast<char32_t>(c)) && c != '\n';
    if (isShown) {
      cells.push_back({std::string(character), columnsOf(c)});
    } else {
      std::string shown = lineText(character);
      const int width = shown[0] == '<' ? static_cast<int>(shown.size()) : 1;  // "<U+202E>", or one character
      cells.push_back({std::move(shown), width});
    }
  }
  cellOfByte.push_back(cells.size());
  return cells;
}

int widthOf(const std::vector<TextCell>& cells, std::size_t begin, std::size_t end) {
  int width = 0;
  for (std::size_t i = begin; i < end; ++i) width += cells[i].width;
  return width;
}

/// A line each byte of which is a column, and that is shown whole.
bool isPlain(std::string_view line) {
  return line.size() <= static_cast<std::size_t>(excerptWidth) &&
         std::ranges::all_of(line, [](char c) { return c >= ' ' && c < 0x7F; });
}

}  // namespace

std::string Paint::with(std::string_view code, std::string_view text) const {
  return on ? fmt::format("\x1B[{}m{}\x1B[0m", code, text) : std::string(text);
}

int displayWidth(std::string_view text) {
  std::vector<std::size_t> cellOfByte;
  const std::vector<TextCell> cells = textCells(text, cellOfByte);
  return widthOf(cells, 0, cells.size());
}

Excerpt excerptOf(const SourceFile& file, Span span) { return excerptOf(file, span, file.position(span.offset).line); }

Excerpt excerptOf(const SourceFile& file, Span span, std::uint32_t lineNumber) {
  Excerpt excerpt;
  excerpt.lineNumber = lineNumber;
  const std::string_view line = file.line(excerpt.lineNumber);
  const auto lineStart = static_cast<std::size_t>(line.data() - file.text().data());
  const std::size_t start = std::min<std::size_t>(span.offset - lineStart, line.size());
  const std::size_t stop = std::min<std::size_t>(start + span.length, line.size());

  if (isPlain(line)) {
    excerpt.line = line.substr(0, line.find_last_not_of(' ') + 1);
    excerpt.markBegin = static_cast<int>(start);
    excerpt.markWidth = std::max(1, static_cast<int>(stop - start));
    return excerpt;
  }
  // Of a line of megabytes only what may be shown is looked at.
  const auto isTail = [&](std::size_t at) { return (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U; };
  const auto isPlainAround = [&] {
    if (line.size() <= 2 * mostLookedAt) return false;
    return isPlain(line.substr(start - std::min(start, near), near)) && isPlain(line.substr(start, near));
  };
  const std::size_t lookedAt = isPlainAround() ? near : mostLookedAt;
  std::size_t from = start > lookedAt ? start - lookedAt : 0;
  std::size_t to = std::min(line.size(), start + lookedAt);
  while (from > 0 && isTail(from)) --from;
  while (to < line.size() && isTail(to)) ++to;
  const bool isPart = from > 0 || to < line.size();
  std::vector<std::size_t> cellOfByte;
  const std::vector<TextCell> cells = textCells(line.substr(from, to - from), cellOfByte);
  const std::size_t markFirst = cellOfByte[start - from];
  const std::size_t markEnd = std::max(cellOfByte[std::min(stop, to) - from], markFirst);

  // The window: the whole line if it fits, else as much around the mark's beginning as fits.
  std::size_t first = 0;
  std::size_t end = cells.size();
  if (isPart || widthOf(cells, 0, end) > excerptWidth) {
    constexpr int before = excerptWidth / 3;
    first = markFirst;
    for (int room = before; first > 0 && room >= cells[first - 1].width; --first) room -= cells[first - 1].width;
    end = first;
    for (int room = excerptWidth; end < cells.size() && room >= cells[end].width; ++end) room -= cells[end].width;
  }
  if (first > 0 || from > 0) excerpt.line += "...";
  excerpt.markBegin = displayWidth(excerpt.line) + widthOf(cells, first, markFirst);
  for (std::size_t i = first; i < end; ++i) excerpt.line += cells[i].text;
  if (end < cells.size() || to < line.size()) excerpt.line += "...";
  excerpt.markWidth = std::max(1, widthOf(cells, markFirst, std::min(markEnd, end)));
  excerpt.line.erase(excerpt.line.find_last_not_of(' ') + 1);
  return excerpt;
}

std::string drawExcerpt(const Excerpt& excerpt, int gutter, char mark, const Paint& paint,
                        std::string (Paint::*paintMark)(std::string_view) const) {
  const std::string bar = paint.blue("|");
  const std::string number = std::to_string(excerpt.lineNumber);
  const auto margin = static_cast<std::size_t>(gutter);
  const auto blanks = [](std::size_t count) { return std::string(count, ' '); };
  std::string text;
  text.reserve(3 * (margin + bar.size() + 4) + 2 * excerpt.line.size() + 16);
  text.append(margin, ' ').append(" ").append(bar).append("\n");
  text.append(paint.blue(blanks(margin - std::min(margin, number.size())) + number)).append(" ").append(bar);
  if (!excerpt.line.empty()) text.append(" ").append(excerpt.line);
  text.append("\n").append(margin, ' ').append(" ").append(bar).append(" ");
  text.append(static_cast<std::size_t>(excerpt.markBegin), ' ');
  text.append((paint.*paintMark)(std::string(static_cast<std::size_t>(excerpt.markWidth), mark))).append("\n");
  return text;
}

std::string placeText(const SourceSet& sources, Span span) {
  const Position position = sources.position(span);
  return fmt::format("{}:{}:{}", sources.file(span.file).name(), position.line, position.column);
}

}  // namespace rungproof
