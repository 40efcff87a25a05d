// Lines in their new form. A line is changed only if the text between the words that were read is blank.
#include "frontend/editor/formatting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "frontend/editor/structured_text.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

constexpr std::size_t operandColumn = 7;       ///< S7-200: "LD     I0.0"
constexpr std::size_t statementColumn = 6;     ///< S7-300/400: room for "M001: "
constexpr std::size_t step7MnemonicWidth = 6;  ///< S7-300/400: "A     I 0.0;"

/// Runs of blanks outside quotation marks become one blank.
std::string squeezed(std::string_view text) {
  std::string result;
  char quote = 0;
  for (const char c : text) {
    if (quote == 0 && (c == '"' || c == '\''))
      quote = c;
    else if (c == quote)
      quote = 0;
    const bool isBlank = quote == 0 && (c == ' ' || c == '\t');
    if (isBlank && (result.empty() || result.back() == ' ')) continue;
    result += isBlank ? ' ' : c;
  }
  return result;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

class LineEdits {
 public:
  LineEdits(const CheckedDocument& document, std::uint32_t first, std::uint32_t last)
      : document_(document), first_(first), last_(last) {}

  const CheckedDocument& document() const { return document_; }
  void replace(std::uint32_t begin, std::uint32_t end, const std::string& text) {
    const std::uint32_t line = document_.place(begin).line;
    if (line < first_ || line > last_) return;
    const Span span{document_.file(), begin, end - begin};
    if (document_.source().text(span) == text) return;
    list_.push_back({{"range", document_.range(span)}, {"newText", text}});
  }
  Json take() { return std::move(list_); }

 private:
  const CheckedDocument& document_;
  const std::uint32_t first_, last_;
  Json list_ = Json::array();
};

/// Where a statement stands on its line.
struct Placed {
  std::uint32_t lineBegin = 0;
  std::string_view before;  ///< from the beginning of the line
  std::uint32_t begin = 0, end = 0;
};

std::optional<Placed> placed(const CheckedDocument& document, const Instruction& instruction) {
  const SourceFile& source = document.source();
  const std::uint32_t begin = instruction.span.offset, end = begin + instruction.span.length;
  if (source.text(instruction.span).find('\n') != std::string_view::npos) return std::nullopt;
  const std::uint32_t lineBegin = source.lineStart(source.position(begin).line);
  return Placed{lineBegin, source.text().substr(lineBegin, begin - lineBegin), begin, end};
}

/// The operands as written, if nothing but blanks and one comma stands between them.
std::optional<std::vector<std::string>> operandTexts(const CheckedDocument& document, const Instruction& instruction) {
  std::vector<std::string> texts;
  std::uint32_t at = instruction.mnemonic().offset + instruction.mnemonicLength;
  const std::string_view text = document.source().text();
  for (const Operand& operand : instruction.operands) {
    if (operand.span.length == 0 || operand.span.offset < at) return std::nullopt;
    const std::string_view between = trimmed(text.substr(at, operand.span.offset - at));
    if (!between.empty() && (between != "," || texts.empty())) return std::nullopt;
    texts.push_back(squeezed(trimmed(document.source().text(operand.span))));
    at = operand.span.offset + operand.span.length;
  }
  const std::uint32_t end = instruction.span.offset + instruction.span.length;
  if (at < end && !trimmed(text.substr(at, end - at)).empty()) return std::nullopt;
  return texts;
}

/// S7-200: "LD     I0.0", "TON    T37, +100".
void formatStatement(const Instruction& instruction, const Placed& place, LineEdits& edits) {
  if (!trimmed(place.before).empty()) return;
  const auto operands = operandTexts(edits.document(), instruction);
  if (!operands) return;
  std::string text(edits.document().source().text(instruction.mnemonic()));
  std::ranges::transform(text, text.begin(), upper);
  if (!operands->empty()) {
    text = padded(std::move(text), operandColumn - 1) + ' ';
    for (std::size_t i = 0; i < operands->size(); ++i) text += (i > 0 ? ", " : "") + (*operands)[i];
  }
  edits.replace(place.lineBegin, place.end, text);
}

/// S7-300/400: "M001: A     I 0.0", and no blank before the semicolon.
void formatStep7Statement(const Instruction& instruction, const Placed& place, LineEdits& edits) {
  const std::string_view before = trimmed(place.before);
  const bool isLabel = before.size() > 1 && before.size() < statementColumn && before.ends_with(':') &&
                       before.find_first_of(" \t\"'/;") == std::string_view::npos;
  if (!before.empty() && !isLabel) return;
  const std::string_view written = edits.document().source().text(instruction.span);
  const std::string_view rest = trimmed(written.substr(instruction.mnemonicLength));
  if (rest.find_first_of("(\"'") != std::string_view::npos && rest.find(':') != std::string_view::npos) return;
  std::string text = padded(std::string(before), statementColumn);
  text += written.substr(0, instruction.mnemonicLength);
  if (!rest.empty()) text = padded(std::move(text), statementColumn + step7MnemonicWidth - 1) + ' ' + squeezed(rest);
  const std::string_view behind = edits.document().source().text().substr(place.end);
  const std::size_t blanks = std::min(behind.find_first_not_of(" \t"), behind.size());
  const bool endsHere = behind.substr(blanks).starts_with(';');
  edits.replace(place.lineBegin, place.end + static_cast<std::uint32_t>(endsHere ? blanks : 0), text);
}

void formatStatements(LineEdits& edits) {
  const CheckedDocument& document = edits.document();
  const bool areNames = dialectOf(document.program().target).text.labelsAreNames;
  const bool hasAccumulators = formOf(document.program().target) == StatementForm::Accumulators;
  std::map<std::uint32_t, std::size_t> statementsOfLine;
  const auto each = [&](const auto& visit) {
    for (const Pou& pou : document.program().pous) {
      for (const Network& network : pou.networks) {
        if (network.drawing != nullptr) continue;
        for (const Instruction& instruction : network.instructions) {
          const bool isBareLabel = areNames && instruction.desc->control == Control::LabelMark;
          if (!document.isHere(instruction.span) || instruction.span.length == 0 || isBareLabel) continue;
          if (const auto place = placed(document, instruction)) visit(instruction, *place);
        }
      }
    }
  };
  each([&](const Instruction&, const Placed& place) { ++statementsOfLine[place.lineBegin]; });
  each([&](const Instruction& instruction, const Placed& place) {
    if (statementsOfLine[place.lineBegin] > 1 || instruction.mnemonicLength == 0) return;
    hasAccumulators ? formatStep7Statement(instruction, place, edits) : formatStatement(instruction, place, edits);
  });
}

/// Levels of structured text, from the first word of each line and what opens and closes in it.
class Indentation {
 public:
  explicit Indentation(const CheckedDocument& document) : source_(document.source()) {
    int level = 0;
    const std::vector<iec::IecToken> tokens = tokensOf(document);
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
      const iec::IecToken& token = tokens[i];
      const std::uint32_t line = source_.position(token.begin).line;
      const bool isFirst = levels_.empty() || levels_.rbegin()->first != line;
      const TextWord* const word = token.kind == iec::TokenKind::Word ? structuredTextWord(token.text) : nullptr;
      const Nesting nesting = word == nullptr || isName(tokens, i) ? Nesting::None : word->nesting;
      if (nesting == Nesting::Closes) level = std::max(0, level - 1);
      const int own = level - (nesting == Nesting::Between && level > 0 ? 1 : 0);
      // What goes on with an expression is one level further in.
      const bool goesOn = isFirst && i > 0 && nesting == Nesting::None &&
                          (joins(tokens[i - 1]) || (token.kind == iec::TokenKind::Punctuation && joins(token)));
      if (isFirst) levels_[line] = own + (goesOn ? 1 : 0);
      if (nesting == Nesting::Opens) ++level;
    }
  }
  const std::map<std::uint32_t, int>& levels() const { return levels_; }

 private:
  /// What stands between the parts of an expression.
  static bool joins(const iec::IecToken& token) {
    static constexpr std::array<std::string_view, 5> words = {"AND", "OR", "XOR", "NOT", "MOD"};
    if (token.kind == iec::TokenKind::Word)
      return std::ranges::any_of(words, [&](std::string_view word) { return equalsIgnoringCase(word, token.text); });
    return token.kind == iec::TokenKind::Punctuation && token.text != ";" && token.text != ":" && token.text != ")" &&
           token.text != "]";
  }
  /// A member or a formal parameter of that name.
  static bool isName(const std::vector<iec::IecToken>& tokens, std::size_t i) {
    return i > 0 && (tokens[i - 1].text == "." || tokens[i + 1].text == ":=");
  }

  const SourceFile& source_;
  std::map<std::uint32_t, int> levels_;  ///< of the lines that begin with a token
};

void formatStructuredText(const FormatStyle& style, LineEdits& edits) {
  const CheckedDocument& document = edits.document();
  const SourceFile& source = document.source();
  for (const auto& [line, level] : Indentation(document).levels()) {
    const std::string_view text = source.line(line);
    const std::size_t first = text.find_first_not_of(" \t");
    // A comment before the first token belongs to the line; one that began earlier stays.
    if (first == std::string_view::npos || text.find("*)") < text.find("(*")) continue;
    const std::uint32_t begin = source.lineStart(line);
    edits.replace(begin, begin + static_cast<std::uint32_t>(first),
                  std::string(static_cast<std::size_t>(level) * style.tabSize, ' '));
  }
}

}  // namespace

Json formattingEdits(const CheckedDocument& document, const FormatStyle& style, std::uint32_t first,
                     std::uint32_t last) {
  LineEdits edits(document, first, last);
  if (document.source().text().empty() || isSclText(document)) return edits.take();
  if (isStructuredText(document))
    formatStructuredText(style, edits);
  else
    formatStatements(edits);
  return edits.take();
}

}  // namespace rungproof
