// Members of Scan for the IEC 61131-3 machine: the program, jumps and calls of bodies.
#pragma once

#include "ir/machine/scan.hpp"

namespace rungproof {

/// Runs the entry block, which lets time pass for timers and calls the program instances in their order.
template <class D, class Hooks>
void Scan<D, Hooks>::iecProgram() {
  const Flow* main = m_.plan.main();
  if (main == nullptr) return;
  m_.evaluation.clear();
  walk(*main);
}

template <class D, class Hooks>
void Scan<D, Hooks>::iecControl(Walk& w, std::uint32_t at) {
  const FlowStep& step = w.flow.steps[at];
  const Instruction& instruction = *step.instruction;
  switch (instruction.desc->control) {
    case Control::Jump: {
      Bool jumps = m_.d.constant(true);
      if (instruction.desc->stack.pops > 0) {
        jumps = m_.d.lnot(m_.d.bit(m_.evaluation.back(), 0));
        m_.evaluation.pop_back();
      }
      if (step.partner != noPartner) branch(w, jumps, step.partner);
      break;
    }
    case Control::Call: {
      const Flow* body = m_.plan.subroutine(static_cast<int>(instruction.operands[0].value));
      if (body == nullptr) break;
      const Instruction* const caller = m_.current;
      inside(m_.d.constant(true), [&] { walk(*body); });
      m_.current = caller;
      break;
    }
    case Control::Return: branch(w, m_.d.constant(true), static_cast<std::uint32_t>(w.flow.steps.size())); break;
    default: break;
  }
}

}  // namespace rungproof
