// How long the comparisons of random programs with plain C++ are, and texts as the engine holds them.
// RUNGPROOF_IEC_SCANS: how many scans, for longer runs; RUNGPROOF_SEED: the first seed.
#pragma once

#include <cstdlib>

#include "tests/iec/iec_run.hpp"

namespace rungproof {

struct RandomCampaign {
  RandomCampaign(std::uint64_t usualScans, std::uint64_t scansOfEachProgram, std::uint64_t usualSeed)
      : scansOfEach(scansOfEachProgram) {
    const char* const asked = std::getenv("RUNGPROOF_IEC_SCANS");
    const char* const first = std::getenv("RUNGPROOF_SEED");
    const std::uint64_t scans = asked == nullptr ? usualScans : std::strtoull(asked, nullptr, 10);
    firstSeed = first == nullptr ? usualSeed : std::strtoull(first, nullptr, 10);
    lastSeed = firstSeed + (scans + scansOfEach - 1) / scansOfEach;
  }

  std::uint64_t scansOfEach, firstSeed, lastSeed;  ///< lastSeed: the first that is not run
};

/// Behind the length of a text its characters lie.
inline std::string textOf(const IecRun& run, const std::string& name) {
  Operand at = run.place(name + ".length");
  std::string characters(run.simulator.read(at), ' ');
  for (char& c : characters) {
    ++at.offset;
    c = static_cast<char>(run.simulator.read(at));
  }
  return characters;
}

}  // namespace rungproof
