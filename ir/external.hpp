// What a program takes from the world around it while it runs, and what it tells it, beyond the registers of the
// machine. The engine answers from the stimulus, the encoder with a fresh variable.
#pragma once

#include <cstdint>

namespace rungproof {

/// Sources of values that the program does not determine. Concrete takes them from the stimulus or a fixed
/// choice; Graph makes a fresh input of the scan for each.
enum class External : std::uint8_t {
  ImmediateInput,  ///< physical input read in mid-scan; index = bit number
  AnalogInput,     ///< AIW; index = word address
  StackBottom,     ///< level shifted in by a pop (001:2868)
  LocalMemory,     ///< L on entry to a block (001:1373); index = byte
  ClockByte,       ///< byte of the real-time clock; index = offset in the TODR buffer
  IntervalClock,   ///< free-running ms counter of BITIM and of SFC 64
  NetworkStatus,   ///< NETR/NETW completion; index = table byte
  ReceivedByte,
  StationAddress,
  LibraryOutput,    ///< what a block without text leaves; index = parameter or effect (ir/s7200/call_contract.hpp)
  AsyncTicks,       ///< 1 ms ticks that elapse before this instruction
  EventFires,       ///< whether interrupt event `index` occurs before this instruction
  UnknownStatus,    ///< status bits that the manual calls meaningless after an error (001:4814)
  UnknownResult,    ///< result that the manual leaves open after an error
  RegisterAtStart,  ///< S7-300/400: what a register holds when an organization block begins; index = which
  AccessError,      ///< S7-300/400: whether a module does not answer a direct access; index = byte
  CalendarDay,      ///< S7-300/400: days from 1990-01-01 to the date of the clock
  TimeOfDay,        ///< S7-300/400: ms since midnight by the clock
  TimerPhase        ///< S7-300/400: by how much the first unit of an S5 timer is short; index = timer
};

/// What an instruction tells the system around the program, beyond the registers it changes.
enum class Signal : std::uint8_t {
  EventAttached,      ///< ATCH; index = event. A timed event takes over its interval and starts anew (001:5472)
  EventDetached,      ///< DTCH; index = event
  EventsCleared,      ///< CEVNT; index = event: its queued entries are dropped (001:5357)
  WatchdogRestarted,  ///< WDR
  Stopped,            ///< STOP
  ClockSet,           ///< TODW, TODWX, SFC 0; index = bytes that Reg::ClockSetting holds, 8 or 19
  HscLoaded,          ///< HSC; index = counter
  PulseCommand,       ///< PLS started, changed or stopped output `index`
  TransmitStarted,    ///< XMT; index = port
  ReceiveStarted,     ///< RCV; index = port
  ReceiveEnded,       ///< RCV with the enable bit off ended a reception; index = port
  NetworkStarted      ///< NETR, NETW; index = entry of Reg::NetTable
};

/// Where an external value is asked for; with the order of execution it identifies the value within a scan.
struct ExternalSite {
  External kind;
  std::uint32_t index = 0;
  std::uint32_t instruction = 0;  ///< Instruction::id
};

}  // namespace rungproof
