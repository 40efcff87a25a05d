// What the parts of the parser share: the tokens, what is expected, and how an error is left behind.
#pragma once

#include <fmt/format.h>

#include <initializer_list>

#include "frontend/iec/iec_parser.hpp"

namespace rungproof::iec {

/// VAR, VAR_INPUT and the like. A name may begin so too.
bool isSectionWord(const std::string& folded);
/// END_IF, END_VAR and the like.
bool isEndWord(const std::string& folded);

class ParserCore {
 protected:
  ParserCore(const SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives)
      : source_(source), sink_(sink), tokens_(tokensOf(source, sink, directives)) {}

  /// Thrown where reading cannot go on; caught where it can begin again.
  struct Unreadable {};

  const IecToken& peek(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
  const IecToken& take() { return at_ + 1 < tokens_.size() ? tokens_[at_++] : tokens_[at_]; }
  bool isEnd() const { return peek().kind == TokenKind::End; }
  static bool isWord(const IecToken& token, std::string_view word) {
    return token.kind == TokenKind::Word && foldedName(token.text) == word;
  }
  bool is(std::string_view word) const {
    const IecToken& token = peek();
    return token.kind == TokenKind::Punctuation ? token.text == word : isWord(token, word);
  }
  bool isAny(std::initializer_list<std::string_view> words) const {
    for (const std::string_view word : words) {
      if (is(word)) return true;
    }
    return false;
  }
  bool accept(std::string_view word) {
    if (!is(word)) return false;
    take();
    return true;
  }
  void expect(std::string_view word) {
    if (!accept(word)) fail(fmt::format("'{}' is needed here{}", word, found()));
  }
  std::string name(std::string_view what) {
    if (peek().kind != TokenKind::Word) fail(fmt::format("{} is needed here{}", what, found()));
    return std::string(take().text);
  }
  std::string found() const {
    return isEnd() ? std::string(", the text ends") : fmt::format(", not '{}'", excerpt(peek().text));
  }
  [[noreturn]] void fail(std::string message) { failAt(peek(), std::move(message)); }
  [[noreturn]] void failAt(const IecToken& token, std::string message) {
    report(std::move(message), token);
    throw Unreadable{};
  }
  void report(std::string message, const IecToken& at) {
    sink_.report(source_.mistake(), source_.span(at.begin, std::max(at.end, at.begin)), std::move(message));
  }
  Span spanFrom(std::uint32_t begin) const {
    const std::uint32_t end = at_ > 0 ? tokens_[at_ - 1].end : begin;
    return source_.span(begin, std::max(begin, end));
  }

  /// What nobody uses does no harm to the rest, and each use of it is an error at its place.
  void leaveOut(std::uint32_t begin, const std::string& message, Severity severity, Syntax code = Syntax::IecTaken) {
    const std::size_t before = sink_.program().findings.size();
    sink_.report(code, spanFrom(begin), message);
    if (sink_.program().findings.size() == before) return;
    Finding& told = sink_.program().findings.back();
    told.help = "what uses it is not covered; the rest is read";
    told.severity = severity;
  }

  /// Keeps hostile nesting from exhausting the stack.
  struct Nesting {
    explicit Nesting(ParserCore& parser) : parser_(parser) {
      if (++parser_.depth_ > 200) {
        --parser_.depth_;
        parser_.fail("this is nested too deeply");
      }
    }
    ~Nesting() { --parser_.depth_; }
    ParserCore& parser_;
  };

  const SourceText& source_;
  SyntaxSink& sink_;
  std::vector<IecToken> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace rungproof::iec
