// What any number of runs of some interrupt routines, in any order, can leave in the places that they write. The
// routines are run once on a state of which nothing is known; then
//   - if one run after the other in a fixed order leaves what all others leave (each is the same when it is repeated,
//   and
//     they may change places), one run of each is enough, and nothing has to be estimated;
//   - otherwise bounds and rules are sought that every run keeps (run_bounds.hpp, kept_states.hpp). What none of them
//   tells of may become anything.
// Pointers of a routine lead where the values of the cells that they are made of allow: all of this is true of routines
// that begin with these values (entry_values.hpp), and each run keeps them.
// Covered by tests/environment.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "analysis/encoding/memory_layout.hpp"
#include "analysis/encoding/run_bounds.hpp"
#include "analysis/encoding/symbolic_store.hpp"

namespace rungproof {

class RoutineEffects {
 public:
  /// What is looked at.
  struct Given {
    std::set<int> routines{};        ///< numbers of interrupt routines that the program has
    bool isOfDevices = false;        ///< some of their events bring values of a device, so that no run is as another
    std::vector<Expr> statements{};  ///< of which runs may keep some
    EntryValues entry{};             ///< that routines are known to begin with, at least
    bool followsPointers = true;
  };
  RoutineEffects(const Plan& plan, const MemoryLayout& layout, const Given& given);

  /// One run of each in any fixed order stands for all sequences of runs.
  bool isOnePassEnough() const { return isOnePassEnough_; }
  /// False: a routine writes through pointers or loops in a way that cannot be told here; places() is not complete.
  bool isComplete() const { return isComplete_; }
  /// What a routine writes, in cells of the layout. Saved and restored places and local memory are left out.
  const std::vector<Place>& places(int routine) const { return written_.at(routine); }
  /// Whether a routine can end the program by a fatal error.
  bool mayHalt(int routine) const { return halting_.contains(routine); }
  /// What any number of runs keeps.
  const RunBounds& bounds() const { return bounds_; }
  /// What this rests on: the values that cells may have where a routine begins. Each run keeps them.
  const EntryValues& entry() const { return entry_; }

  /// What all this says, as nodes of a graph of the program as it is written that are 1 whatever the memory holds: the
  /// routines are run once more without simplification. By routine: it writes nothing else, it does not end the
  /// program; then that runs repeat and change places, or by routine and bound, that one run from a state within all
  /// bounds ends within it.
  std::vector<Node> asFacts(Graph& graph, const Plan& plan, const MemoryLayout& layout) const;
  /// A mistake that tests plant: says that no routine writes the place.
  void forget(const Place& place);

 private:
  class Trial;
  void closeEntry(const Plan& plan, const MemoryLayout& layout, const std::set<int>& routines);
  void findBounds(Trial& trial, const Plan& plan, const MemoryLayout& layout, const std::vector<Expr>& statements);
  std::vector<Node> facts(Trial& trial) const;

  bool isOnePassEnough_ = true;
  bool isComplete_ = true;
  std::map<int, std::vector<Place>> written_;
  std::set<int> halting_;
  RunBounds bounds_;
  EntryValues entry_;
  std::map<std::vector<int>, Decisions> runs_;  ///< what each sequence of runs was told
};

}  // namespace rungproof
