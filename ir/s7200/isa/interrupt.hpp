// Interrupts: ENI DISI ATCH DTCH CEVNT, and the returns CRETI RETI (001:5327-5547).
// The registers hold what is attached and whether interrupts are enabled; the queues belong to the engine, which
// learns of ATCH, DTCH and CEVNT by signals. Tests: tests/manual/interrupt_test.cpp.
#pragma once

#include "ir/s7200/event.hpp"
#include "ir/s7200/hsc_inputs.hpp"
#include "ir/s7200/isa/control.hpp"

namespace rungproof::isa {

/// Events of each CPU (001:5366; 226XM: 000:6980-6986). What of these the oldest and the compact CPUs lack is ADR009's.
constexpr OperandDesc eventOperand() {
  constexpr auto with = [](bool port1, bool counter1) {
    return cpusWith([=](const CpuRow& row) {
      return row.series == Series::S7200 && contains(row.features.events, 25) == port1 &&
             contains(row.features.events, 13) == counter1 && contains(row.features.events, 27);
    });
  };
  constexpr CpuSet small = with(false, false), middle = with(false, true);
  return in("EVNT", Type::Byte, form::Const)
      .within({{0, 12, small},
               {0, 23, middle},
               {19, 23, small},
               {27, 33, small | middle},
               {0, 33, s7200Cpus & ~small & ~middle},
               {0, 44, smartCpus}});
}

/// ENI, DISI: SM4.4 shows the state (001:14108). Forbidden in interrupt routines (001:5426, code 0004).
template <bool enable, Name stlName, Name meaning, std::uint32_t time>
struct GlobalEnable {
  static constexpr Desc desc{.stl = stlName.view(),
                             .meaning = meaning.view(),
                             .group = "interrupt",
                             .role = enable ? Role::Eni : Role::Disi,
                             .stack = {1, 0, 0},
                             .eno = true,
                             .notInInterrupt = true,
                             .time = time,
                             .manual = "001:5331"};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    const auto forbidden = m.d.constant(m.inInterrupt);
    m.hazard(Hazard::NotInInterrupt, forbidden);
    m.when(m.d.lnot(forbidden), [&] {
      m.setBit(Reg::InterruptsEnabled, 0, m.d.constant(enable));
      m.setSm(4, 4, m.d.constant(enable));
    });
  }
};

/// ATCH INT, EVNT: one routine per event, a new one replaces it (001:5345, 001:5370). Error 0002 if the event needs
/// an input that a defined high-speed counter uses. A timed event takes over its period and starts anew (001:5472).
struct Attach {
  static constexpr Desc desc =
      withOperands({.stl = "ATCH",
                    .meaning = "attach an interrupt routine to an event",
                    .group = "interrupt",
                    .role = Role::Atch,
                    .stack = {1, 0, 0},
                    .eno = true,
                    .time = 1200,
                    .manual = "001:5345"},
                   {in("INT", Type::Interrupt, form::Const).within({{0, 127, everyCpu}}), eventOperand()});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const std::uint32_t event = a.number(1);
    if (event >= eventCount) return;
    auto taken = m.d.constant(false);
    if (isEdgeEvent(static_cast<int>(event)))
      taken = hscUses(m, static_cast<int>(edgeInputFor(static_cast<int>(event)).bit));
    m.hazard(Hazard::InputConflict, taken);
    m.when(m.d.lnot(taken), [&] {
      m.set(Reg::EventRoutine, event, m.number(a.number(0) + 1, 8));
      if (isTimedEvent(static_cast<int>(event))) {
        const auto timer = static_cast<std::uint32_t>(timerOfEvent(static_cast<int>(event)));
        m.set(Reg::TimedPeriod, timer, m.load(Area::SM, timedPeriodByte + timer, Width::Byte));
        m.set(Reg::TimedElapsed, timer, m.number(0, 8));
      }
      m.signal(Signal::EventAttached, event);
    });
  }

 private:
  /// Whether a counter is defined in a mode that uses input I0.n; events 2n and 2n + 1 are its edges.
  template <class D>
  static typename D::Bool hscUses(Machine<D>& m, int input) {
    auto used = m.d.constant(false);
    for (int counter = 0; counter < 6; ++counter) {
      for (int mode = 0; mode <= 12; ++mode) {
        if (!hscUsesInput(m.target, counter, mode, input)) continue;
        const auto defined = m.get(Reg::HscMode, static_cast<std::uint32_t>(counter));
        used = m.d.lor(used, m.d.equal(defined, m.number(static_cast<std::uint64_t>(mode) + 1, 8), 8));
      }
    }
    return used;
  }
};

/// DTCH EVNT: the event is ignored from now on (001:5353); what becomes of entries that wait in a queue is
/// Choice::DetachedEvents.
struct Detach {
  static constexpr Desc desc = withOperands({.stl = "DTCH",
                                             .meaning = "detach an event",
                                             .group = "interrupt",
                                             .role = Role::Dtch,
                                             .stack = {1, 0, 0},
                                             .eno = true,
                                             .time = 1200,
                                             .manual = "001:5353"},
                                            {eventOperand()});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const std::uint32_t event = a.number(0);
    if (event >= eventCount) return;
    m.set(Reg::EventRoutine, event, m.number(0, 8));
    m.signal(Signal::EventDetached, event);
  }
};

/// CEVNT EVNT: drops the queued entries of the event (001:5357).
struct ClearEvents {
  static constexpr Desc desc = withOperands({.stl = "CEVNT",
                                             .meaning = "clear the queued entries of an event",
                                             .group = "interrupt",
                                             .role = Role::Cevnt,
                                             .drawn = "CLR_EVNT",
                                             .stack = {1, 0, 0},
                                             .eno = true,
                                             .since2004 = true,
                                             .time = 2400,
                                             .manual = "001:5357"},
                                            {eventOperand()});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    m.signal(Signal::EventsCleared, a.number(0));
  }
};

struct InterruptReturnConditional : InScan {
  static constexpr Desc desc{.stl = "CRETI",
                             .meaning = "leave the interrupt routine if there is power flow",
                             .group = "interrupt",
                             .drawn = "RETI",
                             .execution = Execution::Control,
                             .stack = {1, 0, 0},
                             .control = Control::InterruptReturnConditional,
                             .time = 20,
                             .manual = "001:5341"};
};
struct InterruptReturn : InScan {
  static constexpr Desc desc{.stl = "RETI",
                             .meaning = "end of the interrupt routine",
                             .group = "only in Appendix F or C",
                             .execution = Execution::Control,
                             .control = Control::InterruptReturn,
                             .olderDialectOnly = true,
                             .manual = "001:13991"};
};

using EnableInterrupts = GlobalEnable<true, "ENI", "enable interrupts", 1100>;
using DisableInterrupts = GlobalEnable<false, "DISI", "disable interrupts", 900>;

using InterruptGroup = Group<InterruptReturnConditional, InterruptReturn, EnableInterrupts, DisableInterrupts, Attach,
                             Detach, ClearEvents>;

}  // namespace rungproof::isa
