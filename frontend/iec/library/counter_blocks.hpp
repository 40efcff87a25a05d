// Counters, for each type of numbers. One struct for each block.
#pragma once

#include "frontend/iec/library/library_block.hpp"

namespace rungproof::iec::library {

struct CountUp {
  static constexpr bool isForEachWidth = true;
  static constexpr std::string_view name = "CTU", text = R"(
FUNCTION_BLOCK CTU{0}
VAR_INPUT CU : BOOL; R : BOOL; PV : {1}; END_VAR
VAR_OUTPUT Q : BOOL; CV : {1}; END_VAR
VAR M : BOOL; END_VAR
IF R THEN CV := 0;
ELSIF CU AND NOT M AND (CV < PV OR __READING('iec-counter-limit', 'type-max') AND CV < {2}) THEN CV := CV + 1;
END_IF;
M := CU;
Q := CV >= PV;
END_FUNCTION_BLOCK
)";
};

struct CountDown {
  static constexpr bool isForEachWidth = true;
  static constexpr std::string_view name = "CTD", text = R"(
FUNCTION_BLOCK CTD{0}
VAR_INPUT CD : BOOL; LD : BOOL; PV : {1}; END_VAR
VAR_OUTPUT Q : BOOL; CV : {1}; END_VAR
VAR M : BOOL; END_VAR
IF LD THEN CV := PV;
ELSIF CD AND NOT M AND (CV > 0 OR __READING('iec-ctd-limit', 'type-min') AND CV > {3}) THEN CV := CV - 1;
END_IF;
M := CD;
Q := CV <= 0;
END_FUNCTION_BLOCK
)";
};

struct CountUpAndDown {
  static constexpr bool isForEachWidth = true;
  static constexpr std::string_view name = "CTUD", text = R"(
FUNCTION_BLOCK CTUD{0}
VAR_INPUT CU, CD : BOOL; R, LD : BOOL; PV : {1}; END_VAR
VAR_OUTPUT QU, QD : BOOL; CV : {1}; END_VAR
VAR MU, MD : BOOL; UP, DOWN : BOOL; END_VAR
UP := CU AND NOT MU;
DOWN := CD AND NOT MD;
IF R THEN CV := 0;
ELSIF LD THEN CV := PV;
ELSIF UP AND NOT DOWN AND (CV < PV OR __READING('iec-counter-limit', 'type-max') AND CV < {2}) THEN CV := CV + 1;
ELSIF DOWN AND NOT UP AND (CV > 0 OR __READING('iec-ctd-limit', 'type-min') AND CV > {3}) THEN CV := CV - 1;
END_IF;
IF NOT (__READING('iec-ctud-edges', 'when-counting') AND (R OR LD)) THEN
  MU := CU;
  MD := CD;
END_IF;
QU := CV >= PV;
QD := CV <= 0;
END_FUNCTION_BLOCK
)";
};

using CounterBlocks = Group<CountUp, CountDown, CountUpAndDown>;

}  // namespace rungproof::iec::library
