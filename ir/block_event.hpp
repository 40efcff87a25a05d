// What interrupts OB1 of an S7-300/400: an event for each organization block that something beside the program starts
// (002:799-813). Their numbers follow those of the S7-200; a program that has the block has attached it, for good.
// Priorities: 002:817, 002:1108-1119, 002:1169, 002:1296; where these have none, general knowledge.
// Tested by tests/step7/interrupt_block_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rungproof {

/// What the CPU does at an event whose block the program does not have.
enum class WithoutBlock : std::uint8_t {
  Nothing,       ///< 002:1102; OB81: general knowledge
  ProgramError,  ///< the start of a missing block: OB85, or STOP without that (002:1158, 002:1338)
  Stop           ///< 002:1278
};

struct BlockEventRow {
  int first, last;         ///< numbers of the organization blocks
  int priority;            ///< of the first of them
  bool rises;              ///< each of the following has the next priority
  std::string_view cause;  ///< as a witness names it
  WithoutBlock withoutBlock;
};

inline constexpr auto blockEventTable = std::to_array<BlockEventRow>({
    {10, 17, 2, false, "time-of-day interrupt", WithoutBlock::ProgramError},
    {20, 23, 3, true, "time-delay interrupt", WithoutBlock::ProgramError},
    {30, 38, 7, true, "cyclic interrupt", WithoutBlock::Nothing},
    {40, 47, 16, true, "hardware interrupt", WithoutBlock::ProgramError},
    {80, 80, 25, false, "time error", WithoutBlock::Stop},
    {81, 81, 25, false, "power supply error", WithoutBlock::Nothing},
    {82, 82, 25, false, "diagnostic interrupt", WithoutBlock::Stop},
    {83, 83, 25, false, "insert or remove module", WithoutBlock::Stop},
    {84, 84, 25, false, "CPU hardware fault", WithoutBlock::Stop},
    {85, 85, 25, false, "program execution error", WithoutBlock::Stop},
    {86, 86, 25, false, "rack failure", WithoutBlock::Stop},
    {87, 87, 25, false, "communication error", WithoutBlock::Stop},
});
inline constexpr int highestPriority = 28;

/// Number of the first of these events, behind those of the S7-200, and of the one behind the last.
inline constexpr int firstBlockEvent = 45;
inline constexpr int blockEventEnd = [] {
  int event = firstBlockEvent;
  for (const BlockEventRow& row : blockEventTable) event += row.last - row.first + 1;
  return event;
}();
constexpr bool isBlockEvent(int event) { return event >= firstBlockEvent && event < blockEventEnd; }

/// The row of an organization block; nullptr: nothing starts it in the midst of a scan.
constexpr const BlockEventRow* blockEventRow(int block) {
  for (const BlockEventRow& row : blockEventTable) {
    if (row.first <= block && block <= row.last) return &row;
  }
  return nullptr;
}
/// The event that starts that organization block; -1: none.
constexpr int eventOfBlock(int block) {
  int event = firstBlockEvent;
  for (const BlockEventRow& row : blockEventTable) {
    if (row.first <= block && block <= row.last) return event + block - row.first;
    event += row.last - row.first + 1;
  }
  return -1;
}
/// Number of the organization block; -1: the event is none of an S7-300/400.
constexpr int blockOfEvent(int event) {
  int first = firstBlockEvent;
  for (const BlockEventRow& row : blockEventTable) {
    const int count = row.last - row.first + 1;
    if (event >= first && event < first + count) return row.first + event - first;
    first += count;
  }
  return -1;
}
/// How a stimulus and a witness name an event: by its number, of an S7-300/400 by that of its block.
constexpr int shownEvent(int event) { return isBlockEvent(event) ? blockOfEvent(event) : event; }

/// 1 lowest (OB1) to 28.
constexpr int priorityOf(int event) {
  const BlockEventRow& row = *blockEventRow(blockOfEvent(event));
  return row.priority + (row.rises ? blockOfEvent(event) - row.first : 0);
}

/// The cyclic interrupts OB30 to OB38, and their periods in ms where nobody sets them (002:1108-1119; OB38: general
/// knowledge; a project sets them by options, frontend/settings/options.cpp).
inline constexpr int firstCyclicBlock = 30;
inline constexpr std::uint32_t cyclicBlockCount = 9;
inline constexpr std::array<std::uint16_t, cyclicBlockCount> usualPeriods = {5000, 2000, 1000, 500, 200,
                                                                             100,  50,   20,   10};
inline constexpr int firstCyclicEvent = eventOfBlock(firstCyclicBlock);
constexpr bool isCyclicEvent(int event) {
  return event >= firstCyclicEvent && event < firstCyclicEvent + static_cast<int>(cyclicBlockCount);
}

/// The time-delay interrupts OB20 to OB23, each started by SFC 32 and once (002:1190-1212).
inline constexpr int firstDelayBlock = 20;
inline constexpr std::uint32_t delayBlockCount = 4;
inline constexpr int firstDelayEvent = eventOfBlock(firstDelayBlock);
constexpr bool isDelayEvent(int event) {
  return event >= firstDelayEvent && event < firstDelayEvent + static_cast<int>(delayBlockCount);
}

static_assert(blockOfEvent(eventOfBlock(35)) == 35 && priorityOf(eventOfBlock(35)) == 12);  // 002:1116
static_assert(blockOfEvent(firstBlockEvent) == 10 && eventOfBlock(1) == -1);

}  // namespace rungproof
