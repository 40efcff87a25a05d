// Looks at the process' resident memory; a limit on address space would make allocations fail inside solvers, which
// cannot go on from there.
#include "analysis/proof/proof_watch.hpp"

#include <algorithm>
#include <chrono>

namespace rungproof {

ProofWatch::ProofWatch(const std::atomic<bool>* cancel, std::uint64_t memory) : cancel_(cancel), memory_(memory) {
  if (cancel_ != nullptr || memory_ > 0) thread_ = std::thread([this] { look(); });
}

ProofWatch::~ProofWatch() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void ProofWatch::look() {
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, std::chrono::milliseconds(20), [this] { return ended_; })) {
    if (isOverLimit()) outOfMemory_ = true;
    if (!isStopped()) continue;
    for (std::atomic<bool>* flag : flags_) flag->store(true);
  }
}

void ProofWatch::release() {
  if (!isOutOfMemory()) return;
  returnUnusedMemory();
  if (!isOverLimit()) outOfMemory_ = false;
}

ProofWatch::Guard::Guard(ProofWatch& watch, std::atomic<bool>& flag) : watch_(watch), flag_(flag) {
  const std::lock_guard lock(watch_.mutex_);
  watch_.flags_.push_back(&flag_);
  if (watch_.isStopped()) flag_ = true;
}

ProofWatch::Guard::~Guard() {
  const std::lock_guard lock(watch_.mutex_);
  std::erase(watch_.flags_, &flag_);
}

}  // namespace rungproof
