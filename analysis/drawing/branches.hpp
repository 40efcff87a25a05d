// Lowering along the branches of a drawing, as its picture is read: every circuit begins with a load, side branches
// are saved with LPS, parallel branches closed with OLD and ALD. This is the only way that can be drawn again, so it
// also decides which networks have a picture. Tested by tests/drawing/lower_test.cpp and raise_test.cpp.
#pragma once

#include "analysis/drawing/circuit.hpp"

namespace rungproof {

/// How the result depends on the order of inputs.
enum class PinOrder : std::uint8_t {
  AsDrawn,  ///< the first input of a gate stands on the left
  Free      ///< an input that also feeds something else may come first
};

struct Branches {
  Lowered lowered;                 ///< its fault tells what the stack cannot follow
  std::uint32_t circuits = 0;      ///< separate circuits
  std::uint32_t second = 0;        ///< with several: an element of the second one
  bool comparedAddresses = false;  ///< ReadOrder::comparedAddresses
};

Branches lowerAlongBranches(const Drawing& drawing, const Circuit& circuit, PinOrder order, EditorBits taken);

}  // namespace rungproof
