// A name is changed where it was read as that name: operands, properties, the row or line that declares it. What only
// looks like it - a comment, a text, a member behind a point - stays.
#include "frontend/editor/rename.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

#include "frontend/editor/text_rename.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

bool continuesName(char c) { return isLetter(c) || isDigit(c) || c == '_' || static_cast<unsigned char>(c) >= 0x80; }

enum class NameKind : std::uint8_t { None, Symbol, Local, Label };

/// What the name under the cursor is.
struct NameAtCursor {
  NameKind kind = NameKind::None;
  std::string name;
  Span span;  ///< of the name alone
  const Pou* pou = nullptr;
};

/// The word of the source around an offset.
Span wordAround(const SourceFile& source, std::uint32_t file, std::uint32_t offset) {
  const std::string_view text = source.text();
  std::uint32_t begin = std::min<std::uint32_t>(offset, static_cast<std::uint32_t>(text.size())), end = begin;
  while (begin > 0 && continuesName(text[begin - 1])) --begin;
  while (end < text.size() && continuesName(text[end])) ++end;
  return {file, begin, end - begin};
}

/// Places of a whole word within a span of the source.
std::vector<Span> wholeWordsIn(const CheckedDocument& document, Span span, std::string_view word) {
  std::vector<Span> found;
  const std::string_view text = document.program().sources->text(span);
  for (std::size_t at = 0; at + word.size() <= text.size(); ++at) {
    if (!equalsIgnoringCase(text.substr(at, word.size()), word)) continue;
    const bool begins = at == 0 || !continuesName(text[at - 1]);
    const bool ends = at + word.size() == text.size() || !continuesName(text[at + word.size()]);
    const bool isMember = at > 0 && text[at - 1] == '.';
    if (begins && ends && !isMember)
      found.push_back(
          {span.file, span.offset + static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(word.size())});
  }
  return found;
}

NameAtCursor namedAt(const CheckedDocument& document, ClientPlace place) {
  const std::uint32_t offset = document.offset(place);
  const Cursor cursor = cursorAt(document, offset);
  if (!cursor.operand) return {};
  NameAtCursor named{NameKind::None, {}, wordAround(document.source(), document.file(), offset), cursor.pou};
  named.name = document.source().text(named.span);
  if (cursor.routine() == Type::Label) {
    named.kind = NameKind::Label;
    return named;
  }
  if (cursor.routine() || named.name.empty()) return {};
  const std::string_view before = document.source().text().substr(0, named.span.offset);
  if (before.ends_with('.')) return {};
  const auto isLocal = [&](const LocalVariable& local) { return equalsIgnoringCase(local.name, named.name); };
  if (cursor.pou != nullptr && std::ranges::any_of(cursor.pou->locals, isLocal) &&
      (before.ends_with('#') || document.facts().symbolNamed(named.name) == nullptr))
    named.kind = NameKind::Local;
  else if (document.facts().symbolNamed(named.name) != nullptr)
    named.kind = NameKind::Symbol;
  return named.kind == NameKind::None ? NameAtCursor() : named;
}

/// The places of a name, each once and in the order of the files.
class Renaming {
 public:
  Renaming(const CheckedDocument& document, const NameAtCursor& named) : document_(document), named_(named) {}

