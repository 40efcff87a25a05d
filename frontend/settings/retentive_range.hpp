// Ranges of memory as settings name them: retentive ones of the system block, "VB0..VB99", "MB14", "T0..T31",
// "C0..C255", "DB10.DBB0..DBB19", and the memory of libraries. Tested by tests/smart/retentive_test.cpp and
// contract_test.cpp.
#pragma once

#include <optional>
#include <string_view>

#include "engine/start_up.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Nothing if the text names no bytes of V, M or one data block and no timers or counters.
std::optional<RetentiveRange> retentiveRangeNamed(std::string_view text);
/// "VB1000..VB1285", or "MBUS_SLAVE=VB1000..VB1778" for one block; nothing if the text names no bytes of V.
std::optional<LibraryMemory> libraryMemoryNamed(std::string_view text);

/// The number of "MB100"; nothing if the text names no byte of M.
std::optional<std::uint32_t> clockMemoryNamed(std::string_view text);

}  // namespace rungproof
