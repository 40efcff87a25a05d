// Moves: MOVB MOVW MOVD MOVR, immediate BIR BIW, block moves BMB BMW BMD, SWAP (001:5601-5683, 001:6031-6065). No
// status bits. Tests: tests/manual/move_test.cpp.
#pragma once

#include "ir/s7200/isa/logic.hpp"
#include "ir/s7200/isa/overlapping_copy.hpp"

namespace rungproof::isa {

/// IN to OUT, bit for bit. MOVD also takes an address and so makes pointers (001:5607).
template <Type type, Forms sources, Forms targets, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct Move {
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .meaning = meaning.view(),
                                             .group = "move, shift, rotate",
                                             .role = Role::Move,
                                             .drawn = boxName.view(),
                                             .stack = {1, 0, 0},
                                             .eno = true,
                                             .time = time,
                                             .manual = "001:5603"},
                                            {in("IN", type, sources), out("OUT", type, targets)});
  template <class D>
  static void run(Machine<D>&, Args<D>& a) {
    a.store(1, a.value(0));
  }
};

/// BIR: a byte of the physical inputs, past the image, to memory (001:5626).
struct MoveImmediateRead {
  static constexpr Desc desc =
      withOperands({.stl = "BIR",
                    .meaning = "move byte from the physical inputs",
                    .group = "move, shift, rotate",
                    .immediate = true,
                    .drawn = "MOV_BIR",
                    .stack = {1, 0, 0},
                    .eno = true,
                    .time = 2300,
                    .manual = "001:5626"},
                   {in("IN", Type::Byte, form::I | form::Pointers), out("OUT", Type::Byte, form::byteOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    // A pointer must lead to an input byte; the manual only lists IB and pointers.
    auto isInput = m.d.constant(false);
    a.eachPlace(0, [&](auto condition, Area area, std::uint32_t offset) {
      m.when(m.d.land(condition, m.d.constant(area == Area::I)), [&] {
        auto value = m.number(0, 8);
        for (std::uint32_t bit = 0; bit < 8; ++bit) {
          const auto input = m.d.fromBool(m.externalBit(External::ImmediateInput, offset * 8 + bit), 8);
          value = m.d.bor(value, m.d.shl(input, m.number(bit, 8), 8), 8);
        }
        a.store(1, value);
      });
      isInput = m.d.lor(isInput, m.d.land(condition, m.d.constant(area == Area::I)));
    });
    m.hazard(Hazard::BadIndirectAddress, m.d.lnot(isInput));
  }
};

/// BIW: a byte to the physical outputs and to the image (001:5628).
struct MoveImmediateWrite {
  static constexpr Desc desc =
      withOperands({.stl = "BIW",
                    .meaning = "move byte to the physical outputs",
                    .group = "move, shift, rotate",
                    .immediate = true,
                    .drawn = "MOV_BIW",
                    .stack = {1, 0, 0},
                    .eno = true,
                    .time = 2400,
                    .manual = "001:5628"},
                   {in("IN", Type::Byte, form::byteIn), out("OUT", Type::Byte, form::Q | form::Pointers)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto value = a.value(0);
    auto isOutput = m.d.constant(false);
    a.eachPlace(1, [&](auto condition, Area area, std::uint32_t offset) {
      m.when(m.d.land(condition, m.d.constant(area == Area::Q)), [&] {
        m.save(Area::Q, offset, Width::Byte, value);
        for (std::uint32_t bit = 0; bit < 8; ++bit)
          m.setTerminal(offset * 8 + bit, m.d.bit(value, static_cast<int>(bit)));
      });
      isOutput = m.d.lor(isOutput, m.d.land(condition, m.d.constant(area == Area::Q)));
    });
    m.hazard(Hazard::BadIndirectAddress, m.d.lnot(isOutput));
  }
};

/// Error 0091 of an instruction that writes N elements: N = 0 as Choice::BlockMoveNothing says, or a block that
/// leaves its area. Gives the number of elements to write, width 16.
template <class D>
typename D::Bits legalCount(Machine<D>& m, typename D::Bits count, typename D::Bool fits, int room) {
  D& d = m.d;
  const auto nothing = d.equal(count, m.number(0, 16), 16);
  const auto zeroIsError = m.reads({Choice::BlockMoveNothing, "error"});
  m.hazard(Hazard::OutOfRange, d.lor(d.lnot(fits), d.land(nothing, zeroIsError)));
  const auto cut = m.reads({Choice::BlockMoveTooFar, "up-to-the-end"});
  const auto inside = d.select(cut, m.number(static_cast<std::uint64_t>(room), 16), m.number(0, 16), 16);
  return d.select(fits, count, inside, 16);
}

/// BMB, BMW, BMD: N elements. Overlap, N = 0 and the partial effect of error 0091 are choices.
template <Width width, Forms sources, Forms targets, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct BlockMove {
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .meaning = meaning.view(),
                                             .group = "move, shift, rotate",
                                             .role = Role::BlockMove,
                                             .drawn = boxName.view(),
                                             .stack = {1, 0, 0},
                                             .eno = true,
                                             .time = time,
                                             .manual = "001:5650"},
                                            {in("IN", unsignedType(width), sources).elements(1, 0).counted(2, 255),
                                             out("OUT", unsignedType(width), targets).elements(1, 0).counted(2, 255),
                                             in("N", Type::Byte, form::byteIn).within({{1, 255, everyCpu}})});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto n = m.d.zext(a.value(2), 8, 16);
    const int room = std::min(a.room(0, width, 255), a.room(1, width, 255));
    const auto count = legalCount(m, n, m.d.land(a.fits(0, n, width), a.fits(1, n, width)), room);
    OverlappingCopy<D> copy(m, a.mayOverlap(0, 1), room, bits(width));
    const auto element = [&](int k) { return a.element(0, k, width); };
    copy.begin(count, element);
    m.repeat(count, 16, room, [&](int k) { a.storeElement(1, k, width, copy.value(k, element)); });
  }
};

