// Trail: all that an encoding of a program has decided, so that the same program can be encoded a second time step by
// step alike, as it is written (Rewriting::None). The variables of both are the same, in the same order; the second has
// more of them, because cells that the first knows to keep their value stay variables there (KeptCell).
#pragma once

#include <memory>
#include <string>
#include <unordered_map>

#include "analysis/graph/graph.hpp"

namespace rungproof {

struct Knowledge;
class RoutineEffects;

struct Trail {
  bool isFollowed = false;  ///< false: it is being left
  Decisions decisions;
  std::shared_ptr<const Knowledge> knowledge;
  std::shared_ptr<const RoutineEffects> effects;   ///< of interrupt routines; nullptr: nothing is attached
  std::unordered_map<std::string, int> timeBases;  ///< of clocks, by property name
};

/// A cell that has the same value at the start of every scan: what the first encoding was built on is an invariant
/// that proofs about the second one must show.
struct KeptCell {
  Node node;
  std::uint64_t value;
};

}  // namespace rungproof
