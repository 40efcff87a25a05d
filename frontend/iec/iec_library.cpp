// The function blocks of the standard, in its own language. The state of a timer is 0 idle, 1 running, 2 done; while it
// runs the machine adds the time of each scan to ELAPSED (PASS, ir/iec/isa/control.hpp), so that it goes on whether the
// block is called or not. `__READING('key', 'value')` is TRUE where that reading of an open point is in force.
#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

namespace {

constexpr std::string_view bistables = R"(
FUNCTION_BLOCK SR
VAR_INPUT S1, R : BOOL; END_VAR
VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := S1 OR (NOT R AND Q1);
END_FUNCTION_BLOCK

FUNCTION_BLOCK RS
VAR_INPUT S, R1 : BOOL; END_VAR
VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := NOT R1 AND (S OR Q1);
END_FUNCTION_BLOCK

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

FUNCTION_BLOCK R_TRIG
VAR_INPUT CLK : BOOL; END_VAR
VAR_OUTPUT Q : BOOL; END_VAR
VAR M : BOOL; END_VAR
Q := CLK AND NOT M;
M := CLK;
END_FUNCTION_BLOCK

FUNCTION_BLOCK F_TRIG
VAR_INPUT CLK : BOOL; END_VAR
VAR_OUTPUT Q : BOOL; END_VAR
VAR M : BOOL; KNOWN : BOOL; END_VAR
Q := NOT CLK AND NOT M AND (KNOWN OR NOT __READING('iec-ftrig-first', 'none'));
M := NOT CLK;
KNOWN := TRUE;
END_FUNCTION_BLOCK
)";

/// {0}: name behind the first letters, {1}: type of PV and CV, {2}: its greatest, {3}: its least number.
constexpr std::string_view counters = R"(
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

constexpr std::string_view timers = R"(
FUNCTION_BLOCK TON
VAR_INPUT IN : BOOL; PT : TIME; END_VAR
VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR STATE : USINT; ELAPSED : TIME; M : BOOL; END_VAR
IF STATE = 0 AND IN AND NOT M THEN
  STATE := 1; ELAPSED := T#0ms; Q := FALSE; ET := T#0ms;
  IF __READING('iec-timer-start', 'same-call') AND PT <= T#0ms THEN STATE := 2; Q := TRUE; ET := PT; END_IF;
ELSIF NOT IN THEN
  STATE := 0; Q := FALSE; ET := T#0ms;
ELSIF STATE = 1 THEN
  IF PT <= ELAPSED THEN STATE := 2; Q := TRUE; ET := PT;
  ELSE ET := ELAPSED; END_IF;
END_IF;
M := IN;
END_FUNCTION_BLOCK

FUNCTION_BLOCK TP
VAR_INPUT IN : BOOL; PT : TIME; END_VAR
VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR STATE : USINT; ELAPSED : TIME; M : BOOL; END_VAR
IF STATE = 0 AND IN AND NOT M THEN
  STATE := 1; ELAPSED := T#0ms; Q := TRUE;
  IF __READING('iec-timer-start', 'same-call') AND PT <= T#0ms THEN STATE := 2; Q := FALSE; ET := PT; END_IF;
ELSIF STATE = 1 THEN
  IF PT <= ELAPSED THEN STATE := 2; Q := FALSE; ET := PT;
  ELSE ET := ELAPSED; END_IF;
END_IF;
IF STATE = 2 AND NOT IN THEN ET := T#0ms; STATE := 0; END_IF;
M := IN;
END_FUNCTION_BLOCK

FUNCTION_BLOCK TOF
VAR_INPUT IN : BOOL; PT : TIME; END_VAR
VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR STATE : USINT; ELAPSED : TIME; M : BOOL; END_VAR
IF STATE = 0 AND NOT IN AND M THEN
  STATE := 1; ELAPSED := T#0ms;
  IF __READING('iec-timer-start', 'same-call') AND PT <= T#0ms THEN STATE := 2; ET := PT; END_IF;
