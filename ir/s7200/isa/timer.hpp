// Timers TON TOF TONR, the IEC boxes TON TOF TP, and the interval time BITIM CITIM (001:6517-6727). The instruction
// samples its input and, for 100 ms timers, lets the time of the scan pass; the other resolutions count in
// ir/s7200/timer_refresh.hpp. Tests: tests/manual/timer_test.cpp.
#pragma once

#include "ir/s7200/isa/group.hpp"
#include "ir/s7200/timer_refresh.hpp"

namespace rungproof::isa {

/// Numbers of TONR, and of all other timers (table 6-74, 001:6597-6603).
constexpr OperandDesc timerOperand(TimerKind kind) {
  const OperandDesc timer = inout("Txx", Type::Timer, form::T);
  return kind == TimerKind::Retentive ? timer.within({{0, 31, everyCpu}, {64, 95, everyCpu}})
                                      : timer.within({{32, 63, everyCpu}, {96, 255, everyCpu}});
}

constexpr Role roleOf(TimerKind kind) {
  return kind == TimerKind::OnDelay ? Role::Ton : kind == TimerKind::OffDelay ? Role::Tof : Role::Tonr;
}

template <class D>
void clearTimer(Machine<D>& m, std::uint32_t number) {
  m.set(Reg::TimerCurrent, number, m.number(0, 16));
  m.setBit(Reg::TimerBit, number, m.d.constant(false));
}

/// What an execution with input `in` does before any time passes.
template <TimerKind kind, class D>
void sampleTimer(Machine<D>& m, std::uint32_t number, typename D::Bool in) {
  D& d = m.d;
  const auto before = m.getBit(Reg::TimerInput, number);
  if constexpr (kind == TimerKind::OnDelay || kind == TimerKind::Retentive || kind == TimerKind::IecOnDelay) {
    m.setBit(Reg::TimerRunning, number, in);
    if constexpr (kind != TimerKind::Retentive) m.when(d.lnot(in), [&] { clearTimer(m, number); });
  }
  if constexpr (kind == TimerKind::OffDelay) {
    m.when(in, [&] {
      m.setBit(Reg::TimerBit, number, d.constant(true));
      m.set(Reg::TimerCurrent, number, m.number(0, 16));
      m.setBit(Reg::TimerRunning, number, d.constant(false));
    });
    m.when(d.land(before, d.lnot(in)), [&] { m.setBit(Reg::TimerRunning, number, d.constant(true)); });
  }
  if constexpr (kind == TimerKind::IecPulse) {
    const auto idle = d.lnot(m.getBit(Reg::TimerRunning, number));
    m.when(d.land(idle, d.lnot(in)), [&] { clearTimer(m, number); });
    m.when(d.land(idle, d.land(in, d.lnot(before))), [&] {
      m.set(Reg::TimerCurrent, number, m.number(0, 16));
      m.setBit(Reg::TimerBit, number, d.constant(true));
      m.setBit(Reg::TimerRunning, number, d.constant(true));
    });
  }
  m.setBit(Reg::TimerInput, number, in);
}

/// The whole instruction. A 100 ms timer counts the intervals since the start of the scan before, if it was already
/// counting then: a timer counts what passes after it was enabled (001:6590), and a preset one higher than wanted
/// guarantees the time (001:6592), however long the scans are. Its bit is set by each execution that finds the value at
/// the preset (001:6565, 6611), by the one that enables it too. A TOF in an inactive SCR segment stands at 0 and does
/// not time (001:6575); the other kinds see no power flow there.
template <TimerKind kind, class D>
void runTimer(Machine<D>& m, Args<D>& a) {
  D& d = m.d;
  const std::uint32_t number = a.number(0);
  if (number >= regInfo(Reg::TimerCurrent).count) return;
  m.set(Reg::TimerPreset, number, a.value(1));
  const auto active = kind == TimerKind::OffDelay ? m.scrActive : d.constant(true);
  m.when(d.lnot(active), [&] {
    clearTimer(m, number);
    m.setBit(Reg::TimerRunning, number, d.constant(false));
    m.setBit(Reg::TimerInput, number, d.constant(false));
  });
  m.when(active, [&] {
    const auto wasCounting = m.getBit(Reg::TimerRunning, number);
    sampleTimer<kind>(m, number, m.powerFlow());
    if (timerResolution(static_cast<int>(number)) == 100) advanceTimer(m, kind, number, m.ticks100, wasCounting);
  });
}

template <TimerKind kind, Name stlName, Name meaning, std::uint32_t time>
struct Timer {
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .meaning = meaning.view(),
                                             .group = "timers and counters",
                                             .role = roleOf(kind),
                                             .flowPins = {"IN"},
                                             .execution = Execution::Sampled,
                                             .stack = {1, 0, 0},
                                             .time = time,
                                             .manual = "001:6551"},
                                            {timerOperand(kind), in("PT", Type::Int, form::wordIn)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    runTimer<kind>(m, a);
  }
};

