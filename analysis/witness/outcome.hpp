// The verdicts, as the prover gives them and reports show them.
#pragma once

#include <cstdint>

namespace rungproof {

enum class Outcome : std::uint8_t {
  Proved,
  Violated,
  Reachable,
  Unreachable,
  HoldsToBound,
  Vacuous,
  Unknown,
  NotCovered
};

}  // namespace rungproof
