// Bit strings and truth values: AND, OR, XOR, NOT, shifts, rotations, selection, and whether a reading of an open point
// is in force.
#pragma once

#include "ir/iec/isa/iec_group.hpp"

namespace rungproof::isa::iec {

enum class BitOperator : std::uint8_t { And, Or, Xor };

template <BitOperator which, Name mnemonic>
struct Bitwise {
  static constexpr Desc desc =
      withOperands(described(mnemonic.view(), "combine two values bit by bit"), {part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    const int w = a.width();
    a.push(which == BitOperator::And  ? a.d.band(left, right, w)
           : which == BitOperator::Or ? a.d.bor(left, right, w)
                                      : a.d.bxor(left, right, w));
  }
};

struct Not {
  static constexpr Desc desc = withOperands(described("NOT", "invert all bits"), {part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.d.bnot(a.pop(), a.width()));
  }
};

/// SHL and SHR fill with 0; by the width or more: 0. The count has 32 bits.
template <bool isLeft, Name mnemonic>
struct Shift {
  static constexpr Desc desc =
      withOperands(described(mnemonic.view(), "shift, filling with 0", Role::Shift), {part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto count = a.pop(), value = a.pop();
    const int w = a.width();
    const auto most = a.literal(static_cast<std::uint64_t>(w), 32);
    const auto clamped = a.d.select(a.d.ult(count, most, 32), count, most, 32);
    const auto by = a.asWide(clamped, w);
    a.push(isLeft ? a.d.shl(value, by, w) : a.d.lshr(value, by, w));
  }
};

/// Of a signed number: the sign comes in from above; by the width or more only that is left. The count has 32 bits.
struct ShiftSigned {
  static constexpr Desc desc =
      withOperands(described("SAR", "shift a signed number to the right", Role::Shift), {part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto count = a.pop(), value = a.pop();
    const int w = a.width();
    const auto most = a.literal(static_cast<std::uint64_t>(w), 32);
    const auto by = a.asWide(a.d.select(a.d.ult(count, most, 32), count, most, 32), w);
    const auto inverted = a.d.bnot(a.d.lshr(a.d.bnot(value, w), by, w), w);
    a.push(a.d.select(a.d.bit(value, w - 1), inverted, a.d.lshr(value, by, w), w));
  }
};

/// The count has 32 bits; a rotation by the width is none.
template <bool isLeft, Name mnemonic>
struct Rotate {
  static constexpr Desc desc = withOperands(described(mnemonic.view(), "rotate", Role::Rotate), {part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto count = a.pop(), value = a.pop();
    const int w = a.width();
    const auto size = a.literal(static_cast<std::uint64_t>(w), w);
    const auto low = a.asWide(count, w);
    const auto by = a.d.band(low, a.literal(static_cast<std::uint64_t>(w - 1), w), w);
    const auto rest = a.d.sub(size, by, w);
    const auto up = a.d.shl(value, isLeft ? by : rest, w), down = a.d.lshr(value, isLeft ? rest : by, w);
    a.push(a.d.bor(up, down, w));
  }
};

/// G, IN0, IN1: IN1 where G is TRUE.
struct Select {
  static constexpr Desc desc = withOperands(described("SEL", "choose one of two values"), {part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto one = a.pop(), zero = a.pop();
    const auto chooses = a.popBool();
    a.push(a.d.select(chooses, one, zero, a.width()));
  }
};

/// TRUE where an open point is read as value VALUE of its row (ir/machine/choice_table.hpp).
struct Reads {
  static constexpr Desc desc = withOperands(described("READING", "whether a reading of an open point is in force"),
                                            {part("CHOICE"), part("VALUE")});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.pushBool(a.m.readsValue(static_cast<Choice>(a.number(0)), static_cast<std::uint8_t>(a.number(1))));
  }
};

using LogicGroup = Group<Bitwise<BitOperator::And, "AND">, Bitwise<BitOperator::Or, "OR">,
                         Bitwise<BitOperator::Xor, "XOR">, Not, Shift<true, "SHL">, Shift<false, "SHR">, ShiftSigned,
                         Rotate<true, "ROL">, Rotate<false, "ROR">, Select, Reads>;

}  // namespace rungproof::isa::iec
