// Code that no interrupt can divide: between DISI and ENI (001:5331-5333, 001:5434-5440).
// Tested by the examples of INT004 and tests/rules/output_rules_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

/// By instruction: 1 between DISI and ENI of its block.
std::vector<std::uint8_t> protectedCode(const Facts& facts);

}  // namespace rungproof
