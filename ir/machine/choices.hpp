// The points that the manual leaves open. Each is one named choice with its reading and its reason; the engine,
// the encoder and the reports all take it from here, and `rungproof config` prints the table. The first value of a
// row is the default.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rungproof {

/// What each is stands in its row of choiceTable.
enum class Choice : std::uint8_t {
  InactiveScr,
  IncrementOverflow,
  RoundHalf,
  MainStop,
  UnknownBits,
  SkippedEno,
  ScanClockStart,
  WatchdogMs,
  FirstEdge,
  DivideFlags,
  LatchZeroCount,
  LatchOverBorder,
  RealFromDInt,
  BcdErrorResult,
  AthError,
  SubstringOverflow,
  EncodeZero,
  EncodeHighNibble,
  CountUpDownAtPreset,
  CountDownFirstScan,
  CounterFirstEdge,
  IecCounterPriority,
  ClockData,
  ClockModule,
  PortAgain,
  NetworkAgain,
  StringResultOverflow,
  PidTimeUnit,
  InterruptStack,
  InterruptCallStack,
  DetachedEvents,
  BlockMoveNothing,
  BlockMoveOverlap,
  BlockMoveTooFar,
  ForAtMaximum,
  SubstringBeyondEnd,
  FindEmpty,
  FindStartBeyond,
  AnalogSampling,
  TimerAfterReset,
  MainStack,
  MissingBlocks,
  S5Time,
  OpenBlockPointer,
  ParameterPointer,
  HotRestart,
  LongestScan,
  UnwrittenOutput,
  IecDivZero,
  IecModZero,
  IecArrayRange,
  IecRound,
  IecCounterLimit,
  IecCtdLimit,
  IecTimerStart,
  IecShortCircuit,
  IecTaskOrder,
  IecTimeNumber,
  IecNetworkFeedback,
  IecEnFalseResult,
  IecSfcOrder,
  IecSfcInitialEdge,
  IecSfcFinalScan,
  IecSfcActionOrder,
  IecIntermediate,
  IecTimerPreset,
  IecForBounds,
  IecFbdOrder,
  IecLdFlow,
  IecPhase,
  IecAddressUnit,
  IecFtrigFirst,
  IecCtudEdges,
  IecSema,
  IecLimitCrossed,
  IecSfcSelection,
  IecInout,
  IecTimerClock,
  IecTimerExpiry,
  IecTimerDone,
  IecMuxRange,
  IecToBool,
  IecSubrange,
  IecHexLiteral,
  IecPreemption,
  IecByteOrder,
  IecConditionBlocks,
  count
};

/// Whether proofs cover all values of a choice that nobody has made. A fact of the plant is one way for each plant (a
/// module is fitted or not), or is covered otherwise (unknown bits are free anyway): proofs take the default and say
/// so.
enum class ChoiceKind : std::uint8_t { Reading, Fact };

struct ChoiceInfo {
  Choice choice;
  std::string_view key;                    ///< configuration key
  std::array<std::string_view, 3> values;  ///< names; unused ones are empty
  std::string_view why;                    ///< what is open and why the default is what it is
  std::string_view manual;
  ChoiceKind kind = ChoiceKind::Reading;
};

