// 64 random runs at once that keep the constraints: the source of samples for candidate invariants and of quick
// violations. A quarter of the runs chooses all inputs anew in each scan, others keep them for about 8, 64 or 1024
// scans, because timers and sequences need inputs that stay. Tested by tests/solver/simulation_test.cpp.
#pragma once

#include <random>
#include <vector>

#include "analysis/bits/bit_simulator.hpp"
#include "analysis/bits/engine_contract.hpp"

namespace rungproof {

class SimulationRuns {
 public:
  SimulationRuns(const BitSystem& system, std::uint64_t seed);
  /// Back to (random) initial states.
  void restart();
  /// Chooses the inputs of the next scan and evaluates it. Runs whose constraints could not be met end: their bit
  /// leaves live(). False when no run is left.
  bool choose();
  /// After choose(): moves to the next state.
  void step() { simulator_.step(); }
  const BitSimulator& simulator() const { return simulator_; }
  std::uint64_t live() const { return live_; }
  std::mt19937_64& random() { return random_; }

 private:
  std::uint64_t sparse(int halvings);
  std::uint64_t violating();
  void redraw(std::uint64_t wrong, const std::vector<std::uint64_t>& before, bool keep);
  void takeSamples(std::uint64_t wrong, std::size_t attempt);
  void collectSamples();

  const BitSystem& system_;
  BitSimulator simulator_;
  std::mt19937_64 random_;
  std::uint64_t live_ = ~0ULL;
  bool fresh_ = true;
  BitSimulator::Course ofConstraints_, others_;  ///< gates that the constraints depend on, and those left
  std::vector<std::vector<bool>> samples_;       ///< inputs that meet the constraints in the initial state
};

}  // namespace rungproof
