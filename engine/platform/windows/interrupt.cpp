// Signals of the C runtime; Ctrl-Break is how a parent hands an interrupt on.
#include "engine/platform/interrupt.hpp"

#include <csignal>

namespace rungproof {

namespace {

std::atomic<std::atomic<bool>*> raisedFlag = nullptr;

/// The runtime has put the default in place of this handler before it calls it.
extern "C" void onInterrupt(int) {
  *raisedFlag = true;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGBREAK, SIG_DFL);
}

}  // namespace

InterruptFlag::InterruptFlag(std::atomic<bool>& flag, Interrupts which) : which_(which) {
  raisedFlag = &flag;
  before_ = std::signal(SIGINT, onInterrupt);
  beforeEnd_ = std::signal(SIGBREAK, onInterrupt);
}

InterruptFlag::~InterruptFlag() {
  std::signal(SIGINT, before_);
  std::signal(SIGBREAK, beforeEnd_);
}

}  // namespace rungproof
