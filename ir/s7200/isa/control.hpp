// Program control: END MEND STOP WDR JMP LBL FOR NEXT DLED (001:5687-5801, 001:5886-5915).
// What moves the flow of the program has its meaning in ir/s7200/control.hpp; here are the descriptors.
// Tests: tests/manual/control_test.cpp.
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

/// Base of instructions whose meaning is in ir/s7200/control.hpp.
struct InScan {
  template <class D>
  static void run(Machine<D>&, Args<D>&) {}
};

struct End : InScan {
  static constexpr Desc desc{.stl = "END",
                             .meaning = "end the scan if there is power flow",
                             .group = "program control",
                             .execution = Execution::Control,
                             .stack = {1, 0, 0},
                             .control = Control::End,
                             .notInInterrupt = true,
                             .time = 20,
                             .manual = "001:5687"};
};
struct MainEnd : InScan {
  static constexpr Desc desc{.stl = "MEND",
                             .meaning = "end of the main program",
                             .group = "only in Appendix F or C",
                             .drawn = "END",
                             .execution = Execution::Control,
                             .control = Control::MainEnd,
                             .olderDialectOnly = true,
                             .manual = "001:13985"};
};
struct Stop : InScan {
  static constexpr Desc desc{.stl = "STOP",
                             .meaning = "go to STOP mode",
                             .group = "program control",
                             .execution = Execution::Control,
                             .stack = {1, 0, 0},
                             .control = Control::Stop,
                             .manual = "001:5693"};
};
/// Labels of JMP and LBL (001:5798; CPU 212: general knowledge).
constexpr OperandDesc labelOperand() {
  constexpr CpuSet few = cpusWith([](const CpuRow& row) { return row.features.labels == 64; });
  return in("N", Type::Label, form::Const).within({{0, 63, few}, {0, 255, everyCpu & ~few}});
}

struct Jump : InScan {
  static constexpr Desc desc = withOperands({.stl = "JMP",
                                             .meaning = "jump to the label",
                                             .group = "program control",
                                             .execution = Execution::Control,
                                             .stack = {1, 0, 0},
                                             .control = Control::Jump,
                                             .time = 180,
                                             .manual = "001:5784"},
                                            {labelOperand()});
};
struct Label : InScan {
  static constexpr Desc desc = withOperands({.stl = "LBL",
                                             .meaning = "jump label",
                                             .group = "program control",
                                             .execution = Execution::Control,
                                             .control = Control::LabelMark,
                                             .time = 22,
                                             .manual = "001:5786"},
                                            {labelOperand()});
};
struct For : InScan {
  static constexpr Desc desc =
      withOperands({.stl = "FOR",
                    .meaning = "start of a loop",
                    .group = "program control",
                    .execution = Execution::Control,
                    .stack = {1, 0, 0},
                    .eno = true,
                    .control = Control::For,
                    .time = 3500,
                    .manual = "001:5752"},
                   {inout("INDX", Type::Int, form::wordOut), in("INIT", Type::Int, form::wordIn),
                    in("FINAL", Type::Int, form::wordIn)});
};
struct Next : InScan {
  static constexpr Desc desc{.stl = "NEXT",
                             .meaning = "end of a loop",
                             .group = "program control",
                             .execution = Execution::Control,
                             .control = Control::Next,
                             .manual = "001:5752"};
};

/// WDR restarts the scan watchdog (001:5699).
struct WatchdogReset {
  static constexpr Desc desc{.stl = "WDR",
                             .meaning = "restart the scan watchdog",
                             .group = "program control",
                             .role = Role::Wdr,
                             .stack = {1, 0, 0},
                             .time = 700,
                             .manual = "001:5699"};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    m.signal(Signal::WatchdogRestarted);
  }
};

/// DLED: the SF/DIAG lamp is yellow while IN is above 0 (001:5888).
struct DiagnosticLed {
  static constexpr Desc desc = withOperands({.stl = "DLED",
                                             .meaning = "diagnostic LED",
                                             .group = "program control",
                                             .drawn = "DIAG_LED",
                                             .stack = {1, 0, 0},
                                             .cpus = s7200Cpus,
                                             .since2004 = true,
                                             .time = 1400,
                                             .manual = "001:5888"},
                                            {in("IN", Type::Byte, form::byteIn)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    m.setBit(Reg::DiagnosticLed, 0, m.d.lnot(m.d.equal(a.value(0), m.number(0, 8), 8)));
  }
};

using ControlGroup = Group<End, MainEnd, Stop, WatchdogReset, Jump, Label, For, Next, DiagnosticLed>;

}  // namespace rungproof::isa
