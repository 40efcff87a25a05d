// Sums of words that properties ask for: accounts that give to each other, parts of a stock. What a scan makes of such
// a sum follows from what it adds to each word (word_change.hpp), by form; solvers that are told so need not add up.
// And guesses of what is kept: the sums as the properties have them, and the ranges in which nothing overflows.
// Tested by tests/solver/sums_test.cpp.
#pragma once

#include <vector>

#include "analysis/graph/transition_system.hpp"
#include "analysis/recheck/kept_difference.hpp"

namespace rungproof {

/// What presumably follows in a scan, or of the state after it.
struct GuideNode {
  Node node = noNode;
  bool isAfter = false;
};

struct AskedSums {
  std::vector<KeptSum> sums;
  std::vector<Node> theorems;    ///< of width 1 over states and inputs, one for each sum: 1 whatever these are
  std::vector<GuideNode> guide;  ///< of width 1: words that count become what they are said to, and so on
  std::vector<Node> guesses;     ///< of width 1 over states
};

/// Adds nodes to the graph, all over variables that the questions depend on.
AskedSums sumsAskedFor(const TransitionSystem& system, const Questions& questions);

}  // namespace rungproof
