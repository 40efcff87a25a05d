// A program through every command that reads programs, each in a process of its own, so that a crash of one is a result
// and not the end of the test.
#pragma once

#include <string>

#include "tests/damage/seed_programs.hpp"

namespace rungproof::test {

struct EveryCommandLimits {
  unsigned seconds = 60;             ///< of the processor, for all commands together
  std::string timeout = "1s";        ///< of the prover, per question
  std::size_t memory = 3ULL << 30U;  ///< bytes
};

/// What a program must not do: end by a signal, disagree with itself, or end with 0 (or run) over code that is unread.
/// Empty: it did nothing of it. Sets `isSlow` if the time was over, which is no fault here.
std::string faultOf(const SeedProgram& program, const EveryCommandLimits& limits, bool& isSlow);

}  // namespace rungproof::test
