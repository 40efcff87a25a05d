// Reads a piece and moves every place in it to the element.
#include "frontend/flgnet/fragment.hpp"

#include <fmt/format.h>

#include "frontend/step7/declaration_parser.hpp"
#include "frontend/step7/operand_parser.hpp"

namespace rungproof::flgnet {

namespace {

using step7::Operand;
using step7::OperandForm;
using step7::TypeSyntax;

constexpr step7::Spelling7 spelling{step7::MnemonicSet::International, TextEncoding::Utf8};

void moveTo(Operand& operand, Span span) {
  operand.span = span;
  operand.constant.span = span;
  if (operand.block) operand.block->span = span;
  for (step7::PathStep& step : operand.path) step.span = span;
}

std::shared_ptr<const TypeSyntax> movedTo(const TypeSyntax& type, Span span) {
  auto moved = std::make_shared<TypeSyntax>(type);
  moved->span = span;
  if (moved->named) moved->named->span = span;
  if (moved->element) moved->element = movedTo(*moved->element, span);
  return moved;
}

bool isAlike(std::string_view a, std::string_view upperCase) { return step7::equalsWord(a, upperCase); }

/// What stands before the digits of a constant that has no prefix of its own.
std::string_view constantPrefix(std::string_view type, bool isHex) {
  if (isHex && (isAlike(type, "WORD") || isAlike(type, "INT"))) return "W#";
  if (isHex && (isAlike(type, "DWORD") || isAlike(type, "DINT"))) return "DW#";
  if (isHex && isAlike(type, "BYTE")) return "B#";
  return isAlike(type, "DINT") ? "L#" : "";
}

}  // namespace

std::optional<Operand> operandFrom(std::string_view text, Span span) {
  step7::Cursor cursor(text, span.file);
  step7::OperandOutcome outcome = step7::readOperand7(cursor, spelling);
  if (!outcome.fault.empty() || outcome.operand.form == OperandForm::None || !cursor.atEnd()) return std::nullopt;
  moveTo(outcome.operand, span);
  return std::move(outcome.operand);
}

std::optional<Operand> constantFrom(std::string_view type, std::string_view text, Span span) {
  std::string written(text);
  if (isAlike(type, "BOOL")) written = written == "1" ? "TRUE" : written == "0" ? "FALSE" : written;
  for (const std::string_view own : {"INT#", "DINT#", "REAL#", "BOOL#"}) {
    if (written.size() > own.size() && isAlike(written.substr(0, own.size()), own)) {
      written.erase(0, own.size());
      break;
    }
  }
  if (isAlike(type, "REAL") && written.find('.') == std::string::npos) {
    const std::size_t exponent = std::min(written.find_first_of("eE"), written.size());
    written.insert(exponent, ".0");
  } else {
    const bool isHex = written.starts_with("16#");
    const bool isPlain = written.find('#') == std::string::npos;
    if (isHex || isPlain) written.insert(0, constantPrefix(type, isHex));
  }
  std::optional<Operand> operand = operandFrom(written, span);
  return operand && operand->form == OperandForm::Constant ? operand : std::nullopt;
}

std::shared_ptr<const TypeSyntax> typeFrom(std::string_view text, Span span) {
  Program scratch;
  scratch.sources->add("", "");
  SyntaxSink sink(scratch, 0);
  step7::Cursor cursor(text, 0);
  step7::DeclarationParser parser(cursor, spelling, sink);
  const std::shared_ptr<const TypeSyntax> type = parser.readType();
  cursor.skipSpace();
  return type == nullptr || parser.faults() > 0 || !cursor.atEnd() ? nullptr : movedTo(*type, span);
}

std::optional<std::vector<step7::PathStep>> pathFrom(std::string_view text, Span span) {
  std::optional<Operand> operand = operandFrom("#" + std::string(text), span);
  if (!operand || operand->form != OperandForm::Local) return std::nullopt;
  return std::move(operand->path);
}

}  // namespace rungproof::flgnet
