// The points that the manual leaves open. Each is one named choice with its reading and its reason; the engine,
// the encoder and the reports all take it from here, and `rungproof config` prints the table. The first value of a
// row is the default.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "ir/machine/choice_table.hpp"

namespace rungproof {

inline constexpr std::size_t choiceCount = static_cast<std::size_t>(Choice::count);
constexpr const ChoiceInfo& choiceInfo(Choice choice) { return choiceTable[static_cast<std::size_t>(choice)]; }

/// One of the readings of an open point, such as {Choice::InactiveScr, "skipped"}; unknown names do not compile.
struct NamedReading {
  Choice choice;
  std::uint8_t value = 0;  ///< index into ChoiceInfo::values

  consteval NamedReading(Choice of, std::string_view name) : choice(of) {
    while (choiceInfo(of).values.at(value) != name) ++value;
  }
};

/// The value chosen for each open point, as an index into ChoiceInfo::values.
struct Choices {
  std::array<std::uint8_t, choiceCount> value{};
  std::array<bool, choiceCount> chosen{};  ///< set by the user, even if to the default

  std::uint8_t operator[](Choice choice) const { return value[static_cast<std::size_t>(choice)]; }
  bool is(Choice choice, std::string_view name) const {
    return choiceTable[static_cast<std::size_t>(choice)].values[(*this)[choice]] == name;
  }
  /// Sets by configuration key and value name; false if either is unknown.
  bool set(std::string_view key, std::string_view name) {
    for (const ChoiceInfo& info : choiceTable) {
      if (info.key != key) continue;
      for (std::uint8_t i = 0; i < info.values.size(); ++i) {
        if (info.values[i] == name && !name.empty()) {
          value[static_cast<std::size_t>(info.choice)] = i;
          chosen[static_cast<std::size_t>(info.choice)] = true;
          return true;
        }
      }
    }
    return false;
  }
  bool isChosen(Choice choice) const { return chosen[static_cast<std::size_t>(choice)]; }
  /// Whether proofs take one value of it: the user's, or that of a fact.
  bool isFixed(Choice choice) const { return isChosen(choice) || choiceInfo(choice).kind == ChoiceKind::Fact; }
  std::string_view valueName(Choice choice) const { return choiceInfo(choice).values[(*this)[choice]]; }
  int longestScanMs() const {
    static constexpr std::array<int, 3> limits = {25'000, 5'000, 60'000};
    return limits[(*this)[Choice::LongestScan]];
  }
  int watchdogMs() const { return (*this)[Choice::WatchdogMs] == 0 ? 500 : 300; }
};

namespace detail {
constexpr bool choiceTableIsInOrder() {
  for (std::size_t i = 0; i < choiceTable.size(); ++i) {
    if (static_cast<std::size_t>(choiceTable[i].choice) != i) return false;
  }
  return true;
}
static_assert(choiceTableIsInOrder(), "choiceTable must follow the enumeration");
}  // namespace detail

}  // namespace rungproof
