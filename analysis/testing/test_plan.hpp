// From the steps of a search to few tests: each begins with power-on and goes the nearest way from one step that covers
// something new to the next. Covered by tests/tables/generate_command_test.cpp.
#pragma once

#include <vector>

#include "analysis/testing/bench_search.hpp"

namespace rungproof {

using BenchTest = std::vector<BenchStep>;

/// Tests in which every useful step of the search stands once.
std::vector<BenchTest> plannedTests(const BenchSearch& search);
/// How long the steps of a walk last: until all is at rest, one scan (so that what comes a scan late shows), either, or
/// times between, in which windows of time are open or shut.
enum class Pace : std::uint8_t { Settled, Mixed, Quick, Timed };
/// Ways through what the search has seen, drawn with the seed; settled ones have no steps that are fragile.
std::vector<BenchTest> walks(const BenchSearch& search, std::uint64_t seed, std::size_t count, std::size_t length,
                             Pace pace);
/// The steps from power-on to the end of an edge, as the search went.
BenchTest wayTo(const BenchSearch& search, const BenchSearch::Edge& edge);

}  // namespace rungproof
