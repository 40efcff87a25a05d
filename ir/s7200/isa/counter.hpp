// Counters: CTU, CTD, CTUD (001:3984-4086) and the boxes of the IEC set (001:4090-4117; A 16).
// They run in every pass and take stack levels as inputs: reset or load on top, below it count-down, below that
// count-up. The current value is a signed word, shared with the bit under one number. The stack stays as it is.
// IEC boxes exist in drawings only; the IR names them CTU.IEC, CTD.IEC, CTUD.IEC with the same order of levels
// (CTUD.IEC: CU, CD, R, LD from level 3 to the top) and the outputs as operands. Tests:
// tests/manual/counter_test.cpp.
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

/// Rising edge of a count input since the previous execution; remembers the input. The first scan after RUN
/// only stores unless Choice::CounterFirstEdge says otherwise.
template <class D>
typename D::Bool countEdge(Machine<D>& m, Reg memory, std::uint32_t number, typename D::Bool input) {
  const auto onlyStores = m.d.land(m.getBit(Reg::FirstScan), m.reads({Choice::CounterFirstEdge, "stored"}));
  const auto edge = m.d.land(m.d.land(input, m.d.lnot(m.getBit(memory, number))), m.d.lnot(onlyStores));
  m.setBit(memory, number, input);
  return edge;
}

/// Current value one higher or lower where `condition` holds.
template <class D>
typename D::Bits stepped(Machine<D>& m, typename D::Bool condition, typename D::Bits current, std::uint64_t step) {
  return m.d.select(condition, m.d.add(current, m.number(step, 16), 16), current, 16);
}
inline constexpr std::uint64_t plusOne = 1, minusOne = 0xFFFF;

template <class D>
void setCounter(Machine<D>& m, std::uint32_t number, typename D::Bits current, typename D::Bool bit) {
  m.set(Reg::CounterCurrent, number, current);
  m.setBit(Reg::CounterBit, number, bit);
}

constexpr Desc counterDesc(Role role, std::string_view stl, std::string_view german, std::string_view meaning,
                           std::uint8_t inputs, FlowPins pins, std::uint16_t time) {
  return withOperands({.stl = stl,
                       .german = german,
                       .meaning = meaning,
                       .group = "timers and counters",
                       .role = role,
                       .flowPins = pins,
                       .execution = Execution::Sampled,
                       .stack = {inputs, 0, 0},
                       .time = time,
                       .manual = "001:4013"},
                      {inout("Cxx", Type::Counter, form::C), in("PV", Type::Int, form::wordIn)});
}

/// CTU: counts up to 32767, not only to PV; the bit is current >= PV (001:3990).
struct CountUp {
  static constexpr Desc desc = counterDesc(Role::Ctu, "CTU", "ZV", "count up", 2, {"CU", "R"}, 3100);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const std::uint32_t number = a.number(0);
    const auto preset = a.value(1), current = m.get(Reg::CounterCurrent, number);
    const auto reset = m.powerFlow(0);
    const auto up = countEdge(m, Reg::CounterUp, number, m.powerFlow(1));
    const auto counted = stepped(m, d.land(up, d.slt(current, m.number(32767, 16), 16)), current, plusOne);
    setCounter(m, number, d.select(reset, m.number(0, 16), counted, 16),
               d.land(d.lnot(reset), d.sle(preset, counted, 16)));
  }
};

/// CTD: counts down to 0 and stops; the bit is current = 0; the load input takes PV and clears the bit (001:3999).
struct CountDown {
  static constexpr Desc desc = counterDesc(Role::Ctd, "CTD", "ZR", "count down", 2, {"CD", "LD"}, 2700);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const std::uint32_t number = a.number(0);
    const auto preset = a.value(1), current = m.get(Reg::CounterCurrent, number), zero = m.number(0, 16);
    const auto load = m.powerFlow(0);
    const auto down = countEdge(m, Reg::CounterDown, number, m.powerFlow(1));
    const auto counted = stepped(m, d.land(down, d.slt(zero, current, 16)), current, minusOne);
    auto bit = d.land(d.lnot(load), d.equal(counted, zero, 16));
    const auto isOff = d.land(m.getBit(Reg::FirstScan), m.reads({Choice::CountDownFirstScan, "off"}));
    bit = d.land(bit, d.lnot(isOff));
    setCounter(m, number, d.select(load, preset, counted, 16), bit);
  }
};

/// CTUD: counts both ways and wraps at the ends of the word (000:3361-3376); Choice::CountUpDownAtPreset is the
/// sentence that it stops at PV. Both edges at once leave the value.
struct CountUpDown {
  static constexpr Desc desc = counterDesc(Role::Ctud, "CTUD", "ZVR", "count up/down", 3, {"CU", "CD", "R"}, 3700);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const std::uint32_t number = a.number(0);
    const auto preset = a.value(1), current = m.get(Reg::CounterCurrent, number);
    const auto reset = m.powerFlow(0);
    auto up = countEdge(m, Reg::CounterUp, number, m.powerFlow(2));
    const auto down = countEdge(m, Reg::CounterDown, number, m.powerFlow(1));
    up = d.land(up, d.lor(m.reads({Choice::CountUpDownAtPreset, "wraps"}), d.slt(current, preset, 16)));
    const auto counted = stepped(m, down, stepped(m, up, current, plusOne), minusOne);
    setCounter(m, number, d.select(reset, m.number(0, 16), counted, 16),
               d.land(d.lnot(reset), d.sle(preset, counted, 16)));
  }
};

