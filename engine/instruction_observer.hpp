// Watches a run from instruction to instruction, for displays of power flow. A simulator without an observer does not
// pay for it: observed runs take the path of pending interrupts in front of every instruction.
// Covered by tests/show/scan_test.cpp.
#pragma once

#include "engine/concrete.hpp"

namespace rungproof {

class InstructionObserver {
 public:
  virtual ~InstructionObserver() = default;
  /// In front of an instruction that is about to run; ticks and interrupts that come before it have been served.
  virtual void before(const Machine<Concrete>& machine, const Instruction& instruction) = 0;
  /// A value that an instruction got from outside the program.
  virtual void external(const ExternalSite& site, std::uint64_t value) = 0;
  /// The program of this scan has ended; the rest of the scan has not begun.
  virtual void programEnded(const Machine<Concrete>& machine) = 0;
};

}  // namespace rungproof
