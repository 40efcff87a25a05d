// Which networks LAD or FBD can show, remembered by what decides it: the instructions in their order and the kinds of
// their operands. A program has thousands of networks of a few shapes; each shape is drawn once. Networks whose picture
// depends on more than that are drawn one by one. Tested by tests/drawing/picture_shapes_test.cpp.
#pragma once

#include <string>
#include <unordered_map>

#include "ir/program.hpp"

namespace rungproof {

class PictureShapes {
 public:
  explicit PictureShapes(const Target& target) : target_(target) {}

  /// Whether raise() finds a ladder or an FBD.
  bool canBeDrawn(const Network& network);
  /// Shapes that were drawn so far.
  std::size_t size() const { return known_.size(); }

 private:
  bool makeKey(const Network& network);

  const Target& target_;
  std::string key_;
  std::unordered_map<std::string, bool> known_;
};

}  // namespace rungproof
