// What can be wrong with a drawing as a circuit, judged on its elements: GRF001 and the number of inputs of GRF003.
// For the readers of graphical files, which turn each fault into a finding. Tested by tests/drawing/drawing_check_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ir/drawing.hpp"

namespace rungproof {

struct DrawingFault {
  std::string_view rule;  ///< "GRF001" or "GRF003"
  std::uint32_t element = 0;
  std::string message;
  std::string_view help;
};

/// Faults in the order of the elements: outputs that lead nowhere, boxes and coils with missing inputs, elements that
/// must stand at the left rail (001:2304), a branch that short-circuits its neighbours, gates with more than 32 inputs.
std::vector<DrawingFault> drawingFaults(const Drawing& drawing);

}  // namespace rungproof
