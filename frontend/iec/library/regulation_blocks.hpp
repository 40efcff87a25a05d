// Blocks for regulation, as the annex of the standard has them. CYCLE is the time from one call to the next; its number
// is that of TIME_TO_REAL, for which implementations differ ('iec-time-number'). One struct for each block.
#pragma once

#include "frontend/iec/library/library_block.hpp"

namespace rungproof::iec::library {

struct Hysteresis {
  static constexpr std::string_view name = "HYSTERESIS", text = R"(
FUNCTION_BLOCK HYSTERESIS
VAR_INPUT XIN1, XIN2, EPS : REAL; END_VAR
VAR_OUTPUT Q : BOOL; END_VAR
IF Q THEN
  IF XIN1 < XIN2 - EPS THEN Q := FALSE; END_IF;
ELSIF XIN1 > XIN2 + EPS THEN Q := TRUE;
END_IF;
END_FUNCTION_BLOCK
)";
};

struct Integral {
  static constexpr std::string_view name = "INTEGRAL", text = R"(
FUNCTION_BLOCK INTEGRAL
VAR_INPUT RUN, R1 : BOOL; XIN, X0 : REAL; CYCLE : TIME; END_VAR
VAR_OUTPUT Q : BOOL; XOUT : REAL; END_VAR
Q := NOT R1;
IF R1 THEN XOUT := X0;
ELSIF RUN THEN XOUT := XOUT + XIN * TIME_TO_REAL(CYCLE);
END_IF;
END_FUNCTION_BLOCK
)";
};

struct Derivative {
  static constexpr std::string_view name = "DERIVATIVE", text = R"(
FUNCTION_BLOCK DERIVATIVE
VAR_INPUT RUN : BOOL; XIN : REAL; CYCLE : TIME; END_VAR
VAR_OUTPUT XOUT : REAL; END_VAR
VAR X1, X2, X3 : REAL; END_VAR
IF RUN THEN
  XOUT := (3.0 * (XIN - X3) + X1 - X2) / (10.0 * TIME_TO_REAL(CYCLE));
  X3 := X2; X2 := X1; X1 := XIN;
ELSE
  XOUT := 0.0; X1 := XIN; X2 := XIN; X3 := XIN;
END_IF;
END_FUNCTION_BLOCK
)";
};

struct Pid {
  static constexpr std::string_view name = "PID", text = R"(
FUNCTION_BLOCK PID
VAR_INPUT AUTO : BOOL; PV, SP, X0, KP, TR, TD : REAL; CYCLE : TIME; END_VAR
VAR_OUTPUT XOUT : REAL; END_VAR
VAR ERROR : REAL; ITERM : INTEGRAL; DTERM : DERIVATIVE; END_VAR
ERROR := PV - SP;
ITERM(RUN := AUTO, R1 := NOT AUTO, XIN := ERROR, X0 := TR * (X0 - ERROR), CYCLE := CYCLE);
DTERM(RUN := AUTO, XIN := ERROR, CYCLE := CYCLE);
XOUT := KP * (ERROR + ITERM.XOUT / TR + DTERM.XOUT * TD);
END_FUNCTION_BLOCK
)";
};

struct Ramp {
  static constexpr std::string_view name = "RAMP", text = R"(
FUNCTION_BLOCK RAMP
VAR_INPUT RUN : BOOL; X0, X1 : REAL; TR, CYCLE : TIME; END_VAR
VAR_OUTPUT BUSY : BOOL; XOUT : REAL; END_VAR
VAR XI : REAL; T : TIME; END_VAR
BUSY := RUN;
IF NOT RUN THEN XOUT := X0; XI := X0; T := T#0ms;
ELSIF T >= TR THEN BUSY := FALSE; XOUT := X1;
ELSE
  XOUT := XI + (X1 - XI) * TIME_TO_REAL(T) / TIME_TO_REAL(TR);
  T := T + CYCLE;
END_IF;
END_FUNCTION_BLOCK
)";
};

using RegulationBlocks = Group<Hysteresis, Integral, Derivative, Pid, Ramp>;

}  // namespace rungproof::iec::library
