// Signal correspondence: state words that never change, or that equal another word (or its complement) in every
// reachable state, are replaced by it. What remains has the same runs with fewer words, so every engine gains. The
// equations are found on random runs and proved by induction, all together; they come along as invariants, so that a
// proof about the smaller system becomes one about the given system.
// Tested by tests/solver/merging_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/bits/engine_contract.hpp"
#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// `equation`: word = other, where `other` is a constant or made of words that were not replaced.
struct Replaced {
  Node word = noNode, other = noNode, equation = noNode;
};

struct MergedSystem {
  TransitionSystem
      system;  ///< same graph and inputs, the questions that were asked; words that were replaced are missing
  std::vector<std::size_t> kept;  ///< by state of `system`: its index in the given system
  std::vector<Replaced> facts;    ///< over states of the given system, inductive together
};

/// Equations of those facts that can matter for nodes over states of the given system: an inductive subset.
std::vector<Node> factsBehind(const TransitionSystem& given, const std::vector<Replaced>& facts,
                              const std::vector<Node>& roots);

/// Adds nodes to the graph. When the budget ends, nothing is merged.
MergedSystem mergeStates(const TransitionSystem& given, const Questions& questions, std::uint64_t seed,
                         const Budget& budget);

}  // namespace rungproof
