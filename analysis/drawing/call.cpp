// The instructions that Micro/WIN writes around a CALL with flow inputs, recognised by their shape.
#include <optional>

#include "analysis/drawing/levels.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {

namespace {

bool isEditorBit(const Operand& operand, std::uint32_t byte, unsigned bit) {
  return operand.kind == OperandKind::Direct && operand.area == Area::L && operand.width == Width::Bit &&
         operand.offset == byte && operand.bit == bit;
}

/// L60.0 holds the power flow of the CALL.
bool isOnEnable(const Instruction& instruction) {
  return !instruction.operands.empty() && isEditorBit(instruction.operands[0], 60, 0);
}

/// Flow input k: L63.7, L63.6, ...
bool isFlowBit(const Operand& operand, unsigned k) { return isEditorBit(operand, 63 - k / 8, 7 - k % 8); }

/// Number of flow inputs that a CALL takes; nothing if its operands in L60-L63 are not those of the editor.
std::optional<unsigned> flowsOf(const Instruction& call) {
  unsigned count = 0;
  for (std::size_t i = 1; i < call.operands.size(); ++i) {
    const Operand& operand = call.operands[i];
    if (isFlowBit(operand, count))
      ++count;
    else if (operand.kind == OperandKind::Direct && operand.area == Area::L && operand.offset >= 60)
      return std::nullopt;
  }
  return count;
}

}  // namespace

CallIdiom callIdiomOf(const Network& network) {
  const std::vector<Instruction>& all = network.instructions;
  CallIdiom idiom{std::vector<CallRole>(all.size(), CallRole::None), std::vector<std::uint32_t>(all.size(), 0)};
  std::size_t begin = 0;  // behind the call before
  for (std::uint32_t call = 0; call < all.size(); ++call) {
    if (all[call].desc->control != Control::Call) continue;
    const std::size_t from = begin;
    begin = call + 1;
    const std::optional<unsigned> flows = flowsOf(all[call]);
    if (!flows || *flows == 0 || call == from || all[call - 1].desc != &s7200Instructions().bitContact(Role::Load) ||
        !isOnEnable(all[call - 1]))
      continue;
    std::vector<std::size_t> stores;
    for (std::size_t i = from; i + 1 < call; ++i) {
      const std::size_t next = stores.size();
      const bool isStore =
          isPlainCoil(*all[i].desc) &&
          (next == 0 ? isOnEnable(all[i]) : isFlowBit(all[i].operands[0], static_cast<unsigned>(next - 1)));
      if (isStore) stores.push_back(i);
    }
    if (stores.size() != *flows + 1 || stores.back() + 2 != call) continue;
    for (std::size_t k = 0; k < stores.size(); ++k) {
      idiom.roles[stores[k]] = k == 0 ? CallRole::StoreEnable : CallRole::StoreFlow;
      idiom.callOf[stores[k]] = call;
    }
    idiom.roles[call - 1] = CallRole::Recall;
    idiom.roles[call] = CallRole::Call;
    idiom.callOf[call - 1] = idiom.callOf[call] = call;
  }
  return idiom;
}

Shape shapeOf(const Desc& desc) {
  if (desc.stack.pushes == 1 && desc.stack.needs == 0) return Shape::Contact;
  if (desc.execution == Execution::Stack || desc.execution == Execution::Compare)
    return desc.operandCount == 0 && desc.stack.pushes == 0 && desc.stack.needs == 1 ? Shape::Contact : Shape::Or;
  if (desc.execution == Execution::Coil) return Shape::Coil;
  if (desc.execution == Execution::Control)
    return desc.control == Control::Call || desc.control == Control::For ? Shape::Box : Shape::Coil;
  const bool isLatch =
      desc.operandCount == 2 && desc.operand(0).type == Type::Bool && desc.operand(0).direction == Direction::Out;
  return isLatch || (desc.operandCount == 0 && desc.execution == Execution::Conditional) ? Shape::Coil : Shape::Box;
}

}  // namespace rungproof
