// Tokens of IEC 61131-3 texts: words, literals, punctuation. Comments (nested too) and pragmas are passed over;
// comments that begin with //@ are collected as directives.
#pragma once

#include <string_view>
#include <vector>

#include "frontend/stl/syntax_sink.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

enum class TokenKind : std::uint8_t { Word, Number, Text, Address, Punctuation, End };

struct IecToken {
  TokenKind kind = TokenKind::End;
  std::string_view text;    ///< as written; a literal with its prefix: T#5s
  std::string_view prefix;  ///< of a literal: "T", "INT", "COLOR"; text begins behind the #
  std::uint32_t begin = 0, end = 0;
};

/// A text on its way to a tree: all of a file, or a body out of an XML file. There `places` says for each character
/// where it stands in the file.
struct SourceText {
  std::string_view text;
  std::uint32_t file = 0;
  std::uint32_t offset = 0;
  const std::vector<std::uint32_t>* places = nullptr;
  /// SCL of the S7-300/400: #local, "symbol", addresses with a blank (DBX 0.0), REGION, DIV, GOTO and labels.
  bool isScl = false;

  /// What a mistake in the text is reported as.
  Syntax mistake() const { return isScl ? Syntax::SclText : Syntax::IecText; }
  Span span(std::uint32_t begin, std::uint32_t end) const;
};

/// The last token is End. `comments`: whole, with their signs, in the order of the text.
std::vector<IecToken> tokensOf(const SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives,
                               std::vector<Span>* comments = nullptr);

}  // namespace rungproof::iec
