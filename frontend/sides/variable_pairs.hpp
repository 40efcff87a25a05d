// Two programs of IEC 61131-3: variables stand for each other by their names, wherever they lie. Outputs of programs
// and located outputs are what is compared. Tested by tests/iec/equivalence_test.cpp.
#pragma once

#include <vector>

#include "frontend/files/failure.hpp"
#include "frontend/sides/sides.hpp"

namespace rungproof {

/// Pairs what has no partner yet, and observes the outputs where nothing else is asked for. An output that one program
/// lacks is a failure.
void pairVariables(Sides& sides, std::vector<Failure>& failures);

}  // namespace rungproof
