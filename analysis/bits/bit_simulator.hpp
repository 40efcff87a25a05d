// Evaluates a BitSystem on 64 runs at once, one in each bit of a word. Tested by tests/solver/bit_system_test.cpp.
#pragma once

#include <vector>

#include "analysis/bits/bit_system.hpp"

namespace rungproof {

class BitSimulator {
 public:
  /// Gates in an order in which each comes after those that it depends on.
  struct GateStep {
    Lit out, left, right;
  };
  using Course = std::vector<GateStep>;

  explicit BitSimulator(const BitSystem& system)
      : system_(system), values_(2 * system.variableCount(), 0), next_(system.latches.size(), 0) {
    set(falseLit, 0);
  }

  void setInput(std::size_t index, std::uint64_t lanes) { set(positive(system_.inputs[index]), lanes); }
  void setLatch(std::size_t index, std::uint64_t lanes) { set(positive(system_.latches[index].variable), lanes); }
  std::uint64_t latch(std::size_t index) const { return value(positive(system_.latches[index].variable)); }
  std::uint64_t input(std::size_t index) const { return value(positive(system_.inputs[index])); }
  /// Computes all gates from the current latches and inputs.
  void evaluate() {
    if (all_.empty()) {
      all_.reserve(system_.gates.size());
      for (std::uint32_t gate = 0; gate < system_.gates.size(); ++gate) all_.push_back(stepOf(gate));
    }
    evaluate(all_);
  }
  /// Computes these gates only.
  void evaluate(const Course& course) {
    for (const GateStep& step : course) set(step.out, values_[step.left] & values_[step.right]);
  }
  GateStep stepOf(std::uint32_t gate) const {
    return {positive(system_.gateVariables[gate]), system_.gates[gate].left, system_.gates[gate].right};
  }
  /// Moves the latches to their next values; evaluate() must have been called.
  void step() {
    for (std::size_t i = 0; i < next_.size(); ++i) next_[i] = value(system_.latches[i].next);
    for (std::size_t i = 0; i < next_.size(); ++i) setLatch(i, next_[i]);
  }
  std::uint64_t value(Lit l) const { return values_[l]; }

 private:
  void set(Lit literal, std::uint64_t lanes) {
    values_[literal] = lanes;
    values_[negate(literal)] = ~lanes;
  }

  const BitSystem& system_;
  std::vector<std::uint64_t> values_;  ///< by literal
  std::vector<std::uint64_t> next_;
  Course all_;  ///< once it has been asked for
};

}  // namespace rungproof
