// Shifts, rotates and the shift register (001:5921-6027).
// Shifts fill with 0 whatever the sign (001:5927) and stop at the width; rotates take N modulo the width (001:5942).
// SM1.1 is the last bit out, data and not an error. Tests: tests/manual/shift_test.cpp.
#pragma once

#include "ir/s7200/isa/logic.hpp"

namespace rungproof::isa {

enum class Way { Left, Right };

constexpr Desc shiftDesc(Role role, Width width, std::string_view stl, std::string_view box, std::string_view meaning,
                         std::uint32_t time, std::string_view manual) {
  return withOperands({.stl = stl,
                       .meaning = meaning,
                       .group = "move, shift, rotate",
                       .role = role,
                       .drawn = box,
                       .stack = {1, 0, 0},
                       .eno = true,
                       .affects = status::Zero | status::Overflow,
                       .time = time,
                       .manual = manual},
                      {inout("OUT", unsignedType(width), targetForms(width)), in("N", Type::Byte, form::byteIn)});
}

template <Way way, Width width, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct Shift {
  static constexpr int w = bits(width);
  static constexpr Desc desc =
      shiftDesc(Role::Shift, width, stlName.view(), boxName.view(), meaning.view(), time, "001:5925");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto old = a.value(0);
    const auto limit = m.number(w, w);
    const auto wide = w == 8 ? a.value(1) : d.zext(a.value(1), 8, w);
    const auto n = d.select(d.ult(limit, wide, w), limit, wide, w);
    const auto result = way == Way::Left ? d.shl(old, n, w) : d.lshr(old, n, w);
    const auto lastOut = d.lshr(old, way == Way::Left ? d.sub(limit, n, w) : d.sub(n, m.number(1, w), w), w);
    a.store(0, result);
    m.when(d.lnot(d.equal(n, m.number(0, w), w)), [&] { m.flag(status::Overflow, d.bit(lastOut, 0)); });
    m.flag(status::Zero, d.equal(result, m.number(0, w), w));
  }
};

template <Way way, Width width, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct Rotate {
  static constexpr int w = bits(width);
  static constexpr Desc desc =
      shiftDesc(Role::Rotate, width, stlName.view(), boxName.view(), meaning.view(), time, "001:5942");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto old = a.value(0);
    const auto wide = w == 8 ? a.value(1) : d.zext(a.value(1), 8, w);
    const auto n = d.band(wide, m.number(w - 1, w), w);
    const auto rest = d.sub(m.number(w, w), n, w);
    const auto left = way == Way::Left ? n : rest;
    const auto right = way == Way::Left ? rest : n;
    const auto result = d.bor(d.shl(old, left, w), d.lshr(old, right, w), w);
    a.store(0, result);
    // A multiple of the width rotates nothing and leaves SM1.1 (001:5946).
    m.when(d.lnot(d.equal(n, m.number(0, w), w)),
           [&] { m.flag(status::Overflow, d.bit(result, way == Way::Left ? 0 : w - 1)); });
    m.flag(status::Zero, d.equal(result, m.number(0, w), w));
  }
};

/// SHRB DATA, S_BIT, N: |N| bits from S_BIT on move by one, towards the higher bit if N > 0; DATA enters, the bit
/// that leaves goes to SM1.1 (001:5984-6027). N = 0 and |N| > 64 are error 0092; for N = 0 the manual is silent.
struct ShiftRegister {
  static constexpr int longest = 64;  // 001:6024
  static constexpr Desc desc =
      withOperands({.stl = "SHRB",
                    .meaning = "shift a bit into a shift register",
                    .group = "move, shift, rotate",
                    .role = Role::Shrb,
                    .stack = {1, 0, 0},
                    .eno = true,
                    .affects = status::Overflow,
                    .time = 4800,
                    .manual = "001:5986"},
                   {in("DATA", Type::Bool, form::bitAny), inout("S_BIT", Type::Bool, form::bitAny).counted(2, longest),
                    in("N", Type::Byte, form::byteIn).within({{-longest, longest, everyCpu}})});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto n = a.value(2);
    const auto down = d.bit(n, 7);
    const auto count = d.select(down, d.sub(m.number(0, 8), n, 8), n, 8);
    const auto badCount = d.lor(d.equal(count, m.number(0, 8), 8), d.ult(m.number(longest, 8), count, 8));
    m.hazard(Hazard::BadCount, badCount);
    const int room = static_cast<int>(std::min<std::uint32_t>(a.bitsLeft(1), longest));
    const auto tooFar = d.land(d.lnot(badCount), d.ult(m.number(static_cast<std::uint64_t>(room), 8), count, 8));
    m.hazard(Hazard::OutOfRange, tooFar);
    m.when(d.lnot(d.lor(badCount, tooFar)), [&] {
      const auto data = a.bit(0);
      std::array<typename D::Bool, longest + 1> old;
      old.fill(d.constant(false));
      for (int k = 0; k < room; ++k) old[static_cast<std::size_t>(k)] = a.bitAt(1, k);
      typename D::Bool top = old[0];
      m.repeat(count, 8, room, [&](int k) {
        const auto isTop = d.equal(count, m.number(static_cast<std::uint64_t>(k) + 1, 8), 8);
        const auto at = static_cast<std::size_t>(k);
        top = d.select(isTop, old[at], top);
        a.storeBitAt(1, k,
                     d.select(down, d.select(isTop, data, old[at + 1]), k == 0 ? data : old[at - (k == 0 ? 0 : 1)]));
      });
      m.flag(status::Overflow, d.select(down, old[0], top));
    });
  }
};

using ShiftLeftByte = Shift<Way::Left, Width::Byte, "SLB", "SHL_B", "shift byte left", 2300>;
using ShiftLeftWord = Shift<Way::Left, Width::Word, "SLW", "SHL_W", "shift word left", 2700>;
using ShiftLeftDWord = Shift<Way::Left, Width::DWord, "SLD", "SHL_DW", "shift double word left", 2900>;
using ShiftRightByte = Shift<Way::Right, Width::Byte, "SRB", "SHR_B", "shift byte right", 2200>;
using ShiftRightWord = Shift<Way::Right, Width::Word, "SRW", "SHR_W", "shift word right", 2700>;
using ShiftRightDWord = Shift<Way::Right, Width::DWord, "SRD", "SHR_DW", "shift double word right", 2800>;
using RotateLeftByte = Rotate<Way::Left, Width::Byte, "RLB", "ROL_B", "rotate byte left", 2300>;
using RotateLeftWord = Rotate<Way::Left, Width::Word, "RLW", "ROL_W", "rotate word left", 2700>;
using RotateLeftDWord = Rotate<Way::Left, Width::DWord, "RLD", "ROL_DW", "rotate double word left", 2800>;
using RotateRightByte = Rotate<Way::Right, Width::Byte, "RRB", "ROR_B", "rotate byte right", 2200>;
using RotateRightWord = Rotate<Way::Right, Width::Word, "RRW", "ROR_W", "rotate word right", 2600>;
using RotateRightDWord = Rotate<Way::Right, Width::DWord, "RRD", "ROR_DW", "rotate double word right", 2800>;

using ShiftGroup =
    Group<ShiftRegister, ShiftRightByte, ShiftRightWord, ShiftRightDWord, ShiftLeftByte, ShiftLeftWord, ShiftLeftDWord,
          RotateRightByte, RotateRightWord, RotateRightDWord, RotateLeftByte, RotateLeftWord, RotateLeftDWord>;

}  // namespace rungproof::isa
