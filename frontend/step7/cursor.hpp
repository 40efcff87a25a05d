// A place in a text that moves forward: blanks, comments, words, and what stands next. The readers of STEP 7 sources
// are written on it. Tested by tests/step7/parser_test.cpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ir/source.hpp"

namespace rungproof::step7 {

/// Letters, digits, underscore, and every byte beyond ASCII.
inline bool isWordByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}
inline bool isDecimal(char c) { return c >= '0' && c <= '9'; }

class Cursor {
 public:
  Cursor(std::string_view text, std::uint32_t file) : text_(text), file_(file) {}

  std::uint32_t at() const { return at_; }
  void to(std::uint32_t at) { at_ = at; }
  std::string_view text() const { return text_; }
  std::string_view slice(std::uint32_t begin, std::uint32_t end) const { return text_.substr(begin, end - begin); }
  Span span(std::uint32_t begin, std::uint32_t end) const { return {file_, begin, end > begin ? end - begin : 0}; }
  Span spanFrom(std::uint32_t begin) const { return span(begin, at_); }

  bool atEnd() const { return at_ >= text_.size(); }
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool startsWith(std::string_view text) const { return text_.substr(at_, text.size()) == text; }
  /// The same, ASCII letters in any case.
  bool startsWithLetters(std::string_view upperCase) const;
  void skip(std::size_t bytes) { at_ = static_cast<std::uint32_t>(at_ + bytes); }
  /// Takes the character if it stands next.
  bool take(char c);

  /// Blanks and (* comments *) inside the line.
  void skipBlanks();
  /// Blanks, line ends and comments; comments with // are noted in `remarks`.
  void skipSpace(std::vector<Span>& remarks);
  void skipSpace();
  /// At the end of the line, of the text, or at a comment that lasts to the end of the line.
  bool atLineEnd() const;
  /// The offset where the line ends, without CR and LF.
  std::uint32_t lineEnd() const;
  /// To the beginning of the next line.
  void nextLine();

  /// Word bytes from here; may be empty.
  std::string_view word();
  std::string_view peekWord() const;
  /// The word that stands next equals `upperCase`, and is taken.
  bool takeWord(std::string_view upperCase);
  /// The offset behind the character that ends a text which begins here with a mark ' or "; 0: the line ends first.
  std::uint32_t quotedEnd() const;

 private:
  std::string_view text_;
  std::uint32_t file_;
  std::uint32_t at_ = 0;
};

bool equalsWord(std::string_view word, std::string_view upperCase);

}  // namespace rungproof::step7
