// The columns `given` and `start` of a witness: all that the surroundings did in a scan and that no address tells, and
// what memory and registers held at the start. Whoever has them in a stimulus repeats the run exactly. A cell holds
// items with blanks between them, in the order in which the scan asks:
//   immediate[1]@12=1     a value that the instruction in line 12 asked for; the names of all kinds are in one table
//   tick@12=3             1 ms ticks in front of line 12; tick10=1, tick100=1: ticks of the time bases at the start
//   set.VB100=7           an input, or memory of external writers, before the scan; set.I[32]=7 a byte without address
// and in `start` NAME[index]=value for a register or, as memory.V[10]=3, for a byte. Tested by
// tests/trace/given_columns_test.cpp.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "analysis/witness/witness.hpp"
#include "engine/stimulus.hpp"
#include "frontend/files/failure.hpp"

namespace rungproof {

/// The word that a kind of external value has in the column.
std::string_view externalName(External kind);

/// A run beside its trace. `columns`: those that a stimulus of this program has, by their index in the trace.
struct GivenSide {
  const Program& program;
  const Choices& choices;
  const Witness& witness;
  std::vector<std::pair<std::size_t, TraceSignal>> columns;
};

/// The cells of the columns, by row.
struct GivenCells {
  std::vector<std::string> events, given;
  std::string start{};
};

GivenCells givenOf(const GivenSide& side, const Trace& trace);

/// Gives the trace of a witness, which has all its scans, the columns that make it a whole stimulus.
void addGiven(const Program& program, const Choices& choices, const Witness& witness, Trace& trace);

/// The same for a trace of two programs.
void addGivenOfTwo(const GivenSide& before, const GivenSide& after, Trace& trace);

/// Reads cells of the columns; remembers places, since scans name the same ones.
class GivenReader {
 public:
  explicit GivenReader(const Program& program) : program_(program) {}

  /// False: an item cannot be read; `failure` says which.
  bool readGiven(std::string_view cell, StimulusRow& row, Failure& failure);
  bool readStart(std::string_view cell, std::vector<StartValue>& start, Failure& failure) const;

 private:
  std::optional<ScanPlace> place(std::string_view text);
  bool readItem(std::string_view item, StimulusRow& row);

  const Program& program_;
  std::map<std::string, std::optional<ScanPlace>, std::less<>> places_{};
};

}  // namespace rungproof
