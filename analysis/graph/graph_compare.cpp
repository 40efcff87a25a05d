// Rules for equality and order of words: comparisons with constants go through sums, extensions, concatenations and
// if-then-else down to what they test.
#include <bit>

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// "The sum (or difference) x + y in twice the width equals its own low half sign-extended", as +I and +D ask: true
/// unless the operands' signs make an overflow. Only sign bits are compared, no second adder.
Node Graph::withoutOverflow(Node a, Node b) {
  if (!is(a, Op::Sext)) std::swap(a, b);
  if (!is(a, Op::Sext) || (!is(b, Op::Add) && !is(b, Op::Sub))) return noNode;
  const Node low = child(a, 0);
  const int w = widthOf(low);
  const auto narrow = [&](Node n) -> Node {
    if (is(n, Op::Sext) && widthOf(child(n, 0)) == w) return child(n, 0);
    if (!isConstant(n)) return noNode;
    const Node part = make(Op::Extract, w, n);
    return make(Op::Sext, widthOf(n), part) == n ? part : noNode;
  };
  const Node x = narrow(child(b, 0)), y = narrow(child(b, 1));
  if (x == noNode || y == noNode || make((*this)[b].op, w, x, y) != low) return noNode;
  const auto sign = [&](Node n) { return make(Op::Extract, 1, n, noNode, noNode, static_cast<std::uint64_t>(w - 1)); };
  const Node differ = make(Op::Xor, 1, sign(x), sign(y));
  const Node mayOverflow = is(b, Op::Add) ? makeNot(differ) : differ;
  return makeNot(make(Op::And, 1, mayOverflow, make(Op::Xor, 1, sign(x), sign(low))));
}

Node Graph::equalToConstant(Node a, std::uint64_t value) {
  const int width = widthOf(a);
  const auto equals = [&](Node n, std::uint64_t k) { return make(Op::Equal, 1, n, constantNode(k, widthOf(n))); };
  const NodeData n = (*this)[a];
  switch (n.op) {
    case Op::Not: return equals(n.child[0], ~value);
    case Op::Add:
      if (isConstant(n.child[1])) return equals(n.child[0], value - (*this)[n.child[1]].value);
      break;
    case Op::Sub:
      if (value == 0) return make(Op::Equal, 1, n.child[0], n.child[1]);
      if (isConstant(n.child[0])) return equals(n.child[1], (*this)[n.child[0]].value - value);
      break;
    case Op::Xor:
      if (value == 0) return make(Op::Equal, 1, n.child[0], n.child[1]);
      if (isConstant(n.child[1])) return equals(n.child[0], value ^ (*this)[n.child[1]].value);
      break;
    case Op::Zext: {
      const int from = widthOf(n.child[0]);
      if (value > maskOf(from)) return constantNode(0, 1);
      return equals(n.child[0], value);
    }
    case Op::Sext: {
      const int from = widthOf(n.child[0]);
      const std::uint64_t low = value & maskOf(from);
      const std::uint64_t extended = (low >> (from - 1) & 1) != 0 ? low | (maskOf(width) & ~maskOf(from)) : low;
      if (extended != value) return constantNode(0, 1);
      return equals(n.child[0], low);
    }
    case Op::Concat: {
      const int low = widthOf(n.child[1]);
      return make(Op::And, 1, equals(n.child[0], value >> low), equals(n.child[1], value & maskOf(low)));
    }
    case Op::Ite: {
      const bool constantThen = isConstant(n.child[1]), constantElse = isConstant(n.child[2]);
      if (!constantThen && !constantElse) break;
      return make(Op::Ite, 1, n.child[0], equals(n.child[1], value), equals(n.child[2], value));
    }
    default: break;
  }
  return intern({Op::Equal, 1, {a, constantNode(value, width), noNode}, 0});
}

