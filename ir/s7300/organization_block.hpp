// The organization blocks: what starts each, and which CPUs know such a start (002:799-813, 002:2882-2901).
// Tested by tests/step7/explain_test.cpp and tests/step7/organization_block_test.cpp.
#pragma once

#include <span>
#include <string_view>

#include "ir/s7300/cpu.hpp"

namespace rungproof::s7300 {

/// The CPUs whose operating system may start a block: all, those of the S7-400 (002:810-813, 002:1391), or those and
/// the 318-2 (002:1355, 002:1387).
enum class StartedBy : std::uint8_t { Every, S7400, S7400And318 };

struct OrganizationBlock {
  int first, last;  ///< numbers of blocks of the same kind
  std::string_view kind;
  std::string_view event;  ///< what starts it
  std::string_view manual;
  bool isModelled;  ///< engine and prover start it
  StartedBy startedBy = StartedBy::Every;
  std::string_view gap{};  ///< why it is not modelled, where more can be said than that
};

std::span<const OrganizationBlock> organizationBlocks();
/// nullptr: there is no OB of that number.
const OrganizationBlock* organizationBlock(int number);
/// Whether that CPU ever starts the block.
bool startsOn(const OrganizationBlock& block, Cpu cpu);
/// "every CPU", "S7-400", "S7-400 and CPU 318-2".
std::string_view startedByText(StartedBy cpus);
/// Why nothing is proved beside the block.
std::string_view gapReasonOf(const OrganizationBlock& block);

}  // namespace rungproof::s7300
