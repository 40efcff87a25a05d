// Memory of this process and machine. Covered by tests/timing/limits_test.cpp.
#pragma once

#include <cstdint>

namespace rungproof {

/// Resident memory of this process in bytes; 0 where the system does not tell.
std::uint64_t residentBytes();
/// What the allocator keeps for later goes back to the system.
void returnUnusedMemory();
/// Three quarters of the machine's memory, in bytes; 0 where the system does not tell.
std::uint64_t usualMemoryLimit();

}  // namespace rungproof
