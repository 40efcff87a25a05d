// A run on which two programs differ, for people: a table of the scans that matter, the trace of inputs and both
// outputs, and the networks that drive the differing output in either program, lit. Tested by tests/equivalence.
#pragma once

#include <string>

#include "analysis/equivalence/equivalence.hpp"
#include "engine/trace.hpp"
#include "frontend/report/report.hpp"
#include "frontend/sides/sides.hpp"

namespace rungproof {

class DifferenceReport {
 public:
  DifferenceReport(const Sides& sides, const EquivalenceOptions& options, const EquivalenceRun& run)
      : sides_(sides), options_(options), run_(run) {}

  /// Fills in scan, signal, values, the table and the drawings; `form`: ladder, fbd, stl or none.
  void describe(Comparison& comparison, const std::string& form) const;
  /// All inputs of the run, then the outputs of OLD under their names and those of NEW as "new.Q0.0".
  Trace trace() const;

 private:
  Trace joined(const std::vector<TraceSignal>& inputs, const std::vector<TraceSignal>& before,
               const std::vector<TraceSignal>& after) const;
  std::vector<TraceSignal> inputsOfRun() const;
  std::string lastChange(const Trace& table, std::size_t inputs) const;

  const Sides& sides_;
  const EquivalenceOptions& options_;
  const EquivalenceRun& run_;
};

}  // namespace rungproof
