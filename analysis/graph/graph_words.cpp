// Rules for arithmetic and bitwise operations on words: neutral elements, chains of constants, powers of two.
// Constants stand on the right of commutative operations.
#include <bit>

#include "analysis/graph/graph.hpp"

namespace rungproof {

Node Graph::makeBitwise(Op op, int width, Node a, Node b) {
  if (a == b) return op == Op::Xor ? constantNode(0, width) : a;
  const bool opposite = (is(a, Op::Not) && child(a, 0) == b) || (is(b, Op::Not) && child(b, 0) == a);
  if (opposite) return constantNode(op == Op::And ? 0 : maskOf(width), width);
  if (isConstant(b)) {
    const std::uint64_t k = (*this)[b].value;
    if (k == 0) return op == Op::And ? b : a;
    if (k == maskOf(width)) return op == Op::And ? a : op == Op::Or ? b : makeNot(a);
    if (is(a, op) && isConstant(child(a, 1))) return make(op, width, child(a, 0), make(op, width, child(a, 1), b));
    // Runs of equal mask bits become slices, so that masked fields are seen as fields.
    if (op != Op::Xor && std::popcount(k ^ k >> 1) <= 4) {
      Node result = noNode;
      for (int high = width - 1; high >= 0;) {
        const std::uint64_t bit = k >> high & 1;
        int low = high;
        while (low > 0 && (k >> (low - 1) & 1) == bit) --low;
        const int size = high - low + 1;
        const bool passes = (op == Op::And) == (bit != 0);
        const Node part = passes ? make(Op::Extract, size, a, noNode, noNode, static_cast<std::uint64_t>(low))
                                 : constantNode(op == Op::And ? 0 : maskOf(size), size);
        result = result == noNode ? part : make(Op::Concat, width - low, result, part);
        high = low - 1;
      }
      return result;
    }
  }
  return intern({op, static_cast<std::uint8_t>(width), {a, b, noNode}, 0});
}

Node Graph::makeAdd(int width, Node a, Node b) {
  if (isZero(b)) return a;
  if (isConstant(b)) {
    if (is(a, Op::Add) && isConstant(child(a, 1)))
      return make(Op::Add, width, child(a, 0), make(Op::Add, width, child(a, 1), b));
    if (is(a, Op::Sub) && isConstant(child(a, 0)))
      return make(Op::Sub, width, make(Op::Add, width, child(a, 0), b), child(a, 1));
    if (is(a, Op::Ite) && isConstant(child(a, 1)) && isConstant(child(a, 2))) {
      return make(Op::Ite, width, child(a, 0), make(Op::Add, width, child(a, 1), b),
                  make(Op::Add, width, child(a, 2), b));
    }
    return intern({Op::Add, static_cast<std::uint8_t>(width), {a, b, noNode}, 0});
  }
  if (is(a, Op::Sub) && child(a, 1) == b) return child(a, 0);
  if (is(b, Op::Sub) && child(b, 1) == a) return child(b, 0);
  if (is(a, Op::Sub) && is(b, Op::Sub) && child(b, 1) == child(a, 0))
    return make(Op::Sub, width, child(b, 0), child(a, 1));
  if (is(a, Op::Add) && isConstant(child(a, 1)))
    return make(Op::Add, width, make(Op::Add, width, child(a, 0), b), child(a, 1));
  if (is(b, Op::Add) && isConstant(child(b, 1)))
    return make(Op::Add, width, make(Op::Add, width, a, child(b, 0)), child(b, 1));
  return intern({Op::Add, static_cast<std::uint8_t>(width), {a, b, noNode}, 0});
}

Node Graph::makeSub(int width, Node a, Node b) {
  if (a == b) return constantNode(0, width);
  if (isConstant(b)) return make(Op::Add, width, a, constantNode(~(*this)[b].value + 1, width));
  if (is(a, Op::Add)) {
    if (child(a, 0) == b) return child(a, 1);
    if (child(a, 1) == b) return child(a, 0);
    if (isConstant(child(a, 1))) return make(Op::Add, width, make(Op::Sub, width, child(a, 0), b), child(a, 1));
  }
  if (is(b, Op::Add)) {
    if (child(b, 0) == a) return make(Op::Sub, width, constantNode(0, width), child(b, 1));
    if (child(b, 1) == a) return make(Op::Sub, width, constantNode(0, width), child(b, 0));
    if (isConstant(child(b, 1))) {
      const Node negated = constantNode(~(*this)[child(b, 1)].value + 1, width);
      return make(Op::Add, width, make(Op::Sub, width, a, child(b, 0)), negated);
    }
  }
  return intern({Op::Sub, static_cast<std::uint8_t>(width), {a, b, noNode}, 0});
}

Node Graph::makeMul(int width, Node a, Node b) {
  if (isConstant(b)) {
    const std::uint64_t k = (*this)[b].value;
    if (k == 0) return b;
    if (k == 1) return a;
    if (std::has_single_bit(k))
      return make(Op::Shl, width, a, constantNode(static_cast<std::uint64_t>(std::countr_zero(k)), width));
    if (is(a, Op::Mul) && isConstant(child(a, 1)))
      return make(Op::Mul, width, child(a, 0), make(Op::Mul, width, child(a, 1), b));
  }
  return intern({Op::Mul, static_cast<std::uint8_t>(width), {a, b, noNode}, 0});
}

/// Unsigned division by a power of two is a slice. Signed division is left, except by 1 and of values that cannot be
/// negative.
Node Graph::makeDivision(Op op, int width, Node a, Node b) {
  const bool isSigned = op == Op::Sdiv || op == Op::Srem;
  const bool isQuotient = op == Op::Udiv || op == Op::Sdiv;
  if (isConstant(b) && !isZero(b)) {
    const std::uint64_t k = (*this)[b].value;
    if (k == 1) return isQuotient ? a : constantNode(0, width);
    const std::uint64_t sign = 1ULL << (width - 1);
    if (isSigned && highest(a) < sign && k < sign) return make(isQuotient ? Op::Udiv : Op::Urem, width, a, b);
    if (!isSigned && highest(a) < k) return isQuotient ? constantNode(0, width) : a;
    if (!isSigned && std::has_single_bit(k)) {
      const int shift = std::countr_zero(k);
      const Node part = isQuotient
                            ? make(Op::Extract, width - shift, a, noNode, noNode, static_cast<std::uint64_t>(shift))
                            : make(Op::Extract, shift, a);
      return make(Op::Zext, width, part);
    }
  }
  return intern({op, static_cast<std::uint8_t>(width), {a, b, noNode}, 0});
}

Node Graph::makeShift(Op op, int width, Node a, Node b) {
  if (isZero(a)) return a;
  if (isConstant(b)) {
    const std::uint64_t count = (*this)[b].value;
    if (count == 0) return a;
    if (count >= static_cast<std::uint64_t>(width)) return constantNode(0, width);
    const int shift = static_cast<int>(count), kept = width - shift;
    if (op == Op::Shl) return make(Op::Concat, width, make(Op::Extract, kept, a), constantNode(0, shift));
    return make(Op::Zext, width, make(Op::Extract, kept, a, noNode, noNode, count));
  }
  return intern({op, static_cast<std::uint8_t>(width), {a, b, noNode}, 0});
}

/// Real operations: only what IEEE 754 allows to say without values.
Node Graph::makeReal(Op op, int width, Node a, Node b, std::uint64_t value) {
  if (op == Op::RealLegal && is(a, Op::RealFromInt)) return constantNode(1, 1);
  if (op == Op::RealLess && a == b) return constantNode(0, 1);
  if ((op == Op::RealAdd || op == Op::RealMul || op == Op::RealEqual) && indexOf(b) < indexOf(a))
    std::swap(a, b);  // NaN has one pattern
  return intern({op, static_cast<std::uint8_t>(width), {a, b, noNode}, value});
}

}  // namespace rungproof
