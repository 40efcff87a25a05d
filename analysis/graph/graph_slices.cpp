// Rules for cutting and joining words: slices go down through concatenations, extensions, bitwise operations and the
// low ends of sums; neighbouring slices join again, so that a word read back from its bits is the word itself.
#include <algorithm>

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// Whether cutting a node costs no new operation but slices.
bool Graph::isCheapSlice(Node a, int high, int low, int depth) const {
  switch ((*this)[a].op) {
    case Op::Constant:
    case Op::Variable:
    case Op::Extract:
    case Op::Zext:
    case Op::Sext:
    case Op::Concat: return true;
    case Op::Ite:
      return depth > 0 && isCheapSlice(child(a, 1), high, low, depth - 1) &&
             isCheapSlice(child(a, 2), high, low, depth - 1);
    default: return false;
  }
}

Node Graph::makeExtract(Node a, int high, int low) {
  const int width = high - low + 1;
  const NodeData n = (*this)[a];
  const auto slice = [&](Node of, int from, int to) {
    return make(Op::Extract, from - to + 1, of, noNode, noNode, static_cast<std::uint64_t>(to));
  };
  switch (n.op) {
    case Op::Extract: return slice(n.child[0], high + static_cast<int>(n.value), low + static_cast<int>(n.value));
    case Op::Concat: {
      const int cut = widthOf(n.child[1]);
      if (low >= cut) return slice(n.child[0], high - cut, low - cut);
      if (high < cut) return slice(n.child[1], high, low);
      return make(Op::Concat, width, slice(n.child[0], high - cut, 0), slice(n.child[1], cut - 1, low));
    }
    case Op::Zext: {
      const int from = widthOf(n.child[0]);
      if (low >= from) return constantNode(0, width);
      if (high < from) return slice(n.child[0], high, low);
      return make(Op::Zext, width, slice(n.child[0], from - 1, low));
    }
    case Op::Sext: {
      const int from = widthOf(n.child[0]);
      if (high < from) return slice(n.child[0], high, low);
      const int lowest = std::min(low, from - 1);
      return make(Op::Sext, width, slice(n.child[0], from - 1, lowest));
    }
    case Op::Not: return make(Op::Not, width, slice(n.child[0], high, low));
    case Op::And:
    case Op::Or:
    case Op::Xor:
      if (width == 1 || isConstant(n.child[1]))
        return make(n.op, width, slice(n.child[0], high, low), slice(n.child[1], high, low));
      break;
    case Op::Add:
    case Op::Sub:
    case Op::Mul: {
      // The low end of a sum is the sum of the low ends.
      const auto isCheap = [&](Node operand) {
        return isCheapSlice(operand, high, 0, 0) && !is(operand, Op::Variable);
      };
      if (low == 0 && isCheap(n.child[0]) && isCheap(n.child[1]))
        return make(n.op, width, slice(n.child[0], high, 0), slice(n.child[1], high, 0));
      if (high == 0 && n.op != Op::Mul) return make(Op::Xor, 1, slice(n.child[0], 0, 0), slice(n.child[1], 0, 0));
      break;
    }
    case Op::Ite: {
      const bool gains = !is(n.child[1], Op::Variable) || !is(n.child[2], Op::Variable);
      if (gains && isCheapSlice(n.child[1], high, low, 4) && isCheapSlice(n.child[2], high, low, 4)) {
        return make(Op::Ite, width, n.child[0], slice(n.child[1], high, low), slice(n.child[2], high, low));
      }
      break;
    }
    default: break;
  }
  return intern({Op::Extract, static_cast<std::uint8_t>(width), {a, noNode, noNode}, static_cast<std::uint64_t>(low)});
}

/// One node for a above b if they are neighbouring slices, constants, or choices of such; else noNode.
Node Graph::joined(Node a, Node b) {
  const int width = widthOf(a) + widthOf(b);
  if (isConstant(a) && isConstant(b)) return constantNode((*this)[a].value << widthOf(b) | (*this)[b].value, width);
  const auto start = [&](Node n) { return is(n, Op::Extract) ? static_cast<int>((*this)[n].value) : 0; };
  if (is(a, Op::Extract)) {
    const Node of = child(a, 0);
    const bool isLowEnd = is(b, Op::Extract) && child(b, 0) == of;
    if (isLowEnd && start(b) + widthOf(b) == start(a))
      return make(Op::Extract, width, of, noNode, noNode, static_cast<std::uint64_t>(start(b)));
  }
  if (is(a, Op::Ite) && is(b, Op::Ite) && child(a, 0) == child(b, 0)) {
    const Node condition = child(a, 0);
    const std::array<Node, 2> high = {child(a, 1), child(a, 2)}, low = {child(b, 1), child(b, 2)};
    const Node whenTrue = joined(high[0], low[0]);
    if (whenTrue == noNode) return noNode;
    const Node whenFalse = joined(high[1], low[1]);
    if (whenFalse != noNode) return make(Op::Ite, width, condition, whenTrue, whenFalse);
  }
  return noNode;
}

Node Graph::makeConcat(Node a, Node b) {
  const int width = widthOf(a) + widthOf(b);
  if (isZero(a)) return make(Op::Zext, width, b);
  if (is(b, Op::Concat)) {
    const Node high = child(b, 0), low = child(b, 1);
    return make(Op::Concat, width, make(Op::Concat, widthOf(a) + widthOf(high), a, high), low);
  }
  if (is(a, Op::Zext)) {
    const Node inner = child(a, 0);
    return make(Op::Zext, width, make(Op::Concat, widthOf(inner) + widthOf(b), inner, b));
  }
  if (const Node n = joined(a, b); n != noNode) return n;
  if (is(a, Op::Concat)) {
    const Node high = child(a, 0);
    if (const Node n = joined(child(a, 1), b); n != noNode) return make(Op::Concat, width, high, n);
  }
  return intern({Op::Concat, static_cast<std::uint8_t>(width), {a, b, noNode}, 0});
}

Node Graph::makeZext(int width, Node a) {
  if (is(a, Op::Zext)) return make(Op::Zext, width, child(a, 0));
  return intern({Op::Zext, static_cast<std::uint8_t>(width), {a, noNode, noNode}, 0});
}

Node Graph::makeSext(int width, Node a) {
  const std::uint64_t sign = 1ULL << (widthOf(a) - 1);
  if (is(a, Op::Sext)) return make(Op::Sext, width, child(a, 0));
  if (highest(a) < sign) return make(Op::Zext, width, a);
  return intern({Op::Sext, static_cast<std::uint8_t>(width), {a, noNode, noNode}, 0});
}

}  // namespace rungproof
