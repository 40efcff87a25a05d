// Do two programs drive the same outputs? First it is tried to prove that one scan of either, from any state that the
// first can reach, leads to the same state and outputs: then all their runs are the same. Otherwise both run side by
// side on the same inputs and times, as one transition system; the bit-level engines look for a scan that ends with
// different outputs (simulation first) or prove that there is none. Covered by tests/selfcheck.
#pragma once

#include <string>

#include "analysis/proof/prover.hpp"

namespace rungproof {

enum class OutputComparison : std::uint8_t { Equal, Different, Undecided };

/// Whether it is proved that one scan of either, from any state that the left one can reach, does the same. Cheap, and
/// false where only a longer look could tell.
bool haveSameScans(const Program& left, const Program& right, const PropertySet& set, const ProverOptions& options,
                   double seconds);

/// Outputs are all bits of Q and AQ that either program has; compared at the ends of scans in which the assumptions of
/// `set` hold. Instructions with the same number stand for each other: ticks and interrupts come in front of both.
/// `where`, if given, receives for Different what differs: "Q0.1 in scan 3".
OutputComparison compareOutputs(const Program& left, const Program& right, const PropertySet& set,
                                const ProverOptions& options, double seconds, std::string* where = nullptr);

}  // namespace rungproof