ELSIF IN THEN
  STATE := 0; ET := T#0ms;
ELSIF STATE = 1 THEN
  IF PT <= ELAPSED THEN STATE := 2; ET := PT;
  ELSE ET := ELAPSED; END_IF;
END_IF;
Q := IN OR STATE = 1;
M := IN;
END_FUNCTION_BLOCK
)";

/// A step of a chart: T is the time since its activation and keeps its value behind it, CLOCK the same as far as it is
/// compared with constants, WAS its X of the scan before. The machine lets the time pass (PASS).
constexpr std::string_view steps = R"(
FUNCTION_BLOCK __STEP
VAR_OUTPUT X : BOOL; T : TIME; END_VAR
VAR CLOCK : TIME; WAS : BOOL; END_VAR
END_FUNCTION_BLOCK
)";

constexpr std::string_view regulation = R"(
FUNCTION_BLOCK HYSTERESIS
VAR_INPUT XIN1, XIN2, EPS : REAL; END_VAR
VAR_OUTPUT Q : BOOL; END_VAR
IF Q THEN
  IF XIN1 < XIN2 - EPS THEN Q := FALSE; END_IF;
ELSIF XIN1 > XIN2 + EPS THEN Q := TRUE;
END_IF;
END_FUNCTION_BLOCK
)";

/// The decimal digits of a number, and a minus sign: what INT_TO_STRING and its kin make on every implementation.
constexpr std::string_view digits = R"(
FUNCTION __UNSIGNED_TEXT : STRING[11]
VAR_INPUT X : UDINT; END_VAR
VAR REST : UDINT; I : INT; MADE : STRING[11]; END_VAR
REST := X;
FOR I := 1 TO 10 DO
  IF I = 1 OR REST > 0 THEN
    MADE := CONCAT(MID('0123456789', 1, UDINT_TO_DINT(REST MOD 10) + 1), MADE);
    REST := REST / 10;
  END_IF;
END_FOR;
__UNSIGNED_TEXT := MADE;
END_FUNCTION

FUNCTION __SIGNED_TEXT : STRING[11]
VAR_INPUT X : DINT; END_VAR
IF X < 0 THEN __SIGNED_TEXT := CONCAT('-', __UNSIGNED_TEXT(DINT_TO_UDINT(-X)));
ELSE __SIGNED_TEXT := __UNSIGNED_TEXT(DINT_TO_UDINT(X));
END_IF;
END_FUNCTION
)";

}  // namespace

void addStandardBlocks(Program& program, ProjectSyntax& project) {
  std::string text;
  text += bistables;
  struct Width {
    const char *suffix, *type, *greatest, *least;
  };
  for (const Width& width : {Width{"", "INT", "32767", "-32768"},
                             {"_INT", "INT", "32767", "-32768"},
                             {"_DINT", "DINT", "2147483647", "-2147483648"},
                             {"_UDINT", "UDINT", "4294967295", "0"},
                             {"_UINT", "UINT", "65535", "0"},
                             {"_LINT", "LINT", "9223372036854775807", "-9223372036854775807 - 1"},
                             {"_ULINT", "ULINT", "18446744073709551615", "0"}})
    text += fmt::format(fmt::runtime(counters), width.suffix, width.type, width.greatest, width.least);
  text += timers;
  text += steps;
  text += regulation;
  text += digits;
  const std::uint32_t file = program.sources->add("blocks of IEC 61131-3", text);
  SyntaxSink sink(program, file);
  ProjectSyntax library;
  parseProject({program.sources->file(file).text(), file, 0, nullptr}, sink, library);
  for (BlockSyntax& block : library.blocks) {
    const bool isOwn = std::ranges::any_of(
        project.blocks, [&](const BlockSyntax& own) { return foldedName(own.name) == foldedName(block.name); });
    if (isOwn) continue;
    block.isLibrary = true;
    project.blocks.push_back(std::move(block));
  }
}

}  // namespace rungproof::iec