/// IEC boxes exist in drawings only (001:2217). Q and ET may be left open.
template <TimerKind kind, Name stlName, Name boxName, Name meaning>
struct IecTimer {
  static constexpr Forms numbers = form::T | form::C;
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .meaning = meaning.view(),
                                             .group = "timers and counters",
                                             .role = Role::IecTimer,
                                             .drawn = boxName.view(),
                                             .flowPins = {"IN"},
                                             .execution = Execution::Sampled,
                                             .stack = {1, 0, 0},
                                             .drawingOnly = true,
                                             .manual = "001:6693"},
                                            {timerOperand(kind), in("PT", Type::Int, form::wordIn & ~numbers),
                                             optional(out("Q", Type::Bool, form::bitAny & ~numbers)),
                                             optional(out("ET", Type::Int, (form::wordOut & ~numbers) | form::AQ))});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    runTimer<kind>(m, a);
    a.storeBit(2, m.getBit(Reg::TimerBit, a.number(0)));
    a.store(3, m.get(Reg::TimerCurrent, a.number(0)));
  }
};

/// BITIM: the free-running 1 ms counter to OUT (001:6712). Its start value is not stated.
struct BeginInterval {
  static constexpr Desc desc = withOperands({.stl = "BITIM",
                                             .meaning = "store the 1 ms counter",
                                             .group = "timers and counters",
                                             .drawn = "BGN_ITIME",
                                             .stack = {1, 0, 0},
                                             .since2004 = true,
                                             .time = 1600,
                                             .manual = "001:6712"},
                                            {out("OUT", Type::DWord, form::dwordOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.store(0, m.external(External::IntervalClock, 0, 32));
  }
};

/// CITIM: ms since the counter value IN, modulo 2^32 (001:6714).
struct CalculateInterval {
  static constexpr Desc desc =
      withOperands({.stl = "CITIM",
                    .meaning = "time since a stored counter value",
                    .group = "timers and counters",
                    .drawn = "CAL_ITIME",
                    .stack = {1, 0, 0},
                    .since2004 = true,
                    .time = 2300,
                    .manual = "001:6714"},
                   {in("IN", Type::DWord, form::dwordOut | form::HC), out("OUT", Type::DWord, form::dwordOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.store(1, m.d.sub(m.external(External::IntervalClock, 0, 32), a.value(0), 32));
  }
};

using OnDelay = Timer<TimerKind::OnDelay, "TON", "on-delay timer", 3300>;
using OffDelay = Timer<TimerKind::OffDelay, "TOF", "off-delay timer", 3600>;
using RetentiveOnDelay = Timer<TimerKind::Retentive, "TONR", "retentive on-delay timer", 3200>;
using IecOnDelay = IecTimer<TimerKind::IecOnDelay, "TON.IEC", "TON", "IEC on-delay timer">;
using IecOffDelay = IecTimer<TimerKind::OffDelay, "TOF.IEC", "TOF", "IEC off-delay timer">;
using IecPulse = IecTimer<TimerKind::IecPulse, "TP.IEC", "TP", "IEC pulse timer">;

using TimerGroup =
    Group<OnDelay, OffDelay, RetentiveOnDelay, BeginInterval, CalculateInterval, IecOnDelay, IecOffDelay, IecPulse>;

}  // namespace rungproof::isa
