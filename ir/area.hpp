// The memory areas of the CPU and what can be done with each: one row per area, asked by its properties. Who wants to
// know whether an area is addressed by number, is an output or outlives a power failure asks here and names no area.
// Areas and addressing: 001:1267-1431, pointers 001:1459-1478. Limits stand in ir/s7200/cpu_tables.hpp
// and ir/s7300/cpu.hpp.
// Tested by tests/ir/area_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rungproof {

enum class Area : std::uint8_t { I, Q, AI, AQ, V, M, S, SM, L, T, C, AC, HC, DB, PI, PQ };
inline constexpr int areaCount = 16;

/// Access width. Word accesses to T, C, AI, AQ and double word accesses to HC are the only ones there; only variables
/// of IEC 61131-3 are 64 bits wide.
enum class Width : std::uint8_t { Bit, Byte, Word, DWord, LWord };
constexpr int bits(Width w) { return w == Width::Bit ? 1 : 4 << static_cast<int>(w); }
constexpr int bytes(Width w) { return w == Width::Bit ? 1 : bits(w) / 8; }
/// The width that holds 1, 8, 16, 32 or 64 bits.
constexpr Width widthOfBits(int bits) {
  return bits == 1    ? Width::Bit
         : bits == 8  ? Width::Byte
         : bits == 16 ? Width::Word
         : bits == 32 ? Width::DWord
                      : Width::LWord;
}

/// What an area is for.
enum class AreaUse : std::uint8_t {
  Input,        ///< comes from the terminals
  Output,       ///< goes to the terminals
  Memory,       ///< the program's own, alike for all blocks
  System,       ///< written by the CPU too
  Local,        ///< belongs to one run of a block (001:1367)
  Element,      ///< timers, counters
  Accumulator,  ///< handed on from instruction to instruction
  Device        ///< the value of a fast counter
};

/// How an area is addressed.
enum class Addressing : std::uint8_t {
  Bytes,     ///< I0.0, IB0, IW0, ID0
  Words,     ///< AIW0: words at even byte numbers only
  Elements,  ///< T37: a number that has a bit and a word
  Numbers    ///< AC1, HC0: a number that has one value
};

struct AreaInfo {
  Area area;
  std::string_view name;  ///< letters of the international mnemonics
  AreaUse use;
  Addressing addressing;
  std::optional<Width> width;         ///< the only one its value has; a bit beside it: Addressing::Elements
  bool mayRetain;                     ///< a range of it can be kept over a power failure (001:1534)
  bool mayBeForced;                   ///< 001:7956
  bool mayHoldPointer;                ///< 001:1459
  std::optional<std::uint8_t> tag{};  ///< high byte of a pointer that names it; none: no pointer can (001:1461)
};

// clang-format off
inline constexpr std::array<AreaInfo, areaCount> areaTable = {{
    // area     name   use                   addressed by          width         retain forced holds  tag
    {Area::I,  "I",  AreaUse::Input,       Addressing::Bytes,    {},           false, true,  false, 0x00},
    {Area::Q,  "Q",  AreaUse::Output,      Addressing::Bytes,    {},           false, true,  false, 0x01},
    {Area::AI, "AI", AreaUse::Input,       Addressing::Words,    Width::Word,  false, true,  false, 0x02},
    {Area::AQ, "AQ", AreaUse::Output,      Addressing::Words,    Width::Word,  false, true,  false, 0x03},
    {Area::V,  "V",  AreaUse::Memory,      Addressing::Bytes,    {},           true,  true,  true,  0x08},
    {Area::M,  "M",  AreaUse::Memory,      Addressing::Bytes,    {},           true,  true,  false, 0x04},
    {Area::S,  "S",  AreaUse::Memory,      Addressing::Bytes,    {},           false, false, false, 0x06},
    {Area::SM, "SM", AreaUse::System,      Addressing::Bytes,    {},           false, false, false, 0x05},
    {Area::L,  "L",  AreaUse::Local,       Addressing::Bytes,    {},           false, false, true,  {}},
    {Area::T,  "T",  AreaUse::Element,     Addressing::Elements, Width::Word,  true,  false, false, 0x09},
    {Area::C,  "C",  AreaUse::Element,     Addressing::Elements, Width::Word,  true,  false, false, 0x0A},
    {Area::AC, "AC", AreaUse::Accumulator, Addressing::Numbers,  Width::DWord, false, false, true,  {}},
    {Area::HC, "HC", AreaUse::Device,      Addressing::Numbers,  Width::DWord, false, false, false, {}},
    // S7-300/400: data blocks (byte numbers: ir/block_map.hpp) and modules without their image.
    {Area::DB, "DB", AreaUse::Memory,      Addressing::Bytes,    {},           true,  true,  false, {}},
    {Area::PI, "PI", AreaUse::Input,       Addressing::Bytes,    {},           false, false, false, {}},
    {Area::PQ, "PQ", AreaUse::Output,      Addressing::Bytes,    {},           false, false, false, {}},
}};
// clang-format on

