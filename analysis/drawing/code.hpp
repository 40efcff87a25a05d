// Writing instructions for the nodes of a circuit: the load, AND and OR form of a contact, stack operations, boxes and
// the flow inputs of CALL. Remembers which instruction each element became. Tested by tests/drawing/lower_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/drawing/circuit.hpp"

namespace rungproof {

/// Hands out bits of L60 to L63.
class EditorBitPool {
 public:
  explicit EditorBitPool(EditorBits taken) : taken_(taken) {}

  /// From L60.0 upwards.
  std::optional<unsigned> takeLowest();
  /// From L63.7 downwards, as for flow inputs of CALL (001:6809).
  std::optional<unsigned> takeHighest();
  void give(unsigned bit) { taken_ &= ~(1U << bit); }

 private:
  EditorBits taken_;
};

class CircuitCode {
 public:
  CircuitCode(const Circuit& circuit, std::size_t elementCount, EditorBits taken) : circuit_(circuit), pool_(taken) {
    lowered_.instructionOf.assign(elementCount, noInstruction);
  }

  EditorBitPool& pool() { return pool_; }
  const CircuitNode& node(std::uint32_t n) const { return circuit_.nodes[n]; }

  /// The contact of node n in the form that joins so; counts as its instruction.
  void contact(std::uint32_t n, Role form);
  /// Power: LD, A or O of SM0.0.
  void power(Role form, Span span);
  /// A stack operation, or = and LD on a bit of L60-L63, on behalf of node n.
  void operation(Role role, std::uint32_t n);
  void store(unsigned bit, std::uint32_t n);
  void recall(unsigned bit, Role form, std::uint32_t n);
  /// The instruction of an edge, coil or box without flow parameters, as it stands in the element.
  void instruction(std::uint32_t n);
  /// CALL with its flow parameters in these bits.
  void call(std::uint32_t n, const std::vector<unsigned>& bits);
  /// A box of the IEC set whose output is used: gives it a Q operand if it has none, then loads it (001:6693).
  /// Gives false if no bit is free.
  bool iecOutput(std::uint32_t n);
  /// The last instruction is the one of element of node n.
  void mark(std::uint32_t n);

  Lowered take() { return std::move(lowered_); }

 private:
  void add(const Desc* desc, Operands operands, Span span);

  const Circuit& circuit_;
  EditorBitPool pool_;
  Lowered lowered_;
};

/// Position of Q (QU) in the operands of IEC boxes: behind the number and the preset (001:6693, 001:4107).
inline constexpr std::size_t iecOutputOperand = 2;

/// Whether the power output of the node is a Q operand rather than ENO or the top of the stack.
inline bool isIecBox(const CircuitNode& node) {
  return node.shape == Shape::Box && node.desc->drawingOnly && node.desc->stack.pops == 0;
}

}  // namespace rungproof