inline constexpr std::array<ChoiceInfo, static_cast<std::size_t>(Choice::count)> choiceTable = {{
    {Choice::InactiveScr,
     "inactive-scr",
     {"no-power-flow", "skipped", ""},
     "what an inactive SCR segment does: executed with power flow 0 (TOF is reset, coils drop) or not executed at all",
     "001:5830"},
    {Choice::IncrementOverflow,
     "increment-overflow",
     {"wraps", "keeps", ""},
     "INC/DEC result on overflow: the rule that operands stay as they were is not repeated for them",
     "001:4999"},
    {Choice::RoundHalf, "round-half", {"away-from-zero", "up", ""}, "ROUND of negative halves", "001:3496"},
    {Choice::MainStop,
     "stop-in-main",
     {"at-once", "end-of-scan", ""},
     "whether the rest of the scan runs after STOP in the main program",
     "001:5691"},
    {Choice::UnknownBits,
     "unknown-bits",
     {"zero", "one", "random"},
     "value the engine gives to bits that the manual calls unknown (popped stack levels, local memory); the prover "
     "takes any",
     "001:2868",
     ChoiceKind::Fact},
    {Choice::SkippedEno, "skipped-eno", {"zero", "kept", ""}, "ENO after a box that had no power flow", "001:2276"},
    {Choice::ScanClockStart,
     "scan-clock-start",
     {"off", "on", ""},
     "phase of SM0.4, SM0.5, SM0.6 in the first scan",
     "001:14681"},
    {Choice::WatchdogMs,
     "watchdog",
     {"500ms", "300ms", ""},
     "scan watchdog: the text says 500 ms, the quick reference 300 ms",
     "001:5718",
     ChoiceKind::Fact},
    {Choice::FirstEdge,
     "first-edge",
     {"first-scan-only", "first-execution", ""},
     "EU/ED first executed after the first scan: compares with 0, or stores silently as in the first scan",
     "001:2763"},
    {Choice::DivideFlags,
     "div-flags",
     {"double-word", "quotient", ""},
     "what SM1.0 and SM1.2 describe after DIV: remainder and quotient as one double word, or the quotient",
     "001:4898"},
    {Choice::LatchZeroCount,
     "latch-zero-count",
     {"nothing", "error", ""},
     "S, R, SI, RI with N = 0: no bit, or error 0091",
     "001:2789"},
    {Choice::LatchOverBorder,
     "latch-over-border",
     {"nothing", "up-to-border", ""},
     "which bits S and R change before error 0091 is found: none, or those inside the area",
     "001:2796"},
    {Choice::RealFromDInt,
     "dtr-rounding",
     {"nearest", "truncated", ""},
     "DTR of a number with more than 24 binary digits",
     "001:3465"},
    {Choice::BcdErrorResult,
     "bcd-error-result",
     {"unchanged", "unknown", ""},
     "OUT of BCDI and IBCD after SM1.6",
     "001:3460"},
    {Choice::AthError,
     "ath-error",
     {"stops-there", "nothing", ""},
     "how many bytes ATH writes before an illegal character",
     "001:3587"},
    {Choice::SubstringOverflow,
     "substring-overflow",
     {"unchanged", "unknown", ""},
     "OUT of STI and STD when the number is too large",
     "001:3877"},
    {Choice::EncodeZero, "enco-zero", {"zero", "unchanged", ""}, "ENCO of a word without a 1", "001:3941"},
    {Choice::EncodeHighNibble,
     "enco-high-nibble",
     {"cleared", "kept", ""},
     "upper four bits of OUT after ENCO; the example shows them 0",
     "000:3312"},
    {Choice::CountUpDownAtPreset,
     "ctud-at-preset",
     {"wraps", "stops", ""},
     "one sentence of 2003 stops CTUD at PV; the text above it and the table let it count on",
     "000:3376"},
    {Choice::CountDownFirstScan,
     "ctd-first-scan",
     {"on", "off", ""},
     "bit of a CTD at 0 in the first scan: on by the rule current = 0, off by the table of power-up",
     "001:4030"},
    {Choice::CounterFirstEdge,
     "counter-first-edge",
     {"stored", "counts", ""},
     "a count input that is 1 in the first scan: stored as EU does, or counted",
     "001:2763"},
    {Choice::IecCounterPriority,
     "iec-counter-priority",
     {"reset", "load", ""},
     "R and LD of the IEC up/down counter together",
     "001:4097"},
    {Choice::ClockData,
     "clock-data",
     {"bcd-and-range", "bcd", "any"},
     "which data TODW refuses with error 0007: not BCD or out of its field's range, not BCD only, or none",
     "001:2924"},
    {Choice::ClockModule,
     "clock-module",
     {"absent", "fitted", ""},
     "CPU 221 and 222 have the clock as a plug-in module",
     "001:11666",
     ChoiceKind::Fact},
    {Choice::PortAgain,
     "port-again",
     {"ignored", "error", ""},
     "XMT during a transmission, RCV during a reception: ignored, or error 0009/000B as for XMT against RCV",
     "001:3141"},
    {Choice::NetworkAgain,
     "network-again",
     {"ignored", "queued", ""},
     "NETR, NETW on a table that is still active",
     "001:3031"},
    {Choice::StringResultOverflow,
     "string-overflow",
     {"unchanged", "cut", ""},
     "SCAT result over 254 characters",
     "001:6093"},
    {Choice::PidTimeUnit,
     "pid-time-unit",
     {"minutes", "seconds", ""},
     "Ti and Td of the PID table are in minutes and Ts in seconds, but the printed formulas show no factor 60; the "
     "default applies it",
     "001:5315"},
    {Choice::InterruptStack,
     "interrupt-stack",
     {"one", "zero", ""},
     "top of the logic stack at the start of an interrupt routine; the default is that of a subroutine",
     "001:5430"},
    {Choice::InterruptCallStack,
     "interrupt-call-stack",
     {"saved", "shared", ""},
     "whether CALL in an interrupt routine saves the logic stack as every CALL does, or shares it as the text on "
     "interrupts says",
     "001:5444"},
    {Choice::DetachedEvents,
     "detached-events",
     {"kept", "dropped", ""},
     "events that wait in a queue when DTCH detaches them: they stay and their routine still runs, which is why the "
     "text "
     "lets CEVNT clear them after DTCH, or they are dropped; the prover covers both",
     "001:5357"},
    {Choice::BlockMoveNothing,
     "block-move-zero",
     {"nothing", "error", ""},
     "BMB, BMW, BMD and FILL with N = 0: no effect, or error 0091",
     "001:5654"},
    {Choice::BlockMoveOverlap,
     "block-move-overlap",
     {"ascending", "buffered", ""},
     "block move or string copy onto itself: element by element from the first, or as if all were read before the "
     "first is written",
     "001:5654"},
    {Choice::BlockMoveTooFar,
     "block-move-range",
     {"nothing", "up-to-the-end", ""},
     "what a block move or FILL writes when a block leaves its area (error 0091)",
     "001:5648"},
    {Choice::ForAtMaximum,
     "for-at-maximum",
     {"ends", "wraps", ""},
     "FOR with FINAL = 32767: the loop ends after the pass with 32767, or INDX wraps and it never ends",
     "001:5768"},
    {Choice::SubstringBeyondEnd,
     "substring-beyond-end",
     {"cut", "error", ""},
     "SSCPY asks for more characters than there are: those that are there, or error 0091",
     "001:6133"},
    {Choice::FindEmpty, "find-empty", {"not-found", "at-start", ""}, "SFND for an empty string", "001:6158"},
    {Choice::FindStartBeyond,
     "find-start-beyond",
     {"not-found", "error", ""},
     "SFND, CFND from a position behind the end: 0, or error 0091",
     "001:6158"},
    {Choice::AnalogSampling,
     "analog-sampling",
     {"each-scan", "each-read", ""},
     "analog inputs: sampled once a scan, as with the input filter that is on by default, or at every access, as "
     "without it",
     "001:1812",
     ChoiceKind::Fact},
    {Choice::TimerAfterReset,
     "timer-after-reset",
     {"goes-on", "starts-anew", ""},
     "an enabled 100 ms timer after R: its next execution counts the intervals since the start of the scan before, as "
     "without R, or none as when it is enabled",
     "001:6611"},
    {Choice::MainStack,
     "main-stack",
     {"zero", "unknown", ""},
     "logic stack at the start of the main program: all 0, or any values",
     "001:2868"},
    {Choice::MissingBlocks,
     "missing-blocks",
     {"by-signature", "anything", ""},
     "what a called block may write whose text is missing or hidden by a password: the places that its calls give it, "
     "or anything, so that nothing is proved beside it",
     "001:6815",
     ChoiceKind::Fact},
    {Choice::S5Time,
     "s5-time",
     {"synchronous", "any", ""},
     "S7-300/400: when an S5 timer of n units ends: n units after its start, seen when the next scan begins, or at any "
     "instruction, the first unit short by up to one time base",
     "003:1020"},
    {Choice::OpenBlockPointer,
     "open-block-pointer",
     {"number", "zero", ""},
     "S7-300/400: the data block in a POINTER or ANY for data that is written without its block (DBW 4, P#DBX 4.0 BYTE "
     "2): the number of the open one, or 0",
     "002:2193"},
    {Choice::ParameterPointer,
     "parameter-pointer",
     {"actual", "unknown", ""},
     "S7-300/400: where a POINTER or ANY leads that is made of an elementary parameter of an FC: to what its caller "
     "gives, or to a place that is not known",
     "002:2174"},
    {Choice::HotRestart,
     "hot-restart",
     {"possible", "excluded", ""},
     "S7-400 with OB101: whether the parameters of the CPU let it begin a hot restart; what that leaves is not stated, "
     "so that nothing is proved beside OB101 unless it is excluded",
     "002:1389",
     ChoiceKind::Fact},
    {Choice::LongestScan,
     "longest-scan",
     {"25s", "5s", "60s"},
     "S7-200, S7-300/400: when a scan that restarts its watchdog for ever (WDR, SFC 43) ends in the engine; no manual "
     "states a limit, timers of the S7-200 count wrong from 25 s on; an S7-200 SMART ends at 5 s",
     "001:5708",
     ChoiceKind::Fact},
    {Choice::UnwrittenOutput,
     "unwritten-output",
     {"kept", "any", ""},
     "S7-300/400: what an output of an FC that the block does not write hands out: the actual keeps its value, as it "
     "is given by reference, or gets any, as it does where the call copies it",
     "002:154"},
    {Choice::IecDivZero,
     "iec-div-zero",
     {"fault", "zero", ""},
     "IEC 61131-3: what a whole number divided by 0 does: it ends the scan, or the result is 0",
     "IEC 61131-3"},
    {Choice::IecModZero,
     "iec-mod-zero",
     {"zero", "fault", ""},
     "IEC 61131-3: what MOD by 0 does: the result is 0, or it ends the scan",
     "IEC 61131-3"},
    {Choice::IecArrayRange,
     "iec-array-range",
     {"fault", "clamp", ""},
     "IEC 61131-3: what an index outside of its array does: it ends the scan, or means the nearest element",
     "IEC 61131-3"},
    {Choice::IecRound,
     "iec-round",
     {"half-even", "half-away", ""},
     "IEC 61131-3: where REAL_TO_INT rounds a half: to the even number, or away from zero",
     "IEC 61131-3"},
    {Choice::IecCounterLimit,
     "iec-counter-limit",
     {"preset", "type-max", ""},
     "IEC 61131-3: how far CTU and CTUD count up: to PV, or to the greatest number of the type",
     "IEC 61131-3"},
    {Choice::IecCtdLimit,
     "iec-ctd-limit",
     {"zero", "type-min", ""},
     "IEC 61131-3: how far CTD and CTUD count down: to 0, or to the least number of the type",
     "IEC 61131-3"},
    {Choice::IecTimerStart,
     "iec-timer-start",
     {"next-call", "same-call", ""},
     "IEC 61131-3: whether a timer whose PT is 0 or less ends in the call after the one that starts it, or in the same",
     "IEC 61131-3"},
    {Choice::IecShortCircuit,
     "iec-short-circuit",
     {"no", "yes", ""},
     "IEC 61131-3: whether the right side of AND and OR is computed where the left one decides; it matters where that "
     "divides, indexes or calls",
     "IEC 61131-3"},
    {Choice::IecTaskOrder,
     "iec-task-order",
     {"priority", "declaration", ""},
     "IEC 61131-3: in which order programs run that are due at once: by the priority of their tasks, or as they are "
     "declared",
     "IEC 61131-3"},
    {Choice::IecTimeNumber,
     "iec-time-number",
     {"milliseconds", "seconds", ""},
     "IEC 61131-3: the number that TIME_TO_DINT and its kin make of a duration, and take for one",
     "IEC 61131-3"},
    {Choice::IecNetworkFeedback,
     "iec-network-feedback",
     {"sequential", "snapshot", ""},
     "IEC 61131-3: what a contact sees of a variable that a coil before it in the same network writes: what was "
     "written, or the value of before the network",
     "IEC 61131-3"},
    {Choice::IecEnFalseResult,
     "iec-en-false-result",
     {"kept", "zero", ""},
     "IEC 61131-3: what takes the result of a function with EN while EN is FALSE: it keeps its value (in a drawing the "
     "output of a comparison gives what it gave last), or gets 0",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecSfcOrder,
     "iec-sfc-order",
     {"transitions-first", "actions-first", ""},
     "IEC 61131-3: whether a scan of a chart tests its transitions and then runs the actions of the new situation, or "
     "runs the actions first",
     "IEC 61131-3"},
    {Choice::IecSfcInitialEdge,
     "iec-sfc-initial-edge",
     {"yes", "no", ""},
     "IEC 61131-3: whether the start of a chart activates its initial step, so that P and P1 run in the first scan",
     "IEC 61131-3"},
    {Choice::IecSfcFinalScan,
     "iec-sfc-final-scan",
     {"no", "yes", ""},
     "IEC 61131-3: whether the body of an action runs once more in the scan in which it ceases to be active",
     "IEC 61131-3"},
    {Choice::IecSfcActionOrder,
     "iec-sfc-action-order",
     {"declaration", "alphabetical", ""},
     "IEC 61131-3: in which order the actions of a chart run in a scan: as they are declared, or by their names",
     "IEC 61131-3"},
    {Choice::IecIntermediate,
     "iec-intermediate",
     {"declared", "wide", ""},
     "IEC 61131-3: in how many bits sums and products of SINT, INT, USINT and UINT are computed before they are "
     "compared, divided or widened: in those of their type, or in 32",
     "IEC 61131-3"},
    {Choice::IecTimerPreset,
     "iec-timer-preset",
     {"live", "latched", ""},
     "IEC 61131-3: whether a timer that runs looks at PT in each call, or keeps the PT of its start",
     "IEC 61131-3"},
    {Choice::IecForBounds,
     "iec-for-bounds",
     {"each-pass", "once", ""},
     "IEC 61131-3: whether FOR looks at its limit and its step in each pass, or before the first",
     "IEC 61131-3"},
    {Choice::IecFbdOrder,
     "iec-fbd-order",
     {"execution-id", "position", ""},
     "IEC 61131-3: in which order the results of a drawing are computed that numbers its elements: by these numbers, "
     "or "
     "from top to bottom",
     "IEC 61131-3"},
    {Choice::IecLdFlow,
     "iec-ld-flow",
     {"once", "per-coil", ""},
     "IEC 61131-3: whether the power flow that several coils of a network take is computed once, or again for each of "
     "them, so that it sees what the coils before have written",
     "IEC 61131-3"},
    {Choice::IecPhase,
     "iec-phase",
     {"zero", "any", ""},
     "IEC 61131-3: when tasks of longer intervals run first: all in the first scan, or each in any scan of its "
     "interval",
     "IEC 61131-3"},
    {Choice::IecAddressUnit,
     "iec-address-unit",
     {"distinct", "size", "byte"},
     "IEC 61131-3: what the number of %MW1 counts where %MB2 is used too: each size has places of its own, it counts "
     "words, or it counts bytes",
     "IEC 61131-3"},
    {Choice::IecFtrigFirst,
     "iec-ftrig-first",
     {"edge", "none", ""},
     "IEC 61131-3: whether F_TRIG sees an edge in its first call where CLK is FALSE, as the standard's text has it",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecCtudEdges,
     "iec-ctud-edges",
     {"always", "when-counting", ""},
     "IEC 61131-3: whether CTUD looks at its edges in each call, or only where neither R nor LD is TRUE",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecSema,
     "iec-sema",
     {"direct", "delayed", ""},
     "IEC 61131-3: whether BUSY of SEMA tells of a claim in the same call, or in the next one as the edition of 2003 "
     "writes it",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecLimitCrossed,
     "iec-limit-crossed",
     {"min-of-max", "lower", ""},
     "IEC 61131-3: what LIMIT gives where MN is greater than MX: MIN(MAX(IN, MN), MX), or MN for what is not above it",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecSfcSelection,
     "iec-sfc-selection",
     {"one", "all-true", ""},
     "IEC 61131-3: how many transitions behind one step fire that are TRUE together and have no priority: the first, "
     "as "
     "the standard wants it, or all",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecInout,
     "iec-inout",
     {"reference", "copy", ""},
     "IEC 61131-3: whether IN_OUT is the variable of the caller itself, or a copy that is written back behind the "
     "body; "
     "it matters where two of them are one variable, or a global one",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecTimerClock,
     "iec-timer-clock",
     {"scan", "", ""},
     "IEC 61131-3: all timers see one clock in a scan; controllers that read the clock at each call, so that two calls "
     "in "
     "one scan differ, are not modelled",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecTimerExpiry,
     "iec-timer-expiry",
     {"at-preset", "after-preset", ""},
     "IEC 61131-3: whether a timer ends when the time that has passed reaches PT, or exceeds it",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecTimerDone,
     "iec-timer-done",
     {"holds", "re-evaluated", ""},
     "IEC 61131-3: whether a timer that has ended stays so until IN changes, or compares again, so that a longer PT "
     "lets it go on",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecMuxRange,
     "iec-mux-range",
     {"zero", "fault", "last"},
     "IEC 61131-3: what MUX gives for a K that selects no input: 0, the end of the scan, or the last input",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecToBool,
     "iec-to-bool",
     {"nonzero", "bit0", ""},
     "IEC 61131-3: whether a bit string becomes TRUE where any of its bits is 1, or its lowest one",
     "IEC 61131-3"},
    {Choice::IecSubrange,
     "iec-subrange",
     {"stored", "fault", ""},
     "IEC 61131-3: what a variable does with a value outside of its subrange: it takes it, or the scan ends",
     "IEC 61131-3"},
    {Choice::IecHexLiteral,
     "iec-hex-literal",
     {"pattern", "", ""},
     "IEC 61131-3: 16#FFFF for an INT is the number with these bits, -1; implementations that take it for 65535 refuse "
     "the program",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecPreemption,
     "iec-preemption",
     {"none", "", ""},
     "IEC 61131-3: no task interrupts another; controllers on which one does so in the middle of a scan are not "
     "modelled",
     "IEC 61131-3",
     ChoiceKind::Fact},
    {Choice::IecByteOrder,
     "iec-byte-order",
     {"little", "big", ""},
     "IEC 61131-3: where words and bytes share places, whether the low byte of a word is at the lower address or at "
     "the "
     "higher one",
     "IEC 61131-3"},
    {Choice::IecConditionBlocks,
     "iec-condition-blocks",
     {"while-enabled", "each-scan", ""},
     "IEC 61131-3: whether function blocks in the drawn condition of a transition are called where it is computed, "
     "while "
     "its steps are active, or behind the transitions of every scan",
     "IEC 61131-3"},
}};

