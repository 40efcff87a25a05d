// Definitions, references, outline.
#include "frontend/editor/navigation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

#include "frontend/editor/property_words.hpp"
#include "frontend/editor/structured_navigation.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

/// Kinds of symbols in the protocol.
enum class OutlineKind : int { Module = 2, Class = 5, Method = 6, Function = 12, Variable = 13, Key = 20, Event = 24 };

std::string small(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return result;
}

/// Places, each once.
class Places {
 public:
  explicit Places(const CheckedDocument& document) : document_(document) {}

  const CheckedDocument& document() const { return document_; }
  void add(Span span) {
    if (!has(span)) list_.push_back(span);
    added_.insert(keyOf(span));
  }
  bool empty() const { return list_.empty(); }
  bool has(Span span) const { return added_.contains(keyOf(span)); }
  const std::vector<Span>& spans() const { return list_; }
  Json locations() const {
    Json list = Json::array();
    for (const Span& span : list_) list.push_back(document_.location(span));
    return list;
  }

 private:
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
  static Key keyOf(Span span) { return {span.file, span.offset, span.length}; }

  const CheckedDocument& document_;
  std::set<Key> added_;
  std::vector<Span> list_;
};

void eachInstruction(const Program& program,
                     const std::function<void(const Pou&, const Network&, const Instruction&)>& visit) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) visit(pou, network, instruction);
    }
  }
}

bool isLabel(const Instruction& instruction) { return instruction.desc->control == Control::LabelMark; }

/// The first line of a block or a network.
Span headingOf(const CheckedDocument& document, Span span) {
  const SourceFile& file = document.program().sources->file(span.file);
  const std::uint32_t line = file.position(span.offset).line;
  const std::uint32_t end = file.lineStart(line) + static_cast<std::uint32_t>(file.line(line).size());
  return {span.file, span.offset, std::min(std::max(end, span.offset) - span.offset, span.length)};
}

void addRoutine(const Cursor& cursor, Places& places) {
  const CheckedDocument& document = places.document();
  const auto number = static_cast<int>(cursor.operand->value);
  const Program& program = document.program();
  if (cursor.routine() == Type::Label) {
    eachInstruction(program, [&](const Pou& pou, const Network&, const Instruction& instruction) {
      if (&pou == cursor.pou && isLabel(instruction) && instruction.operands[0].value == number)
        places.add(instruction.span);
    });
    return;
  }
  const Pou* const pou = cursor.routine() == Type::Subroutine ? program.subroutine(number) : program.interrupt(number);
  if (pou != nullptr) places.add(headingOf(document, pou->span));
}

void addDeclarations(const Cursor& cursor, Places& places) {
  const CheckedDocument& document = places.document();
  const Operand& operand = *cursor.operand;
  if (cursor.pou != nullptr && operand.area == Area::L) {
    for (const LocalVariable& local : cursor.pou->locals) {
      if (local.address.offset == operand.offset && local.address.bit == operand.bit &&
          local.address.width == operand.width)
        places.add(local.span);
    }
  }
  if (const LocalVariable* local = localAt(document, cursor); operand.reach != nullptr && local != nullptr)
    return places.add(local->span);
  const Symbol* const named = operand.text.empty() ? nullptr : document.facts().symbolNamed(operand.text);
  const Symbol* const symbol = named != nullptr ? named : document.facts().symbolOf(operand);
  if (symbol != nullptr) places.add(symbol->span);
}

/// The place of an access: its operand, or the instruction where no operand shows it.
Span spanOf(const CheckedDocument& document, const Access& access) {
  const Instruction& instruction = document.facts().instruction(access.instruction);
  const bool isShown = access.operand < instruction.operands.size();
  const Span span = isShown ? instruction.operands[access.operand].span : instruction.span;
  return span.length == 0 ? instruction.span : span;
}

bool isAddress(const Cursor& cursor) {
  return cursor.operand && !cursor.routine() &&
         (cursor.operand->isMemory() || cursor.operand->kind == OperandKind::Address);
}

