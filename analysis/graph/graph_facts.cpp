// What is known of a node without looking at its variables: bits that are always 0 or 1 and unsigned bounds, found
// once when the node is made. Comparisons that the bounds decide become constants.
#include <algorithm>
#include <bit>

#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/graph.hpp"

namespace rungproof {

std::optional<std::uint64_t> Graph::fold(Op op, int width, Node a, Node b, Node c, std::uint64_t value) const {
  if (op == Op::Constant || op == Op::Variable) return std::nullopt;
  std::array<int, 2> widths{};
  std::array<std::uint64_t, 3> operand{};
  const std::array<Node, 3> children = {a, b, c};
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (children[i] == noNode) continue;
    if (!isConstant(children[i])) return std::nullopt;
    operand[i] = (*this)[children[i]].value;
    if (i < widths.size()) widths[i] = widthOf(children[i]);
  }
  return evaluateOperation(op, width, widths, operand, value) & maskOf(width);
}

Node Graph::comparedBy(const NodeData& n) const {
  if (n.op == Op::Not) return compared_[indexOf(n.child[0])];
  if (n.op != Op::Equal && n.op != Op::Ult && n.op != Op::Slt) return noNode;
  if (isConstant(n.child[1])) return n.child[0];
  return isConstant(n.child[0]) ? n.child[1] : noNode;
}

Graph::Facts Graph::factsOf(const NodeData& n) const {
  std::array<Facts, 3> operand{};
  std::array<int, 2> widths{};
  for (std::size_t i = 0; i < 3 && n.child[i] != noNode; ++i) {
    operand[i] = facts_[indexOf(n.child[i])];
    if (i < 2) widths[i] = widthOf(n.child[i]);
  }
  return combine(n.op, n.width, n.value, widths, operand);
}

Graph::Facts Graph::combine(Op op, int width, std::uint64_t value, std::array<int, 2> childWidth,
                            const std::array<Facts, 3>& operand) {
  const std::uint64_t mask = maskOf(width);
  Facts f = anyValue(width);
  const auto of = [&](std::size_t i) -> const Facts& { return operand[i]; };
  const auto bounds = [&](std::uint64_t low, std::uint64_t high) {
    f.low = low;
    f.high = high;
  };
  const auto truth = [&](bool isTrue, bool isFalse) {
    if (isTrue) f = {~1ULL, 1, 1, 1};
    if (isFalse) f = {~0ULL, 0, 0, 0};
  };
  switch (op) {
    case Op::Constant: return exactly(value);
    case Op::Not:
      f.zeros = of(0).ones | ~mask;
      f.ones = of(0).zeros & mask;
      bounds(mask - of(0).high, mask - of(0).low);
      break;
    case Op::And:
      f.zeros = of(0).zeros | of(1).zeros;
      f.ones = of(0).ones & of(1).ones;
      bounds(0, std::min(of(0).high, of(1).high));
      break;
    case Op::Or:
      f.zeros = of(0).zeros & of(1).zeros;
      f.ones = of(0).ones | of(1).ones;
      bounds(std::max(of(0).low, of(1).low), mask);
      break;
    case Op::Xor:
      f.zeros = (of(0).zeros & of(1).zeros) | (of(0).ones & of(1).ones);
      f.ones = (of(0).zeros & of(1).ones) | (of(0).ones & of(1).zeros);
      break;
    case Op::Add:
      if (of(0).high <= mask - of(1).high) bounds(of(0).low + of(1).low, of(0).high + of(1).high);
      break;
    case Op::Sub:
      if (of(0).low >= of(1).high) bounds(of(0).low - of(1).high, of(0).high - of(1).low);
      break;
    case Op::Mul:
      if (of(0).high == 0 || of(1).high <= mask / of(0).high) bounds(of(0).low * of(1).low, of(0).high * of(1).high);
      break;
    case Op::Udiv:
      if (of(1).low > 0) bounds(of(0).low / of(1).high, of(0).high / of(1).low);
      break;
    case Op::Urem:
      bounds(0, of(1).low > 0 ? std::min(of(0).high, of(1).high - 1) : std::max(of(0).high, of(1).high));
      break;
    case Op::Lshr: bounds(0, of(0).high); break;
    case Op::Equal:
      truth(false, ((of(0).ones & of(1).zeros) | (of(0).zeros & of(1).ones)) != 0 || of(0).high < of(1).low ||
                       of(1).high < of(0).low);
      break;
    case Op::Ult: truth(of(0).high < of(1).low, of(0).low >= of(1).high); break;
    case Op::Slt: {
      const int sign = childWidth[0] - 1;
      const auto negative = [&](std::size_t i) { return (of(i).ones >> sign & 1) != 0; };
      const auto positive = [&](std::size_t i) { return (of(i).zeros >> sign & 1) != 0; };
      if (negative(0) && positive(1)) truth(true, false);
      if (positive(0) && negative(1)) truth(false, true);
      break;
    }
    case Op::Ite:
      f.zeros = of(1).zeros & of(2).zeros;
      f.ones = of(1).ones & of(2).ones;
      bounds(std::min(of(1).low, of(2).low), std::max(of(1).high, of(2).high));
      break;
    case Op::Concat: {
      const int low = childWidth[1];
      f.zeros = of(0).zeros << low | (of(1).zeros & maskOf(low));
      f.ones = of(0).ones << low | of(1).ones;
      bounds(of(0).low << low | of(1).low, of(0).high << low | of(1).high);
      break;
    }
    case Op::Extract: {
      f.zeros = of(0).zeros >> value | ~mask;
      f.ones = of(0).ones >> value & mask;
      if (of(0).high >> value <= mask) bounds(of(0).low >> value, of(0).high >> value);
      break;
    }
    case Op::Zext:
      f.zeros = of(0).zeros;
      f.ones = of(0).ones;
      bounds(of(0).low, of(0).high);
      break;
    case Op::Sext: {
      const int from = childWidth[0];
      const std::uint64_t upper = mask & ~maskOf(from);
      f.zeros = (of(0).zeros & maskOf(from)) | ~mask;
      f.ones = of(0).ones;
      if ((of(0).zeros >> (from - 1) & 1) != 0) f.zeros |= upper;
      if ((of(0).ones >> (from - 1) & 1) != 0) f.ones |= upper;
      break;
    }
    default: break;
  }
  // Bounds and bits inform each other: above the highest possible bit all is 0.
  if (f.high != 0)
    f.zeros |= ~maskOf(std::bit_width(f.high));
  else
    f.zeros = ~0ULL;
  f.low = std::max(f.low, f.ones);
  f.high = std::min(f.high, ~f.zeros & mask);
  return f;
}

}  // namespace rungproof
