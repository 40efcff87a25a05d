// The instructions of MC7, the machine code of the S7-300/400: one row each, which decoder and encoder both read.
// Tested by tests/mc7/code_test.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "frontend/step7/syntax.hpp"

namespace rungproof::mc7 {

using step7::Size;

/// What stands in the words of an instruction besides its code. b1 is its second byte; words are big-endian.
enum class Form : std::uint8_t {
  None,             ///< nothing: the operand, if any, is Opcode::operand
  Bit,              ///< area and bit in b1, byte in the second word
  MarkerBit,        ///< short form: bit in the first byte, M byte in b1
  ImageBit,         ///< the same of I and Q, 7 bits of b1
  Sized,            ///< area in b1, byte in the second word
  Number8,          ///< b1
  Number7,          ///< 7 bits of b1
  Number16,         ///< second word
  Count4,           ///< upper 4 bits of b1
  Count6,           ///< lower 6 bits of b1
  BitByMemory,      ///< I [MD 4]: area of the holder and of the bit in b1, address of the holder in the second word
  SizedByMemory,    ///< MW [MD 4]
  NumberByMemory,   ///< T [MW 4]
  BitByRegister,    ///< I [AR1,P#2.0]: area and register in b1, offset in the second word
  SizedByRegister,  ///< MW [AR1,P#2.0]
  AnyByRegister,    ///< [AR1,P#2.0], W [AR1,P#2.0]: the area stands in the register
  Holder,           ///< double word of M, DB, DI or L
  Parameter,        ///< #name of an FC: twice its number
  Jump,             ///< distance in words from the instruction itself
  Offset,           ///< P#2.0 without area, 16 bits
  Pointer,          ///< P#M 2.0, 32 bits
  HexByte,
  HexWord,
  HexDWord,
  BinaryWord,
  BinaryDWord,
  Integer,
  Long,
  Real,
  TwoBytes,
  FourBytes,
  TwoCharacters,
  FourCharacters,
  CountValue,
  Date,
  S5Time,
  Time,
  TimeOfDay
};

struct Opcode {
  std::uint16_t value = 0, mask = 0;
  std::uint8_t bytes = 2;  ///< 2, 4 or 6
  Form form = Form::None;
  Size size = Size::Bit;      ///< of what is read or written; of a parameter: of its type
  std::string_view mnemonic;  ///< international
  /// Letters of the operand that the code implies: "MB", "T", "FC", "OV"; of a parameter of number type its kind.
  std::string_view operand;
};

/// Sorted by value. No word fits two rows.
std::span<const Opcode> opcodes();

/// The row of the instruction whose first word this is, or nullptr.
const Opcode* opcodeOf(std::uint16_t word);

/// Unconditional and conditional calls of FCs and SFCs, behind which a jump over the list of parameters stands.
bool hasParameterList(const Opcode& opcode);

}  // namespace rungproof::mc7
