// Which variables of IEC 61131-3 programs stand for each other: those of one name, wherever they lie. In a program of
// another family it is the symbol of that name, or the address at which the variable is declared. Outputs of programs
// and located outputs are what is compared.
// Tested by tests/iec/equivalence_test.cpp.
#pragma once

#include <vector>

#include "frontend/files/failure.hpp"
#include "frontend/sides/sides.hpp"

namespace rungproof {

/// Pairs what has no partner yet, and observes the outputs where nothing else is asked for. An output that one program
/// lacks is a failure.
void pairVariables(Sides& sides, std::vector<Failure>& failures);

/// The same where one program is of IEC 61131-3 and the other is not.
void pairWithOtherFamily(Sides& sides, std::vector<Failure>& failures);

}  // namespace rungproof
