// The contract of bit-level engines: a verdict that brings its evidence. Proved comes with an inductive
// invariant, violated with the inputs of a run, unknown with the bound reached. Two engines that disagree stop
// the program: that is a defect, never an average.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "analysis/bit_system.hpp"

namespace rungproof {

enum class Answer : std::uint8_t { Proved, Violated, Unknown };

/// A run that ends in a bad state: initial latch values, then the input values of scans 0 .. depth.
struct BitTrace {
  std::vector<bool> initial;              ///< by latch index
  std::vector<std::vector<bool>> inputs;  ///< by scan, by input index
};

/// An inductive invariant over the latches: a conjunction of clauses over latch literals (as BitSystem literals)
/// that holds initially, is kept by every scan together with itself over the last k scans, and excludes the bad
/// states. k = 1 is plain induction; k-induction proofs carry their k and simple-path flag instead of clauses.
struct Certificate {
  std::vector<std::vector<Lit>> clauses;
  int k = 1;
  bool simplePath = false;
};

struct Verdict {
  Answer answer = Answer::Unknown;
  int depth = 0;  ///< Violated: length of the run - 1; Unknown: bad is unreachable within depth scans
  std::string method;
  std::optional<BitTrace> trace;
  std::optional<Certificate> certificate;
};

/// Time and cancellation; engines ask often (at least every 100 ms).
class Budget {
 public:
  using Clock = std::chrono::steady_clock;
  explicit Budget(Clock::time_point deadline, const std::atomic<bool>* cancel = nullptr) : deadline_(deadline), cancel_(cancel) {}
  bool isExhausted() const { return (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) || Clock::now() >= deadline_; }

 private:
  Clock::time_point deadline_;
  const std::atomic<bool>* cancel_;
};

}  // namespace rungproof
