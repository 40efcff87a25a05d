// Runs that the prover has found as test tables, so that what was mended stays mended. Tested by
// tests/tables/witness_table_test.cpp.
#pragma once

#include "analysis/property.hpp"
#include "analysis/witness/witness.hpp"
#include "engine/testing/test_table.hpp"

namespace rungproof {

/// The run as one test. `broken`: the property that its last scan violates; the inputs are set, and the last step
/// expects what the property asks of outputs (asked_values.hpp), nothing else, as nobody knows what else a mended
/// program does. nullptr: the run is right; its outputs are expected where the length of scans does not decide them.
TestTable witnessTable(const Program& program, const PropertySet& set, const Choices& choices, const Witness& witness,
                       const std::string& name, const Property* broken);

}  // namespace rungproof
