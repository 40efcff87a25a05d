// Clock memory of an S7-300/400: a byte of M, chosen in the project, whose bits the CPU flashes beside the program:
// half of the period 0, half 1 (general knowledge). Where each bit is in its period when the run begins is stated
// nowhere. Its time passes as that of S5 timers does (Choice::S5Time): between the scans, or at any instruction. Tested
// by tests/step7/clock_memory_test.cpp.
#pragma once

#include <array>

#include "ir/machine/machine.hpp"

namespace rungproof {

/// ms, by bit.
inline constexpr std::array<std::uint16_t, 8> clockPeriods = {100, 200, 400, 500, 800, 1000, 1600, 2000};

/// The bits as the phases have them.
template <class D>
void showClockMemory(Machine<D>& m) {
  for (std::uint32_t bit = 0; bit < clockPeriods.size(); ++bit) {
    const int width = regInfo(Reg::ClockPhase).width;
    const auto half = m.number(clockPeriods[bit] / 2U, width);
    m.saveBit(Area::M, *m.plan.program->clockMemory, bit, m.d.ule(half, m.get(Reg::ClockPhase, bit), width));
  }
}

/// Lets `ms` (width 16) pass.
template <class D>
void advanceClockMemory(Machine<D>& m, typename D::Bits ms) {
  constexpr int w = 17;
  for (std::uint32_t bit = 0; bit < clockPeriods.size(); ++bit) {
    const int width = regInfo(Reg::ClockPhase).width;
    const auto sum = m.d.add(m.d.zext(m.get(Reg::ClockPhase, bit), width, w), m.d.zext(ms, 16, w), w);
    m.set(Reg::ClockPhase, bit, m.d.extract(m.d.urem(sum, m.number(clockPeriods[bit], w), w), width - 1, 0));
  }
  showClockMemory(m);
}

}  // namespace rungproof
