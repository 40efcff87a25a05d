// How instructions look in ladder and FBD: which operand stands at which pin. The name in a box, the sign in a contact
// or coil and the names of operands and power inputs come from the descriptors (Desc::drawnName). Tested by
// tests/show/layout_test.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ir/desc.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// A box that calls a block.
bool isCallBox(const Desc& desc);
/// A heading that stands in brackets: LBL and LSCR.
bool isBracket(const Desc& desc);
enum class PinSide : std::uint8_t { Above, Left, Right };

/// Where an operand stands. An operand that is read and written stands on both sides.
struct OperandPin {
  std::size_t operand = 0;
  PinSide side = PinSide::Left;
  std::string name;
};

/// Pins of a box for `count` operands, in the order in which they stand, topmost first. `callee`: the called block of a
/// CALL, for the names of parameters; may be nullptr.
std::vector<OperandPin> operandPins(const Desc& desc, std::size_t count, const Pou* callee);

/// Names of the power inputs, topmost first: EN; IN; CU, CD, R.
std::vector<std::string> powerPins(const Desc& desc);
/// The same of a CALL: EN, then the parameters that are given as power flow (001:6808).
std::vector<std::string> callPowerPins(const Operands& operands, const Pou* callee);
/// S7-300/400: the pin by which power leaves a call: an output that is given as power flow, otherwise ENO.
std::string callPowerOutput(const Operands& operands, const Pou* callee);
/// "ENO", "Q", "OUT"; empty where the box has no power output.
std::string powerOutput(const Desc& desc);

}  // namespace rungproof
