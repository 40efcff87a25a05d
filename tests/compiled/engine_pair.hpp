// One program on both engines: the same inputs and scan lengths, and after every scan the same state, errors and time.
#pragma once

#include <string>

#include "engine/simulator.hpp"
#include "tests/differential/random_source.hpp"

namespace rungproof::test {

struct PairOutcome {
  std::string difference;  ///< empty: none
  int scans = 0;
  std::uint64_t compiled = 0;  ///< scans of which machine code ran the program
};

struct PairOptions {
  int scans = 60;
  std::uint32_t longestUs = 30000;
  /// Scans follow scripts that name no place in them, as random runs of the prover do; that of the reference engine has
  /// an event where the program never is, so that it looks in front of every instruction.
  bool isScripted = false;
  bool writesMemory = true;  ///< somebody writes into M and these 128 bytes between the scans
  Area words = Area::V;
  std::uint32_t firstByte = 0;
  SimulatorOptions engine{};
};

/// What two runs differ in: memory, registers, time, errors; empty: in nothing.
std::string firstDifference(const Simulator& reference, const Simulator& compiled);

PairOutcome runBoth(const Program& program, RandomSource& random, const PairOptions& options = {});

}  // namespace rungproof::test
