// From records to wires.
#include "frontend/picture/power_flow.hpp"

#include <algorithm>

#include "engine/trace.hpp"
#include "frontend/picture/box_form.hpp"

namespace rungproof {

namespace {

Flow3 flowOf(bool isOn) { return isOn ? Flow3::On : Flow3::Off; }

SignalType signalType(const Instruction& instruction, std::size_t index) {
  const Desc& desc = *instruction.desc;
  const Type type = index < desc.operandCount ? desc.operands[index].type : Type::Parameter;
  if (type == Type::Real) return SignalType::Real;
  switch (operandWidth(instruction, index)) {
    case Width::Bit: return SignalType::Bool;
    case Width::Byte: return SignalType::Unsigned;
    default: return SignalType::Signed;
  }
}

bool isTrue(double a, double b, Relation relation) {
  switch (relation) {
    case Relation::Less: return a < b;
    case Relation::LessEqual: return a <= b;
    case Relation::Equal: return a == b;
    case Relation::GreaterEqual: return a >= b;
    case Relation::Greater: return a > b;
    default: return a != b;
  }
}

/// The value of operand `index` in front of the instruction as a number; constants too.
std::optional<double> numberRead(const Instruction& instruction, const InstructionRecord& record, std::size_t index) {
  const Operand& operand = instruction.operands[index];
  const SignalType type = signalType(instruction, index);
  const int width = bits(operandWidth(instruction, index));
  if (operand.kind == OperandKind::Constant)
    return numberOf(static_cast<std::uint64_t>(operand.value) & Concrete::mask(width), type, width);
  if (index >= record.read.size() || !record.read[index]) return std::nullopt;
  return numberOf(*record.read[index], type, width);
}

/// Whether the contact is closed, whatever power reaches it.
bool isClosed(const Element& element, const Instruction& instruction, const InstructionRecord& record) {
  if (element.desc->execution != Execution::Compare) {
    const std::optional<std::uint64_t> value = record.read.empty() ? std::nullopt : record.read[0];
    return value && (*value != 0) != element.desc->negated;
  }
  if (element.desc->operands[0].type != Type::String) {
    const std::optional<double> a = numberRead(instruction, record, 0), b = numberRead(instruction, record, 1);
    return a && b && isTrue(*a, *b, element.desc->relation);
  }
  // Strings: the stack tells. Where the other side of an AND is off or of an OR is on, it cannot be seen, nor does it
  // matter.
  return record.after[0] && (roleOf(instruction) != Role::Or || !record.before[0]);
}

class FlowWalk {
 public:
  FlowWalk(const Drawing& drawing, const Network& network, const InstructionRecorder& recorder)
      : drawing_(drawing), network_(network), recorder_(recorder) {}

  std::vector<ElementFlow> run() {
    bool isPowered = false;
    for (const Instruction& instruction : network_.instructions) {
      const InstructionRecord& record = recorder_.of(instruction);
      if (record.executions > 0) isPowered = isPowered || record.scrActive;
    }
    for (const Element& element : drawing_.elements) {
      flows_.push_back(flow(element, isPowered));
      if (!isPowered) flows_.back().output = Flow3::Off;
    }
    return std::move(flows_);
  }

 private:
  bool isOn(const Wire& wire) const { return (flows_[wire.from].output == Flow3::On) != wire.negated; }

  ElementFlow flow(const Element& element, bool isPowered) const {
    ElementFlow result;
    if (element.shape == Shape::Rail) return {flowOf(isPowered), flowOf(isPowered), {}};
    const auto on = [&](const Wire& wire) { return isOn(wire); };
    if (element.shape == Shape::Or || element.shape == Shape::And) {
      const bool isAny = element.shape == Shape::Or;
      result.output = result.state =
          flowOf(isAny ? std::ranges::any_of(element.inputs, on) : std::ranges::all_of(element.inputs, on));
      return result;
    }
    result.output = result.state = Flow3::Off;
    if (element.instruction >= network_.instructions.size()) return result;
    const Instruction& instruction = network_.instructions[element.instruction];
    const InstructionRecord& record = recorder_.of(instruction);
    if (record.executions == 0) return result;
    result.values = valueTexts(instruction, record);
    const bool input = !element.inputs.empty() && isOn(element.inputs[0]);
    switch (element.shape) {
      case Shape::Contact: contact(element, instruction, record, input, result); break;
      case Shape::Coil:
        result.state = flowOf((input && isPowered) || (element.desc->control == Control::Lscr && record.after[0]));
        result.output = result.state;
        break;
      default:
        result.state = flowOf(input && isPowered);
        result.output = flowOf(boxOutput(element, record, input));
        break;
    }
    return result;
  }

  static void contact(const Element& element, const Instruction& instruction, const InstructionRecord& record,
                      bool input, ElementFlow& result) {
    if (element.desc->role == Role::Not) {
      result.output = result.state = flowOf(!input);
    } else if (element.operands.empty()) {
      result.output = result.state = flowOf(record.after[0]);  // EU, ED
    } else {
      const bool closed = isClosed(element, instruction, record);
      result.state = flowOf(closed);
      result.output = flowOf(closed && input);
    }
  }

  static bool boxOutput(const Element& element, const InstructionRecord& record, bool input) {
    if (element.desc->eno) return input && record.eno;
    if (!element.desc->drawingOnly) return false;
    return element.desc->operands[0].type == Type::Bool ? record.after[0] : record.elementBit;
  }

  const Drawing& drawing_;
  const Network& network_;
  const InstructionRecorder& recorder_;
  std::vector<ElementFlow> flows_;
};

}  // namespace

std::vector<std::string> valueTexts(const Instruction& instruction, const InstructionRecord& record) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    const bool isOutput =
        i < instruction.desc->operandCount && instruction.desc->operands[i].direction != Direction::In;
    const std::vector<std::optional<std::uint64_t>>& values = isOutput ? record.written : record.read;
    const bool isKnown = i < values.size() && values[i].has_value();
    const SignalType type = signalType(instruction, i);
    texts.push_back(isKnown ? numberText(numberOf(*values[i], type, bits(operandWidth(instruction, i))), type)
                            : std::string());
  }
  return texts;
}

bool wasExecuted(const Network& network, const InstructionRecorder& recorder) {
  return std::ranges::any_of(network.instructions,
                             [&](const Instruction& instruction) { return recorder.of(instruction).executions > 0; });
}

std::vector<ElementFlow> elementFlows(const Program& program, const Drawing& drawing, const Network& network,
                                      const InstructionRecorder& recorder) {
  if (drawing.isOfVariables) return variableFlows(program, drawing, network, recorder);
  return FlowWalk(drawing, network, recorder).run();
}

}  // namespace rungproof
