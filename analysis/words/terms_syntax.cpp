// Comparisons as they stand, and words that are measured alike: x and y are of one kind where one is moved to the
// other, compared with it, or made from it by adding a constant.
#include <algorithm>
#include <array>
#include <set>

#include "analysis/schedule/schedule.hpp"
#include "analysis/words/terms.hpp"

namespace rungproof {

namespace {

bool isComparison(Op op) {
  return op == Op::Equal || op == Op::Ult || op == Op::Slt || op == Op::RealLess || op == Op::RealEqual ||
         op == Op::RealLegal;
}

std::vector<Node> coneNodes(const WordCone& cone) {
  std::vector<Node> roots = cone.system().constraints;
  roots.push_back(cone.bad());
  for (const StateVariable& state : cone.system().states) roots.push_back(state.next);
  return coneOf(*cone.system().graph, roots);
}

/// By index of a node: no input is under it.
std::vector<bool> overStatesOnly(const WordCone& cone, const std::vector<Node>& nodes) {
  const Graph& graph = *cone.system().graph;
  std::vector<bool> result(graph.size(), false);
  std::vector<bool> isState(graph.size(), false);
  for (const StateVariable& state : cone.system().states) isState[indexOf(state.node)] = true;
  for (const Node n : nodes) {
    const NodeData& node = graph[n];
    result[indexOf(n)] = node.op == Op::Variable ? isState[indexOf(n)] : std::ranges::all_of(node.child, [&](Node c) {
      return c == noNode || result[indexOf(c)];
    });
  }
  return result;
}

/// What a term may be, whatever the conditions.
void collectLeaves(const Graph& graph, Node n, std::vector<Node>& leaves, std::set<Node>& seen) {
  if (leaves.size() >= schedule::leafLimit || !seen.insert(n).second) return;
  const NodeData& node = graph[n];
  if (node.op == Op::Ite) {
    collectLeaves(graph, node.child[1], leaves, seen);
    collectLeaves(graph, node.child[2], leaves, seen);
  } else {
    leaves.push_back(n);
  }
}

std::vector<Node> leavesOf(const Graph& graph, Node n) {
  std::vector<Node> leaves;
  std::set<Node> seen;
  collectLeaves(graph, n, leaves, seen);
  return leaves;
}

/// Words of one kind, by union of sets.
class Kinds {
 public:
  explicit Kinds(const WordCone& cone) : graph_(*cone.system().graph) {
    for (std::size_t i = 0; i < cone.system().states.size(); ++i) {
      state_.emplace(indexOf(cone.system().states[i].node), i);
      parent_.push_back(i);
    }
    constants_.resize(parent_.size());
    isSigned_.resize(parent_.size(), false);
    isUnsigned_.resize(parent_.size(), false);
  }

