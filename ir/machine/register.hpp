// Registers of the machine that are not addressable memory: timers, counters, edge memories, devices, clocks.
// One row per kind: width and count. Together with the memory areas they are the whole state of the machine.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ir/area.hpp"
#include "ir/block_event.hpp"
#include "ir/machine/choices.hpp"

namespace rungproof {

enum class Reg : std::uint8_t {
  Accumulator,
  TimerCurrent,
  TimerBit,
  TimerRunning,
  TimerPreset,
  TimerInput,
  CounterCurrent,
  CounterBit,
  CounterUp,
  CounterDown,
  EdgeMemory,
  EdgeSeen,
  PhysicalInput,
  PhysicalOutput,
  EventRoutine,
  InterruptsEnabled,
  TimedPeriod,
  TimedElapsed,
  CyclicPeriod,
  CyclicElapsed,
  HscCurrent,
  HscPreset,
  HscMode,
  HscEnabled,
  HscUp,
  HscSetup,
  PulseBusy,
  PulsePending,
  PulseCycle,
  PulseWidth,
  PulseCount,
  PulseIsPwm,
  PulseIsMs,
  PulseSegments,
  PulseTable,
  PulseNextCycle,
  PulseNextCount,
  PulseNextIsMs,
  PortBusy,
  PortTable,
  PortLimit,
  StationAddress,
  NetActive,
  NetTable,
  NetIsWrite,
  NetLength,
  NetBuffer,
  ClockSetting,
  PidHistory,
  PhaseTen,
  PhaseHundred,
  PhaseSecond,
  PhaseMinute,
  Eno,
  FirstScan,
  Running,
  DiagnosticLed,
  Fault,
  Reading,
  S5Rest,
  S5Base,
  S5AtEnd,
  S5Free,
  S7Set,
  S7Free,
  LastScan,
  ClockPhase,
  DelayPeriod,
  DelayElapsed,
  DelaySign,
  ErrorsMasked,
  count
};

struct RegInfo {
  Reg reg;
  std::string_view name;
  std::uint8_t width;   ///< bits
  std::uint32_t count;  ///< or one of the numbers below, which registerCount() (ir/machine/plan.hpp) understands
};
/// One per EU and ED; one per timer or counter; one per timer, counter or cyclic interrupt of an S7-300/400.
inline constexpr std::uint32_t perEdge = 0, perTimer = 0xFFFFFFFB, perCounter = 0xFFFFFFFC, perS5Timer = 0xFFFFFFFD,
                               perS7Counter = 0xFFFFFFFE, perCyclicBlock = 0xFFFFFFFF;

inline constexpr std::array<RegInfo, static_cast<std::size_t>(Reg::count)> regTable = {{
    {Reg::Accumulator, "AC", 32, 4},
    {Reg::TimerCurrent, "T.value", 16, perTimer},
    {Reg::TimerBit, "T", 1, perTimer},
    {Reg::TimerRunning, "T.running", 1, perTimer},  // TON, TONR: enabled; TOF, TP: timing
    {Reg::TimerPreset, "T.preset", 16, perTimer},   // of the last execution, for refreshes between executions
    {Reg::TimerInput, "T.in", 1, perTimer},         // input of the last execution
    {Reg::CounterCurrent, "C.value", 16, perCounter},
    {Reg::CounterBit, "C", 1, perCounter},
    {Reg::CounterUp, "C.up", 1, perCounter},  // count inputs of the last execution
    {Reg::CounterDown, "C.down", 1, perCounter},
    {Reg::EdgeMemory, "edge", 1, perEdge},
    {Reg::EdgeSeen, "edge.seen", 1, perEdge},
    {Reg::PhysicalInput, "input", 1, 256},
    {Reg::PhysicalOutput, "output", 1, 256},
    {Reg::EventRoutine, "event", 8, blockEventEnd},  // 0: detached, else number of the routine or block + 1
    {Reg::InterruptsEnabled, "interrupts", 1, 1},
    {Reg::TimedPeriod, "timed.period", 8, 2},    // ms between events 10 or 11 as ATCH found it (001:5472); 0: none
    {Reg::TimedElapsed, "timed.elapsed", 8, 2},  // ms since ATCH or the last of them, less than the period
    {Reg::CyclicPeriod, "cyclic.period", 16, perCyclicBlock},    // ms between two starts of OB30 and those that follow
    {Reg::CyclicElapsed, "cyclic.elapsed", 16, perCyclicBlock},  // ms since the last, less than the period
    {Reg::HscCurrent, "HC", 32, 6},
    {Reg::HscPreset, "HC.preset", 32, 6},
    {Reg::HscMode, "HC.mode", 8, 6},  // 0: no HDEF yet, else mode + 1
    {Reg::HscEnabled, "HC.enabled", 1, 6},
    {Reg::HscUp, "HC.up", 1, 6},
    {Reg::HscSetup, "HC.setup", 3, 6},  // control bits 0-2 as HDEF found them (001:4279)
    {Reg::PulseBusy, "PLS.busy", 1, 4},
    {Reg::PulsePending, "PLS.pending", 1, 4},
    {Reg::PulseCycle, "PLS.cycle", 16, 4},
    {Reg::PulseWidth, "PLS.width", 16, 4},
    {Reg::PulseCount, "PLS.count", 32, 4},
    {Reg::PulseIsPwm, "PLS.pwm", 1, 4},
    {Reg::PulseIsMs, "PLS.ms", 1, 4},                // time base 1 ms instead of 1 us
    {Reg::PulseSegments, "PLS.segments", 8, 4},      // of a running profile, 0: single train
    {Reg::PulseTable, "PLS.table", 16, 4},           // V byte of the running profile
    {Reg::PulseNextCycle, "PLS.next.cycle", 16, 4},  // the one entry of the pipeline
    {Reg::PulseNextCount, "PLS.next.count", 32, 4},
    {Reg::PulseNextIsMs, "PLS.next.ms", 1, 4},
    {Reg::PortBusy, "port.busy", 2, 2},           // bit 0: XMT, bit 1: RCV
    {Reg::PortTable, "port.table", 32, 4},        // address of TBL: port 0 XMT, port 0 RCV, port 1 XMT, port 1 RCV
    {Reg::PortLimit, "port.limit", 8, 2},         // characters that a running reception may store
    {Reg::StationAddress, "port.address", 9, 2},  // 0: that of the system block, else SPA's + 1
    {Reg::NetActive, "net.active", 5, 1},         // entries of net.table in use
    {Reg::NetTable, "net.table", 32, 16},         // address of the table of an active network request, 0: free
    {Reg::NetIsWrite, "net.write", 1, 16},        // its table takes no data: all but NETR
    {Reg::NetLength, "net.length", 8, 16},        // data bytes of the request
    {Reg::NetBuffer, "net.buffer", 32, 16},       // GET: address of the own data that the answer fills, else 0
    {Reg::ClockSetting, "clock", 8, 19},          // bytes of the last TODW or TODWX
    {Reg::PidHistory, "PID.history", 1, 16},
    {Reg::PhaseTen, "phase10", 16, 1},  // ms since the last 10 ms tick that a scan took
    {Reg::PhaseHundred, "phase100", 16, 1},
    {Reg::PhaseSecond, "phase1000", 10, 1},
    {Reg::PhaseMinute, "phase60000", 16, 1},
    {Reg::Eno, "ENO", 1, 1},
    {Reg::FirstScan, "first scan", 1, 1},
    {Reg::Running, "RUN", 1, 1},
    {Reg::DiagnosticLed, "DIAG", 1, 1},
    {Reg::Fault, "fault", 1, 1},  // a fatal error has ended the last scan (ir/s7200/scan_cycle.hpp)
    // By choice, two each: whether its second or its third value is the reading; neither: the first
    // (ir/machine/reading.hpp).
    {Reg::Reading, "reading", 1, 2 * static_cast<std::uint32_t>(choiceCount)},
    // S7-300/400 beside the bits and inputs of timers and counters (ir/s7300/timer.hpp, ir/s7300/isa/counter.hpp).
    {Reg::S5Rest, "T.rest", 24, perS5Timer},  // ms up to its end
    {Reg::S5Base, "T.base", 2, perS5Timer},   // 0: 10 ms to 3: 10 s
    {Reg::S5AtEnd, "T.end", 1, perS5Timer},   // value of the bit when the time is up
    {Reg::S5Free, "T.FR", 1, perS5Timer},     // RLO of the last FR
    {Reg::S7Set, "C.S", 1, perS7Counter},     // RLO of the last S and FR
    {Reg::S7Free, "C.FR", 1, perS7Counter},
    {Reg::LastScan, "last scan", 16, 1},               // ms from the start of the scan before to that of this one
    {Reg::ClockPhase, "clock phase", 11, 8},           // ms since a bit of clock memory began its period
    {Reg::DelayPeriod, "delay", 16, delayBlockCount},  // ms that SFC 32 has given; 0: OB20 to OB23 not started
    {Reg::DelayElapsed, "delay.elapsed", 16, delayBlockCount},  // ms since
    {Reg::DelaySign, "delay.sign", 16, delayBlockCount},        // SIGN of that call
    {Reg::ErrorsMasked, "errors masked", 1, 1},                 // SFC 36 has been called
}};

constexpr const RegInfo& regInfo(Reg reg) { return regTable[static_cast<std::size_t>(reg)]; }

/// What an operand of a timer means by its width: the bit, the current value of an S7-200, the ms that are left of an
/// S5 timer.
constexpr Reg timerRegister(Width width) {
  return width == Width::Bit ? Reg::TimerBit : width == Width::DWord ? Reg::S5Rest : Reg::TimerCurrent;
}

namespace detail {
constexpr bool regTableIsInOrder() {
  for (std::size_t i = 0; i < regTable.size(); ++i) {
    if (static_cast<std::size_t>(regTable[i].reg) != i) return false;
  }
  return true;
}
static_assert(regTableIsInOrder(), "regTable must follow the enumeration");
}  // namespace detail

}  // namespace rungproof
