// The transition system and the reference engine on one program: the same inputs, times and external values, and what
// they differ in after each scan.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "analysis/encoding/encoder.hpp"

namespace rungproof {

struct AgreementOutcome {
  std::string difference;     ///< empty: both sides agree
  int scans = 0;              ///< that were compared
  bool isExact = true;        ///< false: the encoding is an estimate in the first scan already, which proves nothing
  std::string approximation;  ///< why something is estimated, a line each
  bool isWhole = false;       ///< nothing lies outside the cone: not compared
};

struct AgreementQuestion {
  EncoderOptions options;
  std::vector<Place> asked{};    ///< compared alone; empty: all that the program touches
  bool usesAllExternals = true;  ///< the engine reads every value that the run has from outside
  /// Hears each place with its value at the end of the first scan; may be empty.
  std::function<void(const Place&, std::uint64_t)> seen{};
};

/// Random inputs for that many scans.
AgreementOutcome compareScans(const Program& program, std::uint64_t seed, int scanCount,
                              const AgreementQuestion& question);

}  // namespace rungproof
