// Subroutines: CALL, CRET, RET (001:6731-6838). Their meaning is in ir/s7200/control.hpp.
// What each kind of parameter may be is in ir/s7200/call_parameters.hpp. Tests: tests/manual/call_test.cpp.
#pragma once

#include <algorithm>

#include "ir/s7200/isa/control.hpp"

namespace rungproof::isa {

/// Every form that some kind of parameter may take.
inline constexpr Forms anyParameter =
    form::bitAny | form::AC | form::HC | form::AI | form::AQ | form::Pointers | form::Const | form::Address;

/// The second operand stands for 0 to 16 actual parameters (001:6775). Subroutine numbers: table 6-78 (001:6751)
/// against 0..63 for one CPU in table 6-1 (001:2666): the descriptor has the wider range, CpuFeatures both.
struct Call : InScan {
  static constexpr CpuSet large =
      cpusWith([](const CpuRow& row) { return std::max(row.features.subroutines, row.features.callable) == 128; });
  static constexpr CpuSet smallest = cpusWith([](const CpuRow& row) { return row.features.subroutines == 16; });
  static constexpr Desc desc =
      withOperands({.stl = "CALL",
                    .meaning = "call a subroutine with up to 16 parameters",
                    .group = "program control",
                    .execution = Execution::Control,
                    .stack = {1, 0, 0},
                    .eno = true,
                    .control = Control::Call,
                    .time = 900,
                    .manual = "001:6733"},
                   {in("SBR_N", Type::Subroutine, form::Const)
                        .within({{0, 15, smallest}, {0, 63, everyCpu & ~large & ~smallest}, {0, 127, large}}),
                    optional(inout("parameter", Type::Parameter, anyParameter))});
};
struct ReturnConditional : InScan {
  static constexpr Desc desc{.stl = "CRET",
                             .meaning = "return from the subroutine if there is power flow",
                             .group = "program control",
                             .drawn = "RET",
                             .execution = Execution::Control,
                             .stack = {1, 0, 0},
                             .control = Control::ReturnConditional,
                             .time = 1600,
                             .manual = "001:6735"};
};
struct Return : InScan {
  static constexpr Desc desc{.stl = "RET",
                             .meaning = "end of the subroutine",
                             .group = "only in Appendix F or C",
                             .execution = Execution::Control,
                             .control = Control::Return,
                             .olderDialectOnly = true,
                             .time = 1600,
                             .manual = "001:6763"};
};

using CallGroup = Group<Call, ReturnConditional, Return>;

}  // namespace rungproof::isa
