// Names of code blocks.
#include "ir/s7300/block.hpp"

#include <fmt/format.h>

#include <array>

namespace rungproof {

std::string blockName(int block) {
  static constexpr std::array<std::string_view, 6> letters = {"", "OB", "FC", "FB", "SFC", "SFB"};
  return fmt::format("{}{}", letters.at(static_cast<std::size_t>(blockTypeOf(block))), numberOfBlock(block));
}

}  // namespace rungproof
