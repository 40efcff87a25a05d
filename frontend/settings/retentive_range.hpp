// Retentive ranges of the system block as settings name them: "VB0..VB99", "MB14", "T0..T31", "C0..C255". Tested by
// tests/smart/retentive_test.cpp.
#pragma once

#include <optional>
#include <string_view>

#include "engine/start_up.hpp"

namespace rungproof {

/// Nothing if the text names no bytes of V or M and no timers or counters.
std::optional<RetentiveRange> retentiveRangeNamed(std::string_view text);

}  // namespace rungproof
