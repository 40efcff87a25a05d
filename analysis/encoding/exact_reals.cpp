// Each REAL operation becomes words by a rule of the substitution.
#include "analysis/encoding/exact_reals.hpp"

#include "analysis/graph/real_words.hpp"
#include "analysis/graph/substitution.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

Node written(RealWords<Graph>& words, const NodeData& node, Graph::Bits a, Graph::Bits b) {
  switch (node.op) {
    case Op::RealAdd: return words.add(a, b).node;
    case Op::RealSub: return words.sub(a, b).node;
    case Op::RealMul: return words.mul(a, b).node;
    case Op::RealDiv: return words.div(a, b).node;
    case Op::RealFunction: return words.sqrt(a).node;
    case Op::RealEqual: return words.equal(a, b).node;
    case Op::RealLess: return words.less(a, b).node;
    case Op::RealLegal: return words.legal(a).node;
    case Op::RealFromInt: return words.fromInt(a).node;
    case Op::RealToInt: return words.toInt(a, node.value != 0).node;
    default: CHECK(false, "not a REAL operation");
  }
  return noNode;
}

}  // namespace

bool isExactReal(const NodeData& node) {
  return isRealOperation(node.op) && node.op != Op::LongReal &&
         (node.op != Op::RealFunction || static_cast<RealFunction>(node.value) == RealFunction::Sqrt);
}

TransitionSystem withExactReals(const TransitionSystem& system, RealScope scope) {
  RealWords<Graph> words(*system.graph);
  Substitution write(*system.graph, {}, [&](const NodeData& node, const std::array<Node, 3>& child) {
    const bool isMeant = scope == RealScope::All ? isExactReal(node) : isRealComparison(node.op);
    return isMeant ? written(words, node, {child[0]}, {child[1]}) : noNode;
  });
  TransitionSystem result = system;
  for (StateVariable& state : result.states) state.next = write(state.next);
  for (std::vector<Node>* nodes : {&result.constraints, &result.totalConstraints}) {
    for (Node& n : *nodes) n = write(n);
  }
  for (Question& question : result.questions) question.bad = write(question.bad);
  return result;
}

}  // namespace rungproof
