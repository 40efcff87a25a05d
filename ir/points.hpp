// The points that stand on the CPUs themselves (001:552-560, 001:11612-11622; S7-200 SMART: system manual). What lies
// behind them belongs to modules: the S7-200 numbers these without holes in their order (001:1439-1451), the S7-200
// SMART gives every slot fixed addresses. Tested by tests/ir/points_test.cpp.
#pragma once

#include "ir/cpu.hpp"

namespace rungproof {

/// First address behind the CPU's own points of the areas I, Q, AI and AQ, in bits: 12 for I0.0 to I1.3.
constexpr std::uint32_t onBoardEnd(const Target& target, Area area) {
  struct Points {
    std::uint32_t inputs, outputs;
  };
  const auto of = [](Cpu cpu) -> Points {
    switch (cpu) {
      case Cpu::Cpu212:
      case Cpu::Cpu222: return {8, 6};
      case Cpu::Cpu221: return {6, 4};
      case Cpu::Cpu214:
      case Cpu::Cpu224:
      case Cpu::Cpu224XP: return {14, 10};
      case Cpu::Cpu226:
      case Cpu::Cpu226XM: return {24, 16};
      case Cpu::Cr20s:
      case Cpu::Sr20:
      case Cpu::St20: return {12, 8};
      case Cpu::Cr30s:
      case Cpu::Sr30:
      case Cpu::St30: return {18, 12};
      case Cpu::Cr40s:
      case Cpu::Cr40:
      case Cpu::Sr40:
      case Cpu::St40: return {24, 16};
      default: return {36, 24};
    }
  };
  if (area == Area::I) return of(target.cpu).inputs;
  if (area == Area::Q) return of(target.cpu).outputs;
  if (target.cpu != Cpu::Cpu224XP) return 0;
  return area == Area::AI ? 32 : 16;  // AIW0, AIW2; AQW0 (001:1228)
}

}  // namespace rungproof
