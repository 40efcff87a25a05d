// Hints behind operands.
#include "frontend/editor/inlay_hints.hpp"

#include <fmt/format.h>

#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

enum class HintKind : int { Type = 1, Parameter = 2 };  // of the protocol

class Hints {
 public:
  Hints(const CheckedDocument& document, std::uint32_t begin, std::uint32_t end)
      : document_(document), begin_(begin), end_(end) {}

  void addInstruction(const Instruction& instruction) {
    const std::uint32_t operandsBegin = instruction.mnemonic().offset + instruction.mnemonicLength;
    for (const Operand& operand : instruction.operands) {
      if (operand.span.length == 0 || operand.span.offset < operandsBegin) continue;
      if (operand.kind == OperandKind::Direct) addName(operand);
    }
    const std::string time = presetTime(instruction);
    if (!time.empty()) add(instruction.operands[1].span, "= " + time, HintKind::Type);
  }
  Json take() { return std::move(list_); }

 private:
  void addName(const Operand& operand) {
    if (document_.source().text(operand.span).starts_with('#')) return;
    if (!operand.text.empty()) {
      Operand address = operand;
      address.text = "";
      return add(operand.span, toString(address), HintKind::Parameter);
    }
    const Symbol* const symbol = document_.facts().symbolOf(operand);
    if (symbol != nullptr) add(operand.span, symbol->name, HintKind::Parameter);
  }
  void add(Span span, const std::string& label, HintKind kind) {
    const std::uint32_t at = span.offset + span.length;
    if (!document_.isHere(span) || at < begin_ || at > end_) return;
    const ClientPlace place = document_.place(at);
    list_.push_back({{"position", Json{{"line", place.line}, {"character", place.character}}},
                     {"label", label},
                     {"kind", static_cast<int>(kind)},
                     {"paddingLeft", true}});
  }

  const CheckedDocument& document_;
  const std::uint32_t begin_, end_;
  Json list_ = Json::array();
};

}  // namespace

std::string presetTime(const Instruction& instruction) {
  if (instruction.operands.size() < 2) return {};
  const Operand& timer = instruction.operands[0];
  const Operand& preset = instruction.operands[1];
  const bool isTimerBox = instruction.desc->operandCount > 1 && instruction.desc->operand(0).type == Type::Timer;
  if (!isTimerBox || timer.kind != OperandKind::Direct || preset.kind != OperandKind::Constant) return {};
  const int unit = timerResolution(static_cast<int>(timer.offset));
  return fmt::format("{:g} s", static_cast<double>(preset.value * unit) / 1000);
}

Json inlayHintsIn(const CheckedDocument& document, ClientPlace begin, ClientPlace end) {
  Hints hints(document, document.offset(begin), document.offset(end));
  if (formOf(document.program().target) == StatementForm::Expressions) return hints.take();
  for (const Pou& pou : document.program().pous) {
    for (const Network& network : pou.networks) {
      if (network.drawing != nullptr || network.isStructured) continue;
      for (const Instruction& instruction : network.instructions) {
        if (document.isHere(instruction.span)) hints.addInstruction(instruction);
      }
    }
  }
  return hints.take();
}

}  // namespace rungproof