Node Graph::makeEqual(Node a, Node b) {
  if (a == b) return constantNode(1, 1);
  if (isConstant(a)) std::swap(a, b);
  if (isConstant(b)) return equalToConstant(a, (*this)[b].value);
  if (const Node n = withoutOverflow(a, b); n != noNode) return n;
  const int width = widthOf(a);
  const auto zeroIf = [&](Node n) { return make(Op::Equal, 1, n, constantNode(0, width)); };
  if ((is(a, Op::Sext) && is(b, Op::Sext)) || (is(a, Op::Zext) && is(b, Op::Zext))) {
    if (widthOf(child(a, 0)) == widthOf(child(b, 0))) return make(Op::Equal, 1, child(a, 0), child(b, 0));
  }
  if (is(a, Op::Concat) && is(b, Op::Concat) && widthOf(child(a, 1)) == widthOf(child(b, 1))) {
    return make(Op::And, 1, make(Op::Equal, 1, child(a, 0), child(b, 0)), make(Op::Equal, 1, child(a, 1), child(b, 1)));
  }
  for (int i = 0; i < 2; ++i, std::swap(a, b)) {
    if (is(a, Op::Add) && child(a, 0) == b) return zeroIf(child(a, 1));
    if (is(a, Op::Add) && child(a, 1) == b) return zeroIf(child(a, 0));
    if (is(a, Op::Sub) && child(a, 0) == b) return zeroIf(child(a, 1));
    if (is(a, Op::Ite) && child(a, 1) == b) return make(Op::Or, 1, child(a, 0), make(Op::Equal, 1, child(a, 2), b));
    if (is(a, Op::Ite) && child(a, 2) == b)
      return make(Op::Or, 1, makeNot(child(a, 0)), make(Op::Equal, 1, child(a, 1), b));
  }
  if (is(a, Op::Add) && is(b, Op::Add)) {
    for (int i = 0; i < 2; ++i) {
      for (int k = 0; k < 2; ++k) {
        if (child(a, i) == child(b, k)) return make(Op::Equal, 1, child(a, 1 - i), child(b, 1 - k));
      }
    }
  }
  if (indexOf(b) < indexOf(a)) std::swap(a, b);
  return intern({Op::Equal, 1, {a, b, noNode}, 0});
}

Node Graph::makeLess(Op op, Node a, Node b) {
  if (a == b) return constantNode(0, 1);
  const int width = widthOf(a);
  const std::uint64_t mask = maskOf(width), sign = mask ^ mask >> 1;
  const bool isSigned = op == Op::Slt;
  if (isSigned && highest(a) < sign && highest(b) < sign) return make(Op::Ult, 1, a, b);
  if (isSigned && (isZero(b) || (isOnes(a) && !isConstant(b)))) {
    const Node bit = make(Op::Extract, 1, isZero(b) ? a : b, noNode, noNode, static_cast<std::uint64_t>(width - 1));
    return isZero(b) ? bit : makeNot(bit);
  }
  const std::uint64_t smallest = isSigned ? sign : 0, largest = isSigned ? sign - 1 : mask;
  if (isConstant(b)) {
    const std::uint64_t k = (*this)[b].value;
    if (k == smallest) return constantNode(0, 1);
    if (k == ((smallest + 1) & mask)) return make(Op::Equal, 1, a, constantNode(smallest, width));
    if (k == largest) return makeNot(make(Op::Equal, 1, a, b));
  }
  if (isConstant(a)) {
    const std::uint64_t k = (*this)[a].value;
    if (k == largest) return constantNode(0, 1);
    if (k == ((largest - 1) & mask)) return make(Op::Equal, 1, b, constantNode(largest, width));
    if (k == smallest) return makeNot(make(Op::Equal, 1, b, a));
  }
  // Both sides extended the same way: the order is that of what was extended.
  const Op extension = isSigned ? Op::Sext : Op::Zext;
  const auto narrowed = [&](Node n, int from) -> Node {
    if (is(n, extension) && widthOf(child(n, 0)) == from) return child(n, 0);
    if (!isConstant(n)) return noNode;
    const Node part = make(Op::Extract, from, n);
    return make(extension, width, part) == n ? part : noNode;
  };
  if (is(a, extension) || is(b, extension)) {
    const int from = widthOf(child(is(a, extension) ? a : b, 0));
    const Node x = narrowed(a, from), y = narrowed(b, from);
    if (x != noNode && y != noNode) return make(op, 1, x, y);
  }
  for (int i = 0; i < 2; ++i) {
    const Node arms = i == 0 ? a : b, other = i == 0 ? b : a;
    if (!isConstant(other) || !is(arms, Op::Ite) || (!isConstant(child(arms, 1)) && !isConstant(child(arms, 2))))
      continue;
    const auto less = [&](Node arm) { return i == 0 ? make(op, 1, arm, other) : make(op, 1, other, arm); };
    const Node condition = child(arms, 0), whenTrue = child(arms, 1), whenFalse = child(arms, 2);
    return make(Op::Ite, 1, condition, less(whenTrue), less(whenFalse));
  }
  return intern({op, 1, {a, b, noNode}, 0});
}

}  // namespace rungproof
