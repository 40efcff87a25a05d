// Evaluation of nodes on numbers, scalar and 64 lanes wide.
#include "analysis/graph/evaluate.hpp"

#include "engine/concrete.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// Arithmetic needs nothing from outside the program.
struct NoOutside final : Outside {
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};

constexpr std::uint32_t absent = 0xFFFFFFFF;

std::array<int, 2> childWidths(const Graph& graph, const NodeData& node) {
  const auto width = [&](std::size_t i) {
    return node.child[i] == noNode ? 0 : static_cast<int>(graph[node.child[i]].width);
  };
  return {width(0), width(1)};
}

}  // namespace

std::uint64_t evaluateOperation(Op op, int width, std::array<int, 2> childWidth, std::array<std::uint64_t, 3> operand,
                                std::uint64_t value) {
  static NoOutside outside;
  const Concrete d(outside);
  const auto [a, b, c] = operand;
  const int w = childWidth[0];
  switch (op) {
    case Op::Constant:
    case Op::Variable: return value;
    case Op::Not: return d.bnot(a, width);
    case Op::And: return d.band(a, b, width);
    case Op::Or: return d.bor(a, b, width);
    case Op::Xor: return d.bxor(a, b, width);
    case Op::Add: return d.add(a, b, width);
    case Op::Sub: return d.sub(a, b, width);
    case Op::Mul: return d.mul(a, b, width);
    case Op::Udiv: return d.udiv(a, b, width);
    case Op::Urem: return d.urem(a, b, width);
    case Op::Sdiv: return d.sdiv(a, b, width);
    case Op::Srem: return d.srem(a, b, width);
    case Op::Shl: return d.shl(a, b, width);
    case Op::Lshr: return d.lshr(a, b, width);
    case Op::Equal: return d.equal(a, b, w);
    case Op::Ult: return d.ult(a, b, w);
    case Op::Ule: return d.ule(a, b, w);
    case Op::Slt: return d.slt(a, b, w);
    case Op::Sle: return d.sle(a, b, w);
    case Op::Ite: return a != 0 ? b : c;
    case Op::Concat: return d.concat(a, childWidth[0], b, childWidth[1]);
    case Op::Extract: return d.extract(a, static_cast<int>(value) + width - 1, static_cast<int>(value));
    case Op::Zext: return d.zext(a, w, width);
    case Op::Sext: return d.sext(a, w, width);
    case Op::RealAdd: return d.radd(a, b);
    case Op::RealSub: return d.rsub(a, b);
    case Op::RealMul: return d.rmul(a, b);
    case Op::RealDiv: return d.rdiv(a, b);
    case Op::RealFunction: return d.rfunction(value, a);
    case Op::RealEqual: return d.requal(a, b);
    case Op::RealLess: return d.rless(a, b);
    case Op::RealLegal: return d.rlegal(a);
    case Op::RealFromInt: return d.rfromInt(a);
    case Op::RealToInt: return d.rtoInt(a, value != 0);
    case Op::LongReal: return d.longReal(value, a, b, width);
  }
  return 0;
}

std::vector<Node> coneOf(const Graph& graph, std::span<const Node> roots) {
  std::vector<bool> isNeeded(graph.size(), false);
  std::uint32_t last = 0;
  for (const Node root : roots) {
    isNeeded[indexOf(root)] = true;
    last = std::max(last, indexOf(root));
  }
  std::vector<Node> cone;
  for (std::uint32_t i = graph.size() == 0 ? 0 : last + 1; i-- > 0;) {
    if (!isNeeded[i]) continue;
    cone.push_back(static_cast<Node>(i));
    for (const Node child : graph[static_cast<Node>(i)].child) {
      if (child != noNode) isNeeded[indexOf(child)] = true;
    }
  }
  return {cone.rbegin(), cone.rend()};
}

Evaluator::Evaluator(const Graph& graph, std::span<const Node> roots) : graph_(graph), value_(graph.size(), 0) {
  for (const Node n : coneOf(graph, roots)) {
    const NodeData& node = graph[n];
    if (node.op == Op::Constant)
      value_[indexOf(n)] = node.value;
    else if (node.op != Op::Variable)
      computed_.push_back(n);
  }
}

