// Reads stimulus and trace files. The first column is `scan` or `time_ms`; `scan_ms`,
// `event`, `device` (what devices write: nothing else comes from them then), `given` and `start` (all of it:
// given_columns.hpp) have their own meaning; every other
// column is an address, a symbol, "T37.value", an output of a library block
// ("USS_CTRL.Speed"), or a device: "HSC0.pulses", "HSC0.down", "PORT0.receive", "NET.error", "NET.hold". A file with
// time_ms behind scan is a recorded trace: as a stimulus it sets the inputs, and memory that the program does not
// write; what the program computes is passed over. Other files (loggers, VCD) come as tables in this form from
// frontend/logger. Mistakes become failures with file, line and column. Tested by
// tests/trace/stimulus_test.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/stimulus.hpp"
#include "engine/trace.hpp"
#include "frontend/files/failure.hpp"
#include "frontend/logger/trace_import.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Reads a stimulus for a program. With failures, the result is not to be used. `side`: "old" or "new": in a trace of
/// two programs (rungproof equiv) the columns "old.I0.0" and "new.I0.0" belong to one of them; those of the other one
/// are passed over.
Stimulus readStimulus(const std::string& name, std::string_view text, const Program& program,
                      std::vector<Failure>& failures, std::string_view side = "old", const TraceImport& import = {});

/// Reads an expected or recorded trace; columns become signals of the program.
Trace readTrace(const std::string& name, std::string_view text, const Program& program, std::vector<Failure>& failures,
                std::string_view side = "old", const TraceImport& import = {});

/// Reads a trace without a program: a column that is an address or one of the symbols, or both with a blank between
/// them, is that address; others keep their names and are numbers.
Trace readTrace(const std::string& name, std::string_view text, std::vector<Failure>& failures,
                const TraceImport& import = {}, std::span<const Symbol> symbols = {});

}  // namespace rungproof
