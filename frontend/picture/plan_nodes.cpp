// What ladder and FBD nodes have in common: contacts, coils and boxes with their texts.
#include "frontend/picture/plan_nodes.hpp"

#include <algorithm>

#include "frontend/picture/node_parts.hpp"
#include "ir/check.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

std::vector<int> usesOf(const Drawing& drawing) {
  std::vector<int> uses(drawing.elements.size(), 0);
  for (const Element& element : drawing.elements) {
    for (const Wire& wire : element.inputs) ++uses[wire.from];
  }
  return uses;
}

void addAbove(PlanNode& node, const OperandText& text) {
  if (text.address.empty()) return;
  node.namedAbove = !text.symbol.empty();
  if (node.namedAbove) node.above.push_back(text.symbol);
  node.above.push_back(text.address);
}

PlanNode nodeOf(const ElementTexts& texts, int element) {
  PlanNode node;
  node.element = element;
  node.mark = texts.mark(element);
  node.severity = texts.severity(element);
  node.output = texts.output(element);
  node.state = texts.state(element);
  return node;
}

const Pou* calleeOf(const ElementTexts& texts, const Element& element) {
  if (!isCallBox(*element.desc) || texts.program() == nullptr || element.operands.empty()) return nullptr;
  const Operand& number = element.operands[0];
  if (number.kind == OperandKind::Constant) return texts.program()->subroutine(static_cast<int>(number.value));
  for (const Pou& pou : texts.program()->pous) {
    if (pou.kind == PouKind::Subroutine && number.kind == OperandKind::Symbol && pou.name == number.text) return &pou;
  }
  return nullptr;
}

namespace {

std::string nameOfBox(const ElementTexts& texts, const Element& element, int index) {
  if (!isCallBox(*element.desc)) return std::string(element.desc->drawnName());
  if (const Pou* callee = calleeOf(texts, element)) return callee->name;
  const OperandText text = texts.operand(index, 0);
  return element.operands.empty()                            ? "CALL"
         : element.operands[0].kind == OperandKind::Constant ? "SBR_" + text.address
                                                             : text.address;
}

/// A box that says itself what it shows.
PlanNode facedNode(const ElementTexts& texts, const BoxFace& face, int index, bool isOutputUsed) {
  PlanNode node = nodeOf(texts, index);
  node.kind = NodeKind::Box;
  node.name = face.name;
  if (!face.instance.empty()) node.above = {shortened(face.instance)};
  node.hasOutput = isOutputUsed;
  node.outputPin = isOutputUsed ? face.output : std::string();
  std::size_t value = 0;
  const auto add = [&](const std::vector<BoxFace::Pin>& pins, std::vector<DataPin>& into) {
    for (const BoxFace::Pin& pin : pins)
      into.push_back({pin.name, shortened(pin.text) + texts.value(index, value++), pin.isConstant});
  };
  add(face.left, node.left);
  add(face.right, node.right);
  return node;
}

}  // namespace

PlanNode boxNode(const ElementTexts& texts, const Element& element, int index, bool isOutputUsed) {
  if (element.face != nullptr) return facedNode(texts, *element.face, index, isOutputUsed);
  PlanNode node = nodeOf(texts, index);
  const Desc& desc = *element.desc;
  node.kind = NodeKind::Box;
  node.name = nameOfBox(texts, element, index);
  node.outputPin = desc.control == Control::BlockCall ? callPowerOutput(element.operands, calleeOf(texts, element))
                                                      : powerOutput(desc);
  node.hasOutput = !node.outputPin.empty();
  for (const OperandPin& pin : operandPins(desc, element.operands.size(), calleeOf(texts, element))) {
    const Operand& operand = element.operands[pin.operand];
    const OperandText text = texts.operand(index, pin.operand);
    // An output that is not used, or a parameter that is given as power flow.
    const bool isOptional = isCallBox(desc) || (pin.operand < desc.operandCount && desc.operands[pin.operand].optional);
    const bool isOpen = operand.kind == OperandKind::Missing && isOptional;
    if (pin.side == PinSide::Above) {
      addAbove(node, text);
    } else if (!isOpen) {
      if (isOutputUsed && pin.name == node.outputPin) node.outputPin.clear();
      (pin.side == PinSide::Left ? node.left : node.right).push_back({pin.name, text.whole(), text.isConstant});
    }
    const bool hasResolution = desc.execution != Execution::Always;  // a timer of the S7-300 has it from its value
    const bool isTimer =
        hasResolution && pin.operand < desc.operandCount && desc.operands[pin.operand].type == Type::Timer;
    if (pin.side == PinSide::Above && isTimer && operand.kind == OperandKind::Direct) {
      node.note = std::to_string(timerResolution(static_cast<int>(operand.offset))) + " ms";
    }
  }
  return node;
}

std::vector<std::string> powerPinsOf(const ElementTexts& texts, const Element& element) {
  if (element.face != nullptr) return element.face->inputs;
  if (isCallBox(*element.desc)) return callPowerPins(element.operands, calleeOf(texts, element));
  return powerPins(*element.desc);
}

}  // namespace rungproof
