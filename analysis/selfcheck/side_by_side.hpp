// SideBySide: random runs of a program and of its faulty copies, hundreds of traces at once in vector registers
// (engine/lanes). Where a copy drives other outputs than the program, the fault matters; and the traces in which it
// does are those in which a property may notice it, so these alone are followed one by one. Only what the reference
// engine has repeated is told. Covered by tests/selfcheck.
#pragma once

#include <string>
#include <vector>

#include "analysis/proof/prover.hpp"
#include "analysis/witness/run_space.hpp"
#include "engine/lanes/many_traces.hpp"

namespace rungproof {

class SideBySide {
 public:
  /// Makes the runs of the program itself. It must outlive this.
  SideBySide(const Program& program, const PropertySet& set, const ProverOptions& options);

  struct Seen {
    std::string where;      ///< the first output that differs, "Q0.1 in scan 3"; empty: none was seen
    std::string noticedBy;  ///< name of a property that does not hold; empty: none was seen
  };
  /// The same runs of a copy. `asked`: properties that hold in all runs of the program.
  Seen look(const Program& copy, const std::vector<const Property*>& asked) const;
  /// Scans that are compared; 0: the program is not fit for vector code, and nothing is ever seen.
  std::size_t scanCount() const { return outputs_.size(); }

 private:
  using TraceSet = ManyTraces::TraceSet;
  /// Scans with the same inputs.
  struct Phase {
    std::uint32_t lengthMs, repeats;
    std::vector<TraceSet> bits;                     ///< by bit input: the traces in which it is on
    std::vector<std::vector<std::uint64_t>> words;  ///< by other input and trace
  };
  struct Suspect {
    std::size_t trace, scan, output;
  };
  std::vector<Phase> drawnPhases(std::uint64_t seed) const;
  void give(ManyTraces& traces, const Phase& phase) const;
  std::vector<Suspect> suspectsOf(ManyTraces& traces) const;
  std::vector<ReplayScan> scansOf(std::size_t trace, std::size_t count) const;
  bool isConfirmed(const Program& copy, const Suspect& suspect) const;
  std::string noticedIn(const Program& copy, std::size_t trace, const std::vector<const Property*>& asked) const;

  const Program& program_;
  const Choices choices_;
  const TimeRange time_;
  std::vector<Property> assumptions_;
  std::vector<Operand> bits_, words_, watched_;  ///< inputs; output bits that are compared
  std::vector<std::uint64_t> constants_;         ///< that words are set to
  std::vector<Phase> phases_;
  std::vector<std::vector<TraceSet>> outputs_;  ///< by scan and watched output: the traces in which it is on
};

}  // namespace rungproof
