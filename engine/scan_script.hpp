// A script for one scan in place of the clock: which ticks, interrupts and writes of devices come in front of which
// instruction. The prover writes it (engine/replay.hpp). Covered by tests/engine/replay_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/operand.hpp"

namespace rungproof {

/// Place in a scan: in front of the `visit`-th execution (from 0) of an instruction in that scan, or after the program.
struct ScanPlace {
  static constexpr std::uint32_t afterProgram = 0xFFFFFFFF;
  static constexpr std::uint32_t startOfScan = 0xFFFFFFFE;  ///< before the inputs are read; writes of devices only
  std::uint32_t instruction = afterProgram;                 ///< Instruction::id
  std::uint32_t visit = 0;

  friend bool operator==(const ScanPlace&, const ScanPlace&) = default;
};

/// What the clock would do inside a scan, given in full. At one place 1 ms ticks come before writes, these before
/// interrupts.
struct ScanScript {
  struct Event {
    ScanPlace place;
    int event;
    bool isWithNext = false;   ///< comes together with the next one: nothing is served in between
    bool isFromQueue = false;  ///< nothing comes, but an entry that waits is served now
  };
  struct Tick {
    ScanPlace place;
    std::uint32_t ticks;  ///< of 1 ms
  };
  /// A device writes a bit or byte of memory; its status bytes end what it does (engine/device_end.hpp). What no
  /// running request allows is passed over.
  struct Write {
    ScanPlace place;
    Operand operand;
    std::uint64_t value;
  };
  std::optional<std::uint32_t> ticks10;  ///< at the start of the scan; nothing: from the length of the scans before
  std::optional<std::uint32_t> ticks100;
  /// Interrupt events that occur, in their order: one that is attached enters its queue and runs as soon as interrupts
  /// are enabled. Events 21 and 22 come from the ticks of their timers by themselves: only their service can be named.
  /// Events 10 and 11 that are due by the end of the scan and not named come after the program.
  std::vector<Event> events;
  std::vector<Tick> ticks1;   ///< what of the scan's length they leave, elapses after the program
  std::vector<Write> writes;  ///< in the order of execution
  /// Whether an event without a possible cause is left out (runs that shall prove something) or comes all the same
  /// (somebody's own stimulus). Either way Simulator::eventsWithoutCause() tells.
  bool needsCauses = false;
};

}  // namespace rungproof