constexpr const AreaInfo& areaInfo(Area area) { return areaTable[static_cast<std::size_t>(area)]; }
/// Letters of an area as the international mnemonics write it: "I", "Q", "AI", "SM".
constexpr std::string_view areaName(Area area) { return areaInfo(area).name; }

/// Areas as a set of bits, so that a question in a hot loop is a shift.
using AreaSet = std::uint16_t;
template <class Wanted>
constexpr AreaSet areasThat(Wanted wanted) {
  AreaSet set = 0;
  for (const AreaInfo& info : areaTable) {
    if (wanted(info)) set = static_cast<AreaSet>(set | 1U << static_cast<unsigned>(info.area));
  }
  return set;
}
constexpr bool inAreas(AreaSet set, Area area) { return (set >> static_cast<unsigned>(area) & 1U) != 0; }

namespace area_sets {
inline constexpr AreaSet elements = areasThat([](const AreaInfo& a) { return a.addressing == Addressing::Elements; });
inline constexpr AreaSet numbers = areasThat([](const AreaInfo& a) { return a.addressing == Addressing::Numbers; });
inline constexpr AreaSet words = areasThat([](const AreaInfo& a) { return a.addressing == Addressing::Words; });
inline constexpr AreaSet inputs = areasThat([](const AreaInfo& a) { return a.use == AreaUse::Input; });
inline constexpr AreaSet outputs = areasThat([](const AreaInfo& a) { return a.use == AreaUse::Output; });
inline constexpr AreaSet memory = areasThat([](const AreaInfo& a) { return a.use == AreaUse::Memory; });
inline constexpr AreaSet readOnly =
    areasThat([](const AreaInfo& a) { return a.area == Area::AI || a.area == Area::PI || a.use == AreaUse::Device; });
inline constexpr AreaSet pointers = areasThat([](const AreaInfo& a) { return a.mayHoldPointer; });
inline constexpr AreaSet pointedTo = areasThat([](const AreaInfo& a) { return a.tag.has_value(); });
inline constexpr AreaSet betweenScans =
    areasThat([](const AreaInfo& a) { return a.use != AreaUse::Local && a.use != AreaUse::Accumulator; });
}  // namespace area_sets

/// T, C: one number names a bit and a word.
constexpr bool hasBitAndWord(Area area) { return inAreas(area_sets::elements, area); }
/// T, C, AC, HC: the address is a number, not a place of bytes.
constexpr bool addressedByNumber(Area area) { return inAreas(area_sets::elements | area_sets::numbers, area); }
/// AI, AQ: words only.
constexpr bool isAnalogue(Area area) { return inAreas(area_sets::words, area); }
/// I, AI.
constexpr bool isInputArea(Area area) { return inAreas(area_sets::inputs, area); }
/// Q, AQ.
constexpr bool isOutputArea(Area area) { return inAreas(area_sets::outputs, area); }
/// V, M, S: the program's own memory.
constexpr bool isMemoryArea(Area area) { return inAreas(area_sets::memory, area); }
/// AI, HC, PI: no instruction may write there (001:2647, 001:1336).
constexpr bool isReadOnlyArea(Area area) { return inAreas(area_sets::readOnly, area); }
/// V, L, AC: where a pointer may stand (001:1459).
constexpr bool mayHoldPointer(Area area) { return inAreas(area_sets::pointers, area); }
/// All but L, AC and HC (001:1459).
constexpr bool mayBePointedTo(Area area) { return inAreas(area_sets::pointedTo, area); }
/// All but L and AC: it has a value between two scans that belongs to no block.
constexpr bool lastsOverScans(Area area) { return inAreas(area_sets::betweenScans, area); }

namespace detail {
constexpr bool areaTableIsInOrder() {
  for (std::size_t i = 0; i < areaTable.size(); ++i) {
    if (static_cast<std::size_t>(areaTable[i].area) != i) return false;
  }
  return true;
}
static_assert(areaTableIsInOrder(), "areaTable must follow the enumeration");
}  // namespace detail

}  // namespace rungproof
