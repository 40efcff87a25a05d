// Sums are taken apart until only terms are left that are no sums; the arithmetic is modulo 2^width.
#include "analysis/words/linear_form.hpp"

#include <map>
#include <optional>

#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/substitution.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

class Linearised {
 public:
  Linearised(Graph& graph, int width) : graph_(graph), width_(width) {}

  /// left = right; nothing if there are too many choices.
  std::optional<Node> equation(Node left, Node right) {
    Sum sum;
    sum.waiting = {{left, 1}, {right, mask()}};
    return expanded(std::move(sum));
  }

 private:
  /// The sum of all terms times their factors, plus the constant, is 0.
  struct Sum {
    std::map<Node, std::uint64_t> terms;                  ///< that are no sums
    std::vector<std::pair<Node, std::uint64_t>> waiting;  ///< to be looked at
    std::uint64_t constant = 0;
  };
  std::uint64_t mask() const { return Graph::maskOf(width_); }

  std::optional<Node> expanded(Sum sum) {
    while (!sum.waiting.empty()) {
      const auto [n, factor] = sum.waiting.back();
      sum.waiting.pop_back();
      const NodeData node = graph_[n];
      const bool isScaled = node.op == Op::Mul && graph_[node.child[1]].op == Op::Constant;
      if (node.op == Op::Constant) {
        sum.constant += factor * node.value;
      } else if (node.op == Op::Add || node.op == Op::Sub) {
        sum.waiting.emplace_back(node.child[0], factor);
        sum.waiting.emplace_back(node.child[1], node.op == Op::Add ? factor : 0 - factor);
      } else if (isScaled) {
        sum.waiting.emplace_back(node.child[0], factor * graph_[node.child[1]].value);
      } else if (node.op == Op::Ite) {
        return chosen(std::move(sum), node, factor);
      } else if (const Node choice = extended(n); choice != noNode) {
        sum.waiting.emplace_back(choice, factor);
      } else {
        sum.terms[n] += factor;
      }
    }
    return ++equations_ > schedule::choiceLimit ? std::nullopt : std::optional<Node>(written(sum));
  }

  /// A sign extension as what it is of: of a choice, or of a word plus a constant, which may overflow. noNode: of
  /// neither.
  Node extended(Node n) {
    const NodeData node = graph_[n];
    if (node.op != Op::Sext) return noNode;
    const NodeData inner = graph_[node.child[0]];
    const int width = inner.width;
    const auto wide = [&](Node a) { return graph_.make(Op::Sext, node.width, a); };
    if (inner.op == Op::Ite)
      return graph_.make(Op::Ite, node.width, inner.child[0], wide(inner.child[1]), wide(inner.child[2]));
    const bool isSum = inner.op == Op::Add || inner.op == Op::Sub;
    if (!isSum || graph_[inner.child[1]].op != Op::Constant) return noNode;
    const std::uint64_t given = graph_[inner.child[1]].value, sign = 1ULL << (width - 1);
    const std::uint64_t added = inner.op == Op::Add ? given : (0 - given) & Graph::maskOf(width);
    if (added == sign) return noNode;
    const Node word = inner.child[0];
    const auto number = [&](std::uint64_t v, int w) { return graph_.constantNode(v & Graph::maskOf(w), w); };
    const std::uint64_t wideAdded = (added & sign) != 0 ? added - 2 * sign : added;
    // Beyond these values of the word the sum leaves the width: above for positive numbers, below for negative ones.
    const bool isUp = (added & sign) == 0;
    const Node overflows = isUp ? graph_.make(Op::Slt, 1, number(sign - 1 - added, width), word)
                                : graph_.make(Op::Slt, 1, word, number(sign - added, width));
    const Node sum = graph_.make(Op::Add, node.width, wide(word), number(wideAdded, node.width));
    const Node turned = graph_.make(Op::Add, node.width, wide(word),
                                    number(isUp ? wideAdded - 2 * sign : wideAdded + 2 * sign, node.width));
    return graph_.make(Op::Ite, node.width, overflows, turned, sum);
  }

  std::optional<Node> chosen(Sum sum, const NodeData& choice, std::uint64_t factor) {
    const auto known = decided_.find(choice.child[0]);
    std::optional<Node> arms[2];
    for (const bool value : {false, true}) {
      if (known != decided_.end() && known->second != value) continue;
      Sum arm = sum;
      arm.waiting.emplace_back(choice.child[value ? 1 : 2], factor);
      if (known != decided_.end()) return expanded(std::move(arm));
      decided_.emplace(choice.child[0], value);
      arms[value ? 1 : 0] = expanded(std::move(arm));
      decided_.erase(choice.child[0]);
      if (!arms[value ? 1 : 0]) return std::nullopt;
    }
    return graph_.make(Op::Ite, 1, choice.child[0], *arms[1], *arms[0]);
  }

  Node written(const Sum& sum) {
    bool isTurned = false, isFirst = true;
    Node sides[2] = {noNode, noNode};
    for (const auto& [n, factor] : sum.terms) {
      std::uint64_t f = factor & mask();
      if (f == 0) continue;
      const auto isNegative = [&](std::uint64_t v) { return (v >> (width_ - 1) & 1U) != 0; };
      if (isFirst) isTurned = isNegative(f);
      if (isTurned) f = (0 - f) & mask();
      const bool isRight = !isFirst && isNegative(f);  // half of 2^width is its own negative
      isFirst = false;
      if (isRight) f = (0 - f) & mask();
      const Node term = f == 1 ? n : graph_.make(Op::Mul, width_, n, graph_.constantNode(f, width_));
      Node& side = sides[isRight ? 1 : 0];
      side = side == noNode ? term : graph_.make(Op::Add, width_, side, term);
    }
    const Node constant = graph_.constantNode((isTurned ? sum.constant : 0 - sum.constant) & mask(), width_);
    if (isFirst) return graph_.constantNode(graph_[constant].value == 0 ? 1 : 0, 1);
    const Node right = sides[1] == noNode ? constant : graph_.make(Op::Add, width_, sides[1], constant);
    return graph_.make(Op::Equal, 1, sides[0], right);
  }

  Graph& graph_;
  const int width_;
  std::map<Node, bool> decided_;  ///< conditions on the way to this equation
  int equations_ = 0;
};

}  // namespace

Node linearForm(Graph& graph, Node n) {
  const NodeData node = graph[n];
  if (node.op == Op::Not) return graph.make(Op::Not, 1, linearForm(graph, node.child[0]));
  if (node.op != Op::Equal || graph[node.child[0]].width == 1) return n;
  return Linearised(graph, graph[node.child[0]].width).equation(node.child[0], node.child[1]).value_or(n);
}

Node linearForms(Graph& graph, Node n) {
  const Node roots[] = {n};
  std::unordered_map<std::uint32_t, Node> replaced;
  for (const Node under : coneOf(graph, roots)) {
    if (graph[under].op == Op::Equal) replaced.emplace(indexOf(under), linearForm(graph, under));
  }
  return Substitution(graph, std::move(replaced))(n);
}

}  // namespace rungproof
