// Whether one of two programs may stop for the length of a scan alone: execution times are no part of the product, so
// that a loop which only one of them has, and which may outlast the watchdog, leaves equality open.
// Tested by tests/equivalence/guards_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/equivalence/network_match.hpp"

namespace rungproof {

struct LongScans {
  /// Loops that may outlast the watchdog (CTL004) in networks that the other program does not have.
  std::vector<std::string> ofOne;
  bool areInBoth = false;  ///< such a loop stands in both programs
};

LongScans longScansOf(const Program& before, const Program& after, const ProgramMatch& match);

}  // namespace rungproof
