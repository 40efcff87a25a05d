// LoopWidening: what stands for the rounds of a loop that are too many to be followed one by one. Where a loop reaches
// its limit, all that its rounds write takes any value, and one more round is followed from there: it stands for every
// later one, and what leaves the loop in it for every later way out. If that round writes more than was known, this
// becomes free as well and another round follows; otherwise nothing new can come, and who still goes on turns for ever.
//
// Why this is sound: let W be what has been made free at the head of the loop and let the round that follows write
// nothing but W. A real round begins with a state that agrees with a free one outside W, hence it also ends with one;
// by induction all later rounds do, and each of their ways out is one of the free round.
// Covered by tests/prover/loop_test.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "analysis/encoding/symbolic_store.hpp"
#include "ir/families/run.hpp"

namespace rungproof {

class LoopWidening {
 public:
  /// A place has been written.
  void note(const Place& place);
  /// Something has happened that is more than a write of known places: loops that are under way are left out.
  void block();
  /// A branch that closes a loop: Instruction::id, and whether an interrupt routine has come to it.
  using Branch = std::pair<std::uint32_t, bool>;

  /// The loop has come to its limit: nothing is known of it yet.
  void enter(Branch branch) { loops_.erase(branch); }
  /// What becomes of the loop that `branch` closes; `scr`: what the SCR stack holds there. With Follow, freed() and, if
  /// freesScr(), the SCR stack have to become free.
  RoundsLeft next(Branch branch, Node scr);
  /// All that the rounds of that loop have written, as places that do not overlap, the widest first.
  std::vector<Place> freed(Branch branch) const;
  /// Whether its rounds change the SCR stack.
  bool freesScr(Branch branch) const;

 private:
  struct Loop {
    std::set<Place> written;  ///< as the instructions wrote it
    std::set<Place> parts;    ///< the same bit by bit, registers whole: what is free at its head
    std::set<Place> later;    ///< written since then and not free
    Node scr = noNode;        ///< what the SCR stack held at the branch, until it becomes free
    bool isBlocked = false;
  };
  std::map<Branch, Loop> loops_;  ///< that are beyond their limit
};

}  // namespace rungproof
