// The faults, element by element.
#include "analysis/drawing/check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/drawing/raise.hpp"
#include "ir/desc.hpp"

namespace rungproof {

bool isHeading(const Desc& desc) { return desc.execution == Execution::Control && desc.stack.needs == 0; }

std::size_t inputsNeeded(const Element& element) {
  switch (element.shape) {
    case Shape::Rail: return 0;
    case Shape::Contact: return 1;
    case Shape::And:
    case Shape::Or: return 2;
    case Shape::Coil: return isHeading(*element.desc) ? 0 : 1;
    case Shape::Box: break;
  }
  const std::size_t own = std::max<std::size_t>(element.desc->stack.needs, 1);
  if (element.desc->control != Control::Call) return own;
  const auto isOpen = [](const Operand& operand) { return operand.kind == OperandKind::Missing; };
  return own + static_cast<std::size_t>(std::count_if(element.operands.begin(), element.operands.end(), isOpen));
}

namespace {

bool isGate(const Element& element) { return element.shape == Shape::And || element.shape == Shape::Or; }

class Check {
  static constexpr std::uint32_t leftRail = 0xFFFFFFFF;

 public:
  Check(const Drawing& drawing, Form form) : elements_(drawing.elements), form_(form), uses_(elements_.size(), 0) {}

  std::vector<DrawingFault> run() {
    for (const Element& element : elements_) {
      for (const Wire& wire : element.inputs) ++uses_[wire.from];
    }
    source_.resize(elements_.size());
    for (std::uint32_t i = 0; i < elements_.size(); ++i) check(i);
    return std::move(faults_);
  }

 private:
  void fault(std::string_view rule, std::uint32_t i, std::string message, std::string_view help) {
    faults_.push_back({rule, i, std::move(message), help});
  }
  std::string nameOf(std::uint32_t i) const {
    const Element& element = elements_[i];
    if (isGate(element)) return element.shape == Shape::And ? "the AND box" : "the OR box";
    std::string name(element.desc == nullptr ? "the left rail" : element.desc->stl);
    if (!element.operands.empty() && element.operands[0].kind != OperandKind::Missing)
      name += " " + toString(element.operands[0]);
    return name;
  }

  void check(std::uint32_t i) {
    const Element& element = elements_[i];
    source_[i] = i;
    if (element.shape == Shape::Rail) {
      source_[i] = leftRail;
      return;
    }
    const std::size_t needed = inputsNeeded(element), found = element.inputs.size();
    if (element.shape == Shape::Coil && needed == 0 && found > 0) {
      fault("GRF001", i, fmt::format("{} must stand at the left rail", nameOf(i)),
            "connect it to the left rail directly, in a network of its own");
    } else if (found < needed) {
      fault("GRF001", i, fmt::format("{} has {} of {} connected power inputs", nameOf(i), found, needed),
            "connect the open input");
    } else if (found > needed && !isGate(element)) {
      fault("GRF001", i, fmt::format("{} has {} power inputs instead of {}", nameOf(i), found, needed),
            "remove the connections that are too many");
    }
    const bool mayEnd = element.shape == Shape::Box || element.shape == Shape::Coil;
    if (!mayEnd && uses_[i] == 0)
      fault("GRF001", i, fmt::format("the output of {} leads nowhere", nameOf(i)),
            "end the branch with a coil or a box");
    if (isGate(element) && found > maxGateInputs) {
      fault("GRF003", i, fmt::format("{} has {} inputs, {} are allowed", nameOf(i), found, maxGateInputs),
            "divide it into several boxes");
    }
    if (form_ == Form::Ladder) shortCircuit(i);
  }

  /// All rails are one circuit node.
  std::uint32_t node(const Wire& wire) const {
    return elements_[wire.from].shape == Shape::Rail ? leftRail : wire.from;
  }
  std::uint32_t begin(const Wire& wire) const { return uses_[wire.from] > 1 ? node(wire) : source_[wire.from]; }

  /// Follows where the chain of contacts that ends in element i begins, and finds bridged chains.
  void shortCircuit(std::uint32_t i) {
    const Element& element = elements_[i];
    if (element.shape == Shape::Contact && element.inputs.size() == 1) {
      source_[i] = begin(element.inputs[0]);
    }
    if (element.shape != Shape::Or) return;
    const bool sameBegin = std::all_of(element.inputs.begin(), element.inputs.end(),
                                       [&](const Wire& wire) { return begin(wire) == begin(element.inputs[0]); });
    if (sameBegin && !element.inputs.empty()) source_[i] = begin(element.inputs[0]);
    for (const Wire& bridge : element.inputs) {
      const bool bridges = std::any_of(element.inputs.begin(), element.inputs.end(), [&](const Wire& other) {
        return other.from != bridge.from && source_[other.from] == node(bridge);
      });
      if (!bridges || bridge.negated) continue;
      fault("GRF001", i, "a branch without contacts short-circuits the one beside it",
            "put a contact into the branch or remove it");
      return;
    }
  }

  const std::vector<Element>& elements_;
  Form form_;
  std::vector<std::uint32_t> uses_;
  std::vector<std::uint32_t> source_;  ///< by element: the shared element at which its chain of contacts begins
  std::vector<DrawingFault> faults_;
};

}  // namespace

std::vector<DrawingFault> drawingFaults(const Drawing& drawing, Form form) { return Check(drawing, form).run(); }

}  // namespace rungproof
