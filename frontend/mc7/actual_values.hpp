// Actual values of a stored data block, where they differ from what its declaration gives, as assignments of its body.
// Tested by tests/s7project/project_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ir/s7300/declaration.hpp"

namespace rungproof::mc7 {

struct NamedValue {
  std::string name;   ///< "list[2].x"
  std::string value;  ///< as a constant; empty: no constant of the type spells it
};
/// The parts whose values in the image are not those of the reference, in the order of the declaration.
std::vector<NamedValue> valuesUnlike(const s7300::Structure& structure, const std::vector<std::uint8_t>& reference,
                                     std::string_view image);

/// "   name[2].x := W#16#FF ;" lines.
std::string actualValues(const s7300::Structure& structure, std::string_view image);

}  // namespace rungproof::mc7
