// Which variables the parts of a drawing read and write, and whether the order of two results matters.
// Tested by tests/iec/open_readings_test.cpp.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "frontend/graphical/drawn_circuit.hpp"

namespace rungproof::iec {

/// A function block with an instance of its own.
bool isInstance(const DrawnElement& element);

/// Names, in capitals and without what follows a point or a bracket, of all that leads to an element, and of what the
/// element and the blocks on the way write.
struct NamesUsed {
  std::set<std::string> read, written;
};

/// The names in a text.
void addNames(const std::string& text, std::set<std::string>& names);
NamesUsed namesUsed(const DrawnCircuit& circuit, int result);

/// Whether two results that stand in another order in `other` have to do with each other.
bool ordersDiffer(const DrawnCircuit& circuit, const std::vector<int>& order, const std::vector<int>& other);

}  // namespace rungproof::iec
