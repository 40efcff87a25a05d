// A witness as people read it: a trace of the engine's run, and a table of the scans that matter with inputs first.
// Stretches in which nothing but time passes are one row. Tested by tests/prover and tests/golden.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/proof/prover.hpp"
#include "engine/trace.hpp"

namespace rungproof {

struct Context;

/// File names made of the names of properties; no two properties get the same one.
class EvidenceNames {
 public:
  std::string of(std::string_view name);

 private:
  std::set<std::string> given_;
};

/// A file in a folder that is made if it is not there.
std::string evidenceFile(const std::string& folder, const std::string& name);

/// Longer runs than that lose their beginning in a trace. A counter that counts down to the end of its range and back
/// needs 131,072 scans.
inline constexpr std::size_t mostTraceRows = 1'000'000;

/// Every scan of the run with the given signals; at most `limit` rows, the last ones. `hidesIdle`: inputs that do not
/// matter have no value, for the table; a stimulus has to have them, and outputs as `sim` shows them.
Trace traceOf(const Program& program, const Choices& choices, const Witness& witness,
              const std::vector<TraceSignal>& signals, std::size_t limit = mostTraceRows, bool hidesIdle = false);

/// The inputs that matter to the witness first (those it sets, if that is not known), then the addresses of the
/// property, each once.
std::vector<TraceSignal> signalsThatMatter(const Program& program, const ProofResult& result);

/// "V0.0 = 1, VW20 = 1001": what the program touches and has another value at the start than after a loss of memory;
/// empty if there is nothing.
std::string startText(const Program& program, const Choices& choices, const Witness& witness);

/// Writes the witness as CSV (also a stimulus), VCD and SVG into a folder; gives the name of the CSV file. `notes`:
/// what is to be said of it.
std::string writeRun(const Context& context, const std::string& folder, const std::string& stem, const Program& program,
                     const Choices& choices, const ProofResult& result, std::vector<std::string>& notes);

/// Lines of a table: scan, time at its end, interrupts at their places if there are any, values. Runs of equal rows are
/// drawn together; at most `rows` rows.
std::vector<std::string> tableOf(const Trace& trace, std::size_t rows = 24);

}  // namespace rungproof
