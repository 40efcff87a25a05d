// Caps of words: a word that only counts up to what it is compared with may stop there. With the largest constant that
// the value is compared with in program and properties as its cap, nothing that is asked about can tell the difference,
// and the word needs fewer bits. Whether that is so is not read from the program's form but decided: for every value of
// the word, everything else that a scan computes must be the same for the capped value, and the capped word must count
// alike. So a value that flows into arithmetic, a move that is read elsewhere, or a comparison with a larger constant
// refuses the cap. A proof about the capped system becomes one about the given system, with min(word, cap) for the
// word. Tested by tests/solver/word_caps_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/bits/engine_contract.hpp"
#include "analysis/graph/transition_system.hpp"

namespace rungproof {

struct CappedWord {
  std::size_t state = 0;  ///< index in the states of both systems
  std::uint64_t cap = 0;
  Node given = noNode;   ///< the word of the given system
  Node narrow = noNode;  ///< its counterpart, just wide enough for the cap
  Node capped = noNode;  ///< min(given, cap) in the width of `narrow`
  Node range = noNode;   ///< given < 2^(width - 1), which every scan keeps
};

struct CappedSystem {
  TransitionSystem system;  ///< same graph, inputs and constraints, the questions that were asked; states in order
  std::vector<CappedWord> words;  ///< empty: nothing to gain, `system` is the given one

  /// A node over states of `system` as one over states of the given system.
  Node onGivenSystem(Graph& graph, Node n) const;
};

/// Adds nodes to the graph. Words whose check does not end within the budget stay as they are.
CappedSystem capWords(const TransitionSystem& given, const Questions& questions, const Budget& budget);

}  // namespace rungproof
