// The words of structured text as the editor needs them: what is a keyword, what opens and what closes a piece that is
// indented. Tested by tests/editor/semantic_tokens_test.cpp and tests/editor/formatting_test.cpp.
#pragma once

#include <span>
#include <string_view>

#include "frontend/editor/checked_document.hpp"
#include "frontend/iec/iec_lexer.hpp"

namespace rungproof {

/// What a keyword does to the indentation of its line and of those that follow.
enum class Nesting : std::uint8_t { None, Opens, Closes, Between };

struct TextWord {
  std::string_view word;
  Nesting nesting = Nesting::None;
};
std::span<const TextWord> structuredTextWords();
/// The keyword, in any case of letters, or nullptr.
const TextWord* structuredTextWord(std::string_view text);

/// Whether the document is a text of IEC 61131-3, and no drawing in an XML file.
bool isStructuredText(const CheckedDocument& document);
/// Whether bodies in SCL stand in the document. Its instructions are not what its words are.
bool isSclText(const CheckedDocument& document);
/// The tokens of such a document, or of another file of its program; what is wrong with it is not said again.
std::vector<iec::IecToken> tokensOf(const CheckedDocument& document);
std::vector<iec::IecToken> tokensOf(const CheckedDocument& document, std::uint32_t file,
                                    std::vector<Span>* comments = nullptr);
/// The files of the program that are texts of IEC 61131-3; the document, if it is one, is the first.
std::vector<std::uint32_t> structuredTextsOf(const CheckedDocument& document);

}  // namespace rungproof
