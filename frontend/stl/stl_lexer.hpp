// Lines of a statement list, cut into words. A line holds one instruction: mnemonic, operands separated by commas
// or blanks, and a comment after // (001:747, 001:2134). Quotes protect blanks, commas and slashes. A semicolon ends
// a statement, as the import syntax allows. Words are slices of the file text; nothing is copied.
// Tested by tests/reader/stl_lexer_test.cpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace rungproof {

struct Word {
  std::uint32_t begin = 0;  ///< offset in the file
  std::uint32_t end = 0;
  bool afterComma = false;  ///< a comma stands before it
};

struct Line {
  std::vector<Word> words;         ///< of the first statement on the line
  std::uint32_t begin = 0;         ///< first character that is not blank
  std::uint32_t end = 0;           ///< end of the statement, before comment and semicolon
  std::uint32_t commentBegin = 0;  ///< equal to commentEnd: no comment
  std::uint32_t commentEnd = 0;
  bool openQuote = false;      ///< a quotation mark has no partner
  bool endsWithComma = false;  ///< a comma stands behind the last word
  bool isBanner = false;       ///< the whole line is a comment without sign: stars, dashes, "/*"

  bool hasComment() const { return commentBegin < commentEnd; }
};

/// Cuts text[offset, ...) into lines and statements, front to back.
class StlLexer {
 public:
  explicit StlLexer(std::string_view text) : text_(text) {}

  /// The next statement, or false at the end. `line` is overwritten; its buffers are reused.
  bool next(Line& line);
  /// The next physical line without its end, or false; for titles and tables.
  bool nextRaw(std::uint32_t& begin, std::uint32_t& end);
  /// Offset where the next statement begins.
  std::uint32_t position() const { return at_; }
  /// Goes back to an offset that position() gave.
  void rewind(std::uint32_t position) { at_ = position; }
  std::string_view slice(std::uint32_t begin, std::uint32_t end) const { return text_.substr(begin, end - begin); }
  std::string_view slice(const Word& word) const { return slice(word.begin, word.end); }

 private:
  std::string_view text_;
  std::uint32_t at_ = 0;
};

/// Length of the blank at text[at]: blank, tab, no-break space, ideographic space, byte order mark; else 0.
std::size_t wideBlankLength(std::string_view text, std::size_t at);
inline std::size_t blankLength(std::string_view text, std::size_t at) {
  const char c = text[at];
  if (c == ' ' || c == '\t' || c == '\r') return 1;
  return static_cast<unsigned char>(c) < 0xC2 ? 0 : wideBlankLength(text, at);
}
/// Length of an opening or closing quotation mark at text[at] and its kind: ' or "; length 0 if there is none.
struct Quote {
  std::size_t length = 0;
  char kind = 0;
};
Quote wideQuoteAt(std::string_view text, std::size_t at);
inline Quote quoteAt(std::string_view text, std::size_t at) {
  const char c = text[at];
  if (c == '"' || c == '\'') return {1, c};
  return static_cast<unsigned char>(c) < 0xC2 ? Quote{} : wideQuoteAt(text, at);
}
/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
inline char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }
/// ASCII letters compare in any case.
bool equalsIgnoringCase(std::string_view a, std::string_view b);

}  // namespace rungproof
