// Power flow where elements name variables of IEC 61131-3: each value is what lay on the evaluation stack, or what was
// stored. A value that did not arise in the scan, because a jump passed it over, is off.
#include "engine/trace.hpp"
#include "frontend/picture/power_flow.hpp"

namespace rungproof {

namespace {

class VariableFlow {
 public:
  VariableFlow(const Program& program, const Drawing& drawing, const Network& network,
               const InstructionRecorder& recorder)
      : program_(program), drawing_(drawing), network_(network), recorder_(recorder) {}

  std::vector<ElementFlow> run() {
    const bool isPowered = wasExecuted(network_, recorder_);
    for (const Element& element : drawing_.elements) {
      flows_.push_back(isPowered ? flow(element) : ElementFlow{Flow3::Off, Flow3::Off, {}});
    }
    return std::move(flows_);
  }

 private:
  static Flow3 of(bool isOn) { return isOn ? Flow3::On : Flow3::Off; }
  static Flow3 inverse(Flow3 flow) { return flow == Flow3::Unknown ? flow : of(flow == Flow3::Off); }
  Flow3 at(const Wire& wire) const {
    const Flow3 flow = flows_[wire.from].output;
    return wire.negated ? inverse(flow) : flow;
  }

  /// What the instruction left, or stored; nothing: it did not run.
  std::optional<std::uint64_t> valueAt(std::uint32_t instruction, bool isStored) const {
    if (instruction >= network_.instructions.size()) return std::nullopt;
    const InstructionRecord& record = recorder_.of(network_.instructions[instruction]);
    if (record.executions == 0) return std::nullopt;
    if (!isStored) return record.result;
    return record.written.empty() ? std::nullopt : record.written[0];
  }
  bool isMissing(const Element& element) const { return element.instruction >= network_.instructions.size(); }

  ElementFlow flow(const Element& element) const {
    switch (element.shape) {
      case Shape::Rail: return {Flow3::On, Flow3::On, {}};
      case Shape::And:
      case Shape::Or: return gate(element);
      case Shape::Contact: return contact(element);
      case Shape::Coil: return coil(element);
      default: return box(element);
    }
  }

  ElementFlow gate(const Element& element) const {
    const Flow3 deciding = element.shape == Shape::Or ? Flow3::On : Flow3::Off;
    Flow3 flow = inverse(deciding);
    for (const Wire& wire : element.inputs) {
      const Flow3 one = at(wire);
      if (one == deciding) return {deciding, deciding, {}};
      if (one == Flow3::Unknown) flow = one;
    }
    return {flow, flow, {}};
  }

  ElementFlow contact(const Element& element) const {
    const Flow3 before = element.inputs.empty() ? Flow3::On : at(element.inputs[0]);
    if (element.desc->role == Role::Not) return {inverse(before), inverse(before), {}};
    ElementFlow result;
    const std::optional<std::uint64_t> value = valueAt(element.instruction, false);
    result.state = isMissing(element) ? Flow3::Unknown : of(value && (*value != 0) != element.desc->negated);
    const bool isEdgeOfFlow = element.operands.empty();
    if (isEdgeOfFlow || before == Flow3::On)
      result.output = result.state;
    else
      result.output = before == Flow3::Off || result.state == Flow3::Off ? Flow3::Off : Flow3::Unknown;
    if (!isEdgeOfFlow) result.values = {textOf(element.instruction, false)};
    return result;
  }

  ElementFlow coil(const Element& element) const {
    const Flow3 before = element.inputs.empty() ? Flow3::Unknown : at(element.inputs[0]);
    const bool isLatch = element.desc->role == Role::Set || element.desc->role == Role::Reset;
    ElementFlow result{before, before, {}};
    if (!isMissing(element)) {
      const std::optional<std::uint64_t> value = valueAt(element.instruction, true);
      result.state = result.output = isLatch ? of(value.has_value()) : of(value.value_or(0) != 0);
      result.values = {textOf(element.instruction, true)};
    }
    return result;
  }

  /// Values of the pins: left ones, then right ones.
  ElementFlow box(const Element& element) const {
    ElementFlow result;
    const std::optional<std::uint64_t> value = valueAt(element.instruction, false);
    result.state = Flow3::On;
    result.output = isMissing(element) ? Flow3::Unknown : of(value.value_or(0) != 0);
    for (const BoxFace::Pin& pin : element.face->left) result.values.push_back(textOf(pin.instruction, false));
    for (const BoxFace::Pin& pin : element.face->right) result.values.push_back(textOf(pin.instruction, true));
    return result;
  }

  /// As a number of the variable's type.
  std::string textOf(std::uint32_t instruction, bool isStored) const {
    const std::optional<std::uint64_t> value = valueAt(instruction, isStored);
    if (!value) return {};
    const Instruction& place = network_.instructions[instruction];
    if (place.operands.empty() || place.operands[0].kind != OperandKind::Direct) return {};
    const Operand& variable = place.operands[0];
    const auto known = program_.valueTypes.find(variable.offset);
    const int width = bits(variable.width);
    const SignalType type = width == 1                           ? SignalType::Bool
                            : known == program_.valueTypes.end() ? SignalType::Unsigned
                            : known->second == ValueType::Real   ? realOf(width)
                            : known->second == ValueType::Signed ? SignalType::Signed
                                                                 : SignalType::Unsigned;
    return numberText(numberOf(*value, type, width), type);
  }

  const Program& program_;
  const Drawing& drawing_;
  const Network& network_;
  const InstructionRecorder& recorder_;
  std::vector<ElementFlow> flows_;
};

}  // namespace

std::vector<ElementFlow> variableFlows(const Program& program, const Drawing& drawing, const Network& network,
                                       const InstructionRecorder& recorder) {
  return VariableFlow(program, drawing, network, recorder).run();
}

}  // namespace rungproof
