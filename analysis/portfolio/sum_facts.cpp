// Each fact is of one addition, or joins those of two: a solver sees it in a moment, and none of what they say
// together.
#include "analysis/portfolio/sum_facts.hpp"

#include <optional>

#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

class SumFacts {
 public:
  SumFacts(Graph& graph, const std::set<std::int64_t>& limits) : graph_(graph), limits_(limits) {}

  /// Without terms below zero, no part of a sum is more than the whole.
  void boundTerms(Node root) {
    const NodeData node = graph_[root];
    if (isExtension(root)) return boundTerms(node.child[0]);
    if (node.op == Op::Sub) {
      boundTerms(node.child[0]);
      boundTerms(node.child[1]);
    }
    if (node.op != Op::Add) return;
    std::vector<Node> parts;
    if (!boundParts(root, parts)) return;
    const Node isPositive = nonNegative(root);
    for (auto part = parts.rbegin(); part != parts.rend(); ++part)
      facts_.push_back(implied(isPositive, notMore(*part, root)));
  }
  std::vector<Node> result() { return std::move(facts_); }

 private:
  /// Of each sum under the root, those above first: false if something is taken away.
  bool boundParts(Node sum, std::vector<Node>& parts) {
    if (isExtension(sum)) return boundParts(graph_[sum].child[0], parts);
    if (graph_[sum].op == Op::Sub) return false;
    if (graph_[sum].op != Op::Add) return true;
    const auto children = graph_[sum].child;
    for (const Node child : {children[0], children[1]}) {
      if (!boundParts(child, parts)) return false;
    }
    const Node both = graph_.make(Op::And, 1, nonNegative(children[0]), nonNegative(children[1]));
    facts_.push_back(implied(both, graph_.make(Op::Not, 1, isNegative(sum))));
    for (const Node child : {children[0], children[1]}) {
      facts_.push_back(implied(both, notMore(child, sum)));
      parts.push_back(child);
    }
    int taken = 0;
    for (auto limit = limits_.upper_bound(0); limit != limits_.end() && taken < schedule::limitsOfSums;
         ++limit, ++taken) {
      const std::optional<Node> a = within(children[0], *limit), b = within(children[1], *limit),
                                c = within(sum, *limit);
      if (a && b && c) facts_.push_back(implied(graph_.make(Op::And, 1, *a, *b), *c));
    }
    return true;
  }
  std::int64_t termsOf(Node n) const {
    const NodeData& node = graph_[n];
    if (node.op == Op::Sext || node.op == Op::Zext) return termsOf(node.child[0]);
    return node.op == Op::Add ? termsOf(node.child[0]) + termsOf(node.child[1]) : 1;
  }
  /// That a sum of n terms is no more than n times the limit; nothing if that has no place in its width.
  std::optional<Node> within(Node n, std::int64_t limit) {
    const int width = graph_[n].width;
    const std::int64_t most = termsOf(n) * limit;
    if (width > 62 || most >= std::int64_t{1} << (width - 1)) return std::nullopt;
    const Node bound = graph_.constantNode(static_cast<std::uint64_t>(most), width);
    return graph_.make(Op::Not, 1, graph_.make(Op::Slt, 1, bound, n));
  }
  Node implied(Node premise, Node conclusion) {
    return graph_.make(Op::Or, 1, graph_.make(Op::Not, 1, premise), conclusion);
  }
  Node isNegative(Node n) { return graph_.make(Op::Slt, 1, n, graph_.constantNode(0, graph_[n].width)); }
  Node notMore(Node part, Node sum) {
    const int width = graph_[sum].width;
    return graph_.make(
        Op::Not, 1,
        graph_.make(Op::Slt, 1, sum, graph_[part].width == width ? part : graph_.make(Op::Sext, width, part)));
  }
  /// All terms of a sum.
  Node nonNegative(Node n) {
    const NodeData node = graph_[n];
    if (node.op == Op::Zext) return graph_.constantNode(1, 1);
    if (node.op == Op::Sext) return nonNegative(node.child[0]);
    if (node.op == Op::Add) return graph_.make(Op::And, 1, nonNegative(node.child[0]), nonNegative(node.child[1]));
    return graph_.make(Op::Not, 1, isNegative(n));
  }

  bool isExtension(Node n) const { return graph_[n].op == Op::Sext || graph_[n].op == Op::Zext; }

  Graph& graph_;
  const std::set<std::int64_t>& limits_;
  std::vector<Node> facts_;
};

}  // namespace

std::vector<Node> factsOfSum(Graph& graph, Node sum, const std::set<std::int64_t>& limits) {
  SumFacts facts(graph, limits);
  facts.boundTerms(sum);
  return facts.result();
}

}  // namespace rungproof
