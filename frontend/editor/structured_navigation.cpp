// A name means what its block declares; behind an instance, or as the parameter of a call, what the block of the
// instance declares.
#include "frontend/editor/structured_navigation.hpp"

#include <algorithm>

#include "frontend/editor/text_blocks.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

using iec::IecToken;
using iec::TokenKind;

struct LexedFile {
  std::uint32_t file = 0;
  std::vector<IecToken> tokens;
  std::vector<TextBlock> blocks;
};

Span spanOfToken(const LexedFile& text, std::size_t token) {
  return {text.file, text.tokens[token].begin, text.tokens[token].end - text.tokens[token].begin};
}

/// The type behind the colon: of an array that of its elements.
std::string_view typeBehind(const std::vector<IecToken>& tokens, std::size_t i) {
  while (i < tokens.size() && tokens[i].text != ":" && tokens[i].text != ";") ++i;
  std::string_view type;
  for (++i; i < tokens.size() && tokens[i].text != ";" && tokens[i].text != ":="; ++i) {
    if (tokens[i].kind == TokenKind::Word && (type.empty() || isWord(tokens[i - 1], "OF"))) type = tokens[i].text;
  }
  return type;
}

/// Whether a value is given to the variable at a token: x := , x[1].y := , => x, and ST x of a list.
bool isWrittenAt(const std::vector<IecToken>& tokens, std::size_t i) {
  if (i > 0 && tokens[i - 1].text == "=>") return true;
  if (i > 0 && (isWord(tokens[i - 1], "ST") || isWord(tokens[i - 1], "STN") || isWord(tokens[i - 1], "S") ||
                isWord(tokens[i - 1], "R")))
    return true;
  for (++i; i + 1 < tokens.size();) {
    if (tokens[i].text == ".") {
      i += 2;
    } else if (tokens[i].text == "[") {
      while (i < tokens.size() && tokens[i].text != "]") ++i;
      ++i;
    } else {
      break;
    }
  }
  return i < tokens.size() && tokens[i].text == ":=";
}

/// The same block, whether it is written FC1, fc1 or FC 1.
bool isSameBlock(std::string_view a, std::string_view b) {
  const auto bare = [](std::string_view name) {
    std::string text(name);
    std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
    return text;
  };
  const bool isQuoted = a.starts_with('"') || b.starts_with('"');
  return equalsIgnoringCase(a, b) || (!isQuoted && equalsIgnoringCase(bare(a), bare(b)));
}

class NameSearch {
 public:
  explicit NameSearch(const CheckedDocument& document) : document_(document) {
    for (const std::uint32_t file : structuredTextsOf(document)) {
      LexedFile text{file, tokensOf(document, file), {}};
      for (IecToken& token : text.tokens) {  // SCL: #level is the variable level
        if (token.kind != TokenKind::Word || !token.text.starts_with('#')) continue;
        token.text.remove_prefix(1);
        ++token.begin;
      }
      text.blocks = textBlocksOf(text.tokens);
      texts_.push_back(std::move(text));
    }
  }

  std::optional<TextName> at(std::uint32_t offset) const {
    for (const PropertyWord& word : propertyWordsOf(document_)) {
      if (document_.isHere(word.span) && isAt(word.span, offset)) return ofProperty(word, offset);
    }
    if (texts_.empty() || texts_.front().file != document_.file()) return std::nullopt;
    const LexedFile& text = texts_.front();
    for (std::size_t i = 0; i < text.tokens.size(); ++i) {
      const IecToken& token = text.tokens[i];
      if (token.kind == TokenKind::Word && token.begin <= offset && offset <= token.end) return ofToken(text, i);
    }
    return std::nullopt;
  }

  std::vector<DeclaredBlock> blocks() const {
    std::vector<DeclaredBlock> list;
    if (texts_.empty() || texts_.front().file != document_.file()) return list;
    const LexedFile& text = texts_.front();
    for (const TextBlock& block : text.blocks) {
      const IecToken& first = text.tokens[block.begin];
      DeclaredBlock row{block.name,
                        first.text,
                        {text.file, first.begin, text.tokens[block.end].end - first.begin},
                        {text.file, first.begin, text.tokens[block.begin + 1].end - first.begin},
                        {}};
      for (BlockWalk walk(text.tokens, block); !walk.atEnd(); walk.next()) {
        const std::size_t i = walk.index();
        if (walk.declares() && isDeclaredName(text, i))
          row.variables.push_back(
              {text.tokens[i].text, walk.section(), typeBehind(text.tokens, i), spanOfToken(text, i)});
      }
      list.push_back(std::move(row));
    }
    return list;
  }

