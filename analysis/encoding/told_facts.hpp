// ToldFacts: what an encoding that follows a trail (trail.hpp) was told on its way and does not see by itself, as facts
// about its nodes: that conditions have the value which decided the flow, that lists of the targets of pointers are
// complete, that interrupt routines leave what was said of them. If all of them hold in every scan, the encoding is the
// one that nobody had to tell anything: the first fact that a scan broke would be about nodes that are still right.
// Proofs about the encoding show them (analysis/proof/told_proof.hpp). Tested by tests/certificate.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// Nodes of width 1 that are 1 in every scan.
struct ToldFacts {
  std::vector<Node> conditions;
  std::vector<Node> pointers;
  std::vector<Node> effects;
  /// By state variable (index): what was known of it at the start of every scan, which these rest on.
  std::unordered_map<std::uint32_t, std::vector<Node>> known;

  bool areNone() const { return conditions.empty() && pointers.empty() && effects.empty(); }
};

}  // namespace rungproof
