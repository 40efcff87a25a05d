// INC and DEC of bytes (unsigned), words and double words (signed) (001:4999-5054).
// Overflow sets SM1.1; whether the result then wraps or the operand stays is Choice::IncrementOverflow. A byte never
// changes SM1.2 (001:5026-5028). Tests: tests/manual/increment_test.cpp.
#pragma once

#include "ir/s7200/isa/integer.hpp"
#include "ir/s7200/isa/logic.hpp"

namespace rungproof::isa {

template <bool up, Width width, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct Step {
  static constexpr int w = bits(width);
  static constexpr Type type = width == Width::Byte ? Type::Byte : width == Width::Word ? Type::Int : Type::DInt;
  /// The value from which a step overflows.
  static constexpr std::uint64_t edge = width == Width::Byte ? (up ? 0xFF : 0)
                                        : up                 ? (1ULL << (w - 1)) - 1
                                                             : 1ULL << (w - 1);
  static constexpr Desc desc = withOperands(
      {.stl = stlName.view(),
       .meaning = meaning.view(),
       .group = "math, increment, decrement",
       .role = up ? Role::Increment : Role::Decrement,
       .drawn = boxName.view(),
       .stack = {1, 0, 0},
       .eno = true,
       .affects =
           static_cast<StatusBits>(status::Zero | status::Overflow | (width == Width::Byte ? 0 : status::Negative)),
       .time = time,
       .manual = "001:4999"},
      {inout("OUT", type, targetForms(width))});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto old = a.value(0);
    const auto one = m.number(1, w);
    const auto result = up ? d.add(old, one, w) : d.sub(old, one, w);
    const auto overflow = d.equal(old, m.number(edge, w), w);
    const auto wraps = m.reads({Choice::IncrementOverflow, "wraps"});
    m.when(d.lor(wraps, d.lnot(overflow)), [&] { a.store(0, result); });
    m.hazard(Hazard::Overflow, overflow);
    m.flag(status::Overflow, overflow);
    // With SM1.1 the other two bits mean nothing (001:4814).
    m.flag(status::Zero,
           d.select(overflow, m.externalBit(External::UnknownStatus, 0), d.equal(result, m.number(0, w), w)));
    if constexpr (width != Width::Byte) {
      m.flag(status::Negative, d.select(overflow, m.externalBit(External::UnknownStatus, 2), d.bit(result, w - 1)));
    }
  }
};

using IncrementByte = Step<true, Width::Byte, "INCB", "INC_B", "increment byte", 1500>;
using IncrementWord = Step<true, Width::Word, "INCW", "INC_W", "increment word", 2000>;
using IncrementDWord = Step<true, Width::DWord, "INCD", "INC_DW", "increment double word", 2200>;
using DecrementByte = Step<false, Width::Byte, "DECB", "DEC_B", "decrement byte", 1600>;
using DecrementWord = Step<false, Width::Word, "DECW", "DEC_W", "decrement word", 2000>;
using DecrementDWord = Step<false, Width::DWord, "DECD", "DEC_DW", "decrement double word", 2200>;

using IncrementGroup =
    Group<IncrementByte, IncrementWord, IncrementDWord, DecrementByte, DecrementWord, DecrementDWord>;

}  // namespace rungproof::isa
