// Which inputs a high-speed counter occupies in which mode (001:4216-4237, 001:14759-14801). An input may serve one
// purpose only: HDEF reports 0003, ATCH of an edge event 0002, the rule on shared inputs asks here too.
// Tests: tests/ir/hsc_inputs_test.cpp.
#pragma once

#include <array>

#include "ir/s7200/cpu.hpp"

namespace rungproof {

/// What a mode uses an input of the counter for, in the order of its inputs: clock, direction or second clock, reset,
/// start.
inline constexpr int hscInputCount = 4;

/// Numbers of the inputs 1-4 of a counter, I0.0 = 0, I1.0 = 8; -1: it has no such input. No counter of the S7-200 SMART
/// has a start input.
constexpr std::array<int, hscInputCount> hscInputs(const Target& target, int counter) {
  if (isSmart(target)) {
    switch (counter) {
      case 0: return {0, 1, 4, -1};
      case 1: return {1, -1, -1, -1};
      case 2: return {2, 3, 5, -1};
      case 3: return {3, -1, -1, -1};
      case 4: return {6, 7, 10, -1};
      case 5: return {8, 9, 11, -1};
      default: return {-1, -1, -1, -1};
    }
  }
  switch (counter) {
    case 0: return {0, 1, 2, -1};
    case 1: return {6, 7, 8, 9};
    case 2: return {10, 11, 12, 13};
    case 3: return {1, -1, -1, -1};
    case 4: return {3, 4, 5, -1};
    case 5: return {4, -1, -1, -1};
    default: return {-1, -1, -1, -1};
  }
}

/// Whether the mode uses input k (0-3) of its counter. Mode 12 counts pulses of the CPU and uses none.
constexpr bool hscModeUses(int mode, int k) {
  if (mode < 0 || mode > 11) return false;
  const int variant = mode % 3;  // without reset and start, with reset, with both
  return k == 0 || (k == 1 && mode >= 3) || (k == 2 && variant >= 1) || (k == 3 && variant == 2);
}

/// Whether the counter can be defined in that mode at all: without a second, reset or start input it cannot.
constexpr bool hscHasMode(const Target& target, int counter, int mode) {
  if (mode == 12) return !isSmart(target) && (counter == 0 || counter == 3);
  if (counter < 0 || counter > 5 || mode < 0 || mode > 12) return false;
  for (int k = 0; k < hscInputCount; ++k) {
    if (hscModeUses(mode, k) && hscInputs(target, counter)[static_cast<std::size_t>(k)] < 0) return false;
  }
  return true;
}

/// Whether the counter in that mode occupies input number `input`.
constexpr bool hscUsesInput(const Target& target, int counter, int mode, int input) {
  if (!hscHasMode(target, counter, mode)) return false;
  for (int k = 0; k < hscInputCount; ++k) {
    if (hscModeUses(mode, k) && hscInputs(target, counter)[static_cast<std::size_t>(k)] == input) return true;
  }
  return false;
}

}  // namespace rungproof
