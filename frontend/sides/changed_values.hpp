// With which values two programs begin, where that differs: data blocks of an S7-300/400, V memory of an S7-200,
// variables of IEC 61131-3. Tested by tests/equivalence/changed_values_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

struct ValueChange {
  std::string name;           ///< "DB1.n", "VB100", "Line.Limit"
  std::string before, after;  ///< empty: there is none
};

std::vector<ValueChange> changedValues(const Program& before, const Program& after);
/// "DB1.n begins with 5 in place of 0".
std::string changeText(const ValueChange& change);

}  // namespace rungproof
