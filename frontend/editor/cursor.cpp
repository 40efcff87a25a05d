// Finding what stands at a place.
#include "frontend/editor/cursor.hpp"

#include "frontend/editor/property_words.hpp"

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

void findInProgram(const CheckedDocument& document, std::uint32_t offset, Cursor& cursor) {
  const SourceFile& source = document.source();
  for (const Pou& pou : document.program().pous) {
    for (const Network& network : pou.networks) {
      if (!document.isHere(network.span) || !touches(network.span, offset)) continue;
      cursor.pou = &pou;
      cursor.network = &network;
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
