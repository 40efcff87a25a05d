// Line tables of source files.
#include "ir/source.hpp"

#include <algorithm>

namespace rungproof {

namespace {

constexpr std::uint32_t linesApart = 4, bytesApart = 1024;

}  // namespace

SourceFile::SourceFile(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  const auto size = static_cast<std::uint32_t>(text_.size());
  for (std::uint32_t start = 0; start <= size;) {
    const std::uint32_t next = nextLine(start);
    if (lineCount_++ % linesApart == 0 || next - start > bytesApart) marks_.push_back({start, lineCount_, start, 1});
    for (std::uint32_t at = start; next - at > bytesApart; at += bytesApart) {
      const std::uint32_t column = marks_.back().column + charactersIn(at, at + bytesApart);
      marks_.push_back({at + bytesApart, lineCount_, start, column});
    }
    start = next;
  }
  marks_.shrink_to_fit();
}

std::uint32_t SourceFile::nextLine(std::uint32_t offset) const {
  return static_cast<std::uint32_t>(std::min(text_.find('\n', offset), text_.size())) + 1;
}

std::uint32_t SourceFile::charactersIn(std::uint32_t begin, std::uint32_t end) const {
  const auto isTail = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  return end - begin - static_cast<std::uint32_t>(std::count_if(text_.begin() + begin, text_.begin() + end, isTail));
}

std::uint32_t SourceFile::lineStart(std::uint32_t number) const {
  // The last mark of the lines up to this one: from the lines before it, what is left is at most a few short lines.
  const auto above = std::ranges::upper_bound(marks_, number, {}, &Mark::line) - 1;
  if (above->line == number) return above->lineStart;
  std::uint32_t start = above->offset;
  for (std::uint32_t i = number - above->line; i > 0; --i) start = nextLine(start);
  return start;
}

std::string_view SourceFile::text(Span span) const {
  if (span.offset >= text_.size()) return {};
  return std::string_view(text_).substr(span.offset, span.length);
}

Position SourceFile::position(std::uint32_t offset) const {
  offset = std::min<std::uint32_t>(offset, static_cast<std::uint32_t>(text_.size()));
  const Mark& mark = *(std::ranges::upper_bound(marks_, offset, {}, &Mark::offset) - 1);
  std::uint32_t line = mark.line, start = mark.offset, column = mark.column;
  for (std::uint32_t i = start; i < offset; ++i) {
    if (text_[i] != '\n') continue;
    start = i + 1;
    ++line;
    column = 1;
  }
  column += charactersIn(start, offset);
  return {line, column};
}

std::string_view SourceFile::line(std::uint32_t number) const {
  if (number == 0 || number > lineCount_) return {};
  const std::uint32_t begin = lineStart(number);
  std::uint32_t end = number == lineCount_ ? static_cast<std::uint32_t>(text_.size()) : lineStart(number + 1) - 1;
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

std::uint32_t SourceSet::add(std::string name, std::string text) {
  files_.push_back(std::make_unique<SourceFile>(std::move(name), std::move(text)));
  return static_cast<std::uint32_t>(files_.size() - 1);
}

}  // namespace rungproof
