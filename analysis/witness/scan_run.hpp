// A run of an encoded scan on numbers, scan by scan, and its script for the reference engine: what the variables mean
// outside the graph. Counterexamples are replayed through it, and the differential tests drive both sides with it.
// Covered by tests/differential/scan_agreement_test.cpp.
#pragma once

#include <vector>

#include "analysis/encoding/encoder.hpp"
#include "analysis/encoding/scan_inputs.hpp"
#include "analysis/encoding/seen_states.hpp"
#include "analysis/graph/evaluate.hpp"
#include "engine/replay.hpp"

namespace rungproof {

class ScanRun {
 public:
  /// `system` must come from scan.system(); `watched`: further nodes whose values are wanted.
  ScanRun(const EncodedScan& scan, const TransitionSystem& system, std::span<const Node> watched = {});

  /// State at power-up; states with any initial value are 0 until set().
  void start();
  /// A state variable or an input of the scan to come.
  void set(Node variable, std::uint64_t value) { values_.set(variable, value); }
  /// Computes the scan. Gives whether all constraints hold, that is, whether it is one.
  bool evaluate();
  std::uint64_t operator[](Node n) const { return values_[n]; }
  /// Goes on to the next scan: its state becomes this scan's result. Inputs keep their values.
  void advance();

  /// The state before the scan as the engine has it: power-up, with what initially may be anything as it was set.
  Concrete::Store initialState() const;
  /// The evaluated scan as a script for the engine.
  ReplayScan script() const;
  /// Whether script() is another one than when this was asked last; true at first.
  bool isScriptNew();

 private:
  static std::vector<Node> scriptNodes(const EncodedScan& scan);
  static std::vector<Node> rootsOf(const EncodedScan& scan, const TransitionSystem& system,
                                   std::span<const Node> watched);
  bool holds(Node n) const { return values_[n] != 0; }
  ScanPlace placeOf(const BoundarySite& site) const;

  const EncodedScan& scan_;
  const TransitionSystem& system_;
  const std::vector<ScanInput> inputs_;
  Evaluator values_;
  std::vector<std::pair<Node, std::uint64_t>> ofScript_;  ///< what script() reads, and its value when that was new
};

}  // namespace rungproof
