// Operands: memory areas, widths, and the ways of writing an address or a value.
// Areas and addressing: 001:1267-1431, pointers 001:1459-1478. See s7200 table 6-2 for limits (cpu.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ir/source.hpp"

namespace rungproof {

/// Memory areas. The order is the order of the area tag in a pointer (see Choices::pointerTags in machine.hpp).
enum class Area : std::uint8_t { I, Q, AI, AQ, V, M, S, SM, L, T, C, AC, HC };
inline constexpr int areaCount = 13;

/// Access width. Word accesses to T, C, AI, AQ and double word accesses to HC are the only ones there.
enum class Width : std::uint8_t { Bit, Byte, Word, DWord };
constexpr int bits(Width w) { return w == Width::Bit ? 1 : w == Width::Byte ? 8 : w == Width::Word ? 16 : 32; }
constexpr int bytes(Width w) { return w == Width::DWord ? 4 : w == Width::Word ? 2 : 1; }

/// Types of local variables and parameters (001:6789-6805).
enum class DataType : std::uint8_t { Bool, Byte, Word, Int, DWord, DInt, Real, String, Time };

enum class OperandKind : std::uint8_t {
  Direct,    ///< I0.0, VB10, T37, AC1
  Indirect,  ///< *VD10, *LD4, *AC1: the value at the address that the pointer holds
  Address,   ///< &VB10: the address itself
  Constant,  ///< 12, 16#FF, 1.5, 'AB'
  Text,      ///< "ABC"
  Symbol,    ///< a name that no table resolved
  Missing    ///< "?.?" or "????": left open in the editor
};

/// How a constant was written; its bits are in Operand::value.
enum class ConstantForm : std::uint8_t { Decimal, SignedDecimal, Hex, Binary, Ascii, Real, Typed, Boolean };

/// One operand. Which fields count is told by `kind`.
struct Operand {
  OperandKind kind = OperandKind::Missing;
  Area area = Area::V;       ///< Direct, Address: the area; Indirect: the area that holds the pointer
  Width width = Width::Bit;  ///< width as written (VW -> Word); T and C: Bit, the instruction decides; AC: DWord
  ConstantForm form = ConstantForm::Decimal;
  std::uint8_t bit = 0;      ///< bit number 0..7 as written; values above 7 are kept for ADR001
  std::uint32_t offset = 0;  ///< byte number, or the number of a timer, counter, accumulator, HC
  std::int64_t value = 0;    ///< Constant: value (REAL: IEEE single bits)
  Span span;                 ///< the operand as written
  std::string text;          ///< Symbol: name; Text: characters; resolved symbols: the name that stood there

  bool isMemory() const { return kind == OperandKind::Direct || kind == OperandKind::Indirect; }
};

/// Letters of an area as the international mnemonics write it: "I", "Q", "AI", "SM".
std::string_view areaName(Area area);
/// "I0.0", "VW10", "T37", "AC1", "*VD10", "&VB10", "16#FF", "sym"; the canonical international spelling.
std::string toString(const Operand& operand);
/// Characters between marks (' or "), with $ escapes for the mark, $, and bytes outside printable ASCII.
std::string quoted(std::string_view characters, char mark);
/// "V10.3" or "VW10" for an access of that width at byte `offset`.
std::string addressName(Area area, Width width, std::uint32_t offset, unsigned bit = 0);

/// A direct operand of a memory area.
Operand direct(Area area, Width width, std::uint32_t offset, unsigned bit = 0);
Operand constant(std::int64_t value, ConstantForm form = ConstantForm::Decimal);

}  // namespace rungproof
