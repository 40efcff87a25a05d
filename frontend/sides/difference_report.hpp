// A run on which two programs differ, for people: a table of the scans that matter, the trace of inputs and both
// outputs, and the networks that drive the differing output in either program, lit. Tested by tests/equivalence.
#pragma once

#include <string>

#include "analysis/equivalence/equivalence.hpp"
#include "engine/testing/test_table.hpp"
#include "engine/trace.hpp"
#include "frontend/report.hpp"
#include "frontend/sides/sides.hpp"

namespace rungproof {

class DifferenceReport {
 public:
  DifferenceReport(const Sides& sides, const EquivalenceOptions& options, const EquivalenceRun& run)
      : sides_(sides), options_(options), run_(run) {}

  /// Fills in scan, signal, values, the table and the drawings; `form`: ladder, fbd, stl or none; `width`: of a drawing
  /// in columns.
  void describe(Comparison& comparison, const std::string& form, int width = 100) const;
  /// Inputs and outputs of the run. What only one program has, or has otherwise, stands under "old.Q0.0", "new.Q0.0".
  Trace trace() const;
  /// The run as a test that OLD passes and NEW does not.
  TestTable table() const;

 private:
  /// Columns of both runs: those that are alike in both, then OLD's, then NEW's.
  Trace joined(const std::vector<TraceSignal>& common, std::vector<TraceSignal> before,
               std::vector<TraceSignal> after) const;
  /// Inputs that are not 0 all the time: alike in both programs, OLD's own, NEW's own.
  struct Inputs {
    std::vector<TraceSignal> common, before, after;
  };
  Inputs inputs() const;
  std::string lastChange(const Trace& table, std::size_t inputs) const;

  const Sides& sides_;
  const EquivalenceOptions& options_;
  const EquivalenceRun& run_;
};

}  // namespace rungproof