void Evaluator::set(Node variable, std::uint64_t value) {
  CHECK(graph_[variable].op == Op::Variable, "only variables are set");
  if (indexOf(variable) < value_.size()) value_[indexOf(variable)] = value & Graph::maskOf(graph_[variable].width);
}

/// Most nodes are choices and truth values: these are computed here, without a look at the widths of operands.
void Evaluator::run() {
  for (const Node n : computed_) {
    const NodeData& node = graph_[n];
    const auto operand = [&](std::size_t i) { return node.child[i] == noNode ? 0 : value_[indexOf(node.child[i])]; };
    std::uint64_t& value = value_[indexOf(n)];
    switch (node.op) {
      case Op::Not: value = ~operand(0) & Graph::maskOf(node.width); break;
      case Op::And: value = operand(0) & operand(1); break;
      case Op::Or: value = operand(0) | operand(1); break;
      case Op::Xor: value = operand(0) ^ operand(1); break;
      case Op::Equal: value = operand(0) == operand(1) ? 1 : 0; break;
      case Op::Ite: value = operand(0) != 0 ? operand(1) : operand(2); break;
      default:
        value = evaluateOperation(node.op, node.width, childWidths(graph_, node), {operand(0), operand(1), operand(2)},
                                  node.value);
    }
  }
}

LaneEvaluator::LaneEvaluator(const Graph& graph, std::span<const Node> roots)
    : graph_(graph), cone_(coneOf(graph, roots)), place_(graph.size(), absent) {
  std::uint32_t next = 0;
  for (const Node n : cone_) {
    place_[indexOf(n)] = next;
    next += graph_[n].width == 1 ? 1U : static_cast<std::uint32_t>(lanes);
  }
  values_.assign(next, 0);
}

void LaneEvaluator::setBits(Node variable, std::uint64_t bits) {
  if (indexOf(variable) < place_.size() && place_[indexOf(variable)] != absent)
    values_[place_[indexOf(variable)]] = bits;
}

void LaneEvaluator::set(Node variable, int lane, std::uint64_t value) {
  if (indexOf(variable) >= place_.size() || place_[indexOf(variable)] == absent) return;
  std::uint64_t* const first = &values_[place_[indexOf(variable)]];
  if (graph_[variable].width == 1) {
    const std::uint64_t bit = 1ULL << lane;
    *first = (value & 1) != 0 ? *first | bit : *first & ~bit;
  } else {
    first[lane] = value & Graph::maskOf(graph_[variable].width);
  }
}

std::uint64_t LaneEvaluator::at(Node n, int lane) const {
  const std::uint64_t* const first = &values_[place_[indexOf(n)]];
  return graph_[n].width == 1 ? *first >> lane & 1 : first[lane];
}

void LaneEvaluator::run() {
  for (const Node n : cone_) {
    if (graph_[n].op != Op::Variable) runNode(n);
  }
}

void LaneEvaluator::runNode(Node n) {
  const NodeData& node = graph_[n];
  std::uint64_t* const out = &values_[place_[indexOf(n)]];
  if (node.width == 1) {
    const auto lane = [&](std::size_t i) { return bits(node.child[i]); };
    switch (node.op) {
      case Op::Constant: *out = node.value != 0 ? ~0ULL : 0; return;
      case Op::Not: *out = ~lane(0); return;
      case Op::And: *out = lane(0) & lane(1); return;
      case Op::Or: *out = lane(0) | lane(1); return;
      case Op::Xor: *out = lane(0) ^ lane(1); return;
      case Op::Ite: *out = (lane(0) & lane(1)) | (~lane(0) & lane(2)); return;
      default: break;
    }
  }
  const std::array<int, 2> widths = childWidths(graph_, node);
  std::uint64_t gathered = 0;
  for (int k = 0; k < lanes; ++k) {
    const auto operand = [&](std::size_t i) { return node.child[i] == noNode ? 0 : at(node.child[i], k); };
    const std::uint64_t result =
        evaluateOperation(node.op, node.width, widths, {operand(0), operand(1), operand(2)}, node.value);
    if (node.width == 1)
      gathered |= result << k;
    else
      out[k] = result;
  }
  if (node.width == 1) *out = gathered;
}

}  // namespace rungproof