  std::vector<Span> places() {
    const Program& program = document_.program();
    for (const Pou& pou : program.pous) {
      if (named_.kind != NameKind::Symbol && &pou != named_.pou) continue;
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) addOperands(instruction);
      }
    }
    if (named_.kind == NameKind::Local) {
      for (const LocalVariable& local : named_.pou->locals) {
        if (equalsIgnoringCase(local.name, named_.name)) addWords(local.span);
      }
    }
    if (named_.kind == NameKind::Symbol) addSymbol();
    std::vector<Span> list;
    for (const auto& [file, offset, length] : places_) list.push_back({file, offset, length});
    return list;
  }

 private:
  void addOperands(const Instruction& instruction) {
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      const Operand& operand = instruction.operands[i];
      const bool isLabel = routineType(instruction, i) == Type::Label;
      if (operand.span.length == 0 || isLabel != (named_.kind == NameKind::Label)) continue;
      if (!isLabel && operand.text.empty()) continue;
      addWords(operand.span);
    }
  }

  void addSymbol() {
    for (const Symbol& symbol : document_.program().symbols) {
      if (equalsIgnoringCase(symbol.name, named_.name)) addFirstWord(symbol.span);
    }
  }

  void addFirstWord(Span span) {
    const std::vector<Span> words = wholeWordsIn(document_, span, named_.name);
    if (!words.empty()) add(words.front());
  }
  void addWords(Span span) {
    for (const Span& word : wholeWordsIn(document_, span, named_.name)) {
      if (isOfKind(word)) add(word);
    }
  }
  /// In S7-300/400 sources the mark before the name says what it is: "symbol", #local.
  bool isOfKind(Span word) const {
    const SourceFile& file = document_.program().sources->file(word.file);
    const char before = word.offset == 0 ? '\0' : file.text()[word.offset - 1];
    if (named_.kind == NameKind::Symbol) return before != '#';
    return named_.kind != NameKind::Local || before != '"';
  }
  void add(Span word) { places_.emplace(word.file, word.offset, word.length); }

  const CheckedDocument& document_;
  const NameAtCursor& named_;
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> places_;
};

/// Parameters of an S7-300/400 block stand in its calls and in data blocks too, where no operand of the block shows
/// them.
bool isSeenFromOutside(const CheckedDocument& document, const NameAtCursor& named) {
  if (named.kind != NameKind::Local || !dialectOf(document.program().target).memory.hasDataBlocks) return false;
  return std::ranges::any_of(named.pou->locals, [&](const LocalVariable& local) {
    return equalsIgnoringCase(local.name, named.name) && local.section != VarSection::Temp;
  });
}

std::string labelFault(const CheckedDocument& document, const NameAtCursor& named, std::string_view name) {
  if (dialectOf(document.program().target).text.labelsAreNames) {
    if (name.size() > 4 || !isName(name))
      return fmt::format("'{}' is no label: it has one to four letters and digits and begins with a letter", name);
  } else if (name.empty() || name.size() > 3 || !std::ranges::all_of(name, isDigit) ||
             std::stoi(std::string(name)) > 255) {
    return fmt::format("'{}' is no label: labels are numbers from 0 to 255", name);
  }
  for (const Network& network : named.pou->networks) {
    for (const Instruction& instruction : network.instructions) {
      if (instruction.desc->control != Control::LabelMark || instruction.operands.size() == 0) continue;
      const std::string_view other = document.program().sources->text(instruction.operands[0].span);
      if (equalsIgnoringCase(trimmed(other), name)) return fmt::format("the block has a label '{}' already", name);
    }
  }
  return {};
}

/// In S7-200 programs names stand without marks, so that VW10 would be read as the address.
bool isAddressText(const CheckedDocument& document, std::string_view name) {
  Operand address;
  return !dialectOf(document.program().target).text.quotesSymbols &&
         (readAddress(name, Spelling::International, address) || readAddress(name, Spelling::German, address));
}

std::string nameFault(const CheckedDocument& document, const NameAtCursor& named, std::string_view name) {
  if (named.kind == NameKind::Label) return labelFault(document, named, name);
  if (!isName(name))
    return fmt::format("'{}' is no name: it has letters, digits and _, and begins with a letter", name);
  if (isAddressText(document, name)) return fmt::format("'{}' is an address", name);
  if (isSeenFromOutside(document, named))
    return fmt::format("'{}' is a parameter or static data; calls and data blocks name it too", named.name);
  if (equalsIgnoringCase(name, named.name)) return {};
  if (named.kind == NameKind::Symbol && document.facts().symbolNamed(name) != nullptr)
    return fmt::format("there is a symbol '{}' already", name);
  for (const Pou& pou : document.program().pous) {
    if (named.kind == NameKind::Local && &pou != named.pou) continue;
    for (const LocalVariable& local : pou.locals) {
      if (equalsIgnoringCase(local.name, name))
        return fmt::format("{} has a local variable '{}' already", pou.name, name);
    }
  }
  return {};
}

}  // namespace

