// The value of a direct operand in a state of the machine, read and set from outside the program.
// Covered by tests/engine/replay_test.cpp.
#pragma once

#include <cstdint>

#include "engine/concrete.hpp"

namespace rungproof {

/// I and Q from the image; T and C by width (Bit: the bit, Word: the current value); AI, AQ words; HC double words.
std::uint64_t cellValue(const Concrete::Store& store, const Operand& operand);

/// Sets it as the surroundings would: I the physical inputs, which the next scan reads; everything else the cell
/// itself.
void setCell(Concrete::Store& store, const Operand& operand, std::uint64_t value);
/// Whether the surroundings may give a high-speed counter a value: HSC has enabled it (001:4302), else it keeps its
/// own.
bool takesCounts(const Concrete::Store& store, const Operand& counter);

}  // namespace rungproof
