// Sequence control relays: LSCR SCRT CSCRE SCRE (001:5803-5884, 000:7974-8004).
// Their meaning is in ir/s7200/control.hpp; what an inactive segment does is Choice::InactiveScr.
// Tests: tests/manual/scr_test.cpp.
#pragma once

#include "ir/s7200/isa/control.hpp"

namespace rungproof::isa {

struct LoadScr : InScan {
  static constexpr Desc desc = withOperands({.stl = "LSCR",
                                             .meaning = "start of an SCR segment",
                                             .group = "program control",
                                             .drawn = "SCR",
                                             .execution = Execution::Control,
                                             .control = Control::Lscr,
                                             .time = 730,
                                             .manual = "001:5809"},
                                            {in("S_bit", Type::Bool, form::S)});
};
struct ScrTransition : InScan {
  static constexpr Desc desc = withOperands({.stl = "SCRT",
                                             .meaning = "transition to another SCR segment",
                                             .group = "program control",
                                             .execution = Execution::Control,
                                             .stack = {1, 0, 0},
                                             .control = Control::Scrt,
                                             .time = 1000,
                                             .manual = "001:5834"},
                                            {out("S_bit", Type::Bool, form::S)});
};
struct ScrEndConditional : InScan {
  static constexpr Desc desc{.stl = "CSCRE",
                             .meaning = "leave the SCR segment if there is power flow",
                             .group = "program control",
                             .drawn = "SCRE",
                             .execution = Execution::Control,
                             .stack = {1, 0, 0},
                             .control = Control::ScrEndConditional,
                             .time = 310,
                             .manual = "001:5841"};
};
struct ScrEnd : InScan {
  static constexpr Desc desc{.stl = "SCRE",
                             .meaning = "end of an SCR segment",
                             .group = "program control",
                             .execution = Execution::Control,
                             .control = Control::ScrEnd,
                             .time = 24,
                             .manual = "001:5830"};
};

using ScrGroup = Group<LoadScr, ScrTransition, ScrEndConditional, ScrEnd>;

}  // namespace rungproof::isa
