// The contract of bit-level engines: a verdict that brings its evidence. Proved comes with an inductive
// invariant, violated with the inputs of a run, unknown with the bound reached. Two engines that disagree stop
// the program: that is a defect, never an average. Engines are resumable: advance() works until the budget is
// used up or an answer is there, and goes on where it stopped when called again.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/bits/bit_system.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

enum class Answer : std::uint8_t { Proved, Violated, Unknown };

/// A run that ends in a bad state: initial latch values, then the input values of scans 0 .. depth.
struct BitTrace {
  std::vector<bool> initial;              ///< by latch index
  std::vector<std::vector<bool>> inputs;  ///< by scan, by input index
};

/// Why bad is unreachable. With k = 0: the clauses, together with the invariants the engine was given, hold
/// initially, are kept by every scan and exclude bad. With k >= 1: bad does not occur in the first k scans, and no
/// k scans without bad whose states satisfy the given invariants are followed by a bad one; with simplePath the
/// k + 1 states are pairwise different in the latches. Literals are those of the system; variables beyond it are
/// the gates added here, defined over latches and earlier gates only.
struct Certificate {
  std::vector<std::vector<Lit>> clauses;
  std::vector<AndGate> gates;  ///< variable variableCount() + i
  int k = 0;
  bool simplePath = false;
};

struct Verdict {
  Answer answer = Answer::Unknown;
  int depth = 0;  ///< Violated: length of the run - 1; Unknown: bad is unreachable in the first `depth` scans
  std::string method;
  std::optional<BitTrace> trace;
  std::optional<Certificate> certificate;
};

/// Time and cancellation; engines ask often (at least every 100 ms).
class Budget {
 public:
  using Clock = std::chrono::steady_clock;
  /// s of processor time that the calling thread has taken.
  static double threadSeconds() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  }
  explicit Budget(Clock::time_point deadline, const std::atomic<bool>* cancel = nullptr,
                  const std::atomic<bool>* outer = nullptr)
      : deadline_(deadline), cancel_(cancel), outer_(outer) {}
  /// A budget of that many seconds from now.
  static Budget seconds(double s, const std::atomic<bool>* cancel = nullptr, const std::atomic<bool>* outer = nullptr) {
    return Budget(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s)), cancel,
                  outer);
  }
  /// Of the calling thread, which alone may ask: that much of its processor's time, and until the deadline. What is
  /// worth a moment does not depend on what else the machine does.
  static Budget ofThread(double s, const Budget& whole) {
    Budget result = whole;
    result.threadDeadline_ = threadSeconds() + s;
    result.threadLook_ = {};
    return result;
  }
  /// The same cancellation and deadline, but at most that much of the processor's time of the calling thread, which
  /// alone may ask; and not for ever where others have the processor.
  Budget slice(double s) const {
    Budget result = *this;
    const double most = threadSeconds() + s;
    result.threadDeadline_ = threadDeadline_ > 0 ? std::min(threadDeadline_, most) : most;
    result.threadLook_ = {};
    result.deadline_ = std::min(deadline_, seconds(s * schedule::mostWait).deadline_);
    return result;
  }
  bool isExhausted() const {
    if (isSet(cancel_) || isSet(outer_)) return true;
    const Clock::time_point now = Clock::now();
    return now >= deadline_ || (threadDeadline_ > 0 && now >= threadLook_ && isThreadOver(now));
  }

 private:
  /// A thread takes no more of the processor than time passes: until what is left has passed, nobody need look again,
  /// which asks the system and is dear.
  bool isThreadOver(Clock::time_point now) const {
    const std::chrono::duration<double> rest(threadDeadline_ - threadSeconds());
    threadLook_ = now + std::chrono::duration_cast<Clock::duration>(rest);
    return rest.count() <= 0;
  }
  static bool isSet(const std::atomic<bool>* flag) { return flag != nullptr && flag->load(std::memory_order_relaxed); }

  Clock::time_point deadline_;
  const std::atomic<bool>* cancel_;
  const std::atomic<bool>* outer_;
  double threadDeadline_ = 0;             ///< in processor time of the thread; 0: none
  mutable Clock::time_point threadLook_;  ///< not before that can it be over
};

struct EngineOptions {
  int bound = 1 << 30;     ///< BMC and k-induction look at that many scans at most
  std::uint64_t seed = 1;  ///< of random choices
  bool simplePath = true;  ///< k-induction: require different states on the path
  /// Clauses that hold in every reachable state of the system (proved elsewhere), over latches and gates that
  /// depend on latches only.
  std::vector<std::vector<Lit>> invariants;
};

/// An engine at work on one system: can some `bads` literal be true in some scan? The system must outlive it.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual Verdict advance(const Budget& budget) = 0;
  /// True when more time cannot help (bound reached, state space too large for the method).
  virtual bool isExhausted() const { return false; }
};

std::unique_ptr<Engine> makeBmc(const BitSystem& system, const EngineOptions& options);
std::unique_ptr<Engine> makeKInduction(const BitSystem& system, const EngineOptions& options);
std::unique_ptr<Engine> makeIc3(const BitSystem& system, const EngineOptions& options);
std::unique_ptr<Engine> makeExhaustive(const BitSystem& system, const EngineOptions& options);
std::unique_ptr<Engine> makeSimulation(const BitSystem& system, const EngineOptions& options);
std::unique_ptr<Engine> makeHeldInputs(const BitSystem& system, const EngineOptions& options);

}  // namespace rungproof
