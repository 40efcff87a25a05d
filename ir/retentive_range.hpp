// What keeps its value without power.
#pragma once

#include <cstdint>

#include "ir/area.hpp"

namespace rungproof {

/// Bytes of V, M or DB, or numbers of T or C, first to last, that keep their values without power (001:1534).
struct RetentiveRange {
  Area area;
  std::uint32_t first;
  std::uint32_t last;
};

}  // namespace rungproof
