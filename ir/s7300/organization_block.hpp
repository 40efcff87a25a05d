// The organization blocks: what starts each (002:799-813, 002:2882-2901).
// Tested by tests/step7/explain_test.cpp.
#pragma once

#include <span>
#include <string_view>

namespace rungproof::s7300 {

struct OrganizationBlock {
  int first, last;  ///< numbers of blocks of the same kind
  std::string_view kind;
  std::string_view event;  ///< what starts it
  std::string_view manual;
  bool isModelled;  ///< engine and prover start it
};

std::span<const OrganizationBlock> organizationBlocks();
/// nullptr: there is no OB of that number.
const OrganizationBlock* organizationBlock(int number);

}  // namespace rungproof::s7300
