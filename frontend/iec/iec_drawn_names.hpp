// Which variables the parts of a drawing read and write, and whether the order of two results matters.
// Tested by tests/iec/open_readings_test.cpp.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "frontend/graphical/drawn_circuit.hpp"

namespace rungproof::iec {

/// A function block with an instance of its own.
bool isInstance(const DrawnElement& element);

/// Names, in capitals and without what follows a point or a bracket, of all that leads to an element, and of what the
/// element and the blocks on the way write.
struct NamesUsed {
  std::set<std::string> read, written;
  std::size_t looked = 0;  ///< elements
};

/// The names in a text.
void addNames(const std::string& text, std::set<std::string>& names);
NamesUsed namesUsed(const DrawnCircuit& circuit, int result);

/// What results have written so far and their circuits read.
class WrittenNames {
 public:
  explicit WrittenNames(const DrawnCircuit& circuit);

  void note(int result);
  /// Whether the flow at an element reads a variable that a result of its circuit has written.
  bool areReadAt(int element);

 private:
  /// What the flow at an element reads, and how far the list of its circuit was looked at.
  struct Reading {
    std::set<std::string> names;
    std::size_t asked = 0;
    bool isOfWritten = false;
  };
  const DrawnCircuit* circuit_;
  std::set<std::pair<int, std::string>> unwritten_;  ///< by circuit: what contacts and pins read
  std::map<int, std::vector<std::string>> written_;  ///< by circuit: what they read, in the order of writing
  std::map<int, Reading> readings_;
};

/// Whether two results that stand in another order in `other` have to do with each other.
bool ordersDiffer(const DrawnCircuit& circuit, const std::vector<int>& order, const std::vector<int>& other);

}  // namespace rungproof::iec
