// EntryValues: what cells hold whenever an interrupt routine begins, for the cells that pointers of routines are made
// of. A routine that is looked at alone knows nothing else of the memory (routine_effects.hpp); the encoding of the
// scan shows that it is so at each place where routines can come (scan_interrupts.cpp). Covered by
// tests/environment/routine_pointer_test.cpp.
#pragma once

#include <algorithm>
#include <bit>
#include <map>

#include "analysis/encoding/pointer_values.hpp"
#include "analysis/encoding/symbolic_store.hpp"

namespace rungproof {

/// A cell that may hold any value is not in it, or with all values.
using EntryValues = std::map<Place, ValueSet>;

/// Adds the values of the same cells, and cells that are missing. Gives whether anything was new.
inline bool join(EntryValues& values, const EntryValues& more) {
  bool isNew = false;
  for (const auto& [place, set] : more) {
    if (ValueSet& known = values[place]; !known.includes(set)) isNew = known.join(set, pointerValueLimit) || isNew;
  }
  return isNew;
}

/// Bits that hold each of the values of a cell of that width.
inline int bitsFor(const ValueSet& values, int width) {
  return std::clamp(static_cast<int>(std::bit_width(values.facts().high)), 1, width);
}

}  // namespace rungproof
