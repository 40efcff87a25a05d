// The transition system and the reference engine on one program: the same inputs, times and external values, and what
// they differ in after each scan.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/encoding/encoder.hpp"

namespace rungproof {

struct AgreementOutcome {
  std::string difference;  ///< empty: both sides agree
  int scans = 0;
  bool isExact = true;   ///< false: the encoder approximated, so the run proves nothing
  bool isWhole = false;  ///< nothing lies outside the cone: not compared
};

/// Random inputs for that many scans. `asked`: places that are compared alone; empty: all that the program touches.
AgreementOutcome compareScans(const Program& program, std::uint64_t seed, int scanCount, const EncoderOptions& options,
                              const std::vector<Place>& asked = {});

}  // namespace rungproof
