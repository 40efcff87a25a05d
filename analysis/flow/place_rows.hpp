// Rows of places, and what is known of each place in all memory: what a network writes and reads, followed through a
// program forwards (influence.hpp) and backwards (cone_of_influence.hpp). Tested by tests/prover.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "analysis/flow/access.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7200/event.hpp"

namespace rungproof {

/// A row of bits of an area; of numbers for T, C, AC and HC, whose bits and values belong together.
struct PlaceRow {
  Area area = Area::V;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// `elements` elements of that width from an address on.
constexpr PlaceRow rowOf(Area area, Width width, std::uint32_t offset, unsigned bit, std::uint32_t elements = 1) {
  if (addressedByNumber(area)) return {area, offset, elements};
  if (width == Width::Bit) return {area, offset * 8 + bit, elements};
  return {area, offset * 8, elements * static_cast<std::uint32_t>(bits(width))};
}
/// What a direct operand names.
inline PlaceRow rowOf(const Operand& direct) { return rowOf(direct.area, direct.width, direct.offset, direct.bit); }
/// All that the access may touch.
inline PlaceRow rowOf(const Access& access) {
  return rowOf(access.area, access.width, access.offset, access.bit, access.most);
}

constexpr bool meet(const PlaceRow& a, const PlaceRow& b) {
  return a.area == b.area && a.first < b.first + b.count && b.first < a.first + a.count;
}

/// SM1.0 to SM1.7, written by every instruction whose descriptor names status bits.
inline constexpr PlaceRow resultBits{Area::SM, 8, 8};
/// SM4.0 to SM4.7: a run-time error of any instruction sets SM4.3 (001:13945).
inline constexpr PlaceRow errorBits{Area::SM, 32, 8};

/// Whether one of the timers T32 and T96 is among them, which raise events (001:5476).
constexpr bool raisesEvents(const PlaceRow& row) {
  for (std::uint32_t i = 0; row.area == Area::T && i < row.count; ++i) {
    if (eventOfTimer(row.first + i) >= 0) return true;
  }
  return false;
}

/// A value for each place of a CPU; Value() until it is set.
template <class Value>
class PlaceMap {
 public:
  explicit PlaceMap(const Target& target) {
    for (std::size_t a = 0; a < areaCount; ++a) {
      const Area area = static_cast<Area>(a);
      places_[a].resize(static_cast<std::size_t>(areaSize(target, area)) * rowOf(area, Width::Byte, 0, 0).count);
    }
  }

  /// Gives the value to all places of the row that have none; whether there were some.
  bool set(const PlaceRow& row, Value value) {
    bool isNew = false;
    for (std::size_t i = row.first; i < end(row); ++i) {
      Value& known = at(row.area)[i];
      isNew = isNew || known == Value();
      if (known == Value()) known = value;
    }
    return isNew;
  }
  /// The first value in the row; Value() if there is none.
  Value first(const PlaceRow& row) const {
    for (std::size_t i = row.first; i < end(row); ++i) {
      if (places_[static_cast<std::size_t>(row.area)][i] != Value())
        return places_[static_cast<std::size_t>(row.area)][i];
    }
    return Value();
  }

 private:
  std::vector<Value>& at(Area area) { return places_[static_cast<std::size_t>(area)]; }
  std::size_t end(const PlaceRow& row) const {
    return std::min<std::size_t>(places_[static_cast<std::size_t>(row.area)].size(),
                                 std::size_t{row.first} + row.count);
  }
  std::array<std::vector<Value>, areaCount> places_;
};

}  // namespace rungproof
