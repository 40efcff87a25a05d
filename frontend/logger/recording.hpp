// A file of a logger, an oscilloscope or a simulator becomes a table in the project's own form: `time_ms` (or `scan`,
// `time_ms`, `scan_ms`) first, columns with the names that --rename gives, cells as plain numbers ("-", "n/a" and "NaN"
// of a logger are open); every cell keeps its place in the file. What cannot be read keeps its text, and the reader of
// the table says so. Tested by tests/trace/logger_test.cpp and tests/trace/vcd_test.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/logger/csv_table.hpp"
#include "frontend/logger/trace_import.hpp"

namespace rungproof {

/// Reads CSV in any of its forms, or VCD. Bytes may be UTF-8 with or without byte order mark, UTF-16 or CP1252.
CsvTable readRecording(const std::string& name, std::string_view bytes, const TraceImport& import,
                       std::vector<Failure>& failures);

/// A cell as the project writes it: "on" is 1, "0xFF" and "$FF" are 16#FF, and with
/// `hasDecimalComma` "1,5" is 1.5 and "1.234,5" is 1234.5. Any other text stays as it is.
std::string plainCell(std::string_view text, bool hasDecimalComma);

}  // namespace rungproof