  /// Words of one width are of one kind if they share a constant that is not everybody's.
  void joinByConstants() {
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool isShared =
            std::ranges::any_of(constants_[i], [&](std::uint64_t c) { return c > 1 && constants_[j].contains(c); });
        if (isShared) parent_[rootOf(i)] = rootOf(j);
      }
    }
  }
  /// Two terms that meet in a comparison or a move.
  void meet(Node a, Node b, Op op) {
    const std::optional<Base> left = baseOf(a), right = baseOf(b);
    if (left && right) parent_[rootOf(left->state)] = rootOf(right->state);
    if (left) mark(left->state, op);
    if (right) mark(right->state, op);
    if (left && graph_[b].op == Op::Constant) addConstant(*left, b);
    if (right && graph_[a].op == Op::Constant) addConstant(*right, a);
  }
  std::size_t rootOf(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  /// Of all words of i's kind, in the width of word i.
  std::set<std::uint64_t> constantsOf(std::size_t i, int width) const {
    std::set<std::uint64_t> result;
    for (std::size_t j = 0; j < parent_.size(); ++j) {
      if (rootOf(j) != rootOf(i)) continue;
      for (const std::uint64_t value : constants_[j]) result.insert(value & Graph::maskOf(width));
    }
    return result;
  }
  bool isSigned(std::size_t i) const { return any(isSigned_, i); }
  bool isUnsigned(std::size_t i) const { return any(isUnsigned_, i); }

 private:
  struct Base {
    std::size_t state;
    std::uint64_t offset;
  };
  std::optional<Base> baseOf(Node n) const {
    std::uint64_t offset = 0;
    for (int step = 0; step < 8; ++step) {
      if (const auto state = state_.find(indexOf(n)); state != state_.end())
        return graph_[n].width > 1 ? std::optional<Base>({state->second, offset}) : std::nullopt;
      const NodeData& node = graph_[n];
      if (node.op == Op::Zext || node.op == Op::Sext) {
        n = node.child[0];
      } else if ((node.op == Op::Add || node.op == Op::Sub) && graph_[node.child[1]].op == Op::Constant) {
        const std::uint64_t value = graph_[node.child[1]].value;
        offset += node.op == Op::Add ? value : 0 - value;
        n = node.child[0];
      } else {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }
  void addConstant(const Base& base, Node constant) {
    constants_[base.state].insert(graph_[constant].value);
    if (base.offset != 0) constants_[base.state].insert(graph_[constant].value - base.offset);
  }
  void mark(std::size_t state, Op op) {
    if (op == Op::Slt) isSigned_[state] = true;
    if (op == Op::Ult) isUnsigned_[state] = true;
  }
  bool any(const std::vector<bool>& marks, std::size_t i) const {
    for (std::size_t j = 0; j < parent_.size(); ++j) {
      if (marks[j] && rootOf(j) == rootOf(i)) return true;
    }
    return false;
  }

  const Graph& graph_;
  std::unordered_map<std::uint32_t, std::size_t> state_;
  std::vector<std::size_t> parent_;
  std::vector<std::set<std::uint64_t>> constants_;
  std::vector<bool> isSigned_, isUnsigned_;
};

}  // namespace

std::vector<Node> syntacticPredicates(WordCone& cone) {
  Graph& graph = cone.graph();
  const std::vector<Node> nodes = coneNodes(cone);
  const std::vector<bool> isOverStates = overStatesOnly(cone, nodes);
  std::vector<Node> result;
  for (const StateVariable& state : cone.system().states) {
    if (graph[state.node].width == 1) result.push_back(state.node);
  }
  for (const Node n : nodes) {
    const NodeData node = graph[n];
    if (!isComparison(node.op) || (node.op == Op::Equal && graph[node.child[0]].width == 1)) continue;
    const std::vector<Node> left = leavesOf(graph, node.child[0]);
    const std::vector<Node> right =
        node.child[1] == noNode ? std::vector<Node>{noNode} : leavesOf(graph, node.child[1]);
    if (left.size() == 1 && right.size() == 1) {
      if (isOverStates[indexOf(n)]) result.push_back(n);
      continue;
    }
    for (const Node a : left) {
      for (const Node b : right) {
        if (isOverStates[indexOf(a)] && (b == noNode || isOverStates[indexOf(b)]))
          result.push_back(graph.make(node.op, 1, a, b));
      }
    }
  }
  return result;
}

std::vector<Node> orderPredicates(WordCone& cone, std::size_t limit) {
  Graph& graph = cone.graph();
  const TransitionSystem& system = cone.system();
  Kinds kinds(cone);
  for (const Node n : coneNodes(cone)) {
    const NodeData& node = graph[n];
    if (node.op != Op::Equal && node.op != Op::Ult && node.op != Op::Slt) continue;
    for (const Node a : leavesOf(graph, node.child[0])) {
      for (const Node b : leavesOf(graph, node.child[1])) kinds.meet(a, b, node.op);
    }
  }
  for (const StateVariable& state : system.states) {
    if (graph[state.node].width == 1) continue;
    for (const Node leaf : leavesOf(graph, state.next)) kinds.meet(state.node, leaf, Op::Equal);
    if (state.init != noNode) kinds.meet(state.node, state.init, Op::Equal);
  }
  kinds.joinByConstants();
  std::vector<Node> result;
  const auto compare = [&](std::size_t kind, Node a, Node b) {
    for (const Op op : {Op::Slt, Op::Ult}) {
      const bool isWanted = op == Op::Slt ? kinds.isSigned(kind) || !kinds.isUnsigned(kind) : kinds.isUnsigned(kind);
      if (!isWanted) continue;
      result.push_back(graph.make(op, 1, a, b));
      result.push_back(graph.make(op, 1, b, a));
    }
    result.push_back(graph.make(Op::Equal, 1, a, b));
  };
  for (std::size_t i = 0; i < system.states.size() && result.size() < limit; ++i) {
    const Node x = system.states[i].node;
    const int width = graph[x].width;
    if (width == 1) continue;
    for (const std::uint64_t value : kinds.constantsOf(i, width)) compare(i, x, graph.constantNode(value, width));
    for (std::size_t j = 0; j < i; ++j) {
      if (kinds.rootOf(i) == kinds.rootOf(j) && graph[system.states[j].node].width == width)
        compare(i, x, system.states[j].node);
    }
  }
  if (result.size() > limit) result.resize(limit);
  return result;
}

}  // namespace rungproof
