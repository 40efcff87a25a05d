// Operands: the ways of writing an address or a value. Areas and widths stand in ir/area.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ir/area.hpp"
#include "ir/source.hpp"

namespace rungproof {

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
