// The boxes of ladder and FBD of the S7-300/400 (003:14-130; German names 003:502-522) and the statements that the
// editor's compiler writes for each (general knowledge; math: 003:799). Boxes have no meaning of their own.
// Compared row by row with tests/data/s7300_boxes.tsv, and each read and run, by tests/step7/box_test.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof::s7300 {

enum class BoxFrame : std::uint8_t {
  Plain,
  Enabled,  ///< EN and ENO: without an error
  Checked,  ///< ENO is 0 after an overflow
  Call,     ///< ENO is what the block leaves in BR
  Timer,    ///< reset, remaining time and bit follow
  Counter   ///< setting, reset, value and bit follow
};

struct FbdBox {
  std::string_view name;    ///< "ADD_I"
  std::string_view german;  ///< where it differs
  std::string_view title;
  BoxFrame frame;
  /// Statements with ; between them; a pin is $NAME, $BOX what stands above the box.
  std::string_view statements;
  std::string_view manual;
};

std::span<const FbdBox> fbdBoxes();
/// By one of its names; several boxes may share one.
std::vector<const FbdBox*> fbdBoxesNamed(std::string_view name);
/// The statements with EN, JNB, SAVE and ENO around what a box with EN does.
std::string expansionOf(const FbdBox& box);
/// Names of the pins in the order in which the statements use them; with BOX, without EN and ENO.
std::vector<std::string> pinsOf(const FbdBox& box);

}  // namespace rungproof::s7300
