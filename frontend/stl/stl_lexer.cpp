// One pass over each line.
#include "frontend/stl/stl_lexer.hpp"

#include <algorithm>
#include <array>

namespace rungproof {

bool equalsIgnoringCase(std::string_view a, std::string_view b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return upper(x) == upper(y); });
}

std::size_t wideBlankLength(std::string_view text, std::size_t at) {
  if (text.substr(at, 2) == "\xC2\xA0") return 2;
  const std::string_view three = text.substr(at, 3);
  return three == "\xE3\x80\x80" || three == "\xEF\xBB\xBF" || three == "\xE2\x80\x8B" ? 3 : 0;
}

Quote wideQuoteAt(std::string_view text, std::size_t at) {
  const char c = text[at];
  if (c == '\xE2') {
    const std::string_view three = text.substr(at, 3);
    if (three == "\xE2\x80\x9C" || three == "\xE2\x80\x9D" || three == "\xE2\x80\x9E") return {3, '"'};
    if (three == "\xE2\x80\x98" || three == "\xE2\x80\x99") return {3, '\''};
  }
  if (c == '\xC2') {
    const std::string_view two = text.substr(at, 2);
    if (two == "\xC2\xAB" || two == "\xC2\xBB") return {2, '"'};
  }
  return {};
}

std::string_view trimmed(std::string_view text) {
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t blank = blankLength(text, begin);
    if (blank == 0) break;
    begin += blank;
  }
  std::size_t end = text.size();
  while (end > begin) {
    if (blankLength(text, end - 1) == 1) {
      --end;
    } else if (end - begin >= 2 && blankLength(text, end - 2) == 2) {
      end -= 2;
    } else if (end - begin >= 3 && blankLength(text, end - 3) == 3) {
      end -= 3;
    } else {
      break;
    }
  }
  return text.substr(begin, end - begin);
}

