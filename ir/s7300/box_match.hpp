// Boxes with EN, and boxes of timers whose reset is open, that the LAD/FBD compiler wrote as statements
// (ir/s7300/fbd_box.hpp), found again in a network. Tested by tests/drawing/raise_step7_test.cpp.
#pragma once

#include <optional>
#include <vector>

#include "ir/program.hpp"

namespace rungproof::s7300 {

struct MatchedBox {
  const Desc* desc = nullptr;  ///< for drawings only: name, pins EN and ENO, operands in the order of the statements
  Operands operands;           ///< what stands at the pins
  std::size_t length = 0;      ///< instructions, from JNB or the L of the time on
  bool passesOn = false;       ///< A BR or A T 1 at the end: its ENO or Q goes on
};

/// The box that begins with the JNB or L at that place; nothing if the statements behind it are those of none.
std::optional<MatchedBox> boxAt(const Network& network, std::size_t at);

}  // namespace rungproof::s7300
