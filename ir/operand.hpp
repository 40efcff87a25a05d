// Operands: the ways of writing an address or a value. Areas and widths stand in ir/area.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ir/area.hpp"
#include "ir/shared.hpp"
#include "ir/short_text.hpp"
#include "ir/source.hpp"

namespace rungproof {

/// Types of local variables and parameters (001:6789-6805).
/// those of the S7-300/400 behind them: spec of types 002:1951-1978.
enum class DataType : std::uint8_t {
  Bool,
  Byte,
  Word,
  Int,
  DWord,
  DInt,
  Real,
  String,
  Time,
  Char,
  S5Time,
  Date,
  TimeOfDay,
  DateAndTime,
  Array,
  Struct,    ///< a UDT too
  Instance,  ///< an FB or SFB as static data: a multi-instance
  Timer,
  Counter,
  BlockFb,
  BlockFc,
  BlockDb,
  Pointer,
  Any,
  Void
};

enum class OperandKind : std::uint8_t {
  Direct,    ///< I0.0, VB10, T37, AC1
  Indirect,  ///< *VD10, *LD4, *AC1: the value at the address that the pointer holds; S7-300: as Operand::reach says
  Address,   ///< &VB10: the address itself
  Constant,  ///< 12, 16#FF, 1.5, 'AB'
  Text,      ///< "ABC"
  Symbol,    ///< a name that no table resolved
  Missing    ///< "?.?" or "????": left open in the editor
};

/// How a constant was written; its bits are in Operand::value.
enum class ConstantForm : std::uint8_t { Decimal, SignedDecimal, Hex, Binary, Ascii, Real, Typed, Boolean };

struct Reach;

/// One operand. Which fields count is told by `kind`.
struct Operand {
  OperandKind kind = OperandKind::Missing;
  Area area = Area::V;       ///< Direct, Address: the area; Indirect: the area that holds the pointer
  Width width = Width::Bit;  ///< width as written (VW -> Word); T and C: Bit, the instruction decides; AC: DWord
  /// Direct, of a variable of IEC 61131-3 that a name gives: Hex: an unsigned number, SignedDecimal: a signed one,
  /// Real.
  ConstantForm form = ConstantForm::Decimal;
  std::uint32_t offset = 0;  ///< byte number, or the number of a timer, counter, accumulator, HC
  std::int64_t value = 0;    ///< Constant: value (REAL: IEEE single bits)
  Span span;                 ///< the operand as written
  std::uint8_t bit = 0;      ///< bit number 0..7 as written; values above 7 are kept for ADR001
  ShortText text;            ///< Symbol: name; Text: characters; resolved symbols: the name that stood there

  /// S7-300/400: how a place is found that no number names (OperandKind::Indirect); otherwise nullptr.
  Shared<Reach> reach;

  bool isMemory() const { return kind == OperandKind::Direct || kind == OperandKind::Indirect; }
};

/// The ways in which an S7-300/400 finds a place (002:1622-1711); Operand::area, width, offset and bit say what and
/// where.
enum class Way : std::uint8_t {
  OpenBlock,  ///< DBW 2, DIX 0.0: in the block that is open in the DB or DI register
  Instance,   ///< #static, a parameter of an FB: in the block open in DI, AR2 further
  Parameter,  ///< a formal parameter that the call gives by reference; offset and bit: within an actual of complex type
  Pointer,    ///< I[MD4], DBW[LD8], T[MW2]: the bit address, or the number, stands in memory
  Register,   ///< M[AR1,P#2.1]: the register's bit address plus offset and bit
  Crossing,   ///< [AR1,P#2.1], W[AR2,P#0.0]: the area stands in the register too
  Handed,     ///< the bytes of the pointer that a call has made for a formal parameter (ir/s7300/handed_pointer.hpp)
  PointerTo   ///< OperandKind::Address as an actual parameter: the pointer to `pointer`, for a POINTER or an ANY
};
struct Reach {
  Way way;
  bool inDi = false;            ///< OpenBlock, and area DB of Pointer and Register: DI instead of DB
  bool byAr2 = false;           ///< Register, Crossing: AR2 instead of AR1
  std::uint32_t parameter = 0;  ///< Parameter, Handed: number of the formal one among the block's parameters
  /// Pointer: where it stands; its width: Word for numbers, DWord for bit addresses. PointerTo: the place, or the
  /// double word of a pointer constant with the number of its data block in Operand::offset.
  Operand pointer;
  std::uint8_t anyType = 0;    ///< PointerTo: code of the elements in an ANY (002:2257-2263)
  std::uint16_t anyCount = 0;  ///< PointerTo: number of elements in an ANY; of a STRING: its bytes
  /// PointerTo: the place itself is meant, for a block of which it is not known whether it takes a pointer or a value.
  bool isPlaceOrValue = false;
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
