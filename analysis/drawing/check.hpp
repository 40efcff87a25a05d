// What can be wrong with a drawing as a circuit, judged on its elements: GRF001 and the number of inputs of GRF003.
// For the readers of graphical files, which turn each fault into a finding. Tested by
// tests/drawing/drawing_check_test.cpp.
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
/// must stand at the left rail (001:2304), in ladder a branch that short-circuits its neighbours, gates with more than
/// 32 inputs.
std::vector<DrawingFault> drawingFaults(const Drawing& drawing, Form form);
/// Power inputs that an element must have: 0 for rails and headings, EN and the flow parameters for CALL; gates: 2,
/// which is the least.
std::size_t inputsNeeded(const Element& element);
/// LBL, LSCR, SCRE, NEXT and the like: stands at the left rail and takes no power flow (001:2304).
bool isHeading(const Desc& desc);

}  // namespace rungproof
