// What holds in each alternative of a condition holds with it: ways that a jump parted meet again, and what held before
// they parted still holds.
#include "analysis/encoding/assumed.hpp"

#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/substitution.hpp"

namespace rungproof {

namespace {

/// Which of the roots have one of some nodes below them.
std::vector<bool> haveBelow(const Graph& graph, const std::vector<Node>& roots,
                            const std::unordered_map<std::uint32_t, Node>& nodes) {
  std::unordered_map<std::uint32_t, bool> known;
  for (const Node n : coneOf(graph, roots)) {
    bool has = false;
    for (const Node child : graph[n].child)
      has = has || (child != noNode && (nodes.contains(indexOf(child)) || known.at(indexOf(child))));
    known.emplace(indexOf(n), has);
  }
  std::vector<bool> result;
  for (const Node root : roots) result.push_back(known.at(indexOf(root)));
  return result;
}

/// Conditions that have one value wherever another has one: 1 of a conjunction gives 1 to its parts, 0 of it only what
/// 0 of each part gives.
class ImpliedConditions {
 public:
  using Values = std::map<std::uint32_t, bool>;  ///< by node, which is no negation
  explicit ImpliedConditions(const Graph& graph) : graph_(graph) {}

  const Values& of(Node n, bool isOne, int depth = 0) {
    while (graph_[n].op == Op::Not) {
      n = graph_[n].child[0];
      isOne = !isOne;
    }
    const auto [found, isNew] = known_.try_emplace({indexOf(n), isOne});
    if (!isNew) return found->second;
    Values values;
    const NodeData& node = graph_[n];
    const bool isJoin = (node.op == Op::And || node.op == Op::Or) && node.width == 1;
    if (isJoin && depth < deepest) {
      const Values first = of(node.child[0], isOne, depth + 1), second = of(node.child[1], isOne, depth + 1);
      const bool areBoth = (node.op == Op::And) == isOne;
      for (const auto& [condition, value] : first) {
        const auto other = second.find(condition);
        if (areBoth || (other != second.end() && other->second == value)) values.emplace(condition, value);
      }
      if (areBoth) values.insert(second.begin(), second.end());
      while (values.size() > most) values.erase(values.begin());
    }
    values.insert_or_assign(indexOf(n), isOne);
    return known_[{indexOf(n), isOne}] = std::move(values);
  }

 private:
  static constexpr int deepest = 100;
  static constexpr std::size_t most = 100;  ///< conditions; the oldest nodes are given up first
  const Graph& graph_;
  std::map<std::pair<std::uint32_t, bool>, Values> known_;
};

}  // namespace

Assumed assuming(Graph& graph, Node node, Node guard) {
  std::vector<Node> parts, open{guard};
  while (!open.empty()) {
    const Node n = open.back();
    open.pop_back();
    if (graph[n].op == Op::And && graph[n].width == 1)
      open.insert(open.end(), {graph[n].child[0], graph[n].child[1]});
    else if (graph[n].op != Op::Constant)
      parts.push_back(n);
  }
  std::unordered_map<std::uint32_t, Node> truths;
  ImpliedConditions implied(graph);
  for (const Node part : parts) {
    for (const auto& [condition, value] : implied.of(part, true))
      truths.emplace(condition, graph.constantNode(value ? 1 : 0, 1));
  }
  std::vector<Node> bases;
  for (const Node part : parts) {
    const bool isNegated = graph[part].op == Op::Not;
    bases.push_back(isNegated ? graph[part].child[0] : part);
    truths[indexOf(bases.back())] = graph.constantNode(isNegated ? 0 : 1, 1);
  }
  const std::vector<bool> isChanged = haveBelow(graph, bases, truths);
  Node together = graph.constantNode(1, 1);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Node part = parts[i];
    if (isChanged[i]) {
      std::unordered_map<std::uint32_t, Node> others = truths;
      others.erase(indexOf(bases[i]));
      part = Substitution(graph, std::move(others))(part);
    }
    together = graph.make(Op::And, 1, together, part);
  }
  return {Substitution(graph, std::move(truths))(node), together};
}

}  // namespace rungproof
