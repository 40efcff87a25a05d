// What a statement of an S7-300/400 takes from registers and what it leaves there: the ways by which networks hand on
// more than memory. Part of statement_influence.hpp.
#pragma once

#include <cstdint>

#include "ir/program.hpp"

namespace rungproof {

namespace registers {
using Mask = std::uint16_t;
/// RLO with STA, OR and the nesting stack; BR; CC1, CC0, OV, OS; the accumulators; the rest by their names.
inline constexpr Mask rlo = 1, br = 2, result = 4, accu1 = 8, accu2 = 16, furtherAccus = 32, ar1 = 64, ar2 = 128,
                      db = 256, di = 512, all = 1023, accus = accu1 | accu2 | furtherAccus;
}  // namespace registers

struct RegisterUse {
  registers::Mask reads = 0, writes = 0;
  registers::Mask set = 0;  ///< of what is written: whatever stood there before
};

/// `goesOn`: the RLO may be that of a string of logic that has begun before.
RegisterUse registerUse(const Instruction& instruction, bool goesOn);

}  // namespace rungproof
