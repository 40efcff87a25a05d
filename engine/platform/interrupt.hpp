// The user's wish to end, as a flag that work listens to. Covered by tests/timing/limits_test.cpp.
#pragma once

#include <atomic>
#include <cstdint>

namespace rungproof {

enum class Interrupts : std::uint8_t { CtrlC, CtrlCAndEnd };  ///< End: also the system's request to end

/// While it lives, the first interrupt raises the flag, and the second one ends the program. One at a time.
class InterruptFlag {
 public:
  InterruptFlag(std::atomic<bool>& flag, Interrupts which);
  ~InterruptFlag();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;

 private:
  Interrupts which_;
  void (*before_)(int) = nullptr;
  void (*beforeEnd_)(int) = nullptr;
};

}  // namespace rungproof
