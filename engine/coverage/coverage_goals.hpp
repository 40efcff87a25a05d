// What the measures of coverage count, and what of it a recorder has not seen: one list, from which reports, searches
// and questions to the prover derive. Covered by tests/tables/coverage_test.cpp.
#pragma once

#include <array>
#include <compare>
#include <set>
#include <string_view>
#include <vector>

#include "engine/coverage/coverage_recorder.hpp"

namespace rungproof {

enum class Measure : std::uint8_t { Networks, Contacts, Transitions, Mcdc };
inline constexpr std::array<Measure, 4> allMeasures{Measure::Networks, Measure::Contacts, Measure::Transitions,
                                                    Measure::Mcdc};
/// "networks", "mcdc": as the command line and JSON name it.
std::string_view measureWord(Measure measure);
/// "networks", "MC/DC pairs": for people.
std::string_view measureText(Measure measure);

/// Part of what a measure counts that one scan can show.
struct CoverageGoal {
  Measure measure = Measure::Networks;
  std::size_t index = 0;      ///< network, leaf, transition or decision of the map
  std::size_t condition = 0;  ///< Mcdc: of its leaves
  /// Contacts: its own bit is that value. Mcdc: as that value it decides the outcome.
  bool value = false;
  bool isOutcome = false;  ///< Mcdc: `value` is the outcome that it decides, as whatever value
  friend auto operator<=>(const CoverageGoal&, const CoverageGoal&) = default;
};

/// One thing that a measure counts.
struct CoverageItem {
  CoverageGoal first;  ///< its value says nothing
  bool isCovered = false;
  std::vector<CoverageGoal> open;  ///< none of which may be out of reach
};
std::vector<CoverageItem> coverageItems(const CoverageRecorder& recorder);

/// The goals of those measures that the recorder has not seen.
std::vector<CoverageGoal> openGoals(const CoverageRecorder& recorder, const std::set<Measure>& measures);

}  // namespace rungproof
