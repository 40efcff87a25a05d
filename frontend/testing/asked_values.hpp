// What a property asks of outputs at the end of a test, of every program that keeps to it: whatever the outputs were
// before, and for scans of any length. Tested by tests/tables/witness_table_test.cpp.
#pragma once

#include <optional>
#include <vector>

#include "analysis/property.hpp"
#include "engine/simulator.hpp"
#include "engine/testing/test_table.hpp"

namespace rungproof {

/// By column of `table.expects`, for the last row of its one test; nothing: any value may be right. `program` gives
/// the inputs and the time; `lengths`: scans in us to be tried.
std::vector<std::optional<bool>> askedValues(const Program& program, const SimulatorOptions& engine,
                                             const TestTable& table, const Property& property,
                                             const std::vector<std::uint32_t>& lengths);

}  // namespace rungproof
