// Small random systems of words, and a plain exhaustive search of them: all states, all inputs, by evaluation. Shares
// no code with the engine but the evaluation of nodes.
#pragma once

#include <map>
#include <optional>
#include <random>
#include <set>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/graph/evaluate.hpp"
#include "tests/solver/families.hpp"

namespace rungproof::words {

/// Values by state.
using Values = std::vector<std::uint64_t>;

/// Evaluates one scan of a system.
class Scan {
 public:
  explicit Scan(const TransitionSystem& system) : system_(system), evaluator_(*system.graph, rootsOf(system)) {}
  /// False if a constraint is broken.
  bool run(const Values& state, const Values& inputs) {
    for (std::size_t i = 0; i < state.size(); ++i) evaluator_.set(system_.states[i].node, state[i]);
    for (std::size_t i = 0; i < inputs.size(); ++i) evaluator_.set(system_.inputs[i], inputs[i]);
    evaluator_.run();
    for (const Node n : system_.constraints) {
      if (evaluator_[n] == 0) return false;
    }
    return true;
  }
  bool isBad(std::size_t question = 0) const { return evaluator_[system_.questions[question].bad] != 0; }
  Values next() const {
    Values result;
    for (const StateVariable& s : system_.states) result.push_back(evaluator_[s.next]);
    return result;
  }

 private:
  static std::vector<Node> rootsOf(const TransitionSystem& system) {
    std::vector<Node> roots = system.constraints;
    for (const Question& q : system.questions) roots.push_back(q.bad);
    for (const StateVariable& s : system.states) roots.insert(roots.end(), {s.node, s.next});
    roots.insert(roots.end(), system.inputs.begin(), system.inputs.end());
    return roots;
  }
  const TransitionSystem& system_;
  Evaluator evaluator_;
};

/// All tuples of values of these nodes.
inline std::vector<Values> allValues(const Graph& graph, const std::vector<Node>& nodes) {
  std::vector<Values> result{{}};
  for (const Node n : nodes) {
    std::vector<Values> longer;
    for (const Values& v : result) {
      for (std::uint64_t value = 0; value <= Graph::maskOf(graph[n].width); ++value) {
        longer.push_back(v);
        longer.back().push_back(value);
      }
    }
    result = std::move(longer);
  }
  return result;
}

inline std::vector<Node> stateNodes(const TransitionSystem& system) {
  std::vector<Node> nodes;
  for (const StateVariable& s : system.states) nodes.push_back(s.node);
  return nodes;
}

inline bool isInitial(const TransitionSystem& system, const Values& state) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Node init = system.states[i].init;
    if (init != noNode && (*system.graph)[init].value != state[i]) return false;
  }
  return true;
}

/// Length - 1 of the shortest violating run of the first question; nothing if bad is unreachable.
inline std::optional<int> shortestViolation(const TransitionSystem& system) {
  Scan scan(system);
  const std::vector<Values> inputs = allValues(*system.graph, system.inputs);
  std::set<Values> reached;
  std::vector<Values> layer;
  for (const Values& state : allValues(*system.graph, stateNodes(system))) {
    if (isInitial(system, state) && reached.insert(state).second) layer.push_back(state);
  }
  for (int depth = 0; !layer.empty(); ++depth) {
    std::vector<Values> following;
    for (const Values& state : layer) {
      for (const Values& chosen : inputs) {
        if (!scan.run(state, chosen)) continue;
        if (scan.isBad()) return depth;
        Values next = scan.next();
        if (reached.insert(next).second) following.push_back(std::move(next));
      }
    }
    layer = std::move(following);
  }
  return std::nullopt;
}

/// Does the run keep all constraints, begin in an initial state and end in a bad scan?
inline bool isViolation(const TransitionSystem& system, const WordTrace& trace, std::size_t question = 0) {
  if (!isInitial(system, trace.initial) || trace.inputs.empty()) return false;
  Scan scan(system);
  Values state = trace.initial;
  for (const Values& inputs : trace.inputs) {
    if (!scan.run(state, inputs)) return false;
    state = scan.next();
  }
  return scan.isBad(question);
}

