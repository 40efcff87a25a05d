// What blocks without text gave as outputs in a witness, as columns of its trace: "MBUS_MSG.Done", "SBR21.3", which a
// stimulus understands (stimulus_column.hpp). Only outputs that are 1 or a number in some scan have a column, and only
// where all calls of a scan agree, since a stimulus has one value for all of them. Tested by
// tests/smart/contract_test.cpp.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/witness/witness.hpp"
#include "engine/trace.hpp"

namespace rungproof {

class LibraryColumns {
 public:
  LibraryColumns(const Program& program, const Witness& witness);

  const std::vector<TraceSignal>& signals() const { return signals_; }
  /// By signal; nothing where the block is not called.
  std::vector<std::optional<TraceNumber>> valuesIn(std::size_t scan) const;

 private:
  std::vector<TraceSignal> signals_;
  std::vector<std::map<std::size_t, TraceNumber>> values_;  ///< by signal, by scan
};

/// Type of the values of an output in traces and stimuli.
SignalType signalTypeOf(DataType type);

}  // namespace rungproof
