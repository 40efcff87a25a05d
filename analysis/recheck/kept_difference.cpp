// Sums are compared by how often they add what.
#include "analysis/recheck/kept_difference.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

using SignedNode = std::pair<Node, bool>;  ///< true: subtracted

/// Numbers with sign.
struct SignedRange {
  std::int64_t low, high;
};

bool isAddition(const NodeData& node) { return node.op == Op::Add || node.op == Op::Sub; }

/// Of a node as a number with sign, where no addition under it leaves the width that it is made in.
std::optional<SignedRange> exactRangeOf(const Graph& graph, Node n, int& opened) {
  const NodeData& node = graph[n];
  if (node.width > 62) return std::nullopt;
  const std::int64_t half = std::int64_t{1} << (node.width - 1);
  if (node.op == Op::Sext) return exactRangeOf(graph, node.child[0], opened);
  if (node.op == Op::Zext) return SignedRange{0, static_cast<std::int64_t>(Graph::maskOf(graph[node.child[0]].width))};
  if (!isAddition(node)) return SignedRange{-half, half - 1};
  if (++opened > schedule::sumAdditions) return std::nullopt;
  const std::optional<SignedRange> a = exactRangeOf(graph, node.child[0], opened);
  const std::optional<SignedRange> b = a ? exactRangeOf(graph, node.child[1], opened) : std::nullopt;
  if (!a || !b) return std::nullopt;
  const SignedRange sum = node.op == Op::Add ? SignedRange{a->low + b->low, a->high + b->high}
                                             : SignedRange{a->low - b->high, a->high - b->low};
  if (sum.low < -half || sum.high >= half) return std::nullopt;
  return sum;
}

/// What the nodes, of one width, add up to modulo 2^width if all but constants cancels out by its form. Sums in smaller
/// widths are looked into where they are exact.
std::optional<std::uint64_t> constantOf(const Graph& graph, std::vector<SignedNode> open) {
  const int width = graph[open.front().first].width;
  for (const auto& [n, isSubtracted] : open) {
    if (graph[n].width != width) return std::nullopt;
  }
  std::map<std::pair<std::uint32_t, Op>, std::uint64_t> coefficient;
  std::uint64_t constant = 0;
  int opened = 0;
  while (!open.empty()) {
    if (++opened > schedule::sumAdditions) return std::nullopt;
    const auto [n, isSubtracted] = open.back();
    open.pop_back();
    const NodeData& node = graph[n];
    const bool isExact = isAddition(node) || (node.op == Op::Sext && isAddition(graph[node.child[0]]) &&
                                              exactRangeOf(graph, node.child[0], opened).has_value());
    if (isAddition(node) && isExact) {
      open.emplace_back(node.child[0], isSubtracted);
      open.emplace_back(node.child[1], isSubtracted != (node.op == Op::Sub));
    } else if (isExact) {
      open.emplace_back(node.child[0], isSubtracted);
    } else if (node.op == Op::Constant) {
      const std::uint64_t sign = std::uint64_t{1} << (node.width - 1);
      const std::uint64_t value = (node.value ^ sign) - sign;
      constant += isSubtracted ? 0 - value : value;
    } else {
      const bool isExtended = node.op == Op::Sext || node.op == Op::Zext;
      const std::pair key{indexOf(isExtended ? node.child[0] : n), node.op == Op::Zext ? Op::Zext : Op::Sext};
      coefficient[key] += isSubtracted ? ~std::uint64_t{0} : 1;
    }
  }
  const std::uint64_t mask = Graph::maskOf(width);
  for (const auto& [part, factor] : coefficient) {
    if ((factor & mask) != 0) return std::nullopt;
  }
  return constant & mask;
}

bool cancelsOut(const Graph& graph, std::vector<SignedNode> sum) { return constantOf(graph, std::move(sum)) == 0U; }

}  // namespace

bool consistsOfSums(const Graph& graph, const KeptDifference& d) {
  for (const Summand* s : {&d.left, &d.right}) {
    if (!cancelsOut(graph, {{s->next, true}, {s->word, false}, {s->increment, false}})) return false;
  }
  return cancelsOut(graph, {{d.difference, true}, {d.left.progress(), false}, {d.right.progress(), true}});
}

bool consistsOfSums(const Graph& graph, const KeptSum& sum) {
  std::vector<SignedNode> before{{sum.sum, false}}, after{{sum.next, false}};
  for (const SumTerm& t : sum.terms) {
    before.emplace_back(t.term, !t.isSubtracted);
    after.emplace_back(t.next, !t.isSubtracted);
  }
  const std::optional<std::uint64_t> constant = constantOf(graph, std::move(before));
  return constant && constantOf(graph, std::move(after)) == constant;
}

}  // namespace rungproof
