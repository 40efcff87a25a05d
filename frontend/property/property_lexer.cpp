// Tokens of the property language: words (addresses, symbols, keywords), numbers in the S7-200's forms
// (001:1425-1431), durations such as 500ms, 2s, 1.5s, 3min, 1h, and punctuation.
#include "frontend/property/property_lexer.hpp"

#include <bit>
#include <cctype>
#include <charconv>
#include <cstdlib>

namespace rungproof {

namespace {

constexpr std::int64_t largest = 0xFFFFFFFF;  ///< 32 bits

bool isWordStart(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || (static_cast<unsigned char>(c) & 0x80) != 0;
}
bool isWordPart(char c) { return isWordStart(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.'; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

class Lexer {
 public:
  Lexer(std::string_view text, std::uint32_t file, std::uint32_t offset) : text_(text), file_(file), offset_(offset) {}

  std::vector<Token> run() {
    std::vector<Token> tokens;
    for (;;) {
      while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
      if (at_ >= text_.size() || text_[at_] == '#') break;
      tokens.push_back(next());
    }
    tokens.push_back(
        {PropertyToken::End, {}, 0, false, {file_, offset_ + static_cast<std::uint32_t>(text_.size()), 0}, false});
    return tokens;
  }

 private:
  Token next() {
    if (text_[at_] == '%' && at_ + 1 < text_.size() && isWordStart(text_[at_ + 1])) ++at_;  // %Q0.0, as TIA writes
    const std::size_t start = at_;
    if (isDigit(text_[at_])) return number(start);
    const bool isQuoted = text_[at_] == '"' && text_.find('"', at_ + 1) != std::string_view::npos;
    if (isQuoted) at_ = text_.find('"', at_ + 1) + 1;  // "Motor".Speed
    if (isQuoted || isWordStart(text_[at_])) {
      while (at_ < text_.size() && (isWordPart(text_[at_]) || isIndex() || isQuotedPart()) &&
             text_.substr(at_, 2) != "..") {
        const char closing = text_[at_] == '[' ? ']' : text_[at_] == '"' ? '"' : '\0';
        at_ = closing == '\0' ? at_ + 1 : text_.find(closing, at_ + 1) + 1;
      }
      while (at_ > start + 1 && text_[at_ - 1] == '.') --at_;
      return token(PropertyToken::Word, start);
    }
    static constexpr std::string_view pairs[] = {"<>", "<=", ">=", "..", "==", "&&",
                                                 "||", "->", "=>", "!=", "/=", "=<"};
    for (const std::string_view pair : pairs) {
      if (text_.substr(at_, 2) == pair) {
        at_ += 2;
        return token(PropertyToken::Punctuation, start);
      }
    }
    ++at_;
    return token(PropertyToken::Punctuation, start);
  }

  /// [2] or [1,-3] behind the name of an array.
  bool isIndex() const {
    if (text_[at_] != '[') return false;  // before the search, which may go to the end of a long line
    const std::size_t end = text_.find(']', at_);
    return end != std::string_view::npos && end > at_ + 1 &&
           text_.substr(at_ + 1, end - at_ - 1).find_first_not_of("0123456789,- ") == std::string_view::npos;
  }

  /// ."stop nc" behind the name of a data block or a part.
  bool isQuotedPart() const {
    return text_[at_] == '"' && text_[at_ - 1] == '.' && text_.find('"', at_ + 1) != std::string_view::npos;
  }

  Token number(std::size_t start) {
    while (at_ < text_.size() && isDigit(text_[at_])) ++at_;
    if (at_ < text_.size() && text_[at_] == '#') return based(start);
    bool isReal = false;
    if (at_ + 1 < text_.size() && text_[at_] == '.' && isDigit(text_[at_ + 1])) {
      isReal = true;
      ++at_;
      while (at_ < text_.size() && isDigit(text_[at_])) ++at_;
    }
    const std::string digits(text_.substr(start, at_ - start));
    if (const std::int64_t unit = unitHere(); unit != 0) {
      Token t = token(PropertyToken::Duration, start);
      const double milliseconds = std::strtod(digits.c_str(), nullptr) * static_cast<double>(unit);
      t.isTooLarge = milliseconds > static_cast<double>(longestDuration);
      t.value = t.isTooLarge ? longestDuration : static_cast<std::int64_t>(milliseconds + 0.5);
      return t;
    }
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      std::size_t exponent = at_ + 1;
      if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
      if (exponent < text_.size() && isDigit(text_[exponent])) {
        isReal = true;
        at_ = exponent;
        while (at_ < text_.size() && isDigit(text_[at_])) ++at_;
      }
    }
    Token t = token(isReal ? PropertyToken::Real : PropertyToken::Number, start);
    const std::string all(t.text);
    if (isReal) {
      t.value = static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(std::strtof(all.c_str(), nullptr)));
      t.longValue = std::bit_cast<std::int64_t>(std::strtod(all.c_str(), nullptr));
      return t;
    }
    std::uint64_t number = 0;
    t.isHuge = std::from_chars(all.data(), all.data() + all.size(), number).ec != std::errc();
    t.isTooLarge = t.isHuge || number > static_cast<std::uint64_t>(largest);
    t.value = static_cast<std::int64_t>(number);
    return t;
  }

  /// 16#1F, 2#1010_0101: the digits before # are the base.
  Token based(std::size_t start) {
    int base = 10;
    std::from_chars(text_.data() + start, text_.data() + at_, base);
    ++at_;
    const std::size_t first = at_;
    while (at_ < text_.size() && (std::isxdigit(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
      ++at_;
    std::string digits;
    for (const char c : text_.substr(first, at_ - first)) {
      if (c != '_') digits += c;
    }
    Token t = token(PropertyToken::Number, start);
    std::uint64_t value = 0;
    const auto result =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, base == 16 || base == 2 ? base : 36);
    if ((base != 16 && base != 2) || digits.empty() || result.ec != std::errc() ||
        result.ptr != digits.data() + digits.size())
      t.kind = PropertyToken::Punctuation;
    t.value = static_cast<std::int64_t>(value);
    t.isTooLarge = value > static_cast<std::uint64_t>(largest);
    t.isPattern = true;
    return t;
  }

  /// Milliseconds of the unit that follows, 0 if none does.
  std::int64_t unitHere() {
    std::size_t end = at_;
    while (end < text_.size() && std::isalpha(static_cast<unsigned char>(text_[end])) != 0) ++end;
    std::string unit(text_.substr(at_, end - at_));
    for (char& c : unit) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const std::int64_t ms = unit == "ms"                   ? 1
                            : unit == "s"                  ? 1000
                            : unit == "m" || unit == "min" ? 60000
                            : unit == "h"                  ? 3600000
                                                           : 0;
    if (ms != 0) at_ = end;
    return ms;
  }

  Token token(PropertyToken kind, std::size_t start) const {
    return {kind,
            text_.substr(start, at_ - start),
            0,
            false,
            {file_, offset_ + static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(at_ - start)},
            false};
  }

  std::string_view text_;
  std::uint32_t file_;
  std::uint32_t offset_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text, std::uint32_t file, std::uint32_t offset) {
  return Lexer(text, file, offset).run();
}

}  // namespace rungproof
