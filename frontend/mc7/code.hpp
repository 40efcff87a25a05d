// Machine code to instructions, and what stands in their words. Tested by tests/mc7/code_test.cpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "frontend/mc7/opcode.hpp"

namespace rungproof::mc7 {

/// One instruction with what belongs to it.
struct CodeItem {
  const Opcode* opcode = nullptr;
  std::uint32_t at = 0;  ///< offset of its first byte
  std::array<std::uint8_t, 6> bytes{};
  /// Behind UC FC and the like: the entries between the jump over the list and its target.
  std::vector<std::uint32_t> list;
  bool hasList = false;

  unsigned b1() const { return bytes[1]; }
  std::uint16_t word() const { return static_cast<std::uint16_t>(bytes[2] << 8 | bytes[3]); }
  std::uint32_t dword() const {
    return std::uint32_t{word()} << 16 | static_cast<std::uint32_t>(bytes[4] << 8 | bytes[5]);
  }
  /// With its list.
  std::uint32_t length() const {
    return opcode->bytes + (hasList ? 4U + 4U * static_cast<std::uint32_t>(list.size()) : 0U);
  }
  /// Where a jump leads; of JL: behind its entries.
  std::int64_t target() const;
  bool is(std::string_view mnemonic) const { return opcode->mnemonic == mnemonic; }
};

/// Why code cannot be read from a place on.
struct CodeFault {
  std::uint32_t at = 0;
  std::string reason;
};

struct DecodedCode {
  std::vector<CodeItem> items;
  std::optional<CodeFault> fault;

  /// Machine instructions; the jump over a list is one of its own.
  std::size_t instructionCount() const;
};

/// Decodes to the end, or to what is no instruction. A jump that leads to no instruction is a fault too.
DecodedCode decodeCode(std::string_view code);

/// Letters of an area by its 3-bit code and of a size: 3 and Word give "MW". `isLoad`: area 0 is PI and not PQ.
std::string_view areaLetters(unsigned area, Size size, bool isLoad);

}  // namespace rungproof::mc7
