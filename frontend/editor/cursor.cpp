// Finding what stands at a place.
#include "frontend/editor/cursor.hpp"

#include <algorithm>

#include "frontend/editor/property_words.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

/// The end counts too: behind the last letter of a word people still mean the word.
bool touches(Span span, std::uint32_t offset) { return span.offset <= offset && offset <= span.offset + span.length; }

void findInInstruction(const Instruction& instruction, std::uint32_t offset, Cursor& cursor) {
  cursor.instruction = &instruction;
  if (touches(instruction.mnemonic(), offset)) {
    cursor.isMnemonic = true;
    cursor.span = instruction.mnemonic();
    return;
  }
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    const Operand& operand = instruction.operands[i];
    if (operand.span.length == 0 || !touches(operand.span, offset)) continue;
    cursor.operand = operand;
    cursor.operandIndex = static_cast<int>(i);
    cursor.span = operand.span;
  }
}

/// SCL: many instructions have the span of one statement; the smallest operand that stands there is meant.
void findInStructured(const CheckedDocument& document, const Network& network, std::uint32_t offset, Cursor& cursor) {
  for (const Instruction& instruction : network.instructions) {
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      const Operand& operand = instruction.operands[i];
      const bool isThere = document.isHere(operand.span) && operand.span.length > 0 && touches(operand.span, offset);
      if (!isThere || !operand.isMemory() || (cursor.operand && cursor.span.length <= operand.span.length)) continue;
      cursor.instruction = &instruction;
      cursor.operand = operand;
      cursor.operandIndex = static_cast<int>(i);
      cursor.span = operand.span;
    }
  }
}

void findInProgram(const CheckedDocument& document, std::uint32_t offset, Cursor& cursor) {
  const SourceFile& source = document.source();
  for (const Pou& pou : document.program().pous) {
    for (const Network& network : pou.networks) {
      if (!document.isHere(network.span) || !touches(network.span, offset)) continue;
      cursor.pou = &pou;
      cursor.network = &network;
      if (network.isStructured) return findInStructured(document, network, offset, cursor);
      for (const Instruction& instruction : network.instructions) {
        if (document.isHere(instruction.span) && touches(instruction.span, offset))
          return findInInstruction(instruction, offset, cursor);
      }
      if (source.position(offset).line != source.position(network.span.offset).line) continue;
      cursor.isHeading = true;
      cursor.span = {document.file(), network.span.offset,
                     static_cast<std::uint32_t>(source.line(source.position(offset).line).size())};
    }
  }
}

void findInProperties(const CheckedDocument& document, std::uint32_t offset, Cursor& cursor) {
  for (const Property& property : document.properties().properties) {
    for (const Expr* expression : {&property.first, &property.second}) {
      for (const ExprNode& node : expression->nodes) {
        if (node.op != ExprOp::Address || !document.isHere(node.span) || !touches(node.span, offset)) continue;
        cursor.operand = node.operand;
        cursor.span = node.span;
      }
    }
  }
  if (cursor.operand) return;
  // A statement with a mistake names things all the same.
  for (const PropertyWord& word : propertyWordsOf(document)) {
    if (!document.isHere(word.span) || !touches(word.span, offset)) continue;
    const std::optional<Operand> meant = lookupIn(document.program())(word.text);
    if (!meant) continue;
    cursor.operand = meant;
    cursor.span = word.span;
  }
}

void findInSymbols(const CheckedDocument& document, std::uint32_t offset, Cursor& cursor) {
  for (const Symbol& symbol : document.program().symbols) {
    if (!document.isHere(symbol.span) || !touches(symbol.span, offset)) continue;
    cursor.operand = symbol.address;
    cursor.operand->text = symbol.name;
    cursor.span = symbol.span;
  }
}

}  // namespace

std::optional<Type> routineType(const Instruction& instruction, std::size_t operand) {
  if (operand >= static_cast<std::size_t>(instruction.desc->operandCount)) return std::nullopt;
  const Type type = instruction.desc->operand(static_cast<int>(operand)).type;
  const bool isRoutine = type == Type::Label || type == Type::Subroutine || type == Type::Interrupt;
  return isRoutine ? std::optional(type) : std::nullopt;
}

const LocalVariable* localAt(const CheckedDocument& document, const Cursor& cursor) {
  const std::string_view written = document.source().text(cursor.span);
  if (cursor.pou == nullptr || !written.starts_with('#')) return nullptr;
  const std::string_view name = written.substr(1, written.substr(1).find_first_of(".["));
  const auto local = std::ranges::find_if(cursor.pou->locals,
                                          [&](const LocalVariable& one) { return equalsIgnoringCase(one.name, name); });
  return local == cursor.pou->locals.end() ? nullptr : &*local;
}

std::vector<const Access*> usesOfLocal(const CheckedDocument& document, const Cursor& cursor) {
  std::vector<const Access*> uses;
  if (!cursor.operand || cursor.pou == nullptr) return uses;
  const Facts& facts = document.facts();
  const Operand& wanted = *cursor.operand;
  const auto isSame = [&](const Operand& operand) {
    const bool isOfKind = operand.kind == wanted.kind && operand.area == wanted.area &&
                          (operand.reach == nullptr) == (wanted.reach == nullptr);
    if (!isOfKind) return false;
    if (wanted.reach != nullptr &&
        (operand.reach->way != wanted.reach->way || operand.reach->parameter != wanted.reach->parameter))
      return false;
    const auto first = [](const Operand& o) { return o.offset * 8 + (o.width == Width::Bit ? o.bit : 0); };
    const auto end = [&](const Operand& o) { return first(o) + static_cast<std::uint32_t>(bits(o.width)); };
    return first(operand) < end(wanted) && first(wanted) < end(operand);
  };
  for (const Network& network : cursor.pou->networks) {
    for (const Instruction& instruction : network.instructions) {
      for (const Access& access : facts.accesses().of(instruction.id)) {
        const bool isShown = access.operand < instruction.operands.size();
        if (isShown && isSame(instruction.operands[access.operand])) uses.push_back(&access);
      }
    }
  }
  return uses;
}

std::optional<Type> Cursor::routine() const {
  if (instruction == nullptr || operandIndex < 0) return std::nullopt;
  return routineType(*instruction, static_cast<std::size_t>(operandIndex));
}

Cursor cursorAt(const CheckedDocument& document, std::uint32_t offset) {
  Cursor cursor;
  findInProgram(document, offset, cursor);
  if (!cursor.operand && !cursor.isMnemonic) findInProperties(document, offset, cursor);
  if (cursor.isNothing()) findInSymbols(document, offset, cursor);
  return cursor;
}

}  // namespace rungproof