void addUses(const Cursor& cursor, bool onlyWriters, Places& places) {
  const CheckedDocument& document = places.document();
  if (cursor.operand->reach != nullptr) {  // S7-300/400: own data of a block lies at no address that is written
    for (const Access* use : usesOfLocal(document, cursor)) {
      if (!onlyWriters || use->write || use->isBox) places.add(spanOf(document, *use));
    }
    return;
  }
  Operand address = *cursor.operand;
  address.kind = OperandKind::Direct;
  for (const std::size_t index : entriesTouching(document.xref(), address)) {
    const XrefEntry& entry = document.xref().entries[index];
    const bool isOfOther =
        entry.area == Area::L && cursor.pou != nullptr && &document.program().pous[entry.block] != cursor.pou;
    if (isOfOther) continue;
    for (const Access* use : entry.uses) {
      if (!onlyWriters || use->write || use->isBox) places.add(spanOf(document, *use));
    }
  }
}

/// Whether a word of a property means bits of the address.
bool means(const OperandLookup& lookup, const PropertyWord& word, const Operand& address) {
  const std::optional<Operand> meant = lookup(word.text);
  if (!meant || !(meant->isMemory() || meant->kind == OperandKind::Address)) return false;
  const auto entryOf = [](const Operand& operand) {
    XrefEntry entry;
    entry.area = operand.area;
    entry.width = operand.width;
    entry.offset = operand.offset;
    entry.bit = operand.width == Width::Bit && !addressedByNumber(operand.area) ? operand.bit : 0;
    return entry;
  };
  const XrefEntry a = entryOf(*meant), b = entryOf(address);
  return a.area == b.area && a.firstBit() < b.endBit() && b.firstBit() < a.endBit();
}

void addUsesInProperties(const Cursor& cursor, Places& places) {
  if (cursor.operand->area == Area::L) return;
  const CheckedDocument& document = places.document();
  const OperandLookup lookup = lookupIn(document.program());
  for (const PropertyWord& word : propertyWordsOf(document)) {
    if (means(lookup, word, *cursor.operand)) places.add(word.span);
  }
}

/// In property files that lie beside the program but are not read with it.
void addUsesBeside(const CheckedDocument& document, const Operand& address, Json& locations) {
  if (address.area == Area::L) return;
  const OperandLookup lookup = lookupIn(document.program());
  for (const PropertyFileBeside& beside : propertyFilesBeside(document)) {
    for (const PropertyWord& word : beside.words) {
      if (means(lookup, word, address))
        locations.push_back({{"uri", beside.uri}, {"range", rangeJson(*beside.file, word.span)}});
    }
  }
}

void addCalls(const Cursor& cursor, Places& places) {
  const CheckedDocument& document = places.document();
  const Type type = *cursor.routine();
  eachInstruction(document.program(), [&](const Pou& pou, const Network&, const Instruction& instruction) {
    if (isLabel(instruction) || (type == Type::Label && &pou != cursor.pou)) return;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      if (routineType(instruction, i) == type && instruction.operands[i].value == cursor.operand->value)
        places.add(instruction.operands[i].span);
    }
  });
}

Json outlineRow(const CheckedDocument& document, const std::string& name, const std::string& detail, OutlineKind kind,
                Span span, Span heading) {
  return {{"name", name.empty() ? std::string("?") : name},
          {"detail", detail},
          {"kind", static_cast<int>(kind)},
          {"range", document.range(span)},
          {"selectionRange", document.range(heading)}};
}

std::string titleOf(const Network& network) {
  return network.title.empty() ? fmt::format("Network {}", network.number)
                               : fmt::format("Network {}: {}", network.number, network.title);
}

Json networkRow(const CheckedDocument& document, const Network& network) {
  Json row =
      outlineRow(document, titleOf(network), "", OutlineKind::Method, network.span, headingOf(document, network.span));
  for (const Instruction& instruction : network.instructions) {
    if (isLabel(instruction) && !network.isStructured)
      row["children"].push_back(
          outlineRow(document, Facts::text(instruction), "", OutlineKind::Key, instruction.span, instruction.span));
  }
  return row;
}

OutlineKind kindOf(const Pou& pou) {
  return pou.kind == PouKind::Main         ? OutlineKind::Module
         : pou.kind == PouKind::Subroutine ? OutlineKind::Function
                                           : OutlineKind::Event;
}

}  // namespace

