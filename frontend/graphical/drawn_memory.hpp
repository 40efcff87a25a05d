// Memory of drawn programs: variables without an address get places in V memory that nobody else uses, standard
// function blocks get timers, blocks get subroutine numbers, jumps labels. Areas and limits come from
// ir/cpu. Tested by tests/graphical/iec_type_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "frontend/graphical/drawn_model.hpp"

namespace rungproof {

class DrawnMemory {
 public:
  /// Takes note of what the blocks that are already there use.
  explicit DrawnMemory(const Program& program);

  /// A place of V memory; words and double words begin at even bytes. Nothing if V memory is full.
  std::optional<Operand> allocate(IecType type, std::uint32_t stringLength = 0);
  /// Keeps a located V address free.
  void reserve(const Operand& located);

  struct TimerChoice {
    int number = 0;
    int resolution = 0;  ///< ms
  };
  /// A timer of TON and TOF for a preset of `ms`: the coarsest resolution that divides it and counts far enough, so
  /// that the scarce fast timers are left to those who need them (table 6-74, 001:6597-6603). Nothing if the preset
  /// cannot be expressed or no such timer is left.
  std::optional<TimerChoice> timerFor(std::int64_t ms);
  std::optional<int> subroutine();

 private:
  std::optional<int> freeTimer(int resolution);

  Target target_;
  std::vector<bool> usedV_;
  std::uint32_t nextByte_ = 0;
  std::uint32_t bitByte_ = 0;
  unsigned nextBit_ = 8;  ///< 8: no byte with free bits
  std::array<bool, 256> usedTimers_{};
  std::vector<bool> usedSubroutines_;
};

/// Largest preset of a timer in steps of its resolution (001:6551).
inline constexpr std::int64_t largestPreset = 32767;

}  // namespace rungproof
