// The cross reference: for every address the instructions that read and write it, at which width, what overlaps it,
// and which parts of each area nobody uses. A view of the access lists that the rules use too (access.hpp); the
// commands `xref` and the editor server print it. Tested by tests/cli/xref_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

/// All accesses to one address at one width and length.
struct XrefEntry {
  Area area = Area::V;
  Width width = Width::Bit;
  std::uint32_t offset = 0;
  std::uint8_t bit = 0;
  std::uint16_t count = 1;            ///< elements: bits of S, R and SHRB, words of a block move
  std::uint32_t block = 0;            ///< index in Program::pous, counts only for L
  std::vector<const Access*> uses;    ///< in program order
  std::vector<std::size_t> overlaps;  ///< indices in Xref::entries of other entries that share a bit with it

  /// First bit and the one after the last, within the area (and block); numbers of T, C, AC, HC count as 32 bits.
  std::uint32_t firstBit() const;
  std::uint32_t endBit() const;
};

/// Bytes, or numbers of T and C, from `first` to `last` that no instruction, data or pointer target names.
struct FreeRange {
  Area area = Area::V;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

struct Xref {
  std::vector<XrefEntry> entries;              ///< by area, block, address, width
  std::vector<const Access*> throughPointers;  ///< accesses whose place only the running program knows
  std::vector<FreeRange> free;                 ///< of I, Q, V, M, S, T and C
};

Xref crossReference(const Facts& facts);
/// Indices of the entries that share a bit with the address.
std::vector<std::size_t> entriesTouching(const Xref& xref, const Operand& address);
/// "Q0.0", "Q0.0..Q0.7", "VW100..VW118", "T37 (bit)", "T37 (value)".
std::string entryName(const XrefEntry& entry);
/// "VB0..VB99", "T5".
std::string rangeName(const FreeRange& range);

}  // namespace rungproof
