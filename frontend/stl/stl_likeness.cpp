// What a text is, judged by its first lines.
#include "frontend/stl/stl_likeness.hpp"

#include "frontend/stl/stl_keyword.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/stl_statement.hpp"

namespace rungproof {

StlLikeness stlLikeness(std::string_view text) {
  StlLikeness likeness;
  const std::string_view start = trimmed(text.substr(0, 512));
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && (start[first] == '<' || start[first] == '{' || start[first] == '[')) {
    likeness.isMarkup = true;
    return likeness;
  }
  StlLexer lexer(text);
  Line line;
  int lines = 0, hits = 0, seen = 0;
  const OperandContext contexts[] = {{Spelling::International}, {Spelling::German}};
  while (seen < 4000 && lexer.next(line)) {
    if (line.words.empty()) continue;
    ++seen;
    const std::string_view word = lexer.slice(line.words[0]);
    std::size_t length = 0;
    switch (keywordOf(word, length)) {
      case Keyword::OrganizationBlock:
      case Keyword::SubroutineBlock:
      case Keyword::InterruptBlock:
      case Keyword::DataBlock:
      case Keyword::SymbolTable: likeness.hasHeading = true; return likeness;
      case Keyword::Network: ++lines, ++hits; continue;
      default: break;
    }
    if (lines >= 300 || static_cast<unsigned char>(word[0]) >= 0x80) continue;
    ++lines;
    const std::string_view second = line.words.size() > 1 ? lexer.slice(line.words[1]) : std::string_view();
    if (readOlderHeading(word, second, line.words.size())) {
      ++hits;
      continue;
    }
    for (const OperandContext& context : contexts) {
      MnemonicResult found = findMnemonic(word, context);
      if (found.desc == nullptr && !second.empty()) found = findComparison(word, second, context);
      if (found.desc == nullptr) continue;
      const OperandLimits limits = operandLimits(*found.desc);
      const std::size_t operands = line.words.size() - 1 + (found.length < word.size() ? 1 : 0);
      if (operands >= limits.least && operands <= 2 * limits.most + 1) {
        ++hits;
        break;
      }
    }
  }
  likeness.share = lines == 0 ? 0 : hits * 100 / lines;
  return likeness;
}

Spelling detectSpelling(std::string_view text) {
  StlLexer lexer(text);
  Line line;
  int german = 0, international = 0, seen = 0;
  Operand operand;
  while (seen < 20000 && lexer.next(line)) {
    if (line.words.empty()) continue;
    ++seen;
    const std::string_view word = lexer.slice(line.words[0]);
    if (word.size() <= 4 && line.words.size() <= 3) {
      const char first = upper(word[0]);
      if (first == 'U' && s7200Instructions().namedGerman(word) != nullptr) ++german;
      if (first == 'A' && s7200Instructions().named(word) != nullptr) ++international;
    }
    for (std::size_t i = 1; i < line.words.size(); ++i) {
      const std::string_view text2 = lexer.slice(line.words[i]);
      const char first = upper(text2[0]);
      if (first == 'E' || first == 'A' || first == 'Z') {
        if (readAddress(text2, Spelling::German, operand) && !readAddress(text2, Spelling::International, operand))
          ++german;
      } else if (first == 'I' || first == 'Q' || first == 'C') {
        if (readAddress(text2, Spelling::International, operand)) ++international;
      }
    }
  }
  return german > international ? Spelling::German : Spelling::International;
}

}  // namespace rungproof