namespace {

using NameInWord = std::function<std::optional<Span>(const PropertyWord&)>;

/// Edits at those places, and in all properties of the program: also in those of files that lie beside it.
Json workspaceEdit(const CheckedDocument& document, std::vector<Span> places, const NameInWord& inProperty,
                   std::string_view name) {
  Json changes = Json::object();
  if (inProperty) {
    for (const PropertyWord& word : propertyWordsOf(document)) {
      if (const auto span = inProperty(word)) places.push_back(*span);
    }
    for (const PropertyFileBeside& beside : propertyFilesBeside(document)) {
      for (const PropertyWord& word : beside.words) {
        if (const auto span = inProperty(word))
          changes[beside.uri].push_back({{"range", rangeJson(*beside.file, *span)}, {"newText", name}});
      }
    }
  }
  std::ranges::sort(places, {}, [](Span span) { return std::tuple(span.file, span.offset, span.length); });
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (const Span& span : places)
    changes[document.uriOf(span.file)].push_back({{"range", document.range(span)}, {"newText", name}});
  return {{"changes", std::move(changes)}};
}

NameInWord firstNameIs(std::string name) {
  return [name = std::move(name)](const PropertyWord& word) {
    const Span first = firstNameOf(word);
    return equalsIgnoringCase(textOf(word, first), name) ? std::optional(first) : std::nullopt;
  };
}

}  // namespace

Json renameRange(const CheckedDocument& document, ClientPlace place) {
  if (document.source().text().empty() || isSclText(document)) return nullptr;
  Span span;
  if (isStructuredText(document)) {
    if (placesOfVariable(document, document.offset(place)).index() == 1) return nullptr;
    span = wordAround(document.source(), document.file(), document.offset(place));
  } else {
    const NameAtCursor named = namedAt(document, place);
    if (named.kind == NameKind::None) return nullptr;
    span = named.span;
  }
  return {{"range", document.range(span)}, {"placeholder", document.source().text(span)}};
}

std::variant<Json, std::string> renameAt(const CheckedDocument& document, ClientPlace place, std::string_view name) {
  if (document.source().text().empty()) return std::string("the document could not be read");
  if (isStructuredText(document)) {
    auto places = placesOfVariable(document, document.offset(place));
    if (std::string* fault = std::get_if<std::string>(&places)) return std::move(*fault);
    if (std::string fault = variableFault(document, document.offset(place), name); !fault.empty()) return fault;
    VariablePlaces& found = std::get<VariablePlaces>(places);
    return workspaceEdit(document, std::move(found.spans), found.inProperty, name);
  }
  if (isSclText(document)) return std::string("names in SCL are not changed here");
  const NameAtCursor named = namedAt(document, place);
  if (named.kind == NameKind::None) return std::string("nothing there has a name that can be changed");
  const bool hasScl = std::ranges::any_of(document.program().pous, [](const Pou& pou) {
    return std::ranges::any_of(pou.networks, &Network::isStructured);
  });
  if (hasScl && named.kind == NameKind::Symbol)
    return std::string("a body in SCL may name it too; names in SCL are not changed here");
  if (std::string fault = nameFault(document, named, name); !fault.empty()) return fault;
  const bool isSymbol = named.kind == NameKind::Symbol;
  if (isSymbol && document.program().pous.empty())
    return std::string(
        "no program that uses the table is known: rename the symbol in the program, or name the program under 'inputs' "
        "in rungproof.toml");
  return workspaceEdit(document, Renaming(document, named).places(), isSymbol ? firstNameIs(named.name) : NameInWord(),
                       name);
}

}  // namespace rungproof
