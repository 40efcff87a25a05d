// Coils: assignment and its immediate form, set, reset (001:2775-2821).
// Order decides: the last write of a scan wins, and "=" overrides S and R on the same bit (001:2821).
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

/// = : the top of the stack to a bit, 0 as well as 1. Q goes to the image only (001:2777).
struct Assign {
  static constexpr Desc desc = withOperands({.stl = "=",
                                             .meaning = "assign",
                                             .group = "boolean",
                                             .role = Role::Assign,
                                             .drawn = " ",
                                             .execution = Execution::Coil,
                                             .stack = {1, 0, 0},
                                             .time = 24,
                                             .manual = "001:2811"},
                                            {out("bit", Type::Bool, form::bitAny)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.storeBit(0, m.powerFlow());
  }
};

/// =I : to the physical output and to the image at once (001:2781).
struct AssignImmediate {
  static constexpr Desc desc = withOperands({.stl = "=I",
                                             .meaning = "assign immediate",
                                             .group = "boolean",
                                             .role = Role::Assign,
                                             .immediate = true,
                                             .drawn = "I",
                                             .execution = Execution::Coil,
                                             .stack = {1, 0, 0},
                                             .time = 1600,
                                             .manual = "001:2812"},
                                            {out("bit", Type::Bool, form::Q)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.storeBit(0, m.powerFlow());
    m.setTerminal(a.operand(0).offset * 8 + a.operand(0).bit, m.powerFlow());
  }
};

/// S, R, SI, RI: N consecutive bits to 1 or 0. R on T or C clears the current value as well (001:2791).
template <bool value, bool immediate, Name stlName, Name germanName, Name meaning>
struct Latch {
  static constexpr int limit = 255;                           // 001:2789
  static constexpr int s7200Limit = immediate ? 128 : limit;  // 001:2800
  static constexpr Desc desc = withOperands(
      {.stl = stlName.view(),
       .german = germanName.view(),
       .meaning = meaning.view(),
       .group = "boolean",
       .role = value ? Role::Set : Role::Reset,
       .immediate = immediate,
       .stack = {1, 0, 0},
       .eno = true,
       .time = immediate ? 890 : 290,
       .manual = immediate ? "001:2812" : "001:2811"},
      {out("bit", Type::Bool, immediate ? form::Q : form::bitAny).counted(1, limit),
       in("N", Type::Byte, form::byteIn)
           .within({{1, s7200Limit, immediate ? s7200Cpus : everyCpu}, {1, limit, immediate ? smartCpus : 0}})});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto count = a.value(1);
    const std::uint32_t room = std::min<std::uint32_t>(a.bitsLeft(0), 255);
    const auto outside = m.d.ult(m.number(room, 8), count, 8);
    m.hazard(Hazard::OutOfRange, outside);
    const auto isError = m.reads({Choice::LatchZeroCount, "error"});
    m.hazard(Hazard::OutOfRange, m.d.land(isError, m.d.equal(count, m.number(0, 8), 8)));
    const auto partly = m.reads({Choice::LatchOverBorder, "up-to-border"});
    m.when(m.d.lor(partly, m.d.lnot(outside)),
           [&] { m.repeat(count, 8, static_cast<int>(room), [&](int k) { write(m, a, k); }); });
  }
  template <class D>
  static void write(Machine<D>& m, Args<D>& a, int k) {
    const Ref<D>& r = a.ref(0);
    a.storeBitAt(0, k, m.d.constant(value));
    const std::uint32_t number = r.offset + static_cast<std::uint32_t>(k);
    if constexpr (!value) {
      if (hasBitAndWord(r.area)) m.save(r.area, number, Width::Word, m.number(0, 16));
      if (r.area == Area::T) stopTimer(m, number);
    }
    if constexpr (immediate) m.setTerminal(r.offset * 8 + r.bit + static_cast<std::uint32_t>(k), m.d.constant(value));
  }

 private:
  /// A timer that runs off a signal needs a new edge after R (001:6586); the others go on from 0 while they are
  /// enabled, a 100 ms timer perhaps as if it was enabled anew (Choice::TimerAfterReset).
  template <class D>
  static void stopTimer(Machine<D>& m, std::uint32_t number) {
    const TimerUse* use = m.plan.timer(number);
    if (use == nullptr) return;
    const auto stops = [&] { m.setBit(Reg::TimerRunning, number, m.d.constant(false)); };
    if (use->kind == TimerKind::OffDelay || use->kind == TimerKind::IecPulse)
      stops();
    else if (use->resolution == 100)
      m.when(m.reads({Choice::TimerAfterReset, "starts-anew"}), stops);
  }
};

using Set = Latch<true, false, "S", "S", "set N bits">;
using Reset = Latch<false, false, "R", "R", "reset N bits">;
using SetImmediate = Latch<true, true, "SI", "SI", "set N bits immediate">;
using ResetImmediate = Latch<false, true, "RI", "RI", "reset N bits immediate">;

using CoilGroup = Group<Assign, AssignImmediate, Set, Reset, SetImmediate, ResetImmediate>;

}  // namespace rungproof::isa
