// Value change dumps (IEEE 1364, clause 18), as simulators, logic analysers and waveform viewers write them, to a table
// of times and values: one row for every time at which something changes, and one for the end. x and z are open. Words
// and double words are signed, as the S7-200 takes them. A dump that rungproof has written gives its scans back.
// Tested by tests/trace/vcd_test.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/logger/csv_table.hpp"
#include "frontend/logger/trace_import.hpp"

namespace rungproof {

/// Whether the text begins as a value change dump does.
bool looksLikeVcd(std::string_view text);

/// Variables of one name in several scopes are named with their scopes ("top.press.start"). Times are cut to whole us;
/// of several changes within one us the last counts. `import` may give the unit where there is no $timescale.
CsvTable readVcd(const std::string& name, std::string_view text, const TraceImport& import,
                 std::vector<Failure>& failures);

}  // namespace rungproof
