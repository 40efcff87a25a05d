// Line tables of source files.
#include "ir/source.hpp"

#include <algorithm>

namespace rungproof {

SourceFile::SourceFile(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  lineStarts_.reserve(static_cast<std::size_t>(std::ranges::count(text_, '\n')) + 1);
  lineStarts_.push_back(0);
  for (std::uint32_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') lineStarts_.push_back(i + 1);
  }
}

std::string_view SourceFile::text(Span span) const {
  if (span.offset >= text_.size()) return {};
  return std::string_view(text_).substr(span.offset, span.length);
}

Position SourceFile::position(std::uint32_t offset) const {
  offset = std::min<std::uint32_t>(offset, static_cast<std::uint32_t>(text_.size()));
  const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), offset);
  const auto line = static_cast<std::uint32_t>(next - lineStarts_.begin());
  std::uint32_t column = 1;
  for (std::uint32_t i = lineStarts_[line - 1]; i < offset; ++i) {
    const bool continuation = (static_cast<unsigned char>(text_[i]) & 0xC0) == 0x80;
    if (!continuation) ++column;
  }
  return {line, column};
}

std::string_view SourceFile::line(std::uint32_t number) const {
  if (number == 0 || number > lineStarts_.size()) return {};
  const std::uint32_t begin = lineStarts_[number - 1];
  std::uint32_t end = number < lineStarts_.size() ? lineStarts_[number] - 1 : static_cast<std::uint32_t>(text_.size());
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

std::uint32_t SourceSet::add(std::string name, std::string text) {
  files_.push_back(std::make_unique<SourceFile>(std::move(name), std::move(text)));
  return static_cast<std::uint32_t>(files_.size() - 1);
}

}  // namespace rungproof
