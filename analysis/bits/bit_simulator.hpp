// Evaluates a BitSystem on 64 runs at once, one in each bit of a word. Tested by tests/solver/bit_system_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "analysis/bits/bit_system.hpp"

namespace rungproof {

class BitSimulator {
 public:
  explicit BitSimulator(const BitSystem& system)
      : system_(system), values_(system.variableCount(), 0), next_(system.latches.size(), 0) {}

  void setInput(std::size_t index, std::uint64_t lanes) { values_[system_.inputs[index]] = lanes; }
  void setLatch(std::size_t index, std::uint64_t lanes) { values_[system_.latches[index].variable] = lanes; }
  std::uint64_t latch(std::size_t index) const { return values_[system_.latches[index].variable]; }
  std::uint64_t input(std::size_t index) const { return values_[system_.inputs[index]]; }
  /// Computes all gates from the current latches and inputs.
  void evaluate() {
    for (std::size_t i = 0; i < system_.gates.size(); ++i) evaluate(i);
  }
  /// Computes these gates only, each after those that it depends on.
  void evaluate(std::span<const std::uint32_t> gates) {
    for (const std::uint32_t gate : gates) evaluate(gate);
  }
  /// Moves the latches to their next values; evaluate() must have been called.
  void step() {
    for (std::size_t i = 0; i < next_.size(); ++i) next_[i] = value(system_.latches[i].next);
    for (std::size_t i = 0; i < next_.size(); ++i) setLatch(i, next_[i]);
  }
  std::uint64_t value(Lit l) const { return values_[variableOf(l)] ^ (isNegative(l) ? ~0ULL : 0); }

 private:
  void evaluate(std::size_t gate) {
    values_[system_.gateVariables[gate]] = value(system_.gates[gate].left) & value(system_.gates[gate].right);
  }

  const BitSystem& system_;
  std::vector<std::uint64_t> values_;  ///< by variable
  std::vector<std::uint64_t> next_;
};

}  // namespace rungproof
