// Dissolving rails and negations; which effects disturb which contacts.
#include "analysis/drawing/circuit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/drawing/check.hpp"
#include "analysis/drawing/code.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {

std::string nameOf(const Element& element) {
  if (element.shape == Shape::Rail) return "the left rail";
  if (element.shape == Shape::And) return "the AND";
  if (element.shape == Shape::Or) return "the OR";
  const bool hasOperand = !element.operands.empty() && element.operands[0].kind != OperandKind::Missing;
  if (!hasOperand) return std::string(element.desc->stl);
  const std::string operand = toString(element.operands[0]);
  const bool isPlainContact = element.shape == Shape::Contact && element.operands.size() == 1;
  return isPlainContact ? operand : fmt::format("{} {}", element.desc->stl, operand);
}

std::size_t flowParameters(const CircuitNode& node) {
  if (node.shape != Shape::Box || node.desc->control != Control::Call) return 0;
  return static_cast<std::size_t>(
      std::count_if(node.operands->begin(), node.operands->end(),
                    [](const Operand& operand) { return operand.kind == OperandKind::Missing; }));
}

namespace {

class Dissolve {
 public:
  explicit Dissolve(const Drawing& drawing) : elements_(drawing.elements) {}

  Circuit run() {
    nodeOf_.reserve(elements_.size());
    for (std::uint32_t i = 0; i < elements_.size() && !circuit_.fault; ++i) add(i);
    for (std::uint32_t n = 0; n < circuit_.nodes.size(); ++n) {
      const std::vector<std::uint32_t>& inputs = circuit_.nodes[n].inputs;
      for (std::uint32_t pin = 0; pin < inputs.size(); ++pin) {
        if (inputs[pin] != railNode) circuit_.nodes[inputs[pin]].uses.push_back({n, pin});
      }
    }
    return std::move(circuit_);
  }

 private:
  void fault(std::uint32_t i, std::string message) { circuit_.fault = {i, std::move(message)}; }

  void add(std::uint32_t i) {
    const Element& element = elements_[i];
    if (element.shape == Shape::Rail) return nodeOf_.push_back(railNode);
    const bool isGate = element.shape == Shape::And || element.shape == Shape::Or;
    if (!isGate && element.desc == nullptr) return fault(i, "an element without an instruction");
    if (element.shape == Shape::Contact && !isContactDesc(*element.desc)) {
      return fault(i, fmt::format("{} is no contact", nameOf(element)));
    }
    const std::size_t needed = inputsNeeded(element), found = element.inputs.size();
    if (isGate ? found == 0 : found != needed) {
      return fault(i, fmt::format("{} has {} of {} power inputs", nameOf(element), found, needed));
    }
    CircuitNode node;
    for (const Wire& wire : element.inputs) {
      if (wire.from >= i) return fault(i, fmt::format("{} is fed by an element behind it", nameOf(element)));
      const std::uint32_t from = nodeOf_[wire.from];
      if (from != railNode && circuit_.nodes[from].shape == Shape::Coil) {
        return fault(i,
                     fmt::format("{} has no output that could feed {}", nameOf(elements_[wire.from]), nameOf(element)));
      }
      if (from != railNode && hasNoOutput(circuit_.nodes[from])) {
        return fault(i, fmt::format("{} has no power output for {}", nameOf(elements_[wire.from]), nameOf(element)));
      }
      node.inputs.push_back(wire.negated ? negation(from, element.span) : from);
    }
    if (isGate && found == 1) return nodeOf_.push_back(node.inputs[0]);
    node.shape = element.shape;
    node.desc = element.desc;
    node.operands = &element.operands;
    node.span = element.span;
    node.element = i;
    nodeOf_.push_back(append(std::move(node)));
  }

  /// A load form, or EU, ED, NOT.
  static bool isContactDesc(const Desc& desc) {
    return desc.role == Role::Not || isEdge(desc.role) || desc.role == Role::Load;
  }
  static bool hasNoOutput(const CircuitNode& node) {
    if (node.shape != Shape::Box) return false;
    return !node.desc->eno && !node.desc->drawingOnly;
  }

  std::uint32_t negation(std::uint32_t from, Span span) {
    CircuitNode node;
    node.desc = &s7200Instructions().only(Role::Not);
    node.inputs = {from};
    node.span = span;
    return append(std::move(node));
  }
  std::uint32_t append(CircuitNode node) {
    circuit_.nodes.push_back(std::move(node));
    return static_cast<std::uint32_t>(circuit_.nodes.size() - 1);
  }

