// Sums are compared by the coefficients of what they add up.
#include "analysis/recheck/kept_difference.hpp"

#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace rungproof {

namespace {

using SignedNode = std::pair<Node, bool>;  ///< true: subtracted

/// Whether the sum is 0 modulo 2^width, by its form.
bool cancelsOut(const Graph& graph, std::initializer_list<SignedNode> sum) {
  std::vector<SignedNode> open(sum);
  const int width = graph[open.front().first].width;
  std::map<std::uint32_t, std::uint64_t> coefficient;
  std::uint64_t constant = 0;
  while (!open.empty()) {
    const auto [n, isSubtracted] = open.back();
    open.pop_back();
    const NodeData& node = graph[n];
    if (node.width != width) return false;
    if (node.op == Op::Add || node.op == Op::Sub) {
      open.emplace_back(node.child[0], isSubtracted);
      open.emplace_back(node.child[1], isSubtracted != (node.op == Op::Sub));
    } else if (node.op == Op::Constant) {
      constant += isSubtracted ? 0 - node.value : node.value;
    } else {
      coefficient[indexOf(n)] += isSubtracted ? ~std::uint64_t{0} : 1;
    }
  }
  const std::uint64_t mask = Graph::maskOf(width);
  bool isZero = (constant & mask) == 0;
  for (const auto& [n, factor] : coefficient) isZero = isZero && (factor & mask) == 0;
  return isZero;
}

}  // namespace

bool consistsOfSums(const Graph& graph, const KeptDifference& d) {
  for (const Summand* s : {&d.left, &d.right}) {
    if (!cancelsOut(graph, {{s->next, true}, {s->word, false}, {s->increment, false}})) return false;
  }
  return cancelsOut(graph, {{d.difference, true}, {d.left.progress(), false}, {d.right.progress(), true}});
}

}  // namespace rungproof
