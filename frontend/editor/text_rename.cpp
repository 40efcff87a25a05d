// The variable is found by the tokens of its block: declared between VAR and END_VAR, used anywhere but behind a point
// and as a formal parameter.
#include "frontend/editor/text_rename.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/stl/operand_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

using iec::IecToken;
using iec::TokenKind;

bool isWord(const IecToken& token, std::string_view word) {
  return token.kind == TokenKind::Word && equalsIgnoringCase(token.text, word);
}

/// A PROGRAM, FUNCTION or FUNCTION_BLOCK: its tokens, from its first word to its END.
struct TextBlock {
  std::string_view name;
  bool isProgram = false;
  std::size_t begin = 0, end = 0;
};

std::vector<TextBlock> textBlocksOf(const std::vector<IecToken>& tokens) {
  std::vector<TextBlock> blocks;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    for (const std::string_view word : {"PROGRAM", "FUNCTION", "FUNCTION_BLOCK"}) {
      if (!isWord(tokens[i], word)) continue;
      const std::string last = "END_" + std::string(word);
      std::size_t end = i;
      while (end + 1 < tokens.size() && !isWord(tokens[end], last)) ++end;
      // "PROGRAM P1 WITH Task : Main;" in a configuration is no block.
      if (!isWord(tokens[end], last)) continue;
      blocks.push_back({tokens[i + 1].text, word == "PROGRAM", i, end});
      i = end;
      break;
    }
  }
  return blocks;
}

/// The section that declares a name of the block: "VAR_INPUT"; empty if none does.
std::string_view sectionOf(const std::vector<IecToken>& tokens, const TextBlock& block, std::string_view name) {
  std::string_view section;
  bool declares = false;  // before the colon
  for (std::size_t i = block.begin; i < block.end; ++i) {
    const TextWord* const word = tokens[i].kind == TokenKind::Word ? structuredTextWord(tokens[i].text) : nullptr;
    if (word != nullptr && word->word.starts_with("VAR")) {
      section = word->word;
      declares = true;
    } else if (isWord(tokens[i], "END_VAR")) {
      section = {};
      declares = false;
    } else if (tokens[i].text == ":") {
      declares = false;
    } else if (tokens[i].text == ";") {
      declares = !section.empty();
    } else if (declares && isWord(tokens[i], name)) {
      return section;
    }
  }
  return {};
}

bool isMember(const std::vector<IecToken>& tokens, std::size_t i) { return i > 0 && tokens[i - 1].text == "."; }

/// "IN" of "T1(IN := x)": the tokens of the block say how deep in parentheses it stands.
bool isFormal(const std::vector<IecToken>& tokens, std::size_t i, int depth) {
  return depth > 0 && i + 1 < tokens.size() && (tokens[i + 1].text == ":=" || tokens[i + 1].text == "=>");
}

struct Found {
  std::vector<IecToken> tokens;
  TextBlock block;
  std::string_view name;
};

/// The variable, or why there is none.
std::variant<Found, std::string> foundAt(const CheckedDocument& document, std::uint32_t offset) {
  Found found{tokensOf(document), {}, {}};
  for (const TextBlock& block : textBlocksOf(found.tokens)) {
    int depth = 0;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const IecToken& token = found.tokens[i];
      depth += token.text == "(" ? 1 : token.text == ")" ? -1 : 0;
      if (token.kind != TokenKind::Word || token.begin > offset || offset > token.end) continue;
      if (isMember(found.tokens, i) || isFormal(found.tokens, i, depth)) continue;
      found.block = block;
      found.name = token.text;
    }
  }
  const std::string_view section = found.name.empty() ? "" : sectionOf(found.tokens, found.block, found.name);
  if (section.empty()) return std::string("nothing there has a name that can be changed");
  const bool isInside = section == "VAR" || section == "VAR_TEMP" || found.block.isProgram;
  if (!isInside || section == "VAR_GLOBAL" || section == "VAR_EXTERNAL")
    return fmt::format("'{}' is declared in {}: other blocks name it too", found.name, section);
  return found;
}

/// The part of an address in a property that names the variable: "Motor", "P.Motor", "T1" of "T1.Q".
void addOfProperties(const CheckedDocument& document, const Found& found, std::vector<Span>& places) {
  for (const Property& property : document.properties().properties) {
    for (const Expr* expression : {&property.first, &property.second}) {
      for (const ExprNode& node : expression->nodes) {
        if (node.op != ExprOp::Address || !document.isHere(node.span)) continue;
        const std::string_view text = document.source().text(node.span);
        const std::size_t point = text.find('.');
        const bool isQualified =
            point != std::string_view::npos && equalsIgnoringCase(text.substr(0, point), found.block.name);
        const std::size_t begin = isQualified ? point + 1 : 0;
        const std::size_t end = std::min(text.find_first_of(".[", begin), text.size());
        if (equalsIgnoringCase(text.substr(begin, end - begin), found.name))
          places.push_back({document.file(), node.span.offset + static_cast<std::uint32_t>(begin),
                            static_cast<std::uint32_t>(end - begin)});
      }
    }
  }
}

}  // namespace

std::variant<std::vector<Span>, std::string> placesOfVariable(const CheckedDocument& document, std::uint32_t offset) {
  std::variant<Found, std::string> result = foundAt(document, offset);
  if (std::string* fault = std::get_if<std::string>(&result)) return std::move(*fault);
  const Found& found = std::get<Found>(result);
  std::vector<Span> places;
  addOfProperties(document, found, places);
  const bool isNamedOutside = !places.empty();
  for (const TextBlock& other : textBlocksOf(found.tokens)) {
    if (isNamedOutside && other.begin != found.block.begin && !sectionOf(found.tokens, other, found.name).empty())
      return fmt::format("{} declares '{}' too, and properties name it", other.name, found.name);
  }
  int depth = 0;
  for (std::size_t i = found.block.begin; i < found.block.end; ++i) {
    const IecToken& token = found.tokens[i];
    depth += token.text == "(" ? 1 : token.text == ")" ? -1 : 0;
    if (!isWord(token, found.name) || isMember(found.tokens, i) || isFormal(found.tokens, i, depth)) continue;
    places.push_back({document.file(), token.begin, token.end - token.begin});
  }
  return places;
}

std::string variableFault(const CheckedDocument& document, std::uint32_t offset, std::string_view name) {
  if (!isName(name) || structuredTextWord(name) != nullptr)
    return fmt::format("'{}' is no name: it has letters, digits and _, and begins with a letter", name);
  const std::variant<Found, std::string> result = foundAt(document, offset);
  const Found* const found = std::get_if<Found>(&result);
  if (found == nullptr || equalsIgnoringCase(found->name, name)) return {};
  const auto isTaken = [&](const IecToken& token) { return isWord(token, name); };
  if (std::any_of(found->tokens.begin() + static_cast<std::ptrdiff_t>(found->block.begin),
                  found->tokens.begin() + static_cast<std::ptrdiff_t>(found->block.end), isTaken))
    return fmt::format("{} uses the name '{}' already", found->block.name, name);
  return {};
}

}  // namespace rungproof