  std::vector<DeclaredName> globals() const {
    std::vector<DeclaredName> list;
    for (const LexedFile& text : texts_) {
      bool isOpen = false, declares = false;
      for (std::size_t i = 0; i < text.tokens.size(); ++i) {
        const IecToken& token = text.tokens[i];
        if (isWord(token, "VAR_GLOBAL")) isOpen = declares = true;
        if (isWord(token, "END_VAR")) isOpen = declares = false;
        if (token.text == ":") declares = false;
        if (token.text == ";") declares = isOpen;
        if (declares && isDeclaredName(text, i))
          list.push_back({token.text, "VAR_GLOBAL", typeBehind(text.tokens, i), spanOfToken(text, i)});
      }
    }
    return list;
  }

 private:
  using Place = std::pair<const LexedFile*, const TextBlock*>;

  static bool isAt(Span span, std::uint32_t offset) {
    return span.offset <= offset && offset <= span.offset + span.length;
  }
  static bool isDeclaredName(const LexedFile& text, std::size_t i) {
    return text.tokens[i].kind == TokenKind::Word && structuredTextWord(text.tokens[i].text) == nullptr;
  }
  const iec::ProjectSyntax* project() const { return document_.program().syntax.get(); }

  std::optional<TextName> ofProperty(const PropertyWord& word, std::uint32_t offset) const {
    const Span first = firstNameOf(word), second = secondNameOf(word);
    for (const LexedFile& text : texts_) {
      for (const TextBlock& block : text.blocks) {
        if (!block.isProgram) continue;
        const bool isQualified = second.length > 0 && equalsIgnoringCase(textOf(word, first), block.name) &&
                                 !sectionOf(text.tokens, block, textOf(word, second)).empty();
        const Span part = isQualified ? second : first;
        if (isAt(part, offset) && !sectionOf(text.tokens, block, textOf(word, part)).empty())
          return local(text, block, textOf(word, part));
      }
    }
    return isAt(first, offset) ? global(textOf(word, first)) : std::nullopt;
  }

  std::optional<TextName> ofToken(const LexedFile& text, std::size_t i) const {
    const std::string_view name = text.tokens[i].text;
    const auto block =
        std::ranges::find_if(text.blocks, [&](const TextBlock& one) { return one.begin < i && i < one.end; });
    if (block != text.blocks.end()) {
      if (const auto target = targetOf(text, *block, i)) return local(*target->first, *target->second, name);
      if (isVariableAt(text, *block, i)) {
        const std::string_view section = sectionOf(text.tokens, *block, name);
        if (!section.empty() && section != "VAR_EXTERNAL" && section != "VAR_GLOBAL") return local(text, *block, name);
        if (auto found = global(name)) return found;
      }
    } else if (auto found = global(name)) {
      return found;
    }
    return i > 0 && text.tokens[i - 1].text == "." ? std::nullopt : blockNamed(name);
  }

  bool isVariableAt(const LexedFile& text, const TextBlock& block, std::size_t i) const {
    BlockWalk walk(text.tokens, block);
    while (walk.index() < i) walk.next();
    return walk.isVariable(project());
  }

  std::optional<Place> placeOfBlock(std::string_view name) const {
    for (const LexedFile& text : texts_) {
      for (const TextBlock& block : text.blocks) {
        if (isSameBlock(block.name, name)) return Place{&text, &block};
      }
    }
    return std::nullopt;
  }

  /// The block whose variable stands behind a point or as the parameter of a call.
  std::optional<Place> targetOf(const LexedFile& text, const TextBlock& block, std::size_t i) const {
    const std::vector<IecToken>& tokens = text.tokens;
    std::size_t owner = 0;
    if (i > 1 && tokens[i - 1].text == ".") {
      owner = i - 2;
      if (owner > 0 && tokens[owner - 1].text == ".") return std::nullopt;
    } else if (i + 1 < tokens.size() && (tokens[i + 1].text == ":=" || tokens[i + 1].text == "=>")) {
      int depth = 0;
      std::size_t k = i;
      for (; k > block.begin; --k) {
        depth += tokens[k].text == ")" ? 1 : tokens[k].text == "(" ? -1 : 0;
        if (depth < 0) break;
        if (depth == 0 && tokens[k].text == ";") return std::nullopt;
      }
      if (depth >= 0 || k == 0) return std::nullopt;
      owner = k - 1;
    } else {
      return std::nullopt;
    }
    const std::string_view type = typeOf(text, block, tokens[owner].text);
    return placeOfBlock(type.empty() ? tokens[owner].text : type);
  }

  std::string_view typeOf(const LexedFile& text, const TextBlock& block, std::string_view name) const {
    for (BlockWalk walk(text.tokens, block); !walk.atEnd(); walk.next()) {
      if (walk.declares() && isWord(text.tokens[walk.index()], name)) return typeBehind(text.tokens, walk.index());
    }
    return {};
  }

