// Reads test tables: CSV with any separator and encoding that traces have. Columns: `test` (name; a new name begins
// with power-on, an empty cell continues the test above), `step` (text), `wait` (`1 scan`, `5 scans`, `500ms`; one scan
// where the cell is empty), `set ADDRESS`, `expect ADDRESS`, and at the end `note`, which is for people. Mistakes
// become failures with file, line and column. Tested by tests/tables/test_command_test.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/testing/test_table.hpp"
#include "frontend/files/failure.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// With failures the result is not to be used. `separator`: 0 is recognised.
TestTable readTestTable(const std::string& name, std::string_view bytes, const Program& program, char separator,
                        std::vector<Failure>& failures);

/// "5 scans", "500ms"; nothing for anything else.
std::optional<TestWait> waitNamed(std::string_view text);

/// The table as CSV, which reads back as the same.
std::string testTableText(const TestTable& table);

}  // namespace rungproof
