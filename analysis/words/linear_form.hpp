// Equations between sums in a normal form, choice by choice: after a scan in which x grew and y shrank by one, x + y =
// 100 is the same node as before it, and no solver has to find that out with adders. Tested by
// tests/words/linear_form_test.cpp.
#pragma once

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// A node (width 1) equal to `n`. An equation of words becomes a choice, under the conditions that stand in its terms,
/// between equations "sum of terms = sum of terms + constant", terms in the order of their numbers, the first one on
/// the left. Whatever else `n` is, and equations with too many choices, stay as they are.
Node linearForm(Graph& graph, Node n);

/// The same for all equations under a node.
Node linearForms(Graph& graph, Node n);

}  // namespace rungproof