/// Do the clauses hold initially, are they kept by every scan, and do they exclude bad? Tries every state and input.
inline bool isInductive(const TransitionSystem& system, const std::vector<std::vector<Node>>& clauses) {
  Graph& graph = *system.graph;
  Node invariant = graph.constantNode(1, 1);
  for (const std::vector<Node>& clause : clauses) {
    Node some = graph.constantNode(0, 1);
    for (const Node n : clause) some = graph.make(Op::Or, 1, some, n);
    invariant = graph.make(Op::And, 1, invariant, some);
  }
  const Node roots[] = {invariant};
  Evaluator evaluator(graph, roots);
  const auto holds = [&](const Values& state) {
    for (std::size_t i = 0; i < state.size(); ++i) evaluator.set(system.states[i].node, state[i]);
    evaluator.run();
    return evaluator[invariant] != 0;
  };
  Scan scan(system);
  const std::vector<Values> inputs = allValues(graph, system.inputs);
  for (const Values& state : allValues(graph, stateNodes(system))) {
    const bool inside = holds(state);
    if (isInitial(system, state) && !inside) return false;
    if (!inside) continue;
    for (const Values& chosen : inputs) {
      if (scan.run(state, chosen) && (scan.isBad() || !holds(scan.next()))) return false;
    }
  }
  return true;
}

/// Up to three words of 2 to 4 bits, a truth value, up to two inputs; arithmetic, comparisons and choices between them;
/// sometimes a constraint. Words are often kept or counted, so that there is something to be reached.
inline families::Family randomWords(std::mt19937& random) {
  families::Family f;
  Graph& g = *f.graph;
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  const int width = 2 + static_cast<int>(below(3));
  std::vector<Node> words, truths;
  std::vector<Node> states;
  for (std::uint32_t i = 1 + below(width == 4 ? 2 : 3); i > 0; --i)
    states.push_back(f.state("w" + std::to_string(i), width, below(1U << width)));
  for (std::uint32_t i = below(3); i > 0; --i) states.push_back(f.state("b" + std::to_string(i), 1, below(2)));
  if (below(4) == 0) f.system.states[0].init = noNode;
  for (const Node n : states) (g[n].width == 1 ? truths : words).push_back(n);
  truths.push_back(f.input("i"));
  if (below(2) == 0) words.push_back(f.input("j", width));
  words.push_back(f.number(below(1U << width), width));
  words.push_back(f.number(1, width));
  const auto word = [&] { return words[below(static_cast<std::uint32_t>(words.size()))]; };
  const auto truth = [&] {
    const Node n = truths[below(static_cast<std::uint32_t>(truths.size()))];
    return below(2) == 0 ? f.no(n) : n;
  };
  for (std::uint32_t i = 4 + below(10); i > 0; --i) {
    switch (below(6)) {
      case 0: words.push_back(g.make(below(2) == 0 ? Op::Add : Op::Sub, width, word(), word())); break;
      case 1: words.push_back(f.choose(truth(), word(), word())); break;
      case 2: truths.push_back(g.make(Op::Equal, 1, word(), word())); break;
      case 3: truths.push_back(g.make(below(2) == 0 ? Op::Ult : Op::Slt, 1, word(), word())); break;
      case 4: truths.push_back(f.both(truth(), truth())); break;
      default: words.push_back(f.choose(truth(), g.make(Op::Add, width, word(), f.number(1, width)), word())); break;
    }
  }
  for (const Node n : states) {
    if (g[n].width == 1)
      f.next(n, truth());
    else
      f.next(n, below(2) == 0 ? f.choose(truth(), word(), n) : word());
  }
  if (below(4) == 0) f.system.constraints.push_back(f.either(truth(), truth()));
  Node bad = truth();
  for (std::uint32_t i = 1 + below(3); i > 0; --i)
    bad = f.both(bad, below(3) == 0 ? g.make(Op::Equal, 1, word(), f.number(below(1U << width), width)) : truth());
  f.ask("bad", bad);
  return f;
}

}  // namespace rungproof::words
