// The points that the manual leaves open. Each is one named choice with its reading and its reason; the engine,
// the encoder and the reports all take it from here, and `rungproof config` prints the table. The first value of a
// row is the default.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rungproof {

enum class Choice : std::uint8_t {
  InactiveScr,        // s7200 digest B 14
  IncrementOverflow,  // B 4
  RoundHalf,          // A 11
  MainStop,           // B 10
  UnknownBits,        // stack bottom, local memory
  SkippedEno,         // machine 11
  ScanClockStart,     // C18
  WatchdogMs,         // C1
  FirstEdge,          // A 2.4
  StringResultOverflow,
  count
};

struct ChoiceInfo {
  Choice choice;
  std::string_view key;                    ///< configuration key
  std::array<std::string_view, 3> values;  ///< names; unused ones are empty
  std::string_view why;                    ///< what is open and why the default is what it is
  std::string_view manual;
};

inline constexpr std::array<ChoiceInfo, static_cast<std::size_t>(Choice::count)> choiceTable = {{
    {Choice::InactiveScr, "inactive-scr", {"no-power-flow", "skipped", ""},
     "what an inactive SCR segment does: executed with power flow 0 (TOF is reset, coils drop) or not executed at all", "001:5830"},
    {Choice::IncrementOverflow, "increment-overflow", {"wraps", "keeps", ""},
     "INC/DEC result on overflow: the rule that operands stay as they were is not repeated for them", "001:4999"},
    {Choice::RoundHalf, "round-half", {"away-from-zero", "up", ""}, "ROUND of negative halves", "001:3496"},
    {Choice::MainStop, "stop-in-main", {"at-once", "end-of-scan", ""},
     "whether the rest of the scan runs after STOP in the main program", "001:5691"},
    {Choice::UnknownBits, "unknown-bits", {"zero", "one", "random"},
     "value the engine gives to bits that the manual calls unknown (popped stack levels, local memory); the prover takes any", "001:2868"},
    {Choice::SkippedEno, "skipped-eno", {"zero", "kept", ""}, "ENO after a box that had no power flow", "001:2276"},
    {Choice::ScanClockStart, "scan-clock-start", {"off", "on", ""}, "phase of SM0.4, SM0.5, SM0.6 in the first scan", "001:14681"},
    {Choice::WatchdogMs, "watchdog", {"500ms", "300ms", ""}, "scan watchdog: the text says 500 ms, the quick reference 300 ms", "001:5718"},
    {Choice::FirstEdge, "first-edge", {"first-scan-only", "first-execution", ""},
     "EU/ED first executed after the first scan: compares with 0, or stores silently as in the first scan", "001:2763"},
    {Choice::StringResultOverflow, "string-overflow", {"unchanged", "cut", ""}, "SCAT result over 254 characters", "001:6093"},
}};

/// The value chosen for each open point, as an index into ChoiceInfo::values.
struct Choices {
  std::array<std::uint8_t, static_cast<std::size_t>(Choice::count)> value{};

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
          return true;
        }
      }
    }
    return false;
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
