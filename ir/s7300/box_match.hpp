// Boxes with EN that the LAD/FBD compiler wrote as statements (ir/s7300/fbd_box.hpp), found again in a network.
// Tested by tests/drawing/raise_step7_test.cpp.
#pragma once

#include <optional>
#include <vector>

#include "ir/program.hpp"

namespace rungproof::s7300 {

struct MatchedBox {
  const Desc* desc = nullptr;     ///< for drawings only: name, pins EN and ENO, operands in the order of the statements
  std::vector<Operand> operands;  ///< what stands at the pins
  std::size_t length = 0;         ///< instructions, from JNB on
  bool passesOn = false;          ///< A BR at the end: its ENO goes on
};

/// The box that begins with the JNB at that place; nothing if the statements behind it are those of none.
std::optional<MatchedBox> boxAt(const Network& network, std::size_t at);

}  // namespace rungproof::s7300