namespace {

/// A line that is a comment without sign: "/* ...", "* * *", "*****", "-----", "=====", "```".
bool looksLikeBanner(std::string_view rest) {
  if (rest.substr(0, 2) == "/*" || rest.substr(0, 2) == "(*") return true;
  if (rest.substr(0, 3) == "```") return true;
  if (rest.empty() || std::string_view("*-=#_~").find(rest[0]) == std::string_view::npos) return false;
  const std::size_t other = rest.find_first_not_of(rest[0]);
  if (other == std::string_view::npos) return rest.size() >= 3;
  if (rest[0] == '*')
    return other >= 2 || rest.substr(std::min(rest.find_first_not_of(" \t", 1), rest.size() - 1), 1) == "*";
  return other >= 4;
}

/// The bytes that stand in words only: most of a text.
constexpr std::array<bool, 256> plainBytes = [] {
  std::array<bool, 256> plain{};
  for (const char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._"))
    plain[static_cast<unsigned char>(c)] = true;
  return plain;
}();
constexpr bool isPlainByte(char c) { return plainBytes[static_cast<unsigned char>(c)]; }

}  // namespace

bool StlLexer::nextRaw(std::uint32_t& begin, std::uint32_t& end) {
  if (at_ >= text_.size()) return false;
  begin = at_;
  const std::size_t newline = text_.find('\n', at_);
  end = static_cast<std::uint32_t>(newline == std::string_view::npos ? text_.size() : newline);
  at_ = newline == std::string_view::npos ? end : end + 1;
  if (end > begin && text_[end - 1] == '\r') --end;
  return true;
}

bool StlLexer::next(Line& line) {
  if (at_ >= text_.size()) return false;
  line.words.clear();
  line.commentBegin = line.commentEnd = 0;
  line.openQuote = line.isBanner = line.endsWithComma = false;
  std::size_t i = at_;
  const std::size_t size = text_.size();
  while (i < size && text_[i] != '\n') {
    const std::size_t blank = blankLength(text_, i);
    if (blank == 0) break;
    i += blank;
  }
  line.begin = static_cast<std::uint32_t>(i);
  if (i < size && !isLetter(text_[i]) && looksLikeBanner(text_.substr(i, std::min(text_.find('\n', i), size) - i))) {
    const std::size_t newline = std::min(text_.find('\n', i), size);
    line.isBanner = true;
    line.commentBegin = line.end = static_cast<std::uint32_t>(i);
    line.commentEnd = static_cast<std::uint32_t>(newline);
    if (newline > i && text_[newline - 1] == '\r') --line.commentEnd;
    at_ = static_cast<std::uint32_t>(std::min(newline + 1, size));
    return true;
  }
  bool comma = false;
  std::size_t wordBegin = std::string_view::npos;
  std::size_t lastEnd = i;
  const auto finishWord = [&](std::size_t end) {
    if (wordBegin == std::string_view::npos) return;
    line.words.push_back({static_cast<std::uint32_t>(wordBegin), static_cast<std::uint32_t>(end), comma});
    comma = false;
    wordBegin = std::string_view::npos;
    lastEnd = end;
  };
  bool atStatementEnd = false;
  while (i < size && text_[i] != '\n') {
    const char c = text_[i];
    if (isPlainByte(c)) {
      if (wordBegin == std::string_view::npos) wordBegin = i;
      while (++i < size && isPlainByte(text_[i])) {
      }
      continue;
    }
    if (c == '/' && i + 1 < size && text_[i + 1] == '/') {
      finishWord(i);
      const std::size_t newline = std::min(text_.find('\n', i), size);
      line.commentBegin = static_cast<std::uint32_t>(i);
      line.commentEnd = static_cast<std::uint32_t>(newline > i && text_[newline - 1] == '\r' ? newline - 1 : newline);
      i = newline;
      break;
    }
    if (c == ';') {
      finishWord(i);
      ++i;
      atStatementEnd = true;
      break;
    }
    if (c == ',' || (c == '\xEF' && text_.substr(i, 3) == "\xEF\xBC\x8C")) {
      finishWord(i);
      comma = true;
      i += c == ',' ? 1 : 3;
      continue;
    }
    if (const std::size_t blank = blankLength(text_, i); blank > 0) {
      finishWord(i);
      i += blank;
      continue;
    }
    if (wordBegin == std::string_view::npos) wordBegin = i;
    const Quote quote = quoteAt(text_, i);
    if (quote.length == 0 || line.openQuote) {
      ++i;
      continue;
    }
    std::size_t k = i + quote.length;
    bool closed = false;
    while (k < size && text_[k] != '\n') {
      const Quote partner = quoteAt(text_, k);
      if (text_[k] == '$' && k + 1 < size && text_[k + 1] != '\n') {
        k += 2;
      } else if (partner.kind == quote.kind) {
        k += partner.length;
        closed = true;
        break;
      } else {
        ++k;
      }
    }
    if (closed) {
      i = k;
    } else {
      line.openQuote = true;
      i += quote.length;
    }
  }
  finishWord(i);
  line.end = static_cast<std::uint32_t>(lastEnd);
  line.endsWithComma = comma && !atStatementEnd;
  if (atStatementEnd) {
    // A comment or nothing after the semicolon belongs to the same line.
    std::size_t rest = i;
    while (rest < size && text_[rest] != '\n' && blankLength(text_, rest) > 0) rest += blankLength(text_, rest);
    if (rest >= size || text_[rest] == '\n') {
      i = rest;
    } else if (text_[rest] == '/' && rest + 1 < size && text_[rest + 1] == '/') {
      const std::size_t newline = std::min(text_.find('\n', rest), size);
      line.commentBegin = static_cast<std::uint32_t>(rest);
      line.commentEnd =
          static_cast<std::uint32_t>(newline > rest && text_[newline - 1] == '\r' ? newline - 1 : newline);
      i = newline;
    } else {
      at_ = static_cast<std::uint32_t>(i);
      return true;
    }
  }
  at_ = static_cast<std::uint32_t>(std::min(i + 1, size));
  return true;
}

}  // namespace rungproof
