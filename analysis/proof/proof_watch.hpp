// ProofWatch: ends searches from outside when the user interrupts or the memory limit is reached, so that a proof run
// always comes back with what it has settled. A thread looks every 20 ms and raises the flags that searches listen to.
// Covered by tests/timing/limits_test.cpp.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/platform/memory.hpp"

namespace rungproof {

/// Thrown out of encoding when it is stopped.
struct EncodingStopped {};

class ProofWatch {
 public:
  /// `cancel`: set by the user's interrupt, or nullptr. `memory`: bytes, 0: no limit.
  ProofWatch(const std::atomic<bool>* cancel, std::uint64_t memory);
  ~ProofWatch();
  ProofWatch(const ProofWatch&) = delete;
  ProofWatch& operator=(const ProofWatch&) = delete;

  bool isInterrupted() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }
  /// Whether the limit has been reached since the last release().
  bool isOutOfMemory() const { return outOfMemory_.load(std::memory_order_relaxed); }
  bool isStopped() const { return isInterrupted() || isOutOfMemory(); }
  /// Gives freed memory back to the system; searches may go on if that was enough.
  void release();

  /// Raises `flag` when searches have to end, as long as the guard lives.
  class Guard {
   public:
    Guard(ProofWatch& watch, std::atomic<bool>& flag);
    ~Guard();
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

   private:
    ProofWatch& watch_;
    std::atomic<bool>& flag_;
  };

 private:
  void look();
  bool isOverLimit() const { return memory_ > 0 && residentBytes() > memory_; }

  const std::atomic<bool>* cancel_;
  const std::uint64_t memory_;
  std::atomic<bool> outOfMemory_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::vector<std::atomic<bool>*> flags_;
  std::thread thread_;
};

}  // namespace rungproof