Json definitionsAt(const CheckedDocument& document, ClientPlace place) {
  Places places(document);
  if (isStructuredText(document) || isSclText(document)) {
    if (const auto name = textNameAt(document, document.offset(place))) places.add(name->declaration);
    if (!places.empty() || isStructuredText(document)) return places.locations();
  }
  const Cursor cursor = cursorAt(document, document.offset(place));
  if (cursor.operand && cursor.routine()) addRoutine(cursor, places);
  if (!isAddress(cursor)) return places.locations();
  addDeclarations(cursor, places);
  // A name leads to its declaration, an address to whatever gives it its value.
  if (places.empty() || cursor.operand->text.empty()) addUses(cursor, true, places);
  return places.locations();
}

namespace {

void addReferences(const Cursor& cursor, bool withDeclaration, Places& places) {
  if (cursor.operand && cursor.routine()) {
    if (withDeclaration) addRoutine(cursor, places);
    addCalls(cursor, places);
  }
  if (!isAddress(cursor)) return;
  if (withDeclaration) addDeclarations(cursor, places);
  addUses(cursor, false, places);
  if (cursor.operand->reach == nullptr) addUsesInProperties(cursor, places);
}

}  // namespace

namespace {

/// IEC 61131-3: uses in texts and properties.
Json referencesInTexts(const CheckedDocument& document, const TextName& name, bool withDeclaration) {
  Places places(document);
  if (withDeclaration) places.add(name.declaration);
  for (const TextUse& use : name.uses) places.add(use.span);
  if (!name.inProperty) return places.locations();
  for (const PropertyWord& word : propertyWordsOf(document)) {
    if (const auto span = name.inProperty(word)) places.add(*span);
  }
  Json locations = places.locations();
  for (const PropertyFileBeside& beside : propertyFilesBeside(document)) {
    for (const PropertyWord& word : beside.words) {
      if (const auto span = name.inProperty(word))
        locations.push_back({{"uri", beside.uri}, {"range", rangeJson(*beside.file, *span)}});
    }
  }
  return locations;
}

}  // namespace

Json referencesAt(const CheckedDocument& document, ClientPlace place, bool withDeclaration) {
  Places places(document);
  if (isStructuredText(document)) {
    const auto name = textNameAt(document, document.offset(place));
    return name ? referencesInTexts(document, *name, withDeclaration) : places.locations();
  }
  if (isSclText(document)) {
    if (const auto name = textNameAt(document, document.offset(place)))
      return referencesInTexts(document, *name, withDeclaration);
  }
  const Cursor cursor = cursorAt(document, document.offset(place));
  addReferences(cursor, withDeclaration, places);
  Json locations = places.locations();
  if (isAddress(cursor) && cursor.operand->reach == nullptr) addUsesBeside(document, *cursor.operand, locations);
  return locations;
}

Json highlightsAt(const CheckedDocument& document, ClientPlace place) {
  enum class Highlight : int { Text = 1, Read = 2, Write = 3 };  // of the protocol
  Json list = Json::array();
  if (isStructuredText(document)) {
    const auto name = textNameAt(document, document.offset(place));
    const auto add = [&](Span span, Highlight kind) {
      if (document.isHere(span)) list.push_back({{"range", document.range(span)}, {"kind", static_cast<int>(kind)}});
    };
    if (!name) return list;
    add(name->declaration, Highlight::Text);
    for (const TextUse& use : name->uses) add(use.span, use.isWritten ? Highlight::Write : Highlight::Read);
    for (const PropertyWord& word : name->inProperty ? propertyWordsOf(document) : std::vector<PropertyWord>()) {
      if (const auto span = name->inProperty(word)) add(*span, Highlight::Read);
    }
    return list;
  }
  const Cursor cursor = cursorAt(document, document.offset(place));
  Places all(document), written(document);
  addReferences(cursor, true, all);
  if (isAddress(cursor)) addUses(cursor, true, written);
  for (const Span& span : all.spans()) {
    if (!document.isHere(span)) continue;
    const Highlight kind = !isAddress(cursor)  ? Highlight::Text
                           : written.has(span) ? Highlight::Write
                                               : Highlight::Read;
    list.push_back({{"range", document.range(span)}, {"kind", static_cast<int>(kind)}});
  }
  return list;
}

