// Sums are followed through choices: of two ways to a sum of the word, one is taken and the difference added where the
// other one is meant.
#include "analysis/portfolio/word_change.hpp"

#include <algorithm>
#include <unordered_map>

#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

/// A multiple of the word, and what is added to it.
struct Sum {
  int words = 0;
  AddedParts parts;
  Node counts = noNode;
};

void addTo(AddedParts& parts, const AddedPart& part, int times) {
  auto known = std::ranges::find(parts, part, &AddedParts::value_type::first);
  if (known == parts.end()) known = parts.insert(parts.end(), {part, 0});
  known->second += times;
  if (known->second == 0) parts.erase(known);
}

class ChangeSearch {
 public:
  ChangeSearch(Graph& graph, Node word) : graph_(graph), word_(word) {}

  Sum of(Node n) {
    if (const auto known = known_.find(indexOf(n)); known != known_.end()) return known->second;
    ++depth_;
    Sum sum = depth_ > schedule::changeDepth ? whole(n) : made(n);
    if (sum.parts.size() > schedule::changeParts) sum = whole(n);
    --depth_;
    known_.emplace(indexOf(n), sum);
    return sum;
  }

 private:
  Sum made(Node n) {
    const NodeData node = graph_[n];
    if (n == word_) return {1, {}, noNode};
    if (node.op == Op::Constant) return constant(node);
    if (node.op == Op::Add || node.op == Op::Sub) return joined(of(node.child[0]), of(node.child[1]), node.op);
    if (node.op == Op::Ite) return chosen(n, node.child[0], of(node.child[1]), of(node.child[2]));
    return whole(n);
  }
  static Sum whole(Node n) { return {0, {{AddedPart{noNode, n}, 1}}, noNode}; }
  Sum constant(const NodeData& node) {
    if (node.value == 0) return {};
    const bool isNegative = node.value > Graph::maskOf(node.width) / 2;
    const std::uint64_t size = isNegative ? (0 - node.value) & Graph::maskOf(node.width) : node.value;
    return {0, {{AddedPart{noNode, graph_.constantNode(size, node.width)}, isNegative ? -1 : 1}}, noNode};
  }
  Node both(Node a, Node b) { return a == noNode ? b : b == noNode ? a : graph_.make(Op::And, 1, a, b); }
  Sum joined(Sum a, const Sum& b, Op op) {
    const int sign = op == Op::Add ? 1 : -1;
    a.words += sign * b.words;
    a.counts = both(a.counts, b.counts);
    for (const auto& [part, times] : b.parts) addTo(a.parts, part, sign * times);
    return a;
  }
  Sum chosen(Node n, Node condition, const Sum& then, const Sum& otherwise) {
    if (then.words != otherwise.words) {
      const bool isThen = then.words == 1;
      if (!isThen && otherwise.words != 1) return whole(n);
      Sum result = isThen ? then : otherwise;
      result.counts = both(isThen ? condition : graph_.make(Op::Not, 1, condition), result.counts);
      return result;
    }
    if (then.words != 1) return whole(n);
    Sum result = otherwise;
    if (then.counts != otherwise.counts) {
      const auto counts = [&](const Sum& sum) { return sum.counts == noNode ? graph_.constantNode(1, 1) : sum.counts; };
      result.counts = graph_.make(Op::Ite, 1, condition, counts(then), counts(otherwise));
    }
    for (const auto& [part, times] : joined(then, otherwise, Op::Sub).parts)
      addTo(result.parts, {both(condition, part.condition), part.amount}, times);
    return result;
  }

  Graph& graph_;
  const Node word_;
  int depth_ = 0;
  std::unordered_map<std::uint32_t, Sum> known_;
};

}  // namespace

std::optional<WordChange> changeOf(Graph& graph, Node word, Node next) {
  Sum sum = ChangeSearch(graph, word).of(next);
  if (sum.words != 1) return std::nullopt;
  return WordChange{std::move(sum.parts), sum.counts};
}

}  // namespace rungproof
