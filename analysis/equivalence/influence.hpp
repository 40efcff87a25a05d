// What a network can influence: the cells that it writes, the networks that read these, and so on; jumps, calls and ends
// reach the code that they decide on. Wider than what happens, never narrower. Tested by tests/equivalence.
#pragma once

#include <vector>

#include "analysis/equivalence/network_match.hpp"
#include "analysis/facts.hpp"

namespace rungproof {

/// What a set of networks can influence.
struct Influence {
  std::vector<bool> cells;     ///< by cell (AccessIndex::cells())
  std::vector<Address> outputs;  ///< bits of Q and AQ, in order
  std::vector<Operand> memory;   ///< the places of V, M, S, T and C that are written, as the program writes them
  bool isEverything = false;   ///< it writes through a pointer whose targets are not known here, or stops the program
};

Influence influenceOf(const Facts& facts, const std::vector<NetworkRef>& networks);

}  // namespace rungproof
