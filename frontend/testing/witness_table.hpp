// Runs that the prover has found as test tables, so that what was mended stays mended. Tested by
// tests/tables/witness_table_test.cpp.
#pragma once

#include "analysis/property.hpp"
#include "analysis/witness/witness.hpp"
#include "engine/testing/test_table.hpp"

namespace rungproof {

/// The run as one test: its inputs are set, its outputs expected. `broken`: the property that its last scan violates;
/// there an output is expected to be the other way round where that alone keeps the property, and otherwise those that
/// the property reads are left to whoever mends it. nullptr: the run is right.
TestTable witnessTable(const Program& program, const PropertySet& set, const Choices& choices, const Witness& witness,
                       const std::string& name, const Property* broken);

}  // namespace rungproof
