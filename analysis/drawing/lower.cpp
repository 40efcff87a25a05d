// Along the branches if the stack can follow them, otherwise step by step.
#include "analysis/drawing/lower.hpp"

#include "analysis/drawing/branches.hpp"
#include "analysis/drawing/steps.hpp"

namespace rungproof {

namespace {

EditorBits bitsOf(const Operand& operand) {
  if (operand.kind != OperandKind::Direct && operand.kind != OperandKind::Indirect &&
      operand.kind != OperandKind::Address)
    return 0;
  if (operand.area != Area::L) return 0;
  const std::uint64_t first = operand.offset * 8ULL + (operand.width == Width::Bit ? operand.bit : 0);
  const auto width =
      static_cast<std::uint64_t>(bits(operand.kind == OperandKind::Indirect ? Width::DWord : operand.width));
  EditorBits result = 0;
  for (std::uint64_t bit = 60 * 8; bit < 64 * 8; ++bit) {
    if (bit >= first && bit < first + width) result |= 1U << (bit - 60 * 8);
  }
  return result;
}

EditorBits bitsOf(const Operands& operands) {
  EditorBits result = 0;
  for (const Operand& operand : operands) result |= bitsOf(operand);
  return result;
}

}  // namespace

EditorBits editorBitsUsed(const Pou& pou) {
  EditorBits result = 0;
  for (const LocalVariable& local : pou.locals) result |= bitsOf(local.address);
  for (const Network& network : pou.networks) {
    for (const Instruction& instruction : network.instructions) result |= bitsOf(instruction.operands);
  }
  return result;
}

EditorBits editorBitsUsed(const Drawing& drawing) {
  EditorBits result = 0;
  for (const Element& element : drawing.elements) result |= bitsOf(element.operands);
  return result;
}

Lowered lower(const Drawing& drawing, EditorBits taken) {
  const Circuit circuit = circuitOf(drawing);
  if (circuit.fault) {
    Lowered refused;
    refused.fault = circuit.fault;
    return refused;
  }
  taken |= editorBitsUsed(drawing);
  for (const PinOrder order : {PinOrder::AsDrawn, PinOrder::Free}) {
    Branches branches = lowerAlongBranches(drawing, circuit, order, taken);
    if (!branches.lowered.fault) return std::move(branches.lowered);
  }
  return lowerStepByStep(drawing, circuit, taken);
}

std::optional<LoweringFault> lowerInto(Network& network, Drawing drawing, EditorBits taken) {
  Lowered lowered = lower(drawing, taken);
  if (lowered.fault) return lowered.fault;
  for (std::size_t i = 0; i < drawing.elements.size(); ++i) drawing.elements[i].instruction = lowered.instructionOf[i];
  network.instructions = std::move(lowered.instructions);
  network.drawing = std::make_shared<const Drawing>(std::move(drawing));
  return std::nullopt;
}

}  // namespace rungproof
