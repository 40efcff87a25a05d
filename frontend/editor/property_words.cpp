// Words behind the head of each statement: the name of a property is none of the program's.
#include "frontend/editor/property_words.hpp"

#include <algorithm>
#include <filesystem>

#include "engine/platform/names.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/property/property_lexer.hpp"
#include "frontend/property/property_types.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

bool isHeadOfNamed(std::string_view word) {
  return equalsIgnoringCase(word, "prove") || equalsIgnoringCase(word, "assume") || equalsIgnoringCase(word, "reach");
}

void addWordsOf(std::string_view statement, std::uint32_t file, std::uint32_t offset,
                std::vector<PropertyWord>& words) {
  const std::vector<Token> tokens = tokenize(statement, file, offset);
  const std::size_t head = equalsIgnoringCase(tokens[0].text, "at") && tokens.size() > 3 ? 3 : 0;  // every instruction
  auto token = tokens.begin();
  if (isHeadOfNamed(tokens[head].text)) {
    // Without a colon nothing says where the name ends.
    const auto colon = std::ranges::find(tokens, ":", &Token::text);
    if (colon != tokens.end()) token = colon + 1;
  }
  for (; token != tokens.end(); ++token) {
    if (token->kind != PropertyToken::Word) continue;
    std::string word(token->text);
    std::ranges::transform(word, word.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (isKeyword(word)) continue;
    const bool isFunction = token + 1 != tokens.end() && (token + 1)->text == "(";
    if (!isFunction) words.push_back({token->text, token->span});
  }
}

void addWordsOfFile(const SourceFile& source, std::uint32_t file, std::vector<PropertyWord>& words) {
  for (std::uint32_t line = 1; line <= source.lineCount(); ++line)
    addWordsOf(source.line(line), file, source.lineStart(line), words);
}

Span namePartOf(const PropertyWord& word, std::size_t begin) {
  const bool isQuoted = begin < word.text.size() && word.text[begin] == '"';
  if (isQuoted) ++begin;
  const std::size_t end = std::min(word.text.find_first_of(isQuoted ? "\"" : ".[", begin), word.text.size());
  return {word.span.file, word.span.offset + static_cast<std::uint32_t>(begin),
          static_cast<std::uint32_t>(end - std::min(begin, end))};
}

}  // namespace

Span firstNameOf(const PropertyWord& word) { return namePartOf(word, word.text.starts_with('%') ? 1 : 0); }

Span secondNameOf(const PropertyWord& word) {
  const Span first = firstNameOf(word);
  const std::size_t point = word.text.find('.', first.offset - word.span.offset + first.length);
  return point == std::string_view::npos ? Span{word.span.file, word.span.offset, 0} : namePartOf(word, point + 1);
}

std::vector<PropertyWord> propertyWordsOf(const CheckedDocument& document) {
  const SourceSet& sources = *document.program().sources;
  std::vector<PropertyWord> words;
  for (const Directive& directive : document.program().directives) {
    // What a reader made of a declaration stands in no text.
    const std::string_view written = sources.text(directive.span);
    const std::size_t at = written.find(directive.text);
    if (at == std::string_view::npos || directive.text.empty()) continue;
    const std::uint32_t begin = directive.span.offset + static_cast<std::uint32_t>(at);
    addWordsOf(written.substr(at, directive.text.size()), directive.span.file, begin, words);
  }
  for (std::uint32_t file = 0; file < sources.size(); ++file) {
    if (endsInAny(sources.file(file).name(), {".prop"})) addWordsOfFile(sources.file(file), file, words);
  }
  return words;
}

std::vector<PropertyFileBeside> propertyFilesBeside(const CheckedDocument& document) {
  namespace fs = std::filesystem;
  const SourceSet& sources = *document.program().sources;
  std::vector<PropertyFileBeside> beside;
  for (const std::string& program : document.files()) {
    const std::string path = pathName(fs::path(program).replace_extension(".prop"));
    std::error_code error;
    const HeldText* const held = heldText(path);
    if (held == nullptr && !fs::is_regular_file(path, error)) continue;
    const std::string uri = uriOfPath(pathName(fs::weakly_canonical(path, error)));
    bool isKnown = std::ranges::any_of(beside, [&](const PropertyFileBeside& one) { return one.uri == uri; });
    for (std::uint32_t file = 0; file < sources.size() && !isKnown; ++file) {
      const std::string other = pathInProject(sources.file(file).name(), document.settings().root());
      isKnown = fs::weakly_canonical(other, error) == fs::weakly_canonical(path, error);
    }
    const std::optional<std::string> bytes = isKnown ? std::nullopt : bytesOfInput(path);
    if (!bytes) continue;
    PropertyFileBeside one{uri, std::make_unique<const SourceFile>(path, decode(*bytes, TextEncoding::Auto).text), {}};
    addWordsOfFile(*one.file, 0, one.words);
    beside.push_back(std::move(one));
  }
  return beside;
}

}  // namespace rungproof
