// Hazards: what can go wrong while an instruction runs. One list for the engine (run-time errors of table C-2,
// 001:13945-13973, and fatal errors of table C-1, 001:13917-13940), the prover (proof askedProperties) and rules.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rungproof {

enum class Hazard : std::uint8_t {
  HscWithoutHdef,
  InputConflict,
  HscInputConflict,
  NotInInterrupt,
  SimultaneousHscPls,
  BadIndirectAddress,
  ClockData,
  NestingTooDeep,
  SimultaneousPort0,
  HdefTwice,
  SimultaneousPort1,
  NoClock,
  PulseOutputBusy,
  NoSegments,
  BadCompareNumber,
  PulseMode,
  PulseCommand,
  PulseProfile,
  BadPidTable,
  OutOfRange,
  BadCount,
  StringIndexZero,
  FreeportInInterrupt,
  ModuleAccess,
  FatalWatchdog,
  FatalIndirectAddress,
  FatalReal,
  FatalRange,
  Overflow,
  DivideByZero,
  TableFull,
  TableEmpty,
  NotBcd,
  NotAscii,
  BadFormat,
  QueueOverflow,
  LoopBound,
  PortMode,
  PortParameter,
  S7Bcd,
  S7AreaLength,
  S7AreaUnknown,
  S7TimerNumber,
  S7CounterNumber,
  S7Alignment,
  S7WriteProtected,
  S7BlockMissing,
  S7Nesting,
  S7CycleTime,
  S7Stop,
  S7ErrorTwice,
  S7NotLoaded,
  SclIndex,
  IecDivideByZero,
  IecArrayRange,
  IecEndless,
  IecRange
};

/// How the CPU takes it: a status bit only, a logged non-fatal error with SM4.3, or STOP.
enum class HazardClass : std::uint8_t { StatusOnly, NonFatal, Fatal };

struct HazardInfo {
  Hazard hazard;
  std::string_view code;  ///< "0006", or the status bit "SM1.1"
  HazardClass kind;
  std::string_view text;
  std::string_view manual;
};

