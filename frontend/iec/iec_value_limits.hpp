// Which variables keep the limits of their type. Tested by tests/iec/type_limits_test.cpp.
#pragma once

#include <cstdint>
#include <span>

#include "ir/program.hpp"

namespace rungproof::iec {

/// Fills ValueLimits::isKept and sources. `initial`: the bytes of V at the start.
void findKeptLimits(Program& program, std::span<const std::uint8_t> initial);

}  // namespace rungproof::iec
