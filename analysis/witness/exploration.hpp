// Exploration: runs of the engine that start where earlier runs came to something new. A sequence of ten steps, each
// behind a timer of half an hour, is reached step by step: what was reached is kept, inputs are changed there, and
// time passes in the longest scans. Finds runs that are too deep for a search from power-up; proves nothing.
// Tested by tests/prover/exploration_test.cpp.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "analysis/witness/run_space.hpp"
#include "analysis/witness/witness.hpp"

namespace rungproof {

class Exploration {
 public:
  using Clock = std::chrono::steady_clock;

  /// `wanted`: indices of the goals that are watched. Program, assumptions and goals must outlive the exploration. Runs
  /// start at power-up with lost memory.
  Exploration(const Program& program, const RunSpace& space, const std::vector<Property>& assumptions,
              const std::vector<Property>& goals, const std::vector<std::size_t>& wanted, std::uint64_t seed);
  ~Exploration();

  /// That goal is settled elsewhere.
  void withdraw(std::size_t goal);
  /// Explores until `deadline`, until `cancel`, until `goal` (if given) or every open goal is shown, or until nothing
  /// new has come for long. False in that last case: going on is no use.
  bool search(Clock::time_point deadline, const std::atomic<bool>& cancel,
              std::optional<std::size_t> goal = std::nullopt);
  /// The run that shows a goal, repeated by the judge.
  const std::optional<Witness>& found(std::size_t goal) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// An exploration beside other searches for the same goal.
class ExplorationThread {
 public:
  /// Begins after so many seconds, which others have the processor alone. `found` is called in the thread when the goal
  /// has been shown.
  ExplorationThread(Exploration& exploration, std::size_t goal, Exploration::Clock::time_point deadline, double pause,
                    std::function<void()> found);
  ~ExplorationThread() { end(); }
  ExplorationThread(const ExplorationThread&) = delete;
  ExplorationThread& operator=(const ExplorationThread&) = delete;
  /// Stops it. Whether the goal has been shown.
  bool end();
  /// What the search took, after its end.
  double seconds() const { return seconds_; }

 private:
  Exploration& exploration_;
  const std::size_t goal_;
  std::atomic<bool> cancel_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;  ///< before it has begun
  double seconds_ = 0;
  std::thread thread_;
};

}  // namespace rungproof
