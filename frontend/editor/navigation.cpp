// Definitions, references, outline.
#include "frontend/editor/navigation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace rungproof {

namespace {

/// Kinds of symbols in the protocol.
enum class OutlineKind : int { Module = 2, Method = 6, Function = 12, Variable = 13, Key = 20, Event = 24 };

std::string small(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return result;
}

void addLocation(const CheckedDocument& document, Span span, Json& list) {
  Json location = document.location(span);
  const std::string text = location.dump();
  for (const Json& known : list.items()) {
    if (known.dump() == text) return;
  }
  list.push_back(std::move(location));
}

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

void addRoutine(const CheckedDocument& document, const Cursor& cursor, Json& list) {
  const auto number = static_cast<int>(cursor.operand->value);
  const Program& program = document.program();
  if (cursor.routine() == Type::Label) {
    eachInstruction(program, [&](const Pou& pou, const Network&, const Instruction& instruction) {
      if (&pou == cursor.pou && isLabel(instruction) && instruction.operands[0].value == number)
        addLocation(document, instruction.span, list);
    });
    return;
  }
  const Pou* const pou = cursor.routine() == Type::Subroutine ? program.subroutine(number) : program.interrupt(number);
  if (pou != nullptr) addLocation(document, headingOf(document, pou->span), list);
}

void addDeclarations(const CheckedDocument& document, const Cursor& cursor, Json& list) {
  const Operand& operand = *cursor.operand;
  if (cursor.pou != nullptr && operand.area == Area::L) {
    for (const LocalVariable& local : cursor.pou->locals) {
      if (local.address.offset == operand.offset && local.address.bit == operand.bit &&
          local.address.width == operand.width)
        addLocation(document, local.span, list);
    }
  }
  const Symbol* const named = operand.text.empty() ? nullptr : document.facts().symbolNamed(operand.text);
  const Symbol* const symbol = named != nullptr ? named : document.facts().symbolOf(operand);
  if (symbol != nullptr) addLocation(document, symbol->span, list);
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

void addUses(const CheckedDocument& document, const Cursor& cursor, bool onlyWriters, Json& list) {
  Operand address = *cursor.operand;
  address.kind = OperandKind::Direct;
  for (const std::size_t index : entriesTouching(document.xref(), address)) {
    const XrefEntry& entry = document.xref().entries[index];
    const bool isOfOther =
        entry.area == Area::L && cursor.pou != nullptr && &document.program().pous[entry.block] != cursor.pou;
    if (isOfOther) continue;
    for (const Access* use : entry.uses) {
      if (!onlyWriters || use->write || use->isBox) addLocation(document, spanOf(document, *use), list);
    }
  }
}

void addCalls(const CheckedDocument& document, const Cursor& cursor, Json& list) {
  const Type type = *cursor.routine();
  eachInstruction(document.program(), [&](const Pou& pou, const Network&, const Instruction& instruction) {
    if (isLabel(instruction) || (type == Type::Label && &pou != cursor.pou)) return;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      if (routineType(instruction, i) == type && instruction.operands[i].value == cursor.operand->value)
        addLocation(document, instruction.operands[i].span, list);
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
    if (isLabel(instruction))
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
  Json list = Json::array();
  const Cursor cursor = cursorAt(document, document.offset(place));
  if (cursor.operand && cursor.routine()) addRoutine(document, cursor, list);
  if (!isAddress(cursor)) return list;
  addDeclarations(document, cursor, list);
  // A name leads to its declaration, an address to whatever gives it its value.
  if (list.empty() || cursor.operand->text.empty()) addUses(document, cursor, true, list);
  return list;
}

Json referencesAt(const CheckedDocument& document, ClientPlace place, bool withDeclaration) {
  Json list = Json::array();
  const Cursor cursor = cursorAt(document, document.offset(place));
  if (cursor.operand && cursor.routine()) {
    if (withDeclaration) addRoutine(document, cursor, list);
    addCalls(document, cursor, list);
  }
  if (!isAddress(cursor)) return list;
  if (withDeclaration) addDeclarations(document, cursor, list);
  addUses(document, cursor, false, list);
  return list;
}

Json outlineOf(const CheckedDocument& document) {
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
