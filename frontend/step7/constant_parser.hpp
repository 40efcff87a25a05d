// Constants of STEP 7 sources (002:1951-1959, 003:885-897): L#5, W#16#FF, S5T#1S500MS, T#1D, D#2009-4-1, C#10, B#(1,2),
// 'abc', 1.5e+3, P#M 10.0, P#DB1.DBX0.0 BYTE 4, TRUE. Letters in any case, underscores between digits.
// Tested by tests/step7/constant_test.cpp.
#pragma once

#include <optional>
#include <string>

#include "frontend/files/encoding.hpp"
#include "frontend/step7/cursor.hpp"
#include "ir/s7300/constant.hpp"

namespace rungproof::step7 {

/// The two sets of mnemonics (003:1310-1312).
enum class MnemonicSet : std::uint8_t { International, German };

struct ConstantOutcome {
  std::optional<s7300::Constant> constant;
  std::string fault;  ///< why what begins like a constant is none; empty beside no constant: nothing begins like one
};

/// Reads a constant at the cursor. On a fault the cursor stands behind what was looked at.
ConstantOutcome readConstant(Cursor& cursor, MnemonicSet set, TextEncoding encoding);

}  // namespace rungproof::step7
