// Shifts and rotations of ACCU1 (002:2779-2788). The count stands in the instruction or in ACCU2-L-L; with 0 nothing
// changes, flags included. CC1 is the bit that went out last (003:1278); counts beyond the width: general knowledge.
#pragma once

#include "ir/s7300/isa/load.hpp"

namespace rungproof::isa::step7 {

enum class Shifting : std::uint8_t { Left, Right, Signed, RotateLeft, RotateRight };

template <Shifting kind, int w, Name stlName, Name manualLine>
struct ShiftAccu {
  static constexpr Desc desc = [] {
    Desc d = accuDesc(stlName.view(), {}, "shift or rotate ACCU1", "shift and rotate", manualLine.view());
    d.role = kind == Shifting::RotateLeft || kind == Shifting::RotateRight ? Role::Rotate : Role::Shift;
    return withOperands(d, {optional(in("count", Type::Byte, form7::Const).within({{0, w}}))});
  }();
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    constexpr int x = 64;  // holds the value, and the bit that goes out beside it
    const auto count =
        a.hasOperand() ? a.number(static_cast<std::uint64_t>(a.operand().value), 8) : d.extract(a.accu2(), 7, 0);
    const auto value = w == 16 ? a.low1() : a.accu1();
    const auto most = a.number(kind == Shifting::Signed ? w : w + 1, 8);  // further ones change nothing any more
    const auto steps = d.zext(d.select(d.ult(most, count, 8), most, count, 8), 8, x);
    auto result = value;
    auto out = a.no();
    if constexpr (kind == Shifting::Left) {
      const auto shifted = d.shl(d.zext(value, w, x), steps, x);
      result = d.extract(shifted, w - 1, 0);
      out = d.bit(shifted, w);
    } else if constexpr (kind == Shifting::Right || kind == Shifting::Signed) {
      // One bit further left, so that the last bit out stays as bit 0.
      const auto filled = kind == Shifting::Signed ? d.sext(value, w, x - 1) : d.zext(value, w, x - 1);
      const auto shifted = d.lshr(d.concat(filled, x - 1, a.number(0, 1), 1), steps, x);
      result = d.extract(shifted, w, 1);
      out = d.bit(shifted, 0);
      // The sign never leaves its place; from 32 on the 64 bits do not hold it there.
      if constexpr (kind == Shifting::Signed)
        result = d.bor(result, d.band(value, a.number(std::uint64_t{1} << (w - 1), w), w), w);
    } else {
      const auto turns = d.zext(d.band(count, a.number(31, 8), 8), 8, x);
      const auto twice = d.concat(value, 32, value, 32);
      if constexpr (kind == Shifting::RotateLeft) {
        result = d.extract(d.shl(twice, turns, x), 63, 32);
        out = d.bit(result, 0);
      } else {
        result = d.extract(d.lshr(twice, turns, x), 31, 0);
        out = d.bit(result, 31);
      }
    }
    a.m.when(d.lnot(d.equal(count, a.number(0, 8), 8)), [&] {
      if constexpr (w == 16)
        a.setLow1(result);
      else
        a.setAccu1(result);
      a.setConditions(out, a.no());
      a.setBit(a.s.ov, a.no());
    });
  }
};

/// RLDA, RRDA: 33 bits, ACCU1 and CC1, by one.
template <bool left, Name stlName, Name manualLine>
struct RotateThrough {
  static constexpr Desc desc = [] {
    Desc d = accuDesc(stlName.view(), {}, "rotate ACCU1 through CC1", "shift and rotate", manualLine.view());
    d.role = Role::Rotate;
    return d;
  }();
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto value = a.accu1();
    const auto in = d.fromBool(a.s.cc1, 1);
    const auto out = d.bit(value, left ? 31 : 0);
    a.setAccu1(left ? d.concat(d.extract(value, 30, 0), 31, in, 1) : d.concat(in, 1, d.extract(value, 31, 1), 31));
    a.setConditions(out, a.no());
    a.setBit(a.s.ov, a.no());
  }
};

using Step7ShiftGroup =
    Group<ShiftAccu<Shifting::Signed, 16, "SSI", "002:2779">, ShiftAccu<Shifting::Signed, 32, "SSD", "002:2780">,
          ShiftAccu<Shifting::Left, 16, "SLW", "002:2781">, ShiftAccu<Shifting::Right, 16, "SRW", "002:2782">,
          ShiftAccu<Shifting::Left, 32, "SLD", "002:2783">, ShiftAccu<Shifting::Right, 32, "SRD", "002:2784">,
          ShiftAccu<Shifting::RotateLeft, 32, "RLD", "002:2785">,
          ShiftAccu<Shifting::RotateRight, 32, "RRD", "002:2786">, RotateThrough<true, "RLDA", "002:2787">,
          RotateThrough<false, "RRDA", "002:2788">>;

}  // namespace rungproof::isa::step7
