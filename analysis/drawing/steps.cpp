// One element after the other; contacts at the rail are read where they are needed if nothing changes them meanwhile.
#include "analysis/drawing/steps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/drawing/code.hpp"

namespace rungproof {

namespace {

/// Where the output of a node is when it is needed.
enum class ValuePlace : std::uint8_t {
  Inline,  ///< a contact that is read at each use
  Top,     ///< on the stack, taken by the next element
  Bit,     ///< in a bit of L60-L63
  Nowhere  ///< not used
};

class Steps {
 public:
  Steps(const Drawing& drawing, const Circuit& circuit, EditorBits taken)
      : drawing_(drawing), nodes_(circuit.nodes), reads_(circuit), code_(circuit, drawing.elements.size(), taken) {}

  Lowered run() {
    decide();
    reserve();
    for (std::uint32_t n = 0; n < nodes_.size() && !fault_; ++n) {
      if (place_[n] != ValuePlace::Inline) step(n);
    }
    Lowered lowered = code_.take();
    lowered.usesEditorBits = lowered.usesEditorBits || usesBits_;
    lowered.fault = fault_;
    if (fault_) lowered.instructions.clear();
    return lowered;
  }

 private:
  void decide() {
    const std::uint32_t count = static_cast<std::uint32_t>(nodes_.size());
    place_.assign(count, ValuePlace::Bit);
    bit_.assign(count, 0);
    left_.assign(count, 0);
    std::uint32_t next = railNode;  // the next element that is a step of its own
    for (std::uint32_t n = count; n-- > 0;) {
      const CircuitNode& node = nodes_[n];
      left_[n] = static_cast<std::uint32_t>(node.uses.size());
      if (isReadLater(n)) {
        place_[n] = ValuePlace::Inline;
        continue;
      }
      if (node.uses.empty()) place_[n] = ValuePlace::Nowhere;
      if (node.uses.size() == 1 && node.uses[0].node == next && takesFromTop(next, node.uses[0].pin))
        place_[n] = ValuePlace::Top;
      next = n;
    }
  }
  bool isReadLater(std::uint32_t n) {
    const CircuitNode& node = nodes_[n];
    if (!node.isContact() || node.inputs[0] != railNode || node.uses.empty()) return false;
    if (reads_.isFixed(n) && node.uses.size() > 1) return false;
    const std::uint32_t drawn = reads_.placeOf(n);
    return std::all_of(node.uses.begin(), node.uses.end(),
                       [&](const CircuitUse& use) { return reads_.mayMove(n, drawn, reads_.placeOf(use.node)); });
  }
  bool takesFromTop(std::uint32_t n, std::uint32_t pin) const { return pin == 0 || nodes_[n].isGate(); }

  /// Bits for the flow inputs of CALL come before all others, so that they are those of the manual.
  void reserve() {
    std::size_t flows = 0;
    for (const CircuitNode& node : nodes_) flows = std::max(flows, flowParameters(node));
    for (std::size_t i = 0; flows > 0 && i <= flows && !fault_; ++i) callBits_.push_back(take(0, i > 0));
  }
  unsigned take(std::uint32_t n, bool highest = false) {
    const std::optional<unsigned> bit = highest ? code_.pool().takeHighest() : code_.pool().takeLowest();
    if (!bit && !fault_) {
      const std::uint32_t element = nodes_[n].element == noElement ? 0 : nodes_[n].element;
      fault_ = LoweringFault{element, fmt::format("{}: more values have to wait than L60.0 to L63.7 can hold",
                                                  nameOf(drawing_.elements[element]))};
    }
    return bit.value_or(0);
  }

  /// Brings an input into play: loads it, or joins it to the top.
  void bring(std::uint32_t n, std::uint32_t from, Role form) {
    if (from == railNode) {
      if (form != Role::And) code_.power(form, nodes_[n].span);
      return;
    }
    if (place_[from] == ValuePlace::Inline) code_.contact(from, form);
    if (place_[from] == ValuePlace::Bit) code_.recall(bit_[from], form, n);
    if (--left_[from] == 0 && place_[from] == ValuePlace::Bit) code_.pool().give(bit_[from]);
  }
  bool isOnTop(std::uint32_t from) const { return from != railNode && place_[from] == ValuePlace::Top; }

  void step(std::uint32_t n) {
    const CircuitNode& node = nodes_[n];
    if (node.isGate()) {
      gate(n);
    } else if (node.isContact()) {
      const std::uint32_t from = node.inputs[0];
      if (from != railNode) bring(n, from, Role::Load);
      code_.contact(n, from == railNode ? Role::Load : Role::And);
    } else if (flowParameters(node) > 0) {
      call(n);
    } else {
      for (const std::uint32_t from : node.inputs) bring(n, from, Role::Load);
      code_.instruction(n);
    }
    output(n);
  }

  void gate(std::uint32_t n) {
    const CircuitNode& node = nodes_[n];
    const auto top =
        std::find_if(node.inputs.begin(), node.inputs.end(), [&](std::uint32_t from) { return isOnTop(from); });
    const std::size_t first = top == node.inputs.end() ? 0 : static_cast<std::size_t>(top - node.inputs.begin());
    bring(n, node.inputs[first], Role::Load);
    for (std::size_t pin = 0; pin < node.inputs.size(); ++pin) {
      if (pin != first) bring(n, node.inputs[pin], node.shape == Shape::And ? Role::And : Role::Or);
    }
    code_.mark(n);
  }

  void call(std::uint32_t n) {
    const CircuitNode& node = nodes_[n];
    for (std::size_t pin = 0; pin < node.inputs.size(); ++pin) {
      bring(n, node.inputs[pin], Role::Load);
      code_.store(callBits_[pin], n);
    }
    code_.recall(callBits_[0], Role::Load, n);
    code_.call(n, {callBits_.begin() + 1, callBits_.end()});
  }

  void output(std::uint32_t n) {
    const CircuitNode& node = nodes_[n];
    if (node.uses.empty()) return;
    if (node.shape == Shape::Box) {
      if (isIecBox(node) && !code_.iecOutput(n)) take(n);
      if (!isIecBox(node) && node.desc->eno) code_.operation(Role::Aeno, n);
    }
    if (place_[n] != ValuePlace::Bit) return;
    bit_[n] = take(n);
    usesBits_ = true;
    if (!fault_) code_.store(bit_[n], n);
  }

  const Drawing& drawing_;
  const std::vector<CircuitNode>& nodes_;
  ReadOrder reads_;
  CircuitCode code_;
  std::vector<ValuePlace> place_;
  std::vector<unsigned> bit_;
  std::vector<std::uint32_t> left_;  ///< uses still to come
  std::vector<unsigned> callBits_;   ///< EN, then the flow inputs
  bool usesBits_ = false;
  std::optional<LoweringFault> fault_;
};

}  // namespace

Lowered lowerStepByStep(const Drawing& drawing, const Circuit& circuit, EditorBits taken) {
  return Steps(drawing, circuit, taken).run();
}

}  // namespace rungproof
