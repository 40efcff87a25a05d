// Interrupt events: cause, priority group and rank (tables 6-46 and 6-50, 001:5378-5415, 001:5504-5538). Which CPU
// has which event is in cpu.hpp. Those of an S7-300/400 are in ir/block_event.hpp. Covered by
// tests/engine/interrupt_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ir/block_event.hpp"
#include "ir/machine/timed_event.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

/// Priority groups, highest first; each has its own queue (001:5480-5491).
enum class EventGroup : std::uint8_t { Communication, InputOutput, Timed };
inline constexpr int eventGroupCount = 3;

struct EventInfo {
  int event;
  EventGroup group;
  std::uint8_t rank;  ///< within the group; 0 is served first
  std::string_view text;
};

inline constexpr std::array<EventInfo, 45> eventTable = {{
    {0, EventGroup::InputOutput, 2, "rising edge of I0.0"},
    {1, EventGroup::InputOutput, 6, "falling edge of I0.0"},
    {2, EventGroup::InputOutput, 3, "rising edge of I0.1"},
    {3, EventGroup::InputOutput, 7, "falling edge of I0.1"},
    {4, EventGroup::InputOutput, 4, "rising edge of I0.2"},
    {5, EventGroup::InputOutput, 8, "falling edge of I0.2"},
    {6, EventGroup::InputOutput, 5, "rising edge of I0.3"},
    {7, EventGroup::InputOutput, 9, "falling edge of I0.3"},
    {8, EventGroup::Communication, 0, "port 0: character received"},
    {9, EventGroup::Communication, 0, "port 0: transmission complete"},
    {10, EventGroup::Timed, 0, "timed interrupt 0, SMB34"},
    {11, EventGroup::Timed, 1, "timed interrupt 1, SMB35"},
    {12, EventGroup::InputOutput, 10, "HSC0: current value equals preset"},
    {13, EventGroup::InputOutput, 13, "HSC1: current value equals preset"},
    {14, EventGroup::InputOutput, 14, "HSC1: direction changed"},
    {15, EventGroup::InputOutput, 15, "HSC1: external reset"},
    {16, EventGroup::InputOutput, 16, "HSC2: current value equals preset"},
    {17, EventGroup::InputOutput, 17, "HSC2: direction changed"},
    {18, EventGroup::InputOutput, 18, "HSC2: external reset"},
    {19, EventGroup::InputOutput, 0, "PTO0: train complete"},
    {20, EventGroup::InputOutput, 1, "PTO1: train complete"},
    {21, EventGroup::Timed, 2, "T32: current value equals preset"},
    {22, EventGroup::Timed, 3, "T96: current value equals preset"},
    {23, EventGroup::Communication, 0, "port 0: message received"},
    {24, EventGroup::Communication, 1, "port 1: message received"},
    {25, EventGroup::Communication, 1, "port 1: character received"},
    {26, EventGroup::Communication, 1, "port 1: transmission complete"},
    {27, EventGroup::InputOutput, 11, "HSC0: direction changed"},
    {28, EventGroup::InputOutput, 12, "HSC0: external reset"},
    {29, EventGroup::InputOutput, 20, "HSC4: current value equals preset"},
    {30, EventGroup::InputOutput, 21, "HSC4: direction changed"},
    {31, EventGroup::InputOutput, 22, "HSC4: external reset"},
    {32, EventGroup::InputOutput, 19, "HSC3: current value equals preset"},
    {33, EventGroup::InputOutput, 23, "HSC5: current value equals preset"},
    // S7-200 SMART only. Beside 34 the numbers and ranks are uncertain; 39 to 42 stand in no list.
    {34, EventGroup::InputOutput, 1, "PTO2: train complete"},
    {35, EventGroup::InputOutput, 5, "rising edge of I7.0"},
    {36, EventGroup::InputOutput, 9, "falling edge of I7.0"},
    {37, EventGroup::InputOutput, 5, "rising edge of I7.1"},
    {38, EventGroup::InputOutput, 9, "falling edge of I7.1"},
    {39, EventGroup::InputOutput, 24, "no cause is known"},
    {40, EventGroup::InputOutput, 24, "no cause is known"},
    {41, EventGroup::InputOutput, 24, "no cause is known"},
    {42, EventGroup::InputOutput, 24, "no cause is known"},
    {43, EventGroup::InputOutput, 23, "HSC5: direction changed"},
    {44, EventGroup::InputOutput, 23, "HSC5: external reset"},
}};
inline constexpr int eventCount = static_cast<int>(eventTable.size());

