// The variable is found by the tokens of its block: declared between VAR and END_VAR, used anywhere but where the name
// stands for something else: behind a point, as a formal parameter, as a type or a block.
#include "frontend/editor/text_rename.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/editor/text_blocks.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

using iec::IecToken;

struct Found {
  std::uint32_t file = 0;
  std::vector<IecToken> tokens;
  TextBlock block;
  std::string_view name;
};
constexpr std::string_view nothingThere = "nothing there has a name that can be changed";

/// The variable of a program that a property names at an offset of the document.
std::variant<Found, std::string> foundInProperty(const CheckedDocument& document, const PropertyWord& word,
                                                 std::uint32_t offset) {
  const Span first = firstNameOf(word), second = secondNameOf(word);
  const auto isIn = [&](Span part) { return part.offset <= offset && offset <= part.offset + part.length; };
  std::optional<Found> found;
  for (const std::uint32_t file : structuredTextsOf(document)) {
    const std::vector<IecToken> tokens = tokensOf(document, file);
    for (const TextBlock& block : textBlocksOf(tokens)) {
      if (!block.isProgram) continue;
      const bool isQualified = second.length > 0 && equalsIgnoringCase(textOf(word, first), block.name) &&
                               !sectionOf(tokens, block, textOf(word, second)).empty();
      const Span part = isQualified ? second : first;
      const std::string_view name = textOf(word, part);
      if (!isIn(part) || sectionOf(tokens, block, name).empty()) continue;
      if (found) return fmt::format("{} and {} both declare '{}'", found->block.name, block.name, name);
      found = Found{file, tokens, block, name};
    }
  }
  if (!found) return std::string(nothingThere);
  return std::move(*found);
}

std::variant<Found, std::string> foundInText(const CheckedDocument& document, std::uint32_t offset) {
  Found found{document.file(), tokensOf(document), {}, {}};
  for (const TextBlock& block : textBlocksOf(found.tokens)) {
    for (BlockWalk walk(found.tokens, block); !walk.atEnd(); walk.next()) {
      const IecToken& token = found.tokens[walk.index()];
      if (token.begin > offset || offset > token.end || !walk.isVariable(document.program().syntax.get())) continue;
      found.block = block;
      found.name = token.text;
    }
  }
  if (found.name.empty()) return std::string(nothingThere);
  return found;
}

/// The variable, or why there is none.
std::variant<Found, std::string> foundAt(const CheckedDocument& document, std::uint32_t offset) {
  const std::vector<PropertyWord> words = propertyWordsOf(document);
  const auto word = std::ranges::find_if(words, [&](const PropertyWord& one) {
    return document.isHere(one.span) && one.span.offset <= offset && offset <= one.span.offset + one.span.length;
  });
  auto result = word == words.end() ? foundInText(document, offset) : foundInProperty(document, *word, offset);
  const Found* const found = std::get_if<Found>(&result);
  if (found == nullptr) return result;
  const std::string_view section = sectionOf(found->tokens, found->block, found->name);
  if (section.empty()) return std::string(nothingThere);
  const bool isInside = section == "VAR" || section == "VAR_TEMP" || found->block.isProgram;
  if (!isInside || section == "VAR_GLOBAL" || section == "VAR_EXTERNAL")
    return fmt::format("'{}' is declared in {}: other blocks name it too", found->name, section);
  return result;
}

/// The part of a word in a property that names the variable: of "Motor", "P.Motor", "T1.Q".
std::optional<Span> nameIn(const PropertyWord& word, std::string_view block, std::string_view name) {
  const Span first = firstNameOf(word), second = secondNameOf(word);
  if (second.length > 0 && equalsIgnoringCase(textOf(word, first), block) &&
      equalsIgnoringCase(textOf(word, second), name))
    return second;
  return equalsIgnoringCase(textOf(word, first), name) ? std::optional(first) : std::nullopt;
}

/// Whether a property names it behind the name of an instance.
bool isMemberIn(const PropertyWord& word, std::string_view name) {
  for (std::size_t at = word.text.find('.'); at != std::string_view::npos; at = word.text.find('.', at + 1)) {
    const std::string_view part = word.text.substr(at + 1);
    if (equalsIgnoringCase(part.substr(0, part.find_first_of(".[")), name)) return true;
  }
  return false;
}

}  // namespace

std::variant<VariablePlaces, std::string> placesOfVariable(const CheckedDocument& document, std::uint32_t offset) {
  std::variant<Found, std::string> result = foundAt(document, offset);
  if (std::string* fault = std::get_if<std::string>(&result)) return std::move(*fault);
  const Found& found = std::get<Found>(result);
  VariablePlaces places;
  places.name = found.name;
  if (found.block.isProgram)
    places.inProperty = [block = std::string(found.block.name), name = std::string(found.name)](
                            const PropertyWord& word) { return nameIn(word, block, name); };
  std::vector<PropertyWord> words = propertyWordsOf(document);
  const std::vector<PropertyFileBeside> beside = propertyFilesBeside(document);
  for (const PropertyFileBeside& file : beside) words.insert(words.end(), file.words.begin(), file.words.end());
  bool isNamedOutside = false;
  for (const PropertyWord& word : words) {
    if (!found.block.isProgram && isMemberIn(word, found.name))
      return fmt::format("properties name '{}' of an instance", found.name);
    isNamedOutside = isNamedOutside || (places.inProperty && places.inProperty(word));
  }
  for (const std::uint32_t file : structuredTextsOf(document)) {
    const std::vector<IecToken> tokens = file == found.file ? found.tokens : tokensOf(document, file);
    for (const TextBlock& other : textBlocksOf(tokens)) {
      const bool isOther = file != found.file || other.begin != found.block.begin;
      if (isNamedOutside && isOther && !sectionOf(tokens, other, found.name).empty())
        return fmt::format("{} declares '{}' too, and properties name it", other.name, found.name);
    }
  }
  for (BlockWalk walk(found.tokens, found.block); !walk.atEnd(); walk.next()) {
    const IecToken& token = found.tokens[walk.index()];
    if (isWord(token, found.name) && walk.isVariable(document.program().syntax.get()))
      places.spans.push_back({found.file, token.begin, token.end - token.begin});
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
