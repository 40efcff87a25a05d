// How long the condition of a timer can be on without a break, as the text in front of it says: a clock bit or an edge
// that stands in series keeps it short. Tested by tests/rules/timer_rules_test.cpp and
// tests/rules/step7_timer_rules_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "analysis/flow/facts.hpp"

namespace rungproof {

struct OnTime {
  std::int64_t ms = 0;   ///< 0: one scan
  std::string bit{};     ///< the clock bit or the edge that says so
  bool isClock = false;  ///< that bit is one of the CPU, no edge of the program
};

/// S7-200: of the power flow in front of the instruction. Nothing where it may last.
std::optional<OnTime> onTimeOfFlow(const Facts& facts, const InstructionPlace& place);

/// S7-300/400: of the RLO in front of the step, whose string must be scans in series.
std::optional<OnTime> onTimeOfRlo(const Facts& facts, std::uint32_t block, std::uint32_t step);
/// S7-300/400: statements that start the timer of that number.
std::size_t startsOf(const Facts& facts, std::uint32_t timer);
/// S7-300/400: whether a statement or a call may mean a timer whose number the text does not say.
bool usesUnnamedTimers(const Facts& facts);

}  // namespace rungproof
