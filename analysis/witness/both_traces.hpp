// BothTraces: what the solver predicts of a run and what the engine makes of it, side by side as text: the evidence
// that is printed when they do not agree (`prove`, exit 2).
// Covered by tests/prover/disagreement_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/witness/witness.hpp"

namespace rungproof {

struct BothTraces {
  std::vector<std::string> solver;  ///< "scan 1 (10 ms): I0.0=1 Q0.0=0"
  std::vector<std::string> engine;
};

/// Values at the ends of the last scans of a run of `system` (that of `encoding`, possibly with fewer questions):
/// those of the addresses, and the inputs that the run sets to something else than 0.
BothTraces bothTracesOf(const Program& program, EncodedScan& encoding, const TransitionSystem& system,
                        const WordTrace& trace, const Operands& addresses);

}  // namespace rungproof
