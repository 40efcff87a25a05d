// Signals.
#include "engine/platform/interrupt.hpp"

#include <csignal>

namespace rungproof {

namespace {

static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<std::atomic<bool>*>::is_always_lock_free,
              "a signal handler uses them");
std::atomic<std::atomic<bool>*> raisedFlag = nullptr;

extern "C" void onCtrlC(int) {
  *raisedFlag = true;
  std::signal(SIGINT, SIG_DFL);
}

extern "C" void onCtrlCOrEnd(int) {
  *raisedFlag = true;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

InterruptFlag::InterruptFlag(std::atomic<bool>& flag, Interrupts which) : which_(which) {
  raisedFlag = &flag;
  const bool takesEnd = which == Interrupts::CtrlCAndEnd;
  before_ = std::signal(SIGINT, takesEnd ? onCtrlCOrEnd : onCtrlC);
  if (takesEnd) beforeEnd_ = std::signal(SIGTERM, onCtrlCOrEnd);
}

InterruptFlag::~InterruptFlag() {
  std::signal(SIGINT, before_);
  if (which_ == Interrupts::CtrlCAndEnd) std::signal(SIGTERM, beforeEnd_);
}

}  // namespace rungproof
