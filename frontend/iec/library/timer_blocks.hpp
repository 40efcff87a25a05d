// Timers and the clock of steps. One struct for each block. The state of a timer is 0 idle, 1 running, 2 done; while it
// runs the machine adds the time of each scan to ELAPSED (PASS, ir/iec/isa/control.hpp), so that it goes on whether the
// block is called or not. All of them see the clock of the scan ('iec-timer-clock'). By the reading 're-evaluated' of
// 'iec-timer-done' a timer never is done: it runs on and compares in each call.
#pragma once

#include "frontend/iec/library/library_block.hpp"

namespace rungproof::iec::library {

/// TRUE where the time of a running timer is over.
#define RUNGPROOF_IEC_TIME_IS_OVER                         \
  "__READING('iec-timer-clock', 'scan') AND PT <= ELAPSED" \
  " AND NOT (PT = ELAPSED AND __READING('iec-timer-expiry', 'after-preset'))"

struct OnDelay {
  static constexpr std::string_view name = "TON", text = R"(
FUNCTION_BLOCK TON
VAR_INPUT IN : BOOL; PT : TIME; END_VAR
VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR STATE : USINT; ELAPSED : TIME; M : BOOL; END_VAR
IF STATE = 0 AND IN AND NOT M THEN
  STATE := 1; ELAPSED := T#0ms; Q := FALSE; ET := T#0ms;
  IF __READING('iec-timer-start', 'same-call') AND PT <= T#0ms THEN
    Q := TRUE; ET := PT;
    IF NOT __READING('iec-timer-done', 're-evaluated') THEN STATE := 2; END_IF;
  END_IF;
ELSIF NOT IN THEN
  STATE := 0; Q := FALSE; ET := T#0ms;
ELSIF STATE = 1 THEN
  IF )" RUNGPROOF_IEC_TIME_IS_OVER R"( THEN
    Q := TRUE; ET := PT;
    IF NOT __READING('iec-timer-done', 're-evaluated') THEN STATE := 2; END_IF;
  ELSE Q := FALSE; ET := ELAPSED; END_IF;
END_IF;
M := IN;
END_FUNCTION_BLOCK
)";
};

struct Pulse {
  static constexpr std::string_view name = "TP", text = R"(
FUNCTION_BLOCK TP
VAR_INPUT IN : BOOL; PT : TIME; END_VAR
VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR STATE : USINT; ELAPSED : TIME; M : BOOL; END_VAR
IF STATE = 0 AND IN AND NOT M THEN
  STATE := 1; ELAPSED := T#0ms; Q := TRUE;
  IF __READING('iec-timer-start', 'same-call') AND PT <= T#0ms THEN
    Q := FALSE; ET := PT;
    IF NOT __READING('iec-timer-done', 're-evaluated') THEN STATE := 2; END_IF;
  END_IF;
ELSIF STATE = 1 THEN
  IF )" RUNGPROOF_IEC_TIME_IS_OVER R"( THEN
    Q := FALSE; ET := PT;
    IF NOT __READING('iec-timer-done', 're-evaluated') OR NOT IN THEN STATE := 2; END_IF;
  ELSE Q := TRUE; ET := ELAPSED; END_IF;
END_IF;
IF STATE = 2 AND NOT IN THEN ET := T#0ms; STATE := 0; END_IF;
M := IN;
END_FUNCTION_BLOCK
)";
};

struct OffDelay {
  static constexpr std::string_view name = "TOF", text = R"(
FUNCTION_BLOCK TOF
VAR_INPUT IN : BOOL; PT : TIME; END_VAR
VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR STATE : USINT; ELAPSED : TIME; M : BOOL; END_VAR
IF IN THEN
  STATE := 0; ET := T#0ms; Q := TRUE;
ELSIF STATE = 0 AND M THEN
  STATE := 1; ELAPSED := T#0ms; Q := TRUE;
  IF __READING('iec-timer-start', 'same-call') AND PT <= T#0ms THEN
    Q := FALSE; ET := PT;
    IF NOT __READING('iec-timer-done', 're-evaluated') THEN STATE := 2; END_IF;
  END_IF;
ELSIF STATE = 1 THEN
  IF )" RUNGPROOF_IEC_TIME_IS_OVER R"( THEN
    Q := FALSE; ET := PT;
    IF NOT __READING('iec-timer-done', 're-evaluated') THEN STATE := 2; END_IF;
  ELSE Q := TRUE; ET := ELAPSED; END_IF;
ELSE Q := FALSE;
END_IF;
M := IN;
END_FUNCTION_BLOCK
)";
};

#undef RUNGPROOF_IEC_TIME_IS_OVER

/// A step of a chart: T is the time since its activation and keeps its value behind it, CLOCK the same as far as it is
/// compared with constants, WAS its X of the scan before. The machine lets the time pass (PASS).
struct Step {
  static constexpr std::string_view name = "__STEP", text = R"(
FUNCTION_BLOCK __STEP
VAR_OUTPUT X : BOOL; T : TIME; END_VAR
VAR CLOCK : TIME; WAS : BOOL; END_VAR
END_FUNCTION_BLOCK
)";
};

/// What a clock of the day shows is not modelled: any two times at each call.
struct Clock {
  static constexpr std::string_view name = "__CLOCK", text = R"(
FUNCTION_BLOCK __CLOCK
VAR_OUTPUT SHOWN, MOVED : DT; END_VAR
END_FUNCTION_BLOCK
)";
};

/// The clock never goes back. Between a rising edge of IN and its fall CDT begins with PDT and goes on.
struct RealTimeClock {
  static constexpr std::string_view name = "RTC", text = R"(
FUNCTION_BLOCK RTC
VAR_INPUT IN : BOOL; PDT : DT; END_VAR
VAR_OUTPUT Q : BOOL; CDT : DT; END_VAR
VAR M : BOOL; NOW : DT; CLOCK : __CLOCK; END_VAR
CLOCK();
IF CLOCK.SHOWN > NOW THEN NOW := CLOCK.SHOWN; END_IF;
IF NOT IN THEN CDT := NOW;
ELSIF NOT M THEN CDT := PDT;
ELSIF CLOCK.MOVED > CDT THEN CDT := CLOCK.MOVED;
END_IF;
Q := IN;
M := IN;
END_FUNCTION_BLOCK
)";
};

using TimerBlocks = Group<OnDelay, Pulse, OffDelay, Step, Clock, RealTimeClock>;

}  // namespace rungproof::iec::library
