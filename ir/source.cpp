// Line tables of source files.
#include "ir/source.hpp"

#include <algorithm>

namespace rungproof {

namespace {

constexpr std::uint32_t markEvery = 4;

}  // namespace

SourceFile::SourceFile(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  for (std::uint32_t start = 0; start <= text_.size(); start = nextLine(start)) {
    if (lineCount_++ % markEvery == 0) marks_.push_back(start);
  }
  marks_.shrink_to_fit();
}

std::uint32_t SourceFile::nextLine(std::uint32_t offset) const {
  return static_cast<std::uint32_t>(std::min(text_.find('\n', offset), text_.size())) + 1;
}

std::uint32_t SourceFile::lineStart(std::uint32_t number) const {
  std::uint32_t start = marks_[(number - 1) / markEvery];
  for (std::uint32_t i = (number - 1) % markEvery; i > 0; --i) start = nextLine(start);
  return start;
}

std::string_view SourceFile::text(Span span) const {
  if (span.offset >= text_.size()) return {};
  return std::string_view(text_).substr(span.offset, span.length);
}

Position SourceFile::position(std::uint32_t offset) const {
  offset = std::min<std::uint32_t>(offset, static_cast<std::uint32_t>(text_.size()));
  const auto mark = std::upper_bound(marks_.begin(), marks_.end(), offset) - 1;
  std::uint32_t line = static_cast<std::uint32_t>(mark - marks_.begin()) * markEvery + 1, start = *mark;
  for (std::uint32_t next = nextLine(start); next <= offset; next = nextLine(start)) {
    start = next;
    ++line;
  }
  std::uint32_t column = 1;
  for (std::uint32_t i = start; i < offset; ++i) {
    const bool continuation = (static_cast<unsigned char>(text_[i]) & 0xC0) == 0x80;
    if (!continuation) ++column;
  }
  return {line, column};
}

std::string_view SourceFile::line(std::uint32_t number) const {
  if (number == 0 || number > lineCount_) return {};
  const std::uint32_t begin = lineStart(number);
  std::uint32_t end = nextLine(begin) - 1;
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

std::uint32_t SourceSet::add(std::string name, std::string text) {
  files_.push_back(std::make_unique<SourceFile>(std::move(name), std::move(text)));
  return static_cast<std::uint32_t>(files_.size() - 1);
}

}  // namespace rungproof