/// SWAP: exchanges the two bytes of a word in place (001:6031).
struct Swap {
  static constexpr Desc desc = withOperands({.stl = "SWAP",
                                             .meaning = "swap the bytes of a word",
                                             .group = "move, shift, rotate",
                                             .stack = {1, 0, 0},
                                             .eno = true,
                                             .time = 1700,
                                             .manual = "001:6031"},
                                            {inout("IN", Type::Word, form::wordOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto old = a.value(0);
    a.store(0, m.d.concat(m.d.extract(old, 7, 0), 8, m.d.extract(old, 15, 8), 8));
  }
};

inline constexpr Forms wordBuffer = form::byteBuffer | form::T | form::C;

using MoveByte = Move<Type::Byte, form::byteIn, form::byteOut, "MOVB", "MOV_B", "move byte", 1500>;
using MoveWord = Move<Type::Word, form::wordIn, form::wordOut | form::AQ, "MOVW", "MOV_W", "move word", 1800>;
using MoveDWord = Move<Type::DWord, form::dwordIn | form::Address, form::dwordOut, "MOVD", "MOV_DW",
                       "move double word or address", 2000>;
using MoveReal = Move<Type::Real, form::realIn, form::dwordOut, "MOVR", "MOV_R", "move real", 2000>;
using BlockMoveByte =
    BlockMove<Width::Byte, form::byteBuffer, form::byteBuffer, "BMB", "BLKMOV_B", "block move of bytes", 1000>;
using BlockMoveWord = BlockMove<Width::Word, wordBuffer | form::AI, wordBuffer | form::AQ, "BMW", "BLKMOV_W",
                                "block move of words", 1000>;
using BlockMoveDWord =
    BlockMove<Width::DWord, form::byteBuffer, form::byteBuffer, "BMD", "BLKMOV_D", "block move of double words", 1100>;

using MoveGroup = Group<MoveByte, MoveWord, MoveDWord, MoveReal, MoveImmediateRead, MoveImmediateWrite, BlockMoveByte,
                        BlockMoveWord, BlockMoveDWord, Swap>;

}  // namespace rungproof::isa