namespace iec {

inline constexpr Forms presetIn = form::wordIn & ~(form::T | form::C);                                  // 001:4109
inline constexpr Forms flagOut = form::I | form::Q | form::V | form::M | form::SM | form::S | form::L;  // 001:4110
inline constexpr Forms currentOut = form::wordOut & ~(form::T | form::C | form::SM);                    // 001:4111

constexpr Desc boxDesc(std::string_view stl, std::string_view box, std::string_view meaning, std::uint8_t inputs,
                       FlowPins pins, std::uint16_t time) {
  return {.stl = stl,
          .meaning = meaning,
          .group = "timers and counters",
          .role = Role::IecCounter,
          .drawn = box,
          .flowPins = pins,
          .execution = Execution::Sampled,
          .stack = {inputs, 0, 0},
          .drawingOnly = true,
          .time = time,
          .manual = "001:4107"};
}
constexpr OperandDesc numberPin = inout("Cxx", Type::Counter, form::C);
constexpr OperandDesc presetPin = in("PV", Type::Int, presetIn);
constexpr OperandDesc currentPin = optional(out("CV", Type::Int, currentOut));

/// Writes an output pin unless it was left open.
template <class D>
void setFlagPin(Args<D>& a, std::size_t i, typename D::Bool value) {
  if (i < a.size() && a.operand(i).kind != OperandKind::Missing) a.storeBit(i, value);
}
template <class D>
void setWordPin(Args<D>& a, std::size_t i, typename D::Bits value) {
  if (i < a.size() && a.operand(i).kind != OperandKind::Missing) a.store(i, value);
}

/// Counts up and stops at PV; Q is CV >= PV.
struct CountUp {
  static constexpr Desc desc =
      withOperands(boxDesc("CTU.IEC", "CTU", "count up (IEC)", 2, {"CU", "R"}, 3100),
                   {numberPin, presetPin, optional(out("Q", Type::Bool, flagOut)), currentPin});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const std::uint32_t number = a.number(0);
    const auto preset = a.value(1), current = m.get(Reg::CounterCurrent, number);
    const auto up = countEdge(m, Reg::CounterUp, number, m.powerFlow(1));
    const auto counted = stepped(m, d.land(up, d.slt(current, preset, 16)), current, plusOne);
    const auto next = d.select(m.powerFlow(0), m.number(0, 16), counted, 16);
    const auto reached = d.sle(preset, next, 16);
    setCounter(m, number, next, reached);
    setFlagPin(a, 2, reached);
    setWordPin(a, 3, next);
  }
};

/// Counts down and stops at 0; LD takes PV; Q is CV = 0.
struct CountDown {
  static constexpr Desc desc =
      withOperands(boxDesc("CTD.IEC", "CTD", "count down (IEC)", 2, {"CD", "LD"}, 2700),
                   {numberPin, presetPin, optional(out("Q", Type::Bool, flagOut)), currentPin});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const std::uint32_t number = a.number(0);
    const auto preset = a.value(1), current = m.get(Reg::CounterCurrent, number), zero = m.number(0, 16);
    const auto down = countEdge(m, Reg::CounterDown, number, m.powerFlow(1));
    const auto counted = stepped(m, d.land(down, d.slt(zero, current, 16)), current, minusOne);
    const auto next = d.select(m.powerFlow(0), preset, counted, 16);
    const auto empty = d.equal(next, zero, 16);
    setCounter(m, number, next, empty);
    setFlagPin(a, 2, empty);
    setWordPin(a, 3, next);
  }
};

/// Counts both ways between 0 and PV; QU is CV = PV, QD is CV = 0. R against LD is Choice::IecCounterPriority.
struct CountUpDown {
  static constexpr Desc desc =
      withOperands(boxDesc("CTUD.IEC", "CTUD", "count up/down (IEC)", 4, {"CU", "CD", "R", "LD"}, 3700),
                   {numberPin, presetPin, optional(out("QU", Type::Bool, flagOut)),
                    optional(out("QD", Type::Bool, flagOut)), currentPin});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const std::uint32_t number = a.number(0);
    const auto preset = a.value(1), current = m.get(Reg::CounterCurrent, number), zero = m.number(0, 16);
    const auto load = m.powerFlow(0), reset = m.powerFlow(1);
    const auto up = countEdge(m, Reg::CounterUp, number, m.powerFlow(3));
    const auto down = countEdge(m, Reg::CounterDown, number, m.powerFlow(2));
    const auto rises = d.land(d.land(up, d.lnot(down)), d.slt(current, preset, 16));
    const auto falls = d.land(d.land(down, d.lnot(up)), d.slt(zero, current, 16));
    const auto counted = stepped(m, falls, stepped(m, rises, current, plusOne), minusOne);
    const auto resets = d.land(reset, d.lor(d.lnot(load), m.reads({Choice::IecCounterPriority, "reset"})));
    const auto next = d.select(resets, zero, d.select(load, preset, counted, 16), 16);
    const auto full = d.equal(next, preset, 16);
    setCounter(m, number, next, full);
    setFlagPin(a, 2, full);
    setFlagPin(a, 3, d.equal(next, zero, 16));
    setWordPin(a, 4, next);
  }
};

}  // namespace iec

using CounterGroup = Group<CountUp, CountDown, CountUpDown, iec::CountUp, iec::CountDown, iec::CountUpDown>;

}  // namespace rungproof::isa
