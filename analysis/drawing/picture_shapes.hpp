// Which networks LAD or FBD can show, remembered by what decides it: the instructions in their order and the kinds of
// their operands. A program has thousands of networks of a few shapes; each shape is drawn once. Networks whose picture
// depends on more than that are drawn one by one. Tested by tests/drawing/picture_shapes_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

#include "ir/program.hpp"

namespace rungproof {

class PictureShapes {
 public:
  explicit PictureShapes(const Target& target) : target_(target) {}

  /// Whether raise() finds a ladder or an FBD.
  bool canBeDrawn(const Network& network);
  /// What raise() says against an FBD of a network that cannot be drawn; quick for the one that was asked about last.
  struct Refusal {
    const Instruction* at;
    std::string reason;
  };
  Refusal refusalOf(const Network& network) const;
  /// Shapes that were drawn so far.
  std::size_t size() const { return known_.size(); }

 private:
  /// Of a shape; `clause` as in Raised, `at` the instruction that it is said of.
  struct Verdict {
    bool isDrawn = false;
    std::string_view clause = {};
    std::size_t at = 0;
  };
  bool makeKey(const Network& network);

  const Target& target_;
  std::string key_;
  std::unordered_map<std::string, Verdict> known_;
  const Network* lastNetwork_ = nullptr;
  const Verdict* last_ = nullptr;  ///< of its shape, if that decides
};

}  // namespace rungproof