  const std::vector<Element>& elements_;
  std::vector<std::uint32_t> nodeOf_;  ///< by element
  Circuit circuit_;
};

/// Bits [from, to) of an area; timers, counters and accumulators by number.
struct CircuitStretch {
  Area area;
  std::uint64_t from;
  std::uint64_t to;
};

bool overlap(const CircuitStretch& a, const CircuitStretch& b) {
  return a.area == b.area && a.from < b.to && b.from < a.to;
}

/// Where an operand of that type lies; nothing for constants. Only for direct operands.
std::optional<CircuitStretch> stretchOf(const Operand& operand, Type type, std::uint64_t elements) {
  if (operand.kind != OperandKind::Direct) return std::nullopt;
  const bool byNumber = addressedByNumber(operand.area);
  if (byNumber)
    return CircuitStretch{operand.area, operand.offset, operand.offset + (type == Type::Bool ? elements : 1)};
  if (type == Type::Bool) {
    const std::uint64_t first = operand.offset * 8ULL + operand.bit;
    return CircuitStretch{operand.area, first, first + elements};
  }
  const std::uint64_t first = operand.offset * 8ULL;
  return CircuitStretch{operand.area, first, first + elements * static_cast<std::uint64_t>(bits(widthOf(type)))};
}

/// A contact whose moment of reading matters whatever stands beside it.
bool isMomentary(const CircuitNode& node) {
  if (node.desc->immediate) return true;
  for (std::size_t i = 0; i < node.operands->size(); ++i) {
    const Operand& operand = (*node.operands)[i];
    const Type type = node.desc->operand(static_cast<int>(std::min<std::size_t>(i, maxOperands - 1))).type;
    if (type == Type::Real || type == Type::String) return true;
    if (operand.kind == OperandKind::Constant) continue;
    if (operand.kind != OperandKind::Direct) return true;
    if (operand.area == Area::AI || operand.area == Area::HC) return true;
    if (operand.area == Area::T && (operand.offset == 32 || operand.offset == 96)) return true;
  }
  return false;
}

/// An effect after which nothing can be said about memory.
bool isSweeping(const CircuitNode& node) {
  const Desc& desc = *node.desc;
  if (desc.control == Control::Call || desc.control == Control::For || desc.control == Control::Next) return true;
  if (desc.execution == Execution::Control && desc.stack.needs == 0) return true;
  for (std::size_t i = 0; i < node.operands->size(); ++i) {
    const OperandDesc& row = desc.operand(static_cast<int>(std::min<std::size_t>(i, maxOperands - 1)));
    if (row.direction == Direction::In) continue;
    const Operand& operand = (*node.operands)[i];
    if (operand.kind == OperandKind::Missing) continue;
    if (operand.kind != OperandKind::Direct || row.buffer.low != 1 || row.buffer.high != 1) return true;
  }
  return false;
}

/// Number of bits that S, R, SI, RI and SHRB may touch.
std::uint64_t bitsTouched(const CircuitNode& node) {
  for (const Operand& operand : *node.operands) {
    if (operand.kind != OperandKind::Constant) continue;
    return static_cast<std::uint64_t>(std::max<std::int64_t>(operand.value < 0 ? -operand.value : operand.value, 1));
  }
  return node.operands->size() < 2 ? 1 : 255;
}

bool writes(const CircuitNode& effect, const CircuitStretch& place) {
  for (std::size_t i = 0; i < effect.operands->size(); ++i) {
    const OperandDesc& row = effect.desc->operand(static_cast<int>(std::min<std::size_t>(i, maxOperands - 1)));
    if (row.direction == Direction::In) continue;
    const std::uint64_t elements = row.type == Type::Bool ? bitsTouched(effect) : 1;
    const std::optional<CircuitStretch> written = stretchOf((*effect.operands)[i], row.type, elements);
    if (written && overlap(*written, place)) return true;
  }
  return false;
}

bool disturbs(const CircuitNode& effect, const CircuitNode& contact) {
  // An edge is executed or not; what it remembers is its own.
  if (contact.isTransform()) return effect.desc->execution == Execution::Control && contact.desc->role != Role::Not;
  if (isSweeping(effect)) return true;
  for (std::size_t i = 0; i < contact.operands->size(); ++i) {
    const Type type = contact.desc->operand(static_cast<int>(i)).type;
    const std::optional<CircuitStretch> place = stretchOf((*contact.operands)[i], type, 1);
    if (!place) continue;
    const bool isStatus = place->area == Area::SM && place->from >= 8;  // SM0 stays over the scan (001:14046)
    if (isStatus && effect.shape == Shape::Box) return true;
    if (place->area == Area::S && effect.desc->control == Control::Scrt) return true;
    if (writes(effect, *place)) return true;
  }
  return false;
}

}  // namespace

Circuit circuitOf(const Drawing& drawing) { return Dissolve(drawing).run(); }

ReadOrder::ReadOrder(const Circuit& circuit) : circuit_(circuit), isFixed_(circuit.nodes.size(), 0) {
  for (std::uint32_t n = 0; n < circuit.nodes.size(); ++n) {
    const CircuitNode& node = circuit.nodes[n];
    if (!node.isEffect() && !(node.isContact() && isMomentary(node))) continue;
    isFixed_[n] = 1;
    fixed_.push_back(n);
  }
}

std::uint32_t ReadOrder::placeOf(std::uint32_t node) const {
  return static_cast<std::uint32_t>(std::lower_bound(fixed_.begin(), fixed_.end(), node) - fixed_.begin());
}

bool ReadOrder::mayMove(std::uint32_t node, std::uint32_t drawn, std::uint32_t actual) {
  constexpr std::uint64_t mostWork = 2'000'000;
  const CircuitNode& moved = circuit_.nodes[node];
  if (moved.operands == nullptr) return true;
  for (std::uint32_t at = std::min(drawn, actual); at < std::max(drawn, actual); ++at) {
    const std::uint32_t other = fixed_[at];
    if (other == node) continue;
    if (isFixed(node) || ++work_ > mostWork) return false;
    if (!circuit_.nodes[other].isEffect()) continue;
    comparedAddresses_ = true;
    if (disturbs(circuit_.nodes[other], moved)) return false;
  }
  return true;
}

}  // namespace rungproof
