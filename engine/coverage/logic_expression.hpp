// Conditions as trees over the bits that contacts see: what a coil or a box hangs on. One form for the logic stack of
// an S7-200, the RLO chains of an S7-300/400 and the expressions of IEC 61131-3. Covered by
// tests/tables/coverage_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

namespace rungproof {

/// Index of a node in a LogicTrees.
using LogicNode = std::uint32_t;

enum class LogicOp : std::uint8_t { Constant, Leaf, Not, And, Or, Xor };

struct LogicPart {
  LogicOp op = LogicOp::Constant;
  bool value = false;      ///< Constant
  std::uint32_t leaf = 0;  ///< Leaf: its number
  LogicNode a = 0, b = 0;
};

class LogicTrees {
 public:
  LogicNode constant(bool value) { return add({.op = LogicOp::Constant, .value = value}); }
  LogicNode leaf(std::uint32_t number) { return add({.op = LogicOp::Leaf, .leaf = number}); }
  LogicNode lnot(LogicNode a) { return add({.op = LogicOp::Not, .a = a}); }
  LogicNode join(LogicOp op, LogicNode a, LogicNode b) { return add({.op = op, .a = a, .b = b}); }
  const LogicPart& operator[](LogicNode node) const { return parts_[node]; }

  /// Numbers of the leaves under a node, each once, in ascending order.
  std::vector<std::uint32_t> leavesOf(LogicNode root) const;

  /// The value of a node over any kind of truth values; `valueOf(leaf)` gives those of the leaves.
  template <class Algebra, class ValueOf>
  auto evaluate(LogicNode root, Algebra& algebra, const ValueOf& valueOf) const -> decltype(valueOf(0U)) {
    const LogicPart& part = parts_[root];
    switch (part.op) {
      case LogicOp::Constant: return algebra.constant(part.value);
      case LogicOp::Leaf: return valueOf(part.leaf);
      case LogicOp::Not: return algebra.lnot(evaluate(part.a, algebra, valueOf));
      case LogicOp::And: return algebra.land(evaluate(part.a, algebra, valueOf), evaluate(part.b, algebra, valueOf));
      case LogicOp::Or: return algebra.lor(evaluate(part.a, algebra, valueOf), evaluate(part.b, algebra, valueOf));
      default: return algebra.lxor(evaluate(part.a, algebra, valueOf), evaluate(part.b, algebra, valueOf));
    }
  }

 private:
  LogicNode add(const LogicPart& part) {
    parts_.push_back(part);
    return static_cast<LogicNode>(parts_.size() - 1);
  }
  std::vector<LogicPart> parts_;
};

/// The algebra of plain truth values.
struct PlainLogic {
  static bool constant(bool value) { return value; }
  static bool lnot(bool a) { return !a; }
  static bool land(bool a, bool b) { return a && b; }
  static bool lor(bool a, bool b) { return a || b; }
  static bool lxor(bool a, bool b) { return a != b; }
};

}  // namespace rungproof
