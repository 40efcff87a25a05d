// Follows data, not conditions, from the operands of a comparison back to the state words they come from.
#include "analysis/portfolio/state_truths.hpp"

#include <set>
#include <unordered_map>

namespace rungproof {

namespace {

class TruthSearch {
 public:
  TruthSearch(const TransitionSystem& system, std::size_t limit)
      : system_(system), graph_(*system.graph), limit_(limit), inCone_(graph_.size(), false) {
    for (std::size_t i = 0; i < system.states.size(); ++i) states_.emplace(indexOf(system.states[i].node), i);
  }

  std::vector<Node> run(const std::vector<std::size_t>& questions) {
    std::vector<Node> stack = system_.constraints;
    for (const std::size_t q : questions) stack.push_back(system_.questions[q].bad);
    while (!stack.empty()) {
      const Node n = stack.back();
      stack.pop_back();
      if (inCone_[indexOf(n)]) continue;
      inCone_[indexOf(n)] = true;
      if (const auto state = states_.find(indexOf(n)); state != states_.end())
        stack.push_back(system_.states[state->second].next);
      for (const Node child : graph_[n].child) {
        if (child != noNode && graph_[n].op != Op::Variable) stack.push_back(child);
      }
    }
    std::vector<Node> result;
    const std::size_t size = inCone_.size();
    for (std::size_t i = 0; i < size && result.size() < limit_; ++i) {
      const Node n = static_cast<Node>(i);
      if (inCone_[i] && graph_[n].width == 1 && states_.contains(static_cast<std::uint32_t>(i))) result.push_back(n);
    }
    for (std::size_t i = 0; i < size && result.size() < limit_; ++i) {
      if (inCone_[i]) compare(static_cast<Node>(i), result);
    }
    return result;
  }

 private:
  void compare(Node n, std::vector<Node>& result) {
    const NodeData node = graph_[n];
    const bool orders = node.op == Op::Ult || node.op == Op::Ule || node.op == Op::Slt || node.op == Op::Sle;
    if (!orders && node.op != Op::Equal) return;
    for (int side = 0; side < 2; ++side) {
      const Node constant = node.child[static_cast<std::size_t>(side)],
                 data = node.child[static_cast<std::size_t>(1 - side)];
      if (graph_[constant].op != Op::Constant) continue;
      // value < c and c <= value split at c; value <= c and c < value at c + 1.
      const std::uint64_t value = graph_[constant].value;
      const bool strict = node.op == Op::Ult || node.op == Op::Slt;
      const std::uint64_t split = node.op == Op::Equal || (side == 1) == strict ? value : value + 1;
      for (const Node word : wordsOf(data)) {
        const int width = graph_[word].width;
        if (split == 0 || split > Graph::maskOf(width)) continue;
        const Node bound = graph_.constantNode(split, width);
        const Node truth = node.op == Op::Equal ? graph_.make(Op::Equal, 1, word,
                                                              graph_.constantNode(value & Graph::maskOf(width), width))
                                                : graph_.make(Op::Ule, 1, bound, word);
        // Whether it stands at 0 tells whether it has been started.
        for (const Node candidate : {truth, graph_.make(Op::Ule, 1, graph_.constantNode(1, width), word)}) {
          if (graph_[candidate].op != Op::Constant && result.size() < limit_ && seen_.insert(candidate).second)
            result.push_back(candidate);
        }
      }
    }
  }

  /// State words whose value reaches `n` through sums, choices and changes of width.
  std::vector<Node> wordsOf(Node n) {
    std::vector<Node> words, stack{n};
    std::set<Node> visited;
    while (!stack.empty() && visited.size() < 64) {
      const Node top = stack.back();
      stack.pop_back();
      if (!visited.insert(top).second) continue;
      const NodeData& node = graph_[top];
      if (node.op == Op::Variable && node.width > 1 && states_.contains(indexOf(top))) words.push_back(top);
      const bool carries = node.op == Op::Add || node.op == Op::Sub || node.op == Op::Zext || node.op == Op::Sext ||
                           node.op == Op::Extract || node.op == Op::Concat;
      if (carries || node.op == Op::Ite) {
        for (std::size_t i = node.op == Op::Ite ? 1 : 0; i < 3; ++i) {
          if (node.child[i] != noNode) stack.push_back(node.child[i]);
        }
      }
    }
    return words;
  }

  const TransitionSystem& system_;
  Graph& graph_;
  const std::size_t limit_;
  std::vector<bool> inCone_;
  std::unordered_map<std::uint32_t, std::size_t> states_;
  std::set<Node> seen_;
};

}  // namespace

std::vector<Node> stateTruths(const TransitionSystem& system, const std::vector<std::size_t>& questions,
                              std::size_t limit) {
  return TruthSearch(system, limit).run(questions);
}

std::vector<bool> statesAskedFor(const TransitionSystem& system, const std::vector<std::size_t>& questions) {
  const Graph& graph = *system.graph;
  std::unordered_map<std::uint32_t, std::size_t> stateOf;
  for (std::size_t s = 0; s < system.states.size(); ++s) {
    stateOf.emplace(indexOf(system.states[s].node), s);
    if (graph[system.states[s].next].op != Op::Constant) stateOf.emplace(indexOf(system.states[s].next), s);
  }
  std::vector<bool> isAsked(system.states.size(), false), isSeen(graph.size(), false);
  std::vector<Node> stack;
  for (const std::size_t q : questions) stack.push_back(system.questions[q].bad);
  while (!stack.empty()) {
    const Node n = stack.back();
    stack.pop_back();
    if (isSeen[indexOf(n)]) continue;
    isSeen[indexOf(n)] = true;
    if (const auto state = stateOf.find(indexOf(n)); state != stateOf.end()) {
      isAsked[state->second] = true;
      continue;
    }
    for (const Node child : graph[n].child) {
      if (child != noNode && graph[n].op != Op::Variable) stack.push_back(child);
    }
  }
  return isAsked;
}

}  // namespace rungproof