/// Events 21 and 22 belong to the timers T32 and T96 (001:5476); -1: another timer, which has none.
constexpr int eventOfTimer(std::uint32_t number) { return number == 32 ? 21 : number == 96 ? 22 : -1; }
constexpr bool isTimerEvent(int event) { return event == 21 || event == 22; }

/// Inputs whose edges are events (001:5460): a bit of the image and the event of its rising edge, behind which that of
/// the falling one stands. I7.0 and I7.1 are on a signal board of the S7-200 SMART.
struct EdgeInput {
  std::uint32_t bit;
  int rising;
};
inline constexpr std::array<EdgeInput, 6> edgeInputs = {{{0, 0}, {1, 2}, {2, 4}, {3, 6}, {56, 35}, {57, 37}}};
inline constexpr int edgeInputCount = static_cast<int>(edgeInputs.size());
/// Which of them the event belongs to; -1: none.
constexpr int edgeInputOf(int event) {
  for (int input = 0; input < edgeInputCount; ++input) {
    const int rising = edgeInputs[static_cast<std::size_t>(input)].rising;
    if (event == rising || event == rising + 1) return input;
  }
  return -1;
}
constexpr bool isEdgeEvent(int event) { return edgeInputOf(event) >= 0; }
constexpr const EdgeInput& edgeInputFor(int event) { return edgeInputs[static_cast<std::size_t>(edgeInputOf(event))]; }
constexpr bool isRisingEdge(int event) { return isEdgeEvent(event) && edgeInputFor(event).rising == event; }
/// How an edge is remembered: 1 rising, 2 falling.
constexpr int edgeKind(int event) { return isRisingEdge(event) ? 1 : 2; }

/// The highest number of an event that the CPU has.
constexpr int lastEvent(const Target& target) {
  int event = eventCount - 1;
  while (!eventExists(target, event)) --event;
  return event;
}

/// Of an event of either family.
constexpr EventInfo eventInfo(int event) {
  if (event < eventCount) return eventTable[static_cast<std::size_t>(event)];
  const BlockEventRow& row = *blockEventRow(blockOfEvent(event));
  return {event, EventGroup::InputOutput, static_cast<std::uint8_t>(highestPriority - priorityOf(event)), row.cause};
}

/// Whether two events come from the same cause, be it at different inputs, counters, ports or timers: their texts are
/// the same but for numbers.
constexpr bool areAlikeEvents(int a, int b) {
  const std::string_view x = eventInfo(a).text, y = eventInfo(b).text;
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t i = 0, k = 0;; ++i, ++k) {
    while (i < x.size() && isDigit(x[i])) ++i;
    while (k < y.size() && isDigit(y[k])) ++k;
    if (i >= x.size() || k >= y.size()) return i >= x.size() && k >= y.size();
    if (x[i] != y[k]) return false;
  }
}

namespace detail {
constexpr bool eventTableIsInOrder() {
  for (std::size_t i = 0; i < eventTable.size(); ++i) {
    if (eventTable[i].event != static_cast<int>(i)) return false;
  }
  return true;
}
static_assert(eventTableIsInOrder(), "eventTable must be sorted by event number");
static_assert(areAlikeEvents(0, 4) && !areAlikeEvents(0, 1) && areAlikeEvents(12, 33) && !areAlikeEvents(12, 14));
}  // namespace detail

}  // namespace rungproof
