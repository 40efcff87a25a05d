// What a call of a block without text leaves at a place, as an index of External::LibraryOutput.
#pragma once

#include <cstdint>
#include <optional>

#include "ir/area.hpp"

namespace rungproof {

/// External::LibraryOutput of something that is no parameter: what a call without text leaves at a place.
struct LibraryEffect {
  Area area = Area::V;            ///< AC: number 4 is ENO
  std::uint32_t at = 0;           ///< byte or number
  std::optional<unsigned> bit{};  ///< nothing: the whole byte or number

  static constexpr std::uint32_t eno = 4;
  constexpr std::uint32_t index() const {
    return (static_cast<std::uint32_t>(area) + 1) << 24 | (bit ? (*bit + 1) << 20 : 0U) | at;
  }
};
/// The effect behind an index; nothing: it is the place of a parameter.
constexpr std::optional<LibraryEffect> libraryEffect(std::uint32_t index) {
  if (index >> 24 == 0) return std::nullopt;
  LibraryEffect effect{static_cast<Area>((index >> 24) - 1), index & 0xFFFFF};
  if (const std::uint32_t bit = index >> 20 & 0xF; bit != 0) effect.bit = bit - 1;
  return effect;
}

}  // namespace rungproof
