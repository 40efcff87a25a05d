// Actual values of a stored data block, where they differ from what its declaration gives, as assignments of its body.
// Tested by tests/s7project/project_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "ir/s7300/declaration.hpp"

namespace rungproof::mc7 {

/// "   name[2].x := W#16#FF ;" lines.
std::string actualValues(const s7300::Structure& structure, std::string_view image);

}  // namespace rungproof::mc7
