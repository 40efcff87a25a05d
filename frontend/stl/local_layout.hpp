// Places of parameters and local variables in L memory: in the order of CALL (IN, IN_OUT, OUT, then TEMP) from L0.0,
// up to eight consecutive BOOLs in one byte, everything else at the next byte without alignment (001:6815-6823).
// A STRING is a pointer of four bytes (001:6804). Tested by tests/reader/table_test.cpp.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

/// Bytes of local memory of a block (001:1362).
inline constexpr std::uint32_t localMemoryBytes = 64;

/// Sorts the rows into the order of CALL and gives each its L address. Returns the number of bytes used, which may
/// exceed localMemoryBytes.
std::uint32_t layOutLocals(std::vector<LocalVariable>& locals);

/// "BOOL", "WORD" ... in any case, or nothing.
std::optional<DataType> dataTypeNamed(std::string_view name);
std::string_view dataTypeName(DataType type);

}  // namespace rungproof
