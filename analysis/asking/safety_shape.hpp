// What a declared property is about, read from its form: outputs that exclude each other, and a stop that switches
// outputs off. The rules SAF003, SAF004 and SAF006 speak of such properties. Covered by
// tests/prover/rule_questions_test.cpp.
#pragma once

#include <optional>
#include <vector>

#include "analysis/property.hpp"

namespace rungproof {

/// An input in the state in which it stops the machine.
struct StopInput {
  Operand input;
  bool activeWhenOff;  ///< a normally closed contact
};
/// `not I0.1 implies not (Q0.0 or Q0.1)`: any of the stops switches all the outputs off.
struct StopShape {
  std::vector<StopInput> stops;
  Operands outputs;
};
std::optional<StopShape> stopShapeOf(const Property& property);

/// `never Q0.0 and Q0.1` or the like: two or more outputs and nothing else.
bool excludesOutputs(const Property& property);

}  // namespace rungproof
