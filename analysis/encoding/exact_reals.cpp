// Depth first, children before their parents, as in graph/substitution.cpp.
#include "analysis/encoding/exact_reals.hpp"

#include <array>
#include <unordered_map>

#include "analysis/graph/real_words.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

class RealWriter {
 public:
  RealWriter(Graph& graph, RealScope scope) : graph_(graph), scope_(scope), words_(graph) {}

  Node operator()(Node root) {
    std::vector<Node> stack{root};
    while (!stack.empty()) {
      const Node n = stack.back();
      if (known_.contains(indexOf(n))) {
        stack.pop_back();
        continue;
      }
      const NodeData node = graph_[n];
      std::array<Node, 3> child = node.child;
      bool isReady = true;
      for (std::size_t i = 0; i < child.size() && node.op != Op::Variable && node.op != Op::Constant; ++i) {
        if (child[i] == noNode) continue;
        const auto known = known_.find(indexOf(child[i]));
        if (known == known_.end()) {
          stack.push_back(child[i]);
          isReady = false;
        } else {
          child[i] = known->second;
        }
      }
      if (!isReady) continue;
      stack.pop_back();
      Node result = n;
      if (scope_ == RealScope::All ? isExactReal(node) : isRealComparison(node.op))
        result = written(node, {child[0]}, {child[1]});
      else if (child != node.child)
        result = graph_.make(node.op, node.width, child[0], child[1], child[2], node.value);
      known_.emplace(indexOf(n), result);
    }
    return known_.at(indexOf(root));
  }

 private:
  Node written(const NodeData& node, Graph::Bits a, Graph::Bits b) {
    switch (node.op) {
      case Op::RealAdd: return words_.add(a, b).node;
      case Op::RealSub: return words_.sub(a, b).node;
      case Op::RealMul: return words_.mul(a, b).node;
      case Op::RealDiv: return words_.div(a, b).node;
      case Op::RealFunction: return words_.sqrt(a).node;
      case Op::RealEqual: return words_.equal(a, b).node;
      case Op::RealLess: return words_.less(a, b).node;
      case Op::RealLegal: return words_.legal(a).node;
      case Op::RealFromInt: return words_.fromInt(a).node;
      case Op::RealToInt: return words_.toInt(a, node.value != 0).node;
      default: CHECK(false, "not a REAL operation");
    }
    return noNode;
  }

  Graph& graph_;
  const RealScope scope_;
  RealWords<Graph> words_;
  std::unordered_map<std::uint32_t, Node> known_;
};

}  // namespace

bool isExactReal(const NodeData& node) {
  return isRealOperation(node.op) &&
         (node.op != Op::RealFunction || static_cast<RealFunction>(node.value) == RealFunction::Sqrt);
}

TransitionSystem withExactReals(const TransitionSystem& system, RealScope scope) {
  RealWriter write(*system.graph, scope);
  TransitionSystem result = system;
  for (StateVariable& state : result.states) state.next = write(state.next);
  for (std::vector<Node>* nodes : {&result.constraints, &result.totalConstraints}) {
    for (Node& n : *nodes) n = write(n);
  }
  for (Question& question : result.questions) question.bad = write(question.bad);
  return result;
}

}  // namespace rungproof
