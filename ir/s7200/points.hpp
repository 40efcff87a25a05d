// Where the points of the CPU itself end and those of modules begin. Tested by tests/ir/points_test.cpp.
#pragma once

#include "ir/s7200/cpu.hpp"

namespace rungproof {

/// First address behind the CPU's own points of the areas I, Q, AI and AQ, in bits: 12 for I0.0 to I1.3.
constexpr std::uint32_t onBoardEnd(const Target& target, Area area) {
  const OnBoard& points = cpuRow(target.cpu).onBoard;
  switch (area) {
    case Area::I: return points.inputs;
    case Area::Q: return points.outputs;
    case Area::AI: return points.analogInputs * 16;
    case Area::AQ: return points.analogOutputs * 16;
    default: return 0;
  }
}

}  // namespace rungproof
