// Bitwise logic on bytes, words and double words: INV, AND, OR, XOR (001:5551-5599; INV: 000:7387-7442, its page is
// missing in the 2004 text). SM1.0 tells whether the result is 0; no other status bit changes.
// S7-200 SMART: NAND, NOR, NXOR as well. Tests: tests/manual/logic_test.cpp, tests/smart.
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

enum class Bitwise { And, Or, Xor, Nand, Nor, Nxor };
/// Those with a complemented result exist on the S7-200 SMART only.
constexpr bool isComplemented(Bitwise operation) { return operation >= Bitwise::Nand; }

/// Unsigned type and operand forms of a width, for instructions that exist for bytes, words and double words.
constexpr Type unsignedType(Width w) {
  return w == Width::Byte ? Type::Byte : w == Width::Word ? Type::Word : Type::DWord;
}
constexpr Forms sourceForms(Width w) {
  return w == Width::Byte ? form::byteIn : w == Width::Word ? form::wordIn : form::dwordIn;
}
constexpr Forms targetForms(Width w) {
  return w == Width::Byte ? form::byteOut : w == Width::Word ? form::wordOut : form::dwordOut;
}

template <Bitwise operation, Width width, Name stlName, Name germanName, Name boxName, Name meaning, std::uint32_t time>
struct BitwiseLogic {
  static constexpr Desc desc = withOperands(
      {.stl = stlName.view(),
       .german = germanName.view(),
       .meaning = meaning.view(),
       .group = "logic (bitwise)",
       .drawn = boxName.view(),
       .stack = {1, 0, 0},
       .eno = true,
       .affects = status::Zero,
       .cpus = isComplemented(operation) ? smartCpus : everyCpu,
       .since28 = isComplemented(operation),
       .time = time,
       .manual = isComplemented(operation) ? smartManual : "001:5553"},
      {in("IN1", unsignedType(width), sourceForms(width)), inout("OUT", unsignedType(width), targetForms(width))});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    constexpr int w = bits(width);
    typename D::Bits result{};
    if constexpr (operation == Bitwise::And || operation == Bitwise::Nand) result = m.d.band(a.value(0), a.value(1), w);
    if constexpr (operation == Bitwise::Or || operation == Bitwise::Nor) result = m.d.bor(a.value(0), a.value(1), w);
    if constexpr (operation == Bitwise::Xor || operation == Bitwise::Nxor) result = m.d.bxor(a.value(0), a.value(1), w);
    if constexpr (isComplemented(operation)) result = m.d.bnot(result, w);
    a.store(1, result);
    m.flag(status::Zero, m.d.equal(result, m.number(0, w), w));
  }
};

/// One's complement in place.
template <Width width, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct Invert {
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .meaning = meaning.view(),
                                             .group = "logic (bitwise)",
                                             .drawn = boxName.view(),
                                             .stack = {1, 0, 0},
                                             .eno = true,
                                             .affects = status::Zero,
                                             .time = time,
                                             .manual = "000:7387"},
                                            {inout("OUT", unsignedType(width), targetForms(width))});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    constexpr int w = bits(width);
    const auto result = m.d.bnot(a.value(0), w);
    a.store(0, result);
    m.flag(status::Zero, m.d.equal(result, m.number(0, w), w));
  }
};

using AndByte = BitwiseLogic<Bitwise::And, Width::Byte, "ANDB", "UNDB", "WAND_B", "bitwise AND of bytes", 1900>;
using AndWord = BitwiseLogic<Bitwise::And, Width::Word, "ANDW", "UNDW", "WAND_W", "bitwise AND of words", 2500>;
using AndDWord =
    BitwiseLogic<Bitwise::And, Width::DWord, "ANDD", "UNDD", "WAND_DW", "bitwise AND of double words", 3000>;
using OrByte = BitwiseLogic<Bitwise::Or, Width::Byte, "ORB", "ORB", "WOR_B", "bitwise OR of bytes", 1900>;
using OrWord = BitwiseLogic<Bitwise::Or, Width::Word, "ORW", "ORW", "WOR_W", "bitwise OR of words", 2500>;
using OrDWord = BitwiseLogic<Bitwise::Or, Width::DWord, "ORD", "ORD", "WOR_DW", "bitwise OR of double words", 2900>;
using XorByte =
    BitwiseLogic<Bitwise::Xor, Width::Byte, "XORB", "XORB", "WXOR_B", "bitwise exclusive OR of bytes", 1900>;
using XorWord =
    BitwiseLogic<Bitwise::Xor, Width::Word, "XORW", "XORW", "WXOR_W", "bitwise exclusive OR of words", 2500>;
using XorDWord =
    BitwiseLogic<Bitwise::Xor, Width::DWord, "XORD", "XORD", "WXOR_DW", "bitwise exclusive OR of double words", 2900>;
using InvertByte = Invert<Width::Byte, "INVB", "INV_B", "one's complement of a byte", 1600>;
using InvertWord = Invert<Width::Word, "INVW", "INV_W", "one's complement of a word", 2000>;
using InvertDWord = Invert<Width::DWord, "INVD", "INV_DW", "one's complement of a double word", 2200>;

using NandByte = BitwiseLogic<Bitwise::Nand, Width::Byte, "NANDB", "NANDB", "WNAND_B", "bitwise NAND of bytes", 0>;
using NandWord = BitwiseLogic<Bitwise::Nand, Width::Word, "NANDW", "NANDW", "WNAND_W", "bitwise NAND of words", 0>;
using NandDWord =
    BitwiseLogic<Bitwise::Nand, Width::DWord, "NANDD", "NANDD", "WNAND_DW", "bitwise NAND of double words", 0>;
using NorByte = BitwiseLogic<Bitwise::Nor, Width::Byte, "NORB", "NORB", "WNOR_B", "bitwise NOR of bytes", 0>;
using NorWord = BitwiseLogic<Bitwise::Nor, Width::Word, "NORW", "NORW", "WNOR_W", "bitwise NOR of words", 0>;
using NorDWord = BitwiseLogic<Bitwise::Nor, Width::DWord, "NORD", "NORD", "WNOR_DW", "bitwise NOR of double words", 0>;
using NxorByte =
    BitwiseLogic<Bitwise::Nxor, Width::Byte, "NXORB", "NXORB", "WNXOR_B", "bitwise exclusive NOR of bytes", 0>;
using NxorWord =
    BitwiseLogic<Bitwise::Nxor, Width::Word, "NXORW", "NXORW", "WNXOR_W", "bitwise exclusive NOR of words", 0>;
using NxorDWord =
    BitwiseLogic<Bitwise::Nxor, Width::DWord, "NXORD", "NXORD", "WNXOR_DW", "bitwise exclusive NOR of double words", 0>;

using LogicGroup =
    Group<AndByte, AndWord, AndDWord, OrByte, OrWord, OrDWord, XorByte, XorWord, XorDWord, InvertByte, InvertWord,
          InvertDWord, NandByte, NandWord, NandDWord, NorByte, NorWord, NorDWord, NxorByte, NxorWord, NxorDWord>;

}  // namespace rungproof::isa
