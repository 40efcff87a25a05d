// Bistable blocks and edges. One struct for each block.
#pragma once

#include "frontend/iec/library/library_block.hpp"

namespace rungproof::iec::library {

struct SetDominant {
  static constexpr std::string_view name = "SR", text = R"(
FUNCTION_BLOCK SR
VAR_INPUT S1, R : BOOL; END_VAR
VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := S1 OR (NOT R AND Q1);
END_FUNCTION_BLOCK
)";
};

struct ResetDominant {
  static constexpr std::string_view name = "RS", text = R"(
FUNCTION_BLOCK RS
VAR_INPUT S, R1 : BOOL; END_VAR
VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := NOT R1 AND (S OR Q1);
END_FUNCTION_BLOCK
)";
};

struct Semaphore {
  static constexpr std::string_view name = "SEMA", text = R"(
FUNCTION_BLOCK SEMA
VAR_INPUT CLAIM, RELEASE : BOOL; END_VAR
VAR_OUTPUT BUSY : BOOL; END_VAR
VAR X : BOOL; END_VAR
IF __READING('iec-sema', 'delayed') THEN
  BUSY := X;
  IF CLAIM THEN X := TRUE; ELSIF RELEASE THEN BUSY := FALSE; X := FALSE; END_IF;
ELSE
  X := CLAIM OR (X AND NOT RELEASE);
  BUSY := X;
END_IF;
END_FUNCTION_BLOCK
)";
};

struct RisingEdge {
  static constexpr std::string_view name = "R_TRIG", text = R"(
FUNCTION_BLOCK R_TRIG
VAR_INPUT CLK : BOOL; END_VAR
VAR_OUTPUT Q : BOOL; END_VAR
VAR M : BOOL; END_VAR
Q := CLK AND NOT M;
M := CLK;
END_FUNCTION_BLOCK
)";
};

struct FallingEdge {
  static constexpr std::string_view name = "F_TRIG", text = R"(
FUNCTION_BLOCK F_TRIG
VAR_INPUT CLK : BOOL; END_VAR
VAR_OUTPUT Q : BOOL; END_VAR
VAR M : BOOL; KNOWN : BOOL; END_VAR
Q := NOT CLK AND NOT M AND (KNOWN OR NOT __READING('iec-ftrig-first', 'none'));
M := NOT CLK;
KNOWN := TRUE;
END_FUNCTION_BLOCK
)";
};

using BistableBlocks = Group<SetDominant, ResetDominant, Semaphore, RisingEdge, FallingEdge>;

}  // namespace rungproof::iec::library
