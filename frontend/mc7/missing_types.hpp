// Types that stored blocks use and that are not among them: UDTs, FBs and SFBs of instances. The compiled declaration
// of who uses them tells their shape, without names. Tested by tests/s7project/missing_type_test.cpp.
#pragma once

#include <vector>

#include "frontend/mc7/stored_block.hpp"

namespace rungproof::mc7 {

/// UDTs with their shape, FBs and SFBs with their interface, each with the reason why it is no more than that.
std::vector<StoredBlock> missingTypesOf(const std::vector<StoredBlock>& blocks);

}  // namespace rungproof::mc7
