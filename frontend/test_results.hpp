// What `rungproof test` found: each test with its first failing step, coverage by measure, planted faults. Part of a
// report; the reporters of frontend/report print it. Covered by tests/tables.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/coverage/coverage_goals.hpp"
#include "frontend/report.hpp"

namespace rungproof {

struct TestResult {
  std::string name;
  std::string table;  ///< file
  std::size_t steps = 0;
  bool passed = true;
  bool isDecided = true;              ///< something of it was compared
  std::optional<std::size_t> step{};  ///< row within the test, from 1
  std::string signal{}, expected{}, actual{};
  std::string stepText{};
  std::string reason{};  ///< why it failed where no value tells: a fatal error
  std::string timing{};  ///< note of the failing step, where it says `timing`
  std::uint32_t line = 0;
  std::uint64_t scan = 0;
  double timeMs = 0;
  std::vector<std::string> columns{};  ///< of the scans around the failure
  struct Scan {
    std::uint64_t scan = 0;
    double timeMs = 0;
    std::vector<std::string> values{};
  };
  std::vector<Scan> around{};
  std::vector<ShownScan> shown{};  ///< the failing scan as drawings
};

/// Something that a measure counts and that no test covers.
struct MissingGoal {
  std::string text;    ///< "MAIN:4 A I0.2"
  std::string reason;  ///< what was not seen, the proof, or why it is open
  enum class State : std::uint8_t { Uncovered, Unreachable, Open } state = State::Uncovered;
  std::string certificate{};  ///< Unreachable: file or empty
  std::vector<CoverageGoal> open{};
};

struct MeasureResult {
  std::size_t covered = 0, total = 0, unreachable = 0, open = 0;
  std::vector<MissingGoal> missing{};
};

struct CoverageResult {
  std::map<Measure, MeasureResult> measures{
      {Measure::Networks, {}}, {Measure::Contacts, {}}, {Measure::Transitions, {}}, {Measure::Mcdc, {}}};
  std::size_t uniqueCause = 0, masking = 0;  ///< of the pairs covered
};

struct TestReport {
  std::vector<TestResult> tests;
  std::optional<CoverageResult> coverage{};
  std::set<Measure> asked{};           ///< generated tests: measures whose open goals count as undecided
  std::vector<std::string> written{};  ///< files
  std::optional<std::vector<PlantedFault>> kills{};
  std::string drawings{};  ///< networks with the colours of their contacts, for a page

  std::size_t failed() const;
  std::size_t openGoals() const;
};

}  // namespace rungproof