  std::optional<TextName> local(const LexedFile& text, const TextBlock& block, std::string_view name) const {
    TextName found;
    found.name = name;
    found.block = block.name;
    found.isOfProgram = block.isProgram;
    for (BlockWalk walk(text.tokens, block); !walk.atEnd(); walk.next()) {
      const std::size_t i = walk.index();
      if (!isWord(text.tokens[i], name) || !walk.isVariable(project())) continue;
      if (walk.declares() && found.declaration.length == 0) {
        found.declaration = spanOfToken(text, i);
        found.section = walk.section();
        found.type = typeBehind(text.tokens, i);
      } else {
        found.uses.push_back({spanOfToken(text, i), isWrittenAt(text.tokens, i)});
      }
    }
    if (found.declaration.length == 0) return std::nullopt;
    addMembers(block, name, found);
    if (!block.isProgram) return found;
    found.inProperty = [block = std::string(block.name),
                        name = std::string(name)](const PropertyWord& word) -> std::optional<Span> {
      const Span first = firstNameOf(word), second = secondNameOf(word);
      if (second.length > 0 && equalsIgnoringCase(textOf(word, first), block) &&
          equalsIgnoringCase(textOf(word, second), name))
        return second;
      return equalsIgnoringCase(textOf(word, first), name) ? std::optional(first) : std::nullopt;
    };
    return found;
  }

  /// Uses by those who call the block or have an instance of it.
  void addMembers(const TextBlock& block, std::string_view name, TextName& found) const {
    for (const LexedFile& text : texts_) {
      for (const TextBlock& other : text.blocks) {
        for (std::size_t i = other.begin + 1; i < other.end; ++i) {
          if (!isWord(text.tokens[i], name)) continue;
          const auto target = targetOf(text, other, i);
          if (!target || target->second != &block) continue;
          const bool isFormal = text.tokens[i - 1].text != ".";
          const bool isWritten = isFormal ? text.tokens[i + 1].text == ":=" : isWrittenAt(text.tokens, i);
          found.uses.push_back({spanOfToken(text, i), isWritten});
        }
      }
    }
  }

  std::optional<TextName> global(std::string_view name) const {
    for (const DeclaredName& one : globals()) {
      if (!equalsIgnoringCase(one.name, name)) continue;
      TextName found;
      found.name = one.name;
      found.section = one.section;
      found.type = one.type;
      found.declaration = one.span;
      for (const LexedFile& text : texts_) {
        for (const TextBlock& block : text.blocks) {
          const std::string_view section = sectionOf(text.tokens, block, name);
          if (!section.empty() && section != "VAR_EXTERNAL") continue;
          for (BlockWalk walk(text.tokens, block); !walk.atEnd(); walk.next()) {
            if (isWord(text.tokens[walk.index()], name) && walk.isVariable(project()))
              found.uses.push_back({spanOfToken(text, walk.index()), isWrittenAt(text.tokens, walk.index())});
          }
        }
      }
      found.inProperty = [name = std::string(name)](const PropertyWord& word) -> std::optional<Span> {
        const Span first = firstNameOf(word);
        return equalsIgnoringCase(textOf(word, first), name) ? std::optional(first) : std::nullopt;
      };
      return found;
    }
    return std::nullopt;
  }

  std::optional<TextName> blockNamed(std::string_view name) const {
    const auto place = placeOfBlock(name);
    if (!place) return std::nullopt;
    TextName found;
    found.name = place->second->name;
    found.section = place->first->tokens[place->second->begin].text;
    found.declaration = spanOfToken(*place->first, place->second->begin + 1);
    for (const LexedFile& text : texts_) {
      for (std::size_t i = 1; i < text.tokens.size(); ++i) {
        const bool isNamed = text.tokens[i].kind == TokenKind::Word && isSameBlock(text.tokens[i].text, name);
        if (!isNamed || text.tokens[i - 1].text == "." || spanOfToken(text, i) == found.declaration) continue;
        const auto block =
            std::ranges::find_if(text.blocks, [&](const TextBlock& one) { return one.begin < i && i < one.end; });
        const bool isOwn = block != text.blocks.end() && !sectionOf(text.tokens, *block, name).empty() &&
                           isVariableAt(text, *block, i);
        if (!isOwn) found.uses.push_back({spanOfToken(text, i), false});
      }
    }
    return found;
  }

  const CheckedDocument& document_;
  std::vector<LexedFile> texts_;
};

}  // namespace

std::optional<TextName> textNameAt(const CheckedDocument& document, std::uint32_t offset) {
  return NameSearch(document).at(offset);
}

std::vector<DeclaredBlock> declaredBlocksOf(const CheckedDocument& document) { return NameSearch(document).blocks(); }

std::vector<DeclaredName> declaredGlobalsOf(const CheckedDocument& document) { return NameSearch(document).globals(); }

}  // namespace rungproof
