// BenchSearch: looks for what tests can cover the way a person at a test bench does: one input is changed, some scans
// or a time pass, and then it is seen what has come of it. What was reached is kept, and the search goes on from there,
// the shortest way first. Each step is run twice, with the longest scans and with short ones; where the outputs differ,
// the step is fragile and is taken only if nothing else leads on. Proves nothing. Covered by
// tests/tables/generate_command_test.cpp.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "analysis/testing/processor_clock.hpp"
#include "analysis/testing/test_signals.hpp"
#include "analysis/witness/follower.hpp"
#include "engine/coverage/coverage_recorder.hpp"
#include "engine/testing/test_table.hpp"

namespace rungproof {

/// A step at the bench: what is changed, and how long it is waited.
struct BenchStep {
  std::vector<std::pair<std::size_t, TraceNumber>> changes;  ///< input and its value; empty: only time passes
  TestWait wait{};
};

struct BenchOptions {
  SimulatorOptions engine;
  std::uint32_t longestUs = 100000, shortUs = 10000;  ///< scans of the two runs of each step
  double seconds = 10;
  std::size_t memory = 400'000'000;  ///< bytes for kept states
};

class BenchSearch {
 public:
  using Clock = ProcessorClock;
  /// A state that was reached, with the way to it.
  struct Node {
    std::size_t parent = 0;
    BenchStep step;
    std::vector<TraceNumber> inputs;
    std::size_t depth = 0;
    bool isFragile = false;
  };
  /// A step that led somewhere.
  struct Edge {
    std::size_t from = 0, to = 0;
    BenchStep step;
    bool isUseful = false;  ///< covered something for the first time
    bool isFragile = false;
  };

  /// Program, signals and map must outlive the search. `assumptions`: runs that break one are no runs.
  BenchSearch(const Program& program, const TestSignals& signals, const CoverageMap& map,
              const std::vector<const Property*>& assumptions, const BenchOptions& options);
  ~BenchSearch();

  /// Searches until `isDone` or the time is over. False: nothing is left to be tried.
  bool search(const std::function<bool()>& isDone);
  /// Goes on whatever is covered, until `end` or some thousands of states, so that there are more ways to choose from.
  void explore(Clock::time_point end);
  /// Makes steps from power-on, and keeps where they lead. Whether they covered something new.
  bool follow(const std::vector<BenchStep>& steps);

  const CoverageRecorder& recorder() const;
  const std::vector<Node>& nodes() const;
  const std::vector<Edge>& edges() const;
  /// A step that waits as long as it takes until nothing moves; its wait is found by running it.
  static constexpr TestWait untilRest{0, 0};

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rungproof
