// Names and pins.
#include "frontend/picture/box_form.hpp"

#include <algorithm>

namespace rungproof {

namespace {

/// Subtraction and division: STL takes OUT as the first operand (001:4814), the box shows it as IN1.
bool takesOutFirst(const Desc& desc) {
  return desc.role == Role::Sub || desc.role == Role::Div || desc.role == Role::DivWide;
}

bool standsAbove(const Desc& desc, const OperandDesc& operand) {
  if (operand.type == Type::Timer || operand.type == Type::Counter) return operand.direction == Direction::InOut;
  return desc.drawingOnly && operand.type == Type::Bool && operand.direction == Direction::InOut;
}

/// The number of the block, above the box its instance, then its parameters.
std::vector<OperandPin> callPins(std::size_t count, const Pou* callee) {
  std::vector<OperandPin> pins;
  std::size_t next = 1;
  if (callee != nullptr) {
    const bool hasInstance = callee->type == BlockType::Fb || callee->type == BlockType::Sfb;
    if (hasInstance && next < count) pins.push_back({next++, PinSide::Above, "instance"});
    for (const LocalVariable& local : callee->locals) {
      const bool isParameter = local.section != VarSection::Temp && local.section != VarSection::Static;
      if (!isParameter || next >= count) continue;
      pins.push_back({next++, local.section == VarSection::Output ? PinSide::Right : PinSide::Left, local.name});
    }
  }
  for (; next < count; ++next) pins.push_back({next, PinSide::Left, "x" + std::to_string(next)});
  return pins;
}

}  // namespace

std::vector<std::string> callPowerPins(const Operands& operands, const Pou* callee) {
  std::vector<std::string> names = {"EN"};
  for (const OperandPin& pin : callPins(operands.size(), callee)) {
    if (pin.side == PinSide::Left && operands[pin.operand].kind == OperandKind::Missing) names.push_back(pin.name);
  }
  return names;
}

std::string callPowerOutput(const Operands& operands, const Pou* callee) {
  for (const OperandPin& pin : callPins(operands.size(), callee)) {
    if (pin.side == PinSide::Right && operands[pin.operand].kind == OperandKind::Missing) return pin.name;
  }
  return "ENO";
}

bool isCallBox(const Desc& desc) { return desc.control == Control::Call || desc.control == Control::BlockCall; }

bool isBracket(const Desc& desc) { return desc.control == Control::LabelMark || desc.control == Control::Lscr; }

std::vector<OperandPin> operandPins(const Desc& desc, std::size_t count, const Pou* callee) {
  if (isCallBox(desc)) return callPins(count, callee);
  std::vector<OperandPin> pins;
  const bool hasIn1 = desc.operandCount > 0 && desc.operands[0].name == "IN1";
  for (std::size_t i = 0; i < std::min<std::size_t>(count, desc.operandCount); ++i) {
    const OperandDesc& operand = desc.operands[i];
    const std::string name(operand.name);
    if (standsAbove(desc, operand)) {
      pins.push_back({i, PinSide::Above, name});
    } else if (operand.direction == Direction::Out) {
      pins.push_back({i, PinSide::Right, name});
    } else if (operand.direction == Direction::InOut && name == "OUT") {
      pins.push_back({i, PinSide::Left, !hasIn1 ? "IN" : takesOutFirst(desc) ? "IN1" : "IN2"});
      pins.push_back({i, PinSide::Right, name});
    } else {
      pins.push_back({i, PinSide::Left, takesOutFirst(desc) && name == "IN1" ? "IN2" : name});
    }
  }
  if (takesOutFirst(desc)) std::ranges::stable_sort(pins, {}, [](const OperandPin& pin) { return pin.name; });
  return pins;
}

std::vector<std::string> powerPins(const Desc& desc) {
  std::vector<std::string> pins;
  for (const std::string_view pin : desc.flowPins) {
    if (!pin.empty()) pins.emplace_back(pin);
  }
  return pins;
}

std::string powerOutput(const Desc& desc) {
  if (desc.eno) return "ENO";
  if (!desc.drawingOnly) return {};
  return desc.operands[0].type == Type::Bool ? "OUT" : "Q";
}

}  // namespace rungproof
