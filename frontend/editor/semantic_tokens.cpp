// Kinds of words: of statement lists from the instructions that were read, of structured text from its tokens.
#include "frontend/editor/semantic_tokens.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "frontend/editor/cursor.hpp"
#include "frontend/editor/structured_text.hpp"

namespace rungproof {

namespace {

/// The order is that of the legend.
enum class WordKind : std::uint8_t { Keyword, Variable, Property, Parameter, Function, Label, Number, String };
constexpr std::array<std::string_view, 8> wordKindNames = {"keyword",  "variable", "property", "parameter",
                                                           "function", "label",    "number",   "string"};

class Words {
 public:
  explicit Words(const CheckedDocument& document) : document_(document) {}

  void add(Span span, WordKind kind) {
    const bool isOneLine = document_.source().text(span).find('\n') == std::string_view::npos;
    if (span.length > 0 && document_.isHere(span) && isOneLine) words_.emplace(span.offset, Word{span, kind});
  }

  Json take() const {
    Json data = Json::array();
    ClientPlace before;
    std::uint32_t end = 0;
    for (const auto& [offset, word] : words_) {
      if (offset < end) continue;  // part of a word that is listed
      end = offset + word.span.length;
      const ClientPlace first = document_.place(offset);
      const ClientPlace last = document_.place(end);
      data.push_back(first.line - before.line);
      data.push_back(first.line == before.line ? first.character - before.character : first.character);
      data.push_back(last.character - first.character);
      data.push_back(static_cast<int>(word.kind));
      data.push_back(0);
      before = first;
    }
    return {{"data", std::move(data)}};
  }

 private:
  struct Word {
    Span span;
    WordKind kind;
  };
  const CheckedDocument& document_;
  std::map<std::uint32_t, Word> words_;  ///< by offset
};

WordKind wordKindOf(const Instruction& instruction, std::size_t index, std::string_view written) {
  const Operand& operand = instruction.operands[index];
  if (const auto routine = routineType(instruction, index))
    return *routine == Type::Label ? WordKind::Label : WordKind::Function;
  const bool isDescribed = index < static_cast<std::size_t>(instruction.desc->operandCount);
  if (isDescribed && instruction.desc->operand(static_cast<int>(index)).type == Type::Block) return WordKind::Function;
  if (written.starts_with('#')) return WordKind::Parameter;
  if (written.starts_with('\'')) return WordKind::String;
  if (operand.kind == OperandKind::Constant) return WordKind::Number;
  return operand.text.empty() ? WordKind::Variable : WordKind::Property;
}

void addStatements(const CheckedDocument& document, Words& words) {
  for (const Pou& pou : document.program().pous) {
    for (const Network& network : pou.networks) {
      if (network.drawing != nullptr) continue;
      for (const Instruction& instruction : network.instructions) {
        if (!document.isHere(instruction.span)) continue;
        words.add(instruction.mnemonic(), WordKind::Keyword);
        for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
          const Span span = instruction.operands[i].span;
          if (span.length > 0 && document.isHere(span) &&
              span.offset >= instruction.mnemonic().offset + instruction.mnemonicLength)
            words.add(span, wordKindOf(instruction, i, document.source().text(span)));
        }
      }
    }
  }
}

void addStructuredText(const CheckedDocument& document, Words& words) {
  const std::vector<iec::IecToken> tokens = tokensOf(document);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const iec::IecToken& token = tokens[i];
    const Span span{document.file(), token.begin, token.end - token.begin};
    switch (token.kind) {
      case iec::TokenKind::Number: words.add(span, WordKind::Number); break;
      case iec::TokenKind::Text: words.add(span, WordKind::String); break;
      case iec::TokenKind::Address: words.add(span, WordKind::Variable); break;
      case iec::TokenKind::Word:
        if (structuredTextWord(token.text) != nullptr)
          words.add(span, WordKind::Keyword);
        else if (tokens[i + 1].text == "(")
          words.add(span, WordKind::Function);
        else
          words.add(span, i > 0 && tokens[i - 1].text == "." ? WordKind::Property : WordKind::Variable);
        break;
      default: break;
    }
  }
}

}  // namespace

Json semanticLegend() {
  Json names = Json::array();
  for (const std::string_view name : wordKindNames) names.push_back(name);
  return {{"tokenTypes", std::move(names)}, {"tokenModifiers", Json::array()}};
}

Json semanticTokensOf(const CheckedDocument& document) {
  Words words(document);
  if (isStructuredText(document) || isSclText(document))
    addStructuredText(document, words);
  else
    addStatements(document, words);
  return words.take();
}

}  // namespace rungproof
