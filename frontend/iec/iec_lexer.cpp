// Tokens of IEC 61131-3 texts.
#include "frontend/iec/iec_lexer.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "frontend/stl/directive.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::iec {

Span SourceText::span(std::uint32_t begin, std::uint32_t end) const {
  if (places == nullptr) return {file, offset + begin, end - begin};
  const auto at = [&](std::uint32_t i) {
    return i < places->size() ? (*places)[i] : places->empty() ? 0 : places->back();
  };
  return {file, offset + at(begin), end > begin ? at(end - 1) - at(begin) + 1 : 0};
}

namespace {

bool startsName(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || (static_cast<unsigned char>(c) & 0x80) != 0;
}
bool isDigitOf(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool isNamePart(char c) { return startsName(c) || isDigitOf(c); }

/// Areas of the S7-300/400 in both sets of mnemonics, which a blank may part from the number in SCL.
bool isStep7Area(std::string_view word) {
  static constexpr std::string_view areas[] = {"I",   "IB",  "IW",  "ID",  "IX",  "E",   "EB",  "EW",  "ED",  "EX",
                                               "Q",   "QB",  "QW",  "QD",  "QX",  "A",   "AB",  "AW",  "AD",  "AX",
                                               "M",   "MB",  "MW",  "MD",  "MX",  "PIB", "PIW", "PID", "PEB", "PEW",
                                               "PED", "PQB", "PQW", "PQD", "PAB", "PAW", "PAD", "DBX", "DBB", "DBW",
                                               "DBD", "T",   "C",   "Z",   "DB",  "FB",  "FC",  "SFC", "SFB"};
  return std::ranges::find(areas, foldedName(word)) != std::end(areas);
}

class IecLexer {
 public:
  IecLexer(const SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives, std::vector<Span>* comments)
      : source_(source), text_(source.text), sink_(sink), directives_(directives), comments_(comments) {}

  std::vector<IecToken> run() {
    std::vector<IecToken> tokens;
    while (pass(), at_ < text_.size()) tokens.push_back(next());
    tokens.push_back({TokenKind::End, {}, {}, size(), size()});
    return tokens;
  }

 private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(text_.size()); }
  bool sees(std::string_view word) const { return text_.substr(at_, word.size()) == word; }

  /// Blanks, comments, pragmas.
  void pass() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        ++at_;
      } else if (sees("//")) {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        const std::string_view line = trimmed(text_.substr(at_, end - at_));
        comment(line);
        keep(at_, at_ + line.size());
        at_ = end;
      } else if (sees("(*DBG:")) {
        // What OpenPLC appends for its debugger: C, in which *) may stand, a comment for each line.
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (sees("(*")) {
        nested("(*", "*)");
      } else if (sees("/*")) {
        nested("/*", "*/");
      } else if (text_[at_] == '{' && isPragma()) {
        at_ = endOfBraces();
      } else if (source_.isScl && isRegion()) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        return;
      }
    }
  }
  /// REGION name, END_REGION: alone on their lines, for the reader of the text only.
  bool isRegion() const {
    if (at_ > 0 && isNamePart(text_[at_ - 1])) return false;
    std::size_t end = at_;
    while (end < text_.size() && isNamePart(text_[end])) ++end;
    const std::string word = foldedName(text_.substr(at_, end - at_));
    if (word == "END_REGION") return true;
    const std::size_t next = std::min(text_.find_first_not_of(" \t", end), text_.size());
    constexpr std::string_view others = ":=.[(;,)";
    return word == "REGION" && next < text_.size() && others.find(text_[next]) == std::string_view::npos;
  }

  /// Braces hold directives to a compiler; those of MatIEC and Beremiz hold code in C.
  bool isPragma() const {
    static constexpr std::string_view words[] = {"attribute", "external", "region",  "endregion", "warning", "error",
                                                 "info",      "text",     "define",  "undefine",  "if",      "elsif",
                                                 "else",      "end_if",   "flow",    "library",   "disable", "enable",
                                                 "page",      "pragma",   "implicit"};
    std::string_view inner = text_.substr(at_ + 1, endOfBraces() - at_ - 1);
    while (!inner.empty() && std::isspace(static_cast<unsigned char>(inner.front())) != 0) inner.remove_prefix(1);
    std::string word;
    for (const char c : inner) {
      if (!isNamePart(c)) break;
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return inner.find_first_of(";={") == std::string_view::npos || std::ranges::find(words, word) != std::end(words);
  }
  /// Behind the brace that closes the one here.
  std::size_t endOfBraces() const {
    std::size_t depth = 0;
    for (std::size_t i = at_; i < text_.size(); ++i) {
      if (text_[i] == '{') ++depth;
      if (text_[i] == '}' && --depth == 0) return i + 1;
    }
    return text_.size();
  }

  /// Behind the comment that begins here and those within it; nothing if there are fewer ends than beginnings.
  std::optional<std::size_t> endOfNested(std::string_view open, std::string_view close) const {
    std::size_t depth = 0;
    for (std::size_t i = at_; i < text_.size();) {
      const std::string_view mark = text_.substr(i, 2);
      i += mark == open || mark == close ? 2 : 1;
      if (mark == open) ++depth;
      if (mark == close && --depth == 0) return i;
    }
    return std::nullopt;
  }

  /// Comments stand in comments, as in the third edition of the standard. A text whose comments would then have no end
  /// is one for MatIEC: there the first mark that ends a comment ends it.
  void nested(std::string_view open, std::string_view close) {
    const std::size_t first = at_;
    const std::optional<std::size_t> end = isFlat_ ? std::nullopt : endOfNested(open, close);
    const std::size_t firstEnd = end ? *end : text_.find(close, first + 2);
    isFlat_ = !end;
    at_ = end ? *end : firstEnd == std::string_view::npos ? text_.size() : firstEnd + 2;
    keep(first, at_);
    if (firstEnd == std::string_view::npos)
      sink_.report(source_.mistake(),
                   source_.span(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(first) + 2),
                   "the comment has no end");
    std::string_view inner = text_.substr(first + 2, at_ - first - 2);
    while (!inner.empty()) {
      const std::size_t end = std::min(inner.find('\n'), inner.size());
      std::string_view line = trimmed(inner.substr(0, end));
      if (line.ends_with(close)) line = trimmed(line.substr(0, line.size() - 2));
      comment(line);
      inner.remove_prefix(std::min(end + 1, inner.size()));
    }
  }
  void keep(std::size_t begin, std::size_t end) {
    if (comments_ != nullptr)
      comments_->push_back(source_.span(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)));
  }
  void comment(std::string_view line) {
    const auto directive = directiveText(line);
    if (!directive) return;
    const auto begin = static_cast<std::uint32_t>(line.data() - text_.data());
    directives_.push_back(
        {std::string(*directive), source_.span(begin, begin + static_cast<std::uint32_t>(line.size())), -1, 0});
  }

  IecToken token(TokenKind kind, std::size_t first) const {
    return {
        kind, text_.substr(first, at_ - first), {}, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(at_)};
  }

  IecToken next() {
    const std::size_t first = at_;
    const char c = text_[at_];
    if (source_.isScl && (c == '"' || c == '#')) return sclName();
    if (c == '\'' || c == '"') return quotation(c);
    if (c == '%') {
      ++at_;
      while (at_ < text_.size() && (isNamePart(text_[at_]) || text_[at_] == '*' || isPoint())) ++at_;
      return token(TokenKind::Address, first);
    }
    if (c == '{') {
      at_ = endOfBraces();
      return token(TokenKind::Punctuation, first);
    }
    if (isDigitOf(c)) return number();
    if (startsName(c)) return word();
    static constexpr std::string_view pairs[] = {":=", "=>", "<=", ">=", "<>", "**", ".."};
    for (const std::string_view pair : pairs) {
      if (!sees(pair)) continue;
      at_ += 2;
      return token(TokenKind::Punctuation, first);
    }
    ++at_;
    return token(TokenKind::Punctuation, first);
  }
  /// A point between digits: not the two of a range.
  bool isPoint() const { return text_[at_] == '.' && at_ + 1 < text_.size() && isDigitOf(text_[at_ + 1]); }

  IecToken word() {
    const std::size_t first = at_;
    while (at_ < text_.size() && isNamePart(text_[at_])) ++at_;
    if (source_.isScl) blankOfAddress(first);
    if (at_ >= text_.size() || text_[at_] != '#') return token(TokenKind::Word, first);
    const std::string_view prefix = text_.substr(first, at_ - first);
    ++at_;
    const std::size_t behind = std::min(text_.find_first_not_of(" \t", at_), text_.size());
    if (behind < text_.size() && isDigitOf(text_[behind])) at_ = behind;  // T# 5s, as generators write it
    const std::size_t value = at_;
    if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
    while (at_ < text_.size() && (isNamePart(text_[at_]) || text_[at_] == '#' || isPoint() || isDateMark())) ++at_;
    IecToken made = token(TokenKind::Number, value);
    made.prefix = prefix;
    made.begin = static_cast<std::uint32_t>(first);
    return made;
  }
  /// DBX 0.0, FB 1: the number belongs to the word.
  void blankOfAddress(std::size_t first) {
    const std::size_t next = std::min(text_.find_first_not_of(" \t", at_), text_.size());
    if (next == at_ || next >= text_.size() || !isDigitOf(text_[next])) return;
    if (!isStep7Area(text_.substr(first, at_ - first))) return;
    at_ = next;
    while (at_ < text_.size() && isDigitOf(text_[at_])) ++at_;
  }
  /// #name, #"name", "name": a word with its marks.
  IecToken sclName() {
    const std::size_t first = at_;
    if (text_[at_] == '#') ++at_;
    if (at_ < text_.size() && text_[at_] == '"') {
      quotation('"');
    } else {
      while (at_ < text_.size() && isNamePart(text_[at_])) ++at_;
    }
    return token(TokenKind::Word, first);
  }
  /// - and : within dates and times of day.
  bool isDateMark() const {
    return (text_[at_] == '-' || text_[at_] == ':') && at_ + 1 < text_.size() && isDigitOf(text_[at_ + 1]) &&
           isDigitOf(text_[at_ - 1]);
  }

  IecToken number() {
    const std::size_t first = at_;
    const auto digits = [&] {
      while (at_ < text_.size() && (isDigitOf(text_[at_]) || text_[at_] == '_')) ++at_;
    };
    digits();
    if (at_ < text_.size() && text_[at_] == '#') {
      ++at_;
      while (at_ < text_.size() && (std::isxdigit(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
        ++at_;
      return token(TokenKind::Number, first);
    }
    if (isFraction()) {
      ++at_;
      digits();
    }
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      std::size_t exponent = at_ + 1;
      if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
      if (exponent < text_.size() && isDigitOf(text_[exponent])) {
        at_ = exponent;
        digits();
      }
    }
    return token(TokenKind::Number, first);
  }
  bool isFraction() const { return at_ < text_.size() && isPoint(); }

  IecToken quotation(char mark) {
    const std::size_t first = at_++;
    while (at_ < text_.size() && text_[at_] != mark && text_[at_] != '\n') at_ += text_[at_] == '$' ? 2 : 1;
    at_ = std::min(at_, text_.size());
    if (at_ < text_.size() && text_[at_] == mark) {
      ++at_;
    } else {
      sink_.report(source_.mistake(),
                   source_.span(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(first) + 1),
                   "the text has no closing mark");
    }
    return token(TokenKind::Text, first);
  }

  const SourceText& source_;
  std::string_view text_;
  SyntaxSink& sink_;
  std::vector<Directive>& directives_;
  std::vector<Span>* comments_;
  bool isFlat_ = false;  ///< comments do not stand in comments
  std::size_t at_ = 0;
};

}  // namespace

std::vector<IecToken> tokensOf(const SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives,
                               std::vector<Span>* comments) {
  return IecLexer(source, sink, directives, comments).run();
}

}  // namespace rungproof::iec
