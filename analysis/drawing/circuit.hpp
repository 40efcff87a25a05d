// A drawing prepared for lowering: rails dissolved, negation circles made nodes, and for every node who uses its
// output. Also the question that decides about order: may a contact be read at another moment than the drawing says?
// Used by the two ways of lowering, drawing_branches.hpp and drawing_steps.hpp. Tested by tests/drawing/lower_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/drawing/lower.hpp"
#include "ir/desc.hpp"
#include "ir/drawing.hpp"

namespace rungproof {

/// Where an input is the rail; also: no node.
inline constexpr std::uint32_t railNode = 0xFFFFFFFF;
/// CircuitNode::element of a negation circle.
inline constexpr std::uint32_t noElement = 0xFFFFFFFF;

struct CircuitUse {
  std::uint32_t node = 0;
  std::uint32_t pin = 0;
};

struct CircuitNode {
  Shape shape = Shape::Contact;
  const Desc* desc = nullptr;          ///< of a negation circle: NOT
  const Operands* operands = nullptr;  ///< of the element; null for a negation circle
  Span span;
  std::uint32_t element = noElement;
  std::vector<std::uint32_t> inputs;  ///< nodes, or railNode
  std::vector<CircuitUse> uses;

  bool isEffect() const { return shape == Shape::Box || shape == Shape::Coil; }
  /// EU, ED, NOT: changes what flows instead of adding a condition.
  bool isTransform() const { return shape == Shape::Contact && desc->stack.pushes == 0; }
  bool isContact() const { return shape == Shape::Contact && desc->stack.pushes != 0; }
  bool isGate() const { return shape == Shape::And || shape == Shape::Or; }
};

/// Nodes in order of execution. With a fault the rest means nothing.
struct Circuit {
  std::vector<CircuitNode> nodes;
  std::optional<LoweringFault> fault;
};

Circuit circuitOf(const Drawing& drawing);

/// Number of flow parameters of a CALL (operands of kind Missing); 0 for everything else.
std::size_t flowParameters(const CircuitNode& node);
/// Name for messages: "I0.0", "CTU C1", "the OR".
std::string nameOf(const Element& element);

/// Answers whether contacts may move against coils and boxes, which keep their order, as do contacts whose moment of
/// reading matters whatever stands beside them: physical and analogue inputs, 1 ms timers, comparisons that can stop.
class ReadOrder {
 public:
  explicit ReadOrder(const Circuit& circuit);

  /// Nodes that keep their order; a node's place is the number of those with a lower index.
  const std::vector<std::uint32_t>& fixed() const { return fixed_; }
  bool isFixed(std::uint32_t node) const { return isFixed_[node] != 0; }
  std::uint32_t placeOf(std::uint32_t node) const;
  /// A contact or edge drawn at place `drawn` gives the same at place `actual`. Gives up (false) when asked too much.
  bool mayMove(std::uint32_t node, std::uint32_t drawn, std::uint32_t actual);
  /// Whether an answer came from comparing the addresses of two nodes.
  bool comparedAddresses() const { return comparedAddresses_; }

 private:
  const Circuit& circuit_;
  std::vector<std::uint32_t> fixed_;
  std::vector<std::uint8_t> isFixed_;  ///< by node
  std::uint64_t work_ = 0;
  bool comparedAddresses_ = false;
};

}  // namespace rungproof
