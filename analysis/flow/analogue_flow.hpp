// Analogue values on their way through the program: from AIW through moves, conversions and arithmetic, and towards
// AQW, place by place without regard to order. Who wants to know whether a constant belongs to the scaling of an
// analogue value asks here. Tested by tests/rules/port_rules_test.cpp.
#pragma once

#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

class AnalogueFlow {
 public:
  explicit AnalogueFlow(const Facts& facts);

  /// Whether the instruction takes or makes a value that comes from an analogue input or goes to an analogue output.
  bool concerns(std::uint32_t instruction) const { return concerned_[instruction] != 0; }

 private:
  void spread(const Facts& facts, bool forwards);

  std::vector<std::uint8_t> concerned_;  ///< by Instruction::id
};

}  // namespace rungproof
