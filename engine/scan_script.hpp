// A script for one scan in place of the clock: which ticks and interrupts come in front of which instruction. The
// prover writes it (engine/replay.hpp). Covered by tests/engine/replay_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace rungproof {

/// Place in a scan: in front of the `visit`-th execution (from 0) of an instruction in that scan, or after the program.
struct ScanPlace {
  static constexpr std::uint32_t afterProgram = 0xFFFFFFFF;
  std::uint32_t instruction = afterProgram;  ///< Instruction::id
  std::uint32_t visit = 0;
};

/// What the clock would do inside a scan, given in full. At one place 1 ms ticks come before interrupts.
struct ScanScript {
  struct Event {
    ScanPlace place;
    int event;
  };
  struct Tick {
    ScanPlace place;
    std::uint32_t ticks;  ///< of 1 ms
  };
  std::optional<std::uint32_t> ticks10;  ///< at the start of the scan; nothing: from the length of the scans before
  std::optional<std::uint32_t> ticks100;
  std::vector<Event> events;  ///< in the order of execution; one that is not attached and enabled is passed over
  std::vector<Tick> ticks1;   ///< what of the scan's length they leave, elapses after the program
};

}  // namespace rungproof
