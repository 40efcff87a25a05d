// Writes test tables: what the search at the bench and the prover have found is put together to few runs, expected
// values are taken from the engine, and every one of them is checked at the shortest and the longest scans, at others
// between and at changing ones, with inputs early and late. What does not hold everywhere is not expected, and the step
// says so.
//
// Why that covers all scan times and skews: a program sees the length of scans only through timers, clocks and what is
// computed from them, and inputs that are early or late only through the scans for which they act. Steps wait until the
// contacts are at rest, and for as many scans longer as skews may take away; from then on only time can change
// anything. What time changes it changes once, later or earlier, between its times at the ends of the ranges.
// Covered by tests/tables/generate_command_test.cpp.
#pragma once

#include <map>

#include "analysis/testing/bench_search.hpp"
#include "analysis/testing/coverage_questions.hpp"

namespace rungproof {

struct GeneratorOptions {
  SimulatorOptions engine;
  std::uint32_t lowUs = 1000, highUs = 100000;  ///< scans of which every expected value must hold
  std::uint32_t shownUs = 10000;                ///< scans with which coverage is measured
  std::set<Measure> measures{allMeasures.begin(), allMeasures.end()};
  bool changesTogether = false;  ///< a step may change several inputs
  double seconds = 20;           ///< for searching and proving
  std::uint64_t seed = 1;
  ProverOptions prover;
};

struct GeneratedTests {
  TestTable table;
  std::map<CoverageGoal, GoalAnswer> answers;  ///< of goals that no test covers, or that the prover had to find
  std::size_t plays = 0;                       ///< of all tests, to check what they expect
  std::size_t timingRows = 0;
};

/// `map` and what it stands on must outlive the call. Goals of the property set are not asked; its assumptions hold.
GeneratedTests generateTests(const CoverageMap& map, const PropertySet& set, const GeneratorOptions& options);

}  // namespace rungproof
