// Where predicates come from: the comparisons that stand in the program and in the property, then what the same words
// could be compared with - words and constants that flow into each other or meet in a comparison - and the linear
// equations that hold in all sampled states. The second kind is a store from which refinement takes what it needs.
// Tested by tests/words/terms_test.cpp.
#pragma once

#include <vector>

#include "analysis/words/predicates.hpp"

namespace rungproof {

/// State variables of width 1 and the comparisons over states that stand in the system; those behind choices between
/// terms are taken apart. Adds nodes to the cone's graph.
std::vector<Node> syntacticPredicates(WordCone& cone);

/// Comparisons of words with the words and constants of their kind, at most `limit`.
std::vector<Node> orderPredicates(WordCone& cone, std::size_t limit);

/// Equations a x + b y + ... = c between words, with as few words as possible, that hold in all `samples` (states of
/// the cone), the initial state excepted. None if the samples are too few to mean anything.
std::vector<Node> linearPredicates(WordCone& cone, const std::vector<WordState>& samples);

}  // namespace rungproof
