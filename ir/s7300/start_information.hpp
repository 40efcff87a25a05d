// The fields of the start information that an organization block finds in the first 20 bytes of its local data
// (002:2000-2015, 002:1242, 002:1330; general knowledge but for OB1, OB40 and OB82), by their usual names.
// Tested by tests/step7/organization_block_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "ir/area.hpp"

namespace rungproof::s7300 {

struct StartField {
  int block = 0;  ///< number of the organization block
  std::uint32_t byte = 0;
  std::uint8_t bit = 0;
  Width width = Width::Byte;
};

/// "OB40_POINT_ADDR" in any case of letters; nothing if no block has such a field.
std::optional<StartField> startFieldNamed(std::string_view name);

}  // namespace rungproof::s7300
