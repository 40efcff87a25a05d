// A recorded or simulated trace as a test table, so that a mended fault stays mended: what the inputs did is set, what
// the outputs did is expected, one row for each stretch in which nothing of both changes. Tested by
// tests/tables/test_command_test.cpp.
#pragma once

#include <cstdint>
#include <string>

#include "analysis/property.hpp"
#include "engine/testing/test_table.hpp"

namespace rungproof {

/// A stretch of one scan that is longer than usual: one scan, or its time.
enum class LongScan : std::uint8_t { Scan, Time };

/// `name`: of the test. Columns of the trace that are no inputs and no outputs are passed over.
TestTable recordedTable(const Program& program, const PropertySet& set, const Trace& trace, const std::string& name,
                        LongScan single = LongScan::Scan);

}  // namespace rungproof
