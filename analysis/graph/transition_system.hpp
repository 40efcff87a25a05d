// TransitionSystem: one scan as state, inputs, next state, constraints and bad states over a Graph. The encoder
// makes it from a program and its properties; reductions shrink it; engines answer questions about it; exports
// print it. Word level; bit_system.hpp is its bit-blasted form.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// A state variable: its value at the start of a scan, at the start of the first scan, and at the scan's end.
struct StateVariable {
  Node node = noNode;  ///< Op::Variable with isState
  Node init = noNode;  ///< a term without state variables; noNode: any value
  Node next = noNode;
};

/// A question: can `bad` be 1 in some scan of some run? `bad` ranges over state, inputs (and through them the
/// state after the scan, which the encoder has already substituted).
struct Question {
  std::string name;
  Node bad = noNode;
  std::size_t number = 0;  ///< its index in the system of the side that asks it, in parts of that system too
};

/// State variables that belong to one timer, as far as the program has them. A hint: nothing is believed for it.
struct TimerHint {
  Node bit = noNode, input = noNode, running = noNode;
  Node rest = noNode;     ///< of its time, where it counts down
  Node current = noNode;  ///< value, where it counts up
};

/// Questions of a system by their index there, which never changes: who answers a part of them is given a list.
using Questions = std::vector<std::size_t>;

struct TransitionSystem {
  Graph* graph = nullptr;
  std::vector<StateVariable> states;
  std::vector<Node> inputs;
  std::vector<Node> constraints;  ///< hold in every scan; a run that breaks one is no run
  /// Those of `constraints` that inputs of their own can meet in every state, or free initial values once and for all:
  /// they can be left out of the cone of a question that does not share variables with them.
  std::vector<Node> totalConstraints;
  std::vector<Question> questions;
  std::vector<TimerHint> timers;  ///< state variables that were reduced away may still be named
  /// What clocks and timers count by where every scan lasts as long: its ms, its ticks. A hint, as the timers are.
  std::vector<std::uint64_t> steadySteps;
};

inline Questions allQuestions(const TransitionSystem& system) {
  Questions all(system.questions.size());
  for (std::size_t q = 0; q < all.size(); ++q) all[q] = q;
  return all;
}

/// State variables (node indices) that the nodes depend on within one scan; REAL operations count as inputs.
std::unordered_set<std::uint32_t> statesUnder(const TransitionSystem& system, const std::vector<Node>& roots);

}  // namespace rungproof