inline constexpr std::array hazardTable = {
    HazardInfo{Hazard::HscWithoutHdef, "0001", HazardClass::NonFatal, "HSC executed before HDEF", "001:13949"},
    HazardInfo{Hazard::InputConflict, "0002", HazardClass::NonFatal, "interrupt event uses an input that an HSC uses",
               "001:13950"},
    HazardInfo{Hazard::HscInputConflict, "0003", HazardClass::NonFatal,
               "HSC input already used by another HSC or event", "001:13951"},
    HazardInfo{Hazard::NotInInterrupt, "0004", HazardClass::NonFatal, "instruction not allowed in an interrupt routine",
               "001:13952"},
    HazardInfo{Hazard::SimultaneousHscPls, "0005", HazardClass::NonFatal,
               "second HSC or PLS with the same number before the first ended", "001:13953"},
    HazardInfo{Hazard::BadIndirectAddress, "0006", HazardClass::NonFatal, "pointer does not hold a legal address",
               "001:13954"},
    HazardInfo{Hazard::ClockData, "0007", HazardClass::NonFatal,
               "clock data not legal, or clock used by two program parts at once", "001:13955"},
    HazardInfo{Hazard::NestingTooDeep, "0008", HazardClass::NonFatal, "subroutines nested too deeply", "001:13956"},
    HazardInfo{Hazard::SimultaneousPort0, "0009", HazardClass::NonFatal, "XMT and RCV at the same time on port 0",
               "001:13957"},
    HazardInfo{Hazard::HdefTwice, "000A", HazardClass::NonFatal, "HDEF executed twice for one counter", "001:13958"},
    HazardInfo{Hazard::SimultaneousPort1, "000B", HazardClass::NonFatal, "XMT and RCV at the same time on port 1",
               "001:13959"},
    HazardInfo{Hazard::NoClock, "000C", HazardClass::NonFatal, "the CPU has no clock", "001:13960"},
    HazardInfo{Hazard::PulseOutputBusy, "000D", HazardClass::NonFatal, "pulse output redefined while active",
               "001:13961"},
    HazardInfo{Hazard::NoSegments, "000E", HazardClass::NonFatal, "PTO profile has 0 segments", "001:13962"},
    HazardInfo{Hazard::BadCompareNumber, "000F", HazardClass::NonFatal, "illegal number in a compare contact",
               "001:13963"},
    HazardInfo{Hazard::PulseMode, "0010", HazardClass::NonFatal, "PTO command not allowed in this mode", "001:13964"},
    HazardInfo{Hazard::PulseCommand, "0011", HazardClass::NonFatal, "illegal PTO command code", "001:13965"},
    HazardInfo{Hazard::PulseProfile, "0012", HazardClass::NonFatal, "illegal PTO profile table", "001:13966"},
    HazardInfo{Hazard::BadPidTable, "0013", HazardClass::NonFatal, "illegal PID table", "001:13967"},
    HazardInfo{Hazard::OutOfRange, "0091", HazardClass::NonFatal, "operand leaves its area", "001:13968"},
    HazardInfo{Hazard::BadCount, "0092", HazardClass::NonFatal, "count not legal", "001:13969"},
    HazardInfo{Hazard::StringIndexZero, "009B", HazardClass::NonFatal, "string index is 0", "001:13972"},
    HazardInfo{Hazard::FreeportInInterrupt, "009A", HazardClass::NonFatal,
               "change to Freeport mode in an interrupt routine", "001:13971"},
    HazardInfo{Hazard::ModuleAccess, "", HazardClass::NonFatal, "expansion module cannot be reached", "001:5630"},
    HazardInfo{Hazard::FatalWatchdog, "F0003", HazardClass::Fatal, "scan watchdog expired", "001:13920"},
    HazardInfo{Hazard::FatalIndirectAddress, "F0011", HazardClass::Fatal,
               "pointer of a compare contact does not hold a legal address", "001:13934"},
    HazardInfo{Hazard::FatalReal, "F0012", HazardClass::Fatal, "compare contact met an illegal real number",
               "001:13935"},
    HazardInfo{Hazard::FatalRange, "F0014", HazardClass::Fatal, "range error in a compare contact", "001:13937"},
    HazardInfo{Hazard::Overflow, "SM1.1", HazardClass::StatusOnly, "result does not fit, or value not legal",
               "001:4814"},
    HazardInfo{Hazard::DivideByZero, "SM1.3", HazardClass::StatusOnly, "division by zero", "001:4814"},
    HazardInfo{Hazard::TableFull, "SM1.4", HazardClass::StatusOnly, "table is full", "001:6260"},
    HazardInfo{Hazard::TableEmpty, "SM1.5", HazardClass::StatusOnly, "table is empty", "001:6314"},
    HazardInfo{Hazard::NotBcd, "SM1.6", HazardClass::StatusOnly, "value is not BCD or does not fit BCD", "001:3460"},
    HazardInfo{Hazard::NotAscii, "SM1.7", HazardClass::StatusOnly, "character is not a hexadecimal digit", "001:3583"},
    HazardInfo{Hazard::BadFormat, "", HazardClass::StatusOnly, "format operand not legal", "001:3655"},
    HazardInfo{Hazard::QueueOverflow, "SM4.x", HazardClass::StatusOnly, "interrupt queue is full", "001:5491"},
    HazardInfo{Hazard::LoopBound, "", HazardClass::StatusOnly, "loop runs longer than the analysis follows it",
               "001:5718"},
    HazardInfo{Hazard::PortMode, "", HazardClass::StatusOnly, "port is not in the mode that the instruction needs",
               "001:3147"},
    HazardInfo{Hazard::PortParameter, "", HazardClass::StatusOnly,
               "communication parameters not legal, or too many requests", "001:3145"},
    // S7-300/400: synchronous errors, which end in STOP where OB121 is missing (002:1278-1290). The code is the
    // OB121_SW_FLT of the first of them.
    HazardInfo{Hazard::S7Bcd, "OB121 21", HazardClass::Fatal, "value is not BCD", "002:1286"},
    HazardInfo{Hazard::S7AreaLength, "OB121 22", HazardClass::Fatal, "access leaves its area or data block",
               "002:1289"},
    HazardInfo{Hazard::S7AreaUnknown, "OB121 24", HazardClass::Fatal, "pointer names an area that cannot be accessed",
               "002:1289"},
    HazardInfo{Hazard::S7TimerNumber, "OB121 26", HazardClass::Fatal, "the CPU has no timer of that number",
               "002:1289"},
    HazardInfo{Hazard::S7CounterNumber, "OB121 27", HazardClass::Fatal, "the CPU has no counter of that number",
               "002:1289"},
    HazardInfo{Hazard::S7Alignment, "OB121 28", HazardClass::Fatal,
               "bit part of the pointer to a byte, word or double "
               "word is not 0",
               "002:1290"},
    HazardInfo{Hazard::S7WriteProtected, "OB121 30", HazardClass::Fatal, "write to a write-protected data block",
               "002:1288"},
    HazardInfo{Hazard::S7BlockMissing, "OB121 3A", HazardClass::Fatal, "block is not loaded", "002:1287"},
    HazardInfo{Hazard::S7Nesting, "STOP", HazardClass::Fatal, "blocks nested too deeply", "002:1278"},
    HazardInfo{Hazard::S7CycleTime, "STOP", HazardClass::Fatal, "the scan outlasts the cycle monitoring", "002:1296"},
    HazardInfo{Hazard::S7Stop, "STOP", HazardClass::Fatal, "SFC 46 stops the CPU", "002:2343"},
    HazardInfo{Hazard::S7ErrorTwice, "STOP", HazardClass::Fatal,
               "synchronous error in the block that takes such errors", "002:1278"},
    HazardInfo{Hazard::S7NotLoaded, "STOP", HazardClass::Fatal, "an event comes whose organization block is missing",
               "002:1278"},
    // The CPU does not look: what it reads or writes then lies beside the array.
    HazardInfo{Hazard::SclIndex, "", HazardClass::StatusOnly, "index outside the bounds of its array", "002:2068"},
    // IEC 61131-3: what the standard calls errors, by the reading that the scan ends with them.
    HazardInfo{Hazard::IecDivideByZero, "ERROR", HazardClass::Fatal, "division by zero", "IEC 61131-3"},
    HazardInfo{Hazard::IecArrayRange, "ERROR", HazardClass::Fatal, "index outside its array", "IEC 61131-3"},
    HazardInfo{Hazard::IecEndless, "ERROR", HazardClass::Fatal, "the scan does not end", "IEC 61131-3"},
    HazardInfo{Hazard::IecRange, "ERROR", HazardClass::Fatal, "value outside its range", "IEC 61131-3"},
};

constexpr const HazardInfo& hazardInfo(Hazard hazard) { return hazardTable[static_cast<std::size_t>(hazard)]; }

namespace detail {
constexpr bool hazardTableIsInOrder() {
  for (std::size_t i = 0; i < hazardTable.size(); ++i) {
    if (static_cast<std::size_t>(hazardTable[i].hazard) != i) return false;
  }
  return hazardTable.size() == static_cast<std::size_t>(Hazard::IecRange) + 1;
}
static_assert(hazardTableIsInOrder(), "hazardTable must list the hazards in the order of the enumeration");
}  // namespace detail

}  // namespace rungproof
