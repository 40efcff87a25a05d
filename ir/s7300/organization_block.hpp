// The organization blocks: what starts each, and which CPUs know such a start (002:799-813, 002:2882-2901).
// Tested by tests/step7/explain_test.cpp and tests/step7/organization_block_test.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/program.hpp"
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
  int of300 = 0;           ///< the only one of several that an S7-300 starts; 0: startedBy says it of all
  int of318 = 0;           ///< the second one that the 318-2 starts (general knowledge)
  std::string_view manual300{};
};

std::span<const OrganizationBlock> organizationBlocks();
/// nullptr: there is no OB of that number.
const OrganizationBlock* organizationBlock(int number);
/// The CPUs that may start the block of that number, which is one of the row.
StartedBy startersOf(const OrganizationBlock& row, int number);
/// Whether that CPU may start the organization block of that number. Of a number without a row nothing is known: true.
bool startsOn(int number, Cpu cpu);
/// Whether the CPU of the program may run the block: false for organization blocks that it never starts. A program that
/// begins with a cold restart is for a CPU that has one.
bool mayStart(const Program& program, const Pou& pou);
/// OB100 to OB102 run once, before the first scan (002:1367-1415).
bool isStartUpBlock(const Pou& pou);
/// What is taken for granted of organization blocks that some CPUs start and others do not.
std::vector<std::string> startTexts(const Program& program);
/// "every CPU", "S7-400", "S7-400 and CPU 318-2".
std::string_view startedByText(StartedBy cpus);
/// Where the manual says that.
std::string_view startersManual(const OrganizationBlock& row, int number);
/// Why nothing is proved beside the block.
std::string_view gapReasonOf(const OrganizationBlock& block);

}  // namespace rungproof::s7300