Json foldsOf(const CheckedDocument& document) {
  Json list = Json::array();
  const auto add = [&](Span span, bool isBlock) {
    if (!document.isHere(span) || span.length == 0) return;
    std::string_view text = document.source().text(span);
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r' || text.back() == ' ')) text.remove_suffix(1);
    const std::uint32_t first = document.place(span.offset).line;
    std::uint32_t last = document.place(span.offset + static_cast<std::uint32_t>(text.size())).line;
    // The last network reaches to the end of its block, whose last line is not the network's.
    const std::size_t line = text.rfind('\n');
    if (!isBlock && line != std::string_view::npos && text.substr(line + 1).starts_with("END_")) --last;
    if (last > first) list.push_back({{"startLine", first}, {"endLine", last}});
  };
  for (const Pou& pou : document.program().pous) {
    if (pou.isInstance) continue;
    add(pou.span, true);
    for (const Network& network : pou.networks) {
      if (network.span.offset != pou.span.offset) add(network.span, false);
    }
  }
  return list;
}

namespace {

OutlineKind kindOfText(std::string_view kind) {
  return equalsIgnoringCase(kind, "PROGRAM")    ? OutlineKind::Module
         : equalsIgnoringCase(kind, "FUNCTION") ? OutlineKind::Function
                                                : OutlineKind::Class;
}

/// IEC 61131-3: blocks and in them their variables, as the text has them.
Json outlineOfText(const CheckedDocument& document) {
  Json list = Json::array();
  for (const DeclaredBlock& block : declaredBlocksOf(document)) {
    Json row = outlineRow(document, std::string(block.name), std::string(block.kind), kindOfText(block.kind),
                          block.span, block.heading);
    row["children"] = Json::array();
    for (const DeclaredName& variable : block.variables)
      row["children"].push_back(outlineRow(document, std::string(variable.name), std::string(variable.type),
                                           OutlineKind::Variable, variable.span, variable.span));
    list.push_back(std::move(row));
  }
  for (const DeclaredName& variable : declaredGlobalsOf(document)) {
    if (document.isHere(variable.span))
      list.push_back(outlineRow(document, std::string(variable.name), std::string(variable.type), OutlineKind::Variable,
                                variable.span, variable.span));
  }
  return list;
}

}  // namespace

Json outlineOf(const CheckedDocument& document) {
  if (isStructuredText(document)) return outlineOfText(document);
  Json list = Json::array();
  for (const Pou& pou : document.program().pous) {
    Json networks = Json::array();
    for (const Network& network : pou.networks) {
      if (document.isHere(network.span)) networks.push_back(networkRow(document, network));
    }
    if (!document.isHere(pou.span)) continue;
    Json row = outlineRow(document, pou.name, pou.title, kindOf(pou), pou.span, headingOf(document, pou.span));
    row["children"] = std::move(networks);
    list.push_back(std::move(row));
  }
  for (const Symbol& symbol : document.program().symbols) {
    if (document.isHere(symbol.span))
      list.push_back(
          outlineRow(document, symbol.name, toString(symbol.address), OutlineKind::Variable, symbol.span, symbol.span));
  }
  return list;
}

void addSymbols(const CheckedDocument& document, std::string_view text, Json& list) {
  const std::string wanted = small(text);
  const auto add = [&](const std::string& name, OutlineKind kind, Span span, const std::string& container) {
    if (small(name).find(wanted) == std::string::npos) return;
    list.push_back({{"name", name},
                    {"kind", static_cast<int>(kind)},
                    {"location", document.location(span)},
                    {"containerName", container}});
  };
  if (isStructuredText(document)) {
    for (const DeclaredBlock& block : declaredBlocksOf(document)) {
      add(std::string(block.name), kindOfText(block.kind), block.heading, "");
      for (const DeclaredName& variable : block.variables)
        add(std::string(variable.name), OutlineKind::Variable, variable.span, std::string(block.name));
    }
    for (const DeclaredName& variable : declaredGlobalsOf(document)) {
      if (document.isHere(variable.span)) add(std::string(variable.name), OutlineKind::Variable, variable.span, "");
    }
    return;
  }
  for (const Pou& pou : document.program().pous) {
    add(pou.name, kindOf(pou), headingOf(document, pou.span), "");
    for (const Network& network : pou.networks) {
      if (!network.title.empty())
        add(titleOf(network), OutlineKind::Method, headingOf(document, network.span), pou.name);
    }
  }
  for (const Symbol& symbol : document.program().symbols)
    add(symbol.name, OutlineKind::Variable, symbol.span, toString(symbol.address));
}

}  // namespace rungproof
