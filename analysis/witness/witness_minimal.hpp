// Smaller witnesses: fewer scans, no interrupts that are not needed, scans of an everyday length where the length does
// not matter, no values at the start and no inputs that do not matter. Scans are left out and changed as long as the
// engine still shows the same; what may have any value, alone and together with all others that may, does not matter.
// "Any value" is tried with random values for all of them together, so it is an observation of the engine and no proof.
// Covered by tests/prover/witness_test.cpp.
#pragma once

#include "analysis/witness/witness.hpp"

namespace rungproof {

/// The witness without scans that are not needed; Witness::matters is filled in and idle inputs are 0. Stops after
/// `seconds` with what it has by then; a witness that could not be tried in that time comes back without `matters`.
/// `plainMs`: the everyday length of a scan, within the range that the witness keeps.
Witness minimised(const Judge& judge, Witness witness, std::uint32_t plainMs, double seconds, std::uint64_t seed);
/// Only the interrupts that are not needed are taken out: for long witnesses.
Witness withoutIdleEvents(const Judge& judge, Witness witness, double seconds);

}  // namespace rungproof
