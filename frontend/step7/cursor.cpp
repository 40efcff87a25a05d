// Moving through a text.
#include "frontend/step7/cursor.hpp"

#include <algorithm>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::step7 {

bool equalsWord(std::string_view word, std::string_view upperCase) {
  return word.size() == upperCase.size() &&
         std::ranges::equal(word, upperCase, [](char a, char b) { return upper(a) == b; });
}

bool Cursor::startsWithLetters(std::string_view upperCase) const {
  return equalsWord(text_.substr(std::min<std::size_t>(at_, text_.size()), upperCase.size()), upperCase);
}

bool Cursor::take(char c) {
  if (peek() != c || atEnd()) return false;
  ++at_;
  return true;
}

void Cursor::skipBlanks() {
  while (!atEnd()) {
    if (const std::size_t blank = blankLength(text_, at_); blank > 0) {
      skip(blank);
    } else if (startsWith("(*")) {
      const std::size_t end = text_.find("*)", at_ + 2);
      const std::size_t newline = text_.find('\n', at_);
      if (end == std::string_view::npos || end > newline) return;
      at_ = static_cast<std::uint32_t>(end + 2);
    } else {
      return;
    }
  }
}

void Cursor::skipSpace(std::vector<Span>& remarks) {
  while (!atEnd()) {
    skipBlanks();
    if (peek() == '\n') {
      skip(1);
    } else if (startsWith("//")) {
      const std::uint32_t end = lineEnd();
      remarks.push_back(span(at_, end));
      at_ = end;
    } else if (startsWith("(*")) {  // over several lines
      const std::size_t end = text_.find("*)", at_ + 2);
      if (end == std::string_view::npos) return;
      remarks.push_back(span(at_, static_cast<std::uint32_t>(end + 2)));
      at_ = static_cast<std::uint32_t>(end + 2);
    } else {
      return;
    }
  }
}

void Cursor::skipSpace() {
  std::vector<Span> remarks;
  skipSpace(remarks);
}

bool Cursor::atLineEnd() const { return atEnd() || peek() == '\n' || startsWith("//"); }

std::uint32_t Cursor::lineEnd() const {
  std::size_t end = std::min(text_.find('\n', at_), text_.size());
  if (end > at_ && text_[end - 1] == '\r') --end;
  return static_cast<std::uint32_t>(end);
}

void Cursor::nextLine() {
  const std::size_t newline = text_.find('\n', at_);
  at_ = static_cast<std::uint32_t>(newline == std::string_view::npos ? text_.size() : newline + 1);
}

std::string_view Cursor::peekWord() const {
  std::size_t end = at_;
  while (end < text_.size() && isWordByte(text_[end])) {
    if (blankLength(text_, end) > 0) break;
    ++end;
  }
  return end > at_ ? text_.substr(at_, end - at_) : std::string_view();
}

std::string_view Cursor::word() {
  const std::string_view found = peekWord();
  skip(found.size());
  return found;
}

bool Cursor::takeWord(std::string_view upperCase) {
  if (!equalsWord(peekWord(), upperCase)) return false;
  skip(upperCase.size());
  return true;
}

std::uint32_t Cursor::quotedEnd() const {
  const char mark = peek();
  for (std::size_t i = at_ + 1; i < text_.size() && text_[i] != '\n'; ++i) {
    if (mark == '\'' && text_[i] == '$' && i + 1 < text_.size() && text_[i + 1] != '\n') {
      ++i;
    } else if (text_[i] == mark) {
      return static_cast<std::uint32_t>(i + 1);
    }
  }
  return 0;
}

}  // namespace rungproof::step7
