// What SFC 39 locks and SFC 40 unlocks (002:2353): interrupts of all organization blocks, of a class of them, or of
// one. An event that comes while it is locked is lost, and nothing else follows from it; one that waited before still
// runs; calls of all priorities see the same locks, up to SFC 40 or the next start. Which MODE and OB_NR name what is
// general knowledge. The register that holds the block of an event holds the lock too, in its highest bit.
// Tested by tests/step7/interrupt_lock_test.cpp.
#pragma once

#include <cstdint>

#include "ir/block_event.hpp"

namespace rungproof {

inline constexpr std::uint64_t lockBit = 0x80;

/// Whether that content of Reg::EventRoutine says so.
constexpr bool isLocked(int event, std::uint64_t content) { return isBlockEvent(event) && (content & lockBit) != 0; }
/// Number of the routine or block + 1; 0: detached.
constexpr std::uint64_t routineIn(int event, std::uint64_t content) {
  return isBlockEvent(event) ? content & ~lockBit : content;
}
/// What OB_NR names a class by: OB81 to OB87 are of the class of OB80.
constexpr int lockClassOf(int block) { return block / 10 * 10; }

static_assert(blockOfEvent(blockEventEnd - 1) + 1 < static_cast<int>(lockBit), "the lock has a bit of its own");
static_assert(lockClassOf(35) == 30 && lockClassOf(87) == 80);

}  // namespace rungproof
