// Footprints: which parts of the state each instruction and each interrupt routine reads and writes, recorded while a
// scan is encoded. They tell where 1 ms ticks and interrupts have to be let in.
//
// Why it is enough to let an interrupt routine R run in front of instructions that conflict with it, and after the
// program: if instruction i writes nothing that R reads or writes, and reads nothing that R writes, then "R, i" and
// "i, R" lead to the same state, so an interrupt in front of i can be moved behind it. What R saves and restores
// (accumulators, SM1, ENO) does not count as written; whether R runs at all depends on the attachment, the global
// enable and RUN, which count as read. A property that holds at every instruction looks in between: what it reads
// counts as read by every instruction (EncoderOptions::watched). The same argument holds for the ticks of 1 ms timers.
// Covered by tests/encoder/interrupt_test.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "analysis/encoding/symbolic_store.hpp"

namespace rungproof {

/// Keys of places, ascending: one for each bit of memory, one for each register.
using FootprintKeys = std::set<std::uint64_t>;

struct Footprint {
  FootprintKeys reads;
  FootprintKeys writes;

  bool conflictsWith(const Footprint& other) const;
};

struct Footprints {
  std::map<std::uint32_t, Footprint> ofInstruction;  ///< by Instruction::id
  std::map<int, Footprint> ofRoutine;                ///< by interrupt number

  /// `routine`: the interrupt routine that runs, or -1.
  void record(std::uint32_t instruction, int routine, const Touch& touch);
  /// Adds what another run has recorded. Gives whether that was anything new.
  bool merge(const Footprints& other);
};

void addKeys(const Place& place, FootprintKeys& keys);
/// Numbers of the registers of these kinds among its keys.
std::set<std::uint32_t> indicesIn(const Footprint& footprint, std::span<const Reg> kinds);
/// The places behind keys: runs of bits inside one byte, and registers.
std::vector<Place> placesOf(const FootprintKeys& keys);
/// What decides whether an interrupt event can occur, and what its device writes then (ir/s7200/event_cause.hpp).
void addCauseKeys(int event, Footprint& footprint);

}  // namespace rungproof