inline constexpr std::size_t choiceCount = static_cast<std::size_t>(Choice::count);
constexpr const ChoiceInfo& choiceInfo(Choice choice) { return choiceTable[static_cast<std::size_t>(choice)]; }

/// One of the readings of an open point, such as {Choice::InactiveScr, "skipped"}; unknown names do not compile.
struct NamedReading {
  Choice choice;
  std::uint8_t value = 0;  ///< index into ChoiceInfo::values

  consteval NamedReading(Choice of, std::string_view name) : choice(of) {
    while (choiceInfo(of).values.at(value) != name) ++value;
  }
};

/// The value chosen for each open point, as an index into ChoiceInfo::values.
struct Choices {
  std::array<std::uint8_t, choiceCount> value{};
  std::array<bool, choiceCount> chosen{};  ///< set by the user, even if to the default

  std::uint8_t operator[](Choice choice) const { return value[static_cast<std::size_t>(choice)]; }
  bool is(Choice choice, std::string_view name) const {
    return choiceTable[static_cast<std::size_t>(choice)].values[(*this)[choice]] == name;
  }
  /// Sets by configuration key and value name; false if either is unknown.
  bool set(std::string_view key, std::string_view name) {
    for (const ChoiceInfo& info : choiceTable) {
      if (info.key != key) continue;
      for (std::uint8_t i = 0; i < info.values.size(); ++i) {
        if (info.values[i] == name && !name.empty()) {
          value[static_cast<std::size_t>(info.choice)] = i;
          chosen[static_cast<std::size_t>(info.choice)] = true;
          return true;
        }
      }
    }
    return false;
  }
  bool isChosen(Choice choice) const { return chosen[static_cast<std::size_t>(choice)]; }
  /// Whether proofs take one value of it: the user's, or that of a fact.
  bool isFixed(Choice choice) const { return isChosen(choice) || choiceInfo(choice).kind == ChoiceKind::Fact; }
  std::string_view valueName(Choice choice) const { return choiceInfo(choice).values[(*this)[choice]]; }
  int longestScanMs() const {
    static constexpr std::array<int, 3> limits = {25'000, 5'000, 60'000};
    return limits[(*this)[Choice::LongestScan]];
  }
  int watchdogMs() const { return (*this)[Choice::WatchdogMs] == 0 ? 500 : 300; }
};

namespace detail {
constexpr bool choiceTableIsInOrder() {
  for (std::size_t i = 0; i < choiceTable.size(); ++i) {
    if (static_cast<std::size_t>(choiceTable[i].choice) != i) return false;
  }
  return true;
}
static_assert(choiceTableIsInOrder(), "choiceTable must follow the enumeration");
}  // namespace detail

}  // namespace rungproof
