// What a scan adds to a word, under which conditions: "1 where network 3 runs, less 1 where network 4 does". Two words
// that give to each other what they take have changes that cancel out by their form, whatever the conditions are.
// Tested by tests/solver/sums_test.cpp.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// What is added, and where: the nodes of an amount and of a condition (width 1; noNode: always). Constants are not
/// negative as numbers with sign.
struct AddedPart {
  Node condition = noNode, amount = noNode;
  friend auto operator<=>(const AddedPart&, const AddedPart&) = default;
};

/// How often each part is added, less how often it is taken away, in the program's order.
using AddedParts = std::vector<std::pair<AddedPart, int>>;

struct WordChange {
  AddedParts parts;
  Node counts = noNode;  ///< of width 1: else the word becomes something else altogether (noNode: always)
};

/// By which `next` differs from `word` where it counts. Nothing where it never is a sum of the word. Adds nodes to the
/// graph.
std::optional<WordChange> changeOf(Graph& graph, Node word, Node next);

}  // namespace rungproof
