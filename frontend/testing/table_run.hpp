// Runs test tables: each test from power-on, its first failing step with the scans around it, and what all of them
// cover. Tested by tests/tables/test_command_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "engine/coverage/coverage_recorder.hpp"
#include "engine/testing/test_player.hpp"
#include "frontend/settings/options.hpp"
#include "frontend/test_results.hpp"

namespace rungproof {

struct TableRunOptions {
  SimulatorOptions engine;
  ScanTime scanTime{};
  CoverageRecorder* coverage = nullptr;  ///< may be nullptr
  std::optional<Form> shows{};           ///< the failing scan is drawn so
  bool hasPage = false;                  ///< and for a page
};

/// Results of the tests of one table, in their order.
std::vector<TestResult> runTable(const Program& program, const TestTable& table, const TableRunOptions& options);

/// What a recorder has seen, as numbers and names.
CoverageResult coverageOf(const CoverageRecorder& recorder);

}  // namespace rungproof
