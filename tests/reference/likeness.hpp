// A machine of the tests and the naive interpreter side by side: the same state in both, one scan of both, and what
// differs afterwards. Used by the random tests of this folder.
#pragma once

#include <string>

#include "naive.hpp"
#include "tests/manual/plant.hpp"

namespace rungproof::reference {

/// Gives the naive interpreter the state of the plant: memory, registers, the world outside.
void copyState(const manual::Plant& plant, naive::Interpreter& plain);

/// What differs between the two after a scan, or nothing. `last`: the instruction whose REAL result may differ in its
/// last bit, because the manual does not say how it is computed; nullptr: none.
std::string difference(manual::Plant& plant, naive::Interpreter& plain, const Instruction* last);

/// Whether two REAL results are the same number but for rounding of intermediate results of that size.
bool isClose(std::uint32_t a, std::uint32_t b, double least = 1e-30);

}  // namespace rungproof::reference
