// Writes test tables: what the search at the bench and the prover have found is put together to few runs, expected
// values are taken from the engine, and every one of them is checked at the shortest and the longest scans, at others
// between and at changing ones, with inputs early and late. What does not hold everywhere is not expected, and the step
// says so.
//
// What that proves stands in robust_check.hpp. Then planted faults are looked for that no test notices
// (fault_tests.hpp). Covered by tests/tables/generate_command_test.cpp.
#pragma once

#include <map>

#include "analysis/testing/bench_search.hpp"
#include "analysis/testing/coverage_questions.hpp"

namespace rungproof {

/// Steps of a test; a person at the machine follows no longer one.
inline constexpr std::size_t mostTestSteps = 200;

struct GeneratorOptions {
  SimulatorOptions engine;
  std::uint32_t lowUs = 1000, highUs = 100000;  ///< scans of which every expected value must hold
  std::uint32_t shownUs = 10000;                ///< scans with which coverage is measured
  std::set<Measure> measures{allMeasures.begin(), allMeasures.end()};
  bool changesTogether = false;  ///< a step may change several inputs
  double seconds = 18;           ///< of processor time for everything; proofs under way may take a little more
  std::uint64_t seed = 1;
  ProverOptions prover;
};

struct GeneratedTests {
  TestTable table;
  std::map<CoverageGoal, GoalAnswer> answers;  ///< of goals that no test covers, or that the prover had to find
  std::size_t plays = 0;                       ///< of all tests, to check what they expect
  /// Expected values that were proved for every whole millisecond and all skews, that were tried only, and that come
  /// with the shown scans alone.
  std::size_t provedCells = 0, checkedCells = 0, timedCells = 0;
  std::size_t timingRows = 0;  ///< steps that say `timing`
  std::size_t triedRows = 0;   ///< steps that say `timing` because nothing could be proved
  std::size_t silentRows = 0;  ///< steps at which some output is not compared, as it depends on the length of scans
};

/// `map` and what it stands on must outlive the call. Goals of the property set are not asked; its assumptions hold.
GeneratedTests generateTests(const CoverageMap& map, const PropertySet& set, const GeneratorOptions& options);

}  // namespace rungproof
