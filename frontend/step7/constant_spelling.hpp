// Constants as they are printed: one spelling for each value, international, as STEP 7 shows it.
// Tested by tests/step7/constant_test.cpp.
#pragma once

#include <string>

#include "ir/area.hpp"
#include "ir/s7300/constant.hpp"

namespace rungproof::step7 {

/// "5", "L#5", "W#16#FF", "S5T#2S", "P#M 10.0", "'ab'".
std::string spellingOf(const s7300::Constant& constant);
/// Bits that the constant takes: Bit for TRUE and FALSE.
Width widthOfConstant(const s7300::Constant& constant);

}  // namespace rungproof::step7
