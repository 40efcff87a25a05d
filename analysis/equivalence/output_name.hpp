// The name of an output that was compared, as its program writes it.
// Tested by tests/iec/equivalence_test.cpp.
#pragma once

#include <optional>
#include <string>

#include "analysis/equivalence/address_pairs.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// IEC 61131-3: the variable at the address of the program. `name` where there is none, and in other families.
std::string outputName(const Program& program, const std::optional<Address>& address, const std::string& name);

}  // namespace rungproof
