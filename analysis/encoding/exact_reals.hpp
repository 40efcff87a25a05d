// REAL operations of a transition system, written out in words (graph/real_words.hpp), so that engines which know bits
// only decide them exactly. States, inputs and questions stay where they are: runs and certificates of the result are
// those of the original. Sine, cosine, tangent, logarithm and exponential stay what they are.
// Covered by tests/prover/real_test.cpp and tests/differential/real_words_test.cpp.
#pragma once

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

constexpr bool isRealOperation(Op op) { return op >= Op::RealAdd; }
/// Comparisons and the test for legal numbers: short enough to be written out always.
constexpr bool isRealComparison(Op op) { return op == Op::RealEqual || op == Op::RealLess || op == Op::RealLegal; }
/// Whether the operation can be written out.
bool isExactReal(const NodeData& node);

enum class RealScope : std::uint8_t { Comparisons, All };
/// Adds nodes to the system's graph.
TransitionSystem withExactReals(const TransitionSystem& system, RealScope scope);

}  // namespace rungproof
