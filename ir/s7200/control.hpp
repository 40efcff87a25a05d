// What moves the flow of a program of rungs: JMP, FOR, CALL, SCR, END, STOP and the entry of interrupt routines.
// Members of Scan (ir/machine/scan.hpp).
#pragma once

#include "ir/machine/scan.hpp"
#include "ir/s7200/args.hpp"

namespace rungproof {

/// Runs the main program once. The stack at its start is not stated (Choice::MainStack).
template <class D, class Hooks>
void Scan<D, Hooks>::rungProgram() {
  const Flow* main = m_.plan.main();
  if (main == nullptr) return;
  m_.frame = 0;
  freshLocals(0);
  enterStack(m_.d.constant(false));
  m_.when(m_.reads({Choice::MainStack, "unknown"}), [&] {
    for (std::uint32_t i = 0; i < m_.stackLevels; ++i) m_.setLevel(i, m_.externalBit(External::StackBottom, i));
  });
  ended_ = m_.d.constant(false);
  walk(*main);
}

/// Stack, accumulators, SM1 and ENO are saved around the routine (001:5430). Its stack starts as Choice::InterruptStack
/// says.
template <class D, class Hooks>
void Scan<D, Hooks>::rungInterrupt(int number, Bool condition) {
  const Flow* routine = m_.plan.interrupt(number);
  if (routine == nullptr) return;
  m_.when(condition, [&] {
    freshLocals(interruptFrame);
    const Context saved = enter(interruptFrame);
    m_.stack[0] = m_.reads({Choice::InterruptStack, "one"});
    std::array<Bits, 4> accumulators;
    for (std::uint32_t i = 0; i < 4; ++i) accumulators[i] = m_.get(Reg::Accumulator, i);
    const Bits status = m_.load(Area::SM, 1, Width::Byte);
    const Bool eno = m_.getBit(Reg::Eno);
    m_.inInterrupt = true;
    walk(*routine);
    m_.inInterrupt = false;
    ended_ = m_.d.constant(false);
    m_.save(Area::SM, 1, Width::Byte, status);
    m_.setBit(Reg::Eno, 0, eno);
    for (std::uint32_t i = 0; i < 4; ++i) m_.set(Reg::Accumulator, i, accumulators[i]);
    leave(saved);
  });
}

template <class D, class Hooks>
void Scan<D, Hooks>::control(Walk& w, std::uint32_t at) {
  const FlowStep& step = w.flow.steps[at];
  const Instruction& instruction = *step.instruction;
  const auto end = static_cast<std::uint32_t>(w.flow.steps.size());
  switch (instruction.desc->control) {
    case Control::Jump:
      if (step.partner != noPartner) branch(w, m_.powerFlow(), step.partner);
      break;
    case Control::For: forLoop(w, at); break;
    case Control::Next: nextRound(w, at); break;
    case Control::Call:
      m_.enoAfter(m_.powerFlow());
      inside(m_.powerFlow(), [&] { call(instruction); });
      m_.guard = m_.d.land(m_.guard, m_.d.lnot(ended_));
      break;
    case Control::ReturnConditional:
    case Control::InterruptReturnConditional:
    case Control::End: branch(w, m_.powerFlow(), end); break;
    case Control::Return:
    case Control::InterruptReturn:
    case Control::MainEnd: branch(w, m_.d.constant(true), end); break;
    case Control::Stop: stop(w); break;
    case Control::Lscr: {
      const Operand& s = instruction.operands[0];
      const Bool active = m_.loadBit(Area::S, s.offset, s.bit);
      m_.setTop(active);
      m_.scrActive = m_.d.select(m_.guard, active, m_.scrActive);
      if (step.partner != noPartner)
        branch(w, m_.d.land(m_.d.lnot(active), m_.reads({Choice::InactiveScr, "skipped"})), step.partner);
      break;
    }
    case Control::Scrt: {
      const Operand& to = instruction.operands[0];
      m_.when(m_.powerFlow(), [&] {
        if (step.partner != noPartner) {
          const Operand& from = w.flow.steps[step.partner].instruction->operands[0];
          m_.saveBit(Area::S, from.offset, from.bit, m_.d.constant(false));
        }
        m_.saveBit(Area::S, to.offset, to.bit, m_.d.constant(true));
      });
      break;
    }
    case Control::ScrEndConditional:
      if (step.partner != noPartner) branch(w, m_.powerFlow(), step.partner);
      break;
    case Control::ScrEnd: m_.scrActive = m_.d.select(m_.guard, m_.d.constant(true), m_.scrActive); break;
    default: break;
  }
}

/// FOR INDX, INIT, FINAL: without power flow, or with INIT above FINAL, the body is skipped (001:5762-5768).
template <class D, class Hooks>
void Scan<D, Hooks>::forLoop(Walk& w, std::uint32_t at) {
  const FlowStep& step = w.flow.steps[at];
  if (step.partner == noPartner) return;
  Bool skip = m_.d.lnot(m_.powerFlow());
  m_.enoAfter(m_.powerFlow());
  m_.when(m_.powerFlow(), [&] {
    Args<D> args(m_, *step.instruction, *step.instruction->desc);
    const Bool legal = args.resolve();
    m_.hazard(Hazard::BadIndirectAddress, m_.d.lnot(legal));
    const Bits init = args.value(1);
    m_.when(legal, [&] { args.store(0, init); });
    skip = m_.d.lor(skip, m_.d.lor(m_.d.lnot(legal), m_.d.slt(args.value(2), init, 16)));
  });
  branch(w, skip, step.partner + 1);
}

/// NEXT: INDX + 1; the loop ends when INDX exceeds FINAL, which is read anew in every round (001:5762).
template <class D, class Hooks>
void Scan<D, Hooks>::nextRound(Walk& w, std::uint32_t at) {
  const FlowStep& step = w.flow.steps[at];
  if (step.partner == noPartner) return;
  const Instruction& head = *w.flow.steps[step.partner].instruction;
  Args<D> args(m_, head, *head.desc);
  const Bool legal = args.resolve();
  m_.hazard(Hazard::BadIndirectAddress, m_.d.lnot(legal));
  const Bits old = args.value(0);
  const Bits index = m_.d.add(old, m_.d.literal(1, 16), 16);
  m_.when(legal, [&] { args.store(0, index); });
  const Bool atMaximum = m_.d.equal(old, m_.d.literal(0x7FFF, 16), 16);
  const Bool last =
      m_.d.lor(m_.d.slt(args.value(2), index, 16), m_.d.land(atMaximum, m_.reads({Choice::ForAtMaximum, "ends"})));
  m_.setTop(m_.d.constant(true));
  branch(w, m_.d.land(legal, m_.d.lnot(last)), step.partner + 1);
}

/// STOP: in an interrupt routine, and in the subroutine it called, the routine ends and the scan is completed
/// (001:5695); in the main program Choice::MainStop says whether the rest of the scan runs.
template <class D, class Hooks>
void Scan<D, Hooks>::stop(Walk& w) {
  const Bool stopped = m_.powerFlow();
  m_.when(stopped, [&] {
    m_.setBit(Reg::Running, 0, m_.d.constant(false));
    m_.signal(Signal::Stopped);
  });
  if (m_.inInterrupt) {
    ended_ = m_.d.lor(ended_, m_.d.land(m_.guard, stopped));
    branch(w, stopped, static_cast<std::uint32_t>(w.flow.steps.size()));
  } else {
    m_.halt(m_.d.land(stopped, m_.reads({Choice::MainStop, "at-once"})));
  }
}

template <class D, class Hooks>
void Scan<D, Hooks>::call(const Instruction& instruction) {
  const bool hasNumber = !instruction.operands.empty() && instruction.operands[0].kind == OperandKind::Constant;
  const Flow* callee = hasNumber ? m_.plan.subroutine(static_cast<int>(instruction.operands[0].value)) : nullptr;
  if (callee == nullptr) return hooks_.callWithoutBody(*this, instruction);
  const unsigned calleeFrame = m_.frame + 1;
  const bool tooDeep = m_.inInterrupt
                           ? calleeFrame > interruptFrame + static_cast<unsigned>(m_.features.interruptNesting)
                           : calleeFrame > mainNesting;
  m_.hazard(Hazard::NestingTooDeep, m_.d.constant(tooDeep));
  if (tooDeep) return;
  freshLocals(calleeFrame);
  copyIn(instruction, *callee->pou, calleeFrame);
  Context saved = enter(calleeFrame);
  const Bool shared = m_.inInterrupt ? m_.reads({Choice::InterruptCallStack, "shared"}) : m_.d.constant(false);
  const auto share = [&](LogicStack<D>& to, const LogicStack<D>& from) {
    for (std::size_t i = 0; i < m_.stackLevels; ++i) to[i] = m_.d.select(shared, from[i], to[i]);
  };
  share(m_.stack, saved.stack);
  walk(*callee);
  share(saved.stack, m_.stack);
  leave(saved);
  copyOut(instruction, *callee->pou, calleeFrame);
}

/// IN and IN_OUT: the value to the parameter's place in the callee's local memory (001:6815).
template <class D, class Hooks>
void Scan<D, Hooks>::copyIn(const Instruction& instruction, const Pou& callee, unsigned calleeFrame) {
  const unsigned callerFrame = m_.frame;
  std::size_t i = 1;
  for (const LocalVariable& local : callee.locals) {
    if (local.section == VarSection::Temp || i >= instruction.operands.size()) continue;
    const std::size_t at = i++;
    if (local.section == VarSection::Output) continue;
    Args<D> args(m_, instruction, *instruction.desc);
    const Bits value = args.parameter(at, local.type);
    m_.frame = calleeFrame;
    m_.save(Area::L, local.address.offset, local.address.width, value, local.address.bit);
    m_.frame = callerFrame;
  }
}

template <class D, class Hooks>
void Scan<D, Hooks>::copyOut(const Instruction& instruction, const Pou& callee, unsigned calleeFrame) {
  const unsigned callerFrame = m_.frame;
  std::size_t i = 1;
  for (const LocalVariable& local : callee.locals) {
    if (local.section == VarSection::Temp || i >= instruction.operands.size()) continue;
    const std::size_t at = i++;
    if (local.section == VarSection::Input) continue;
    m_.frame = calleeFrame;
    const Bits value = m_.load(Area::L, local.address.offset, local.address.width, local.address.bit);
    m_.frame = callerFrame;
    Args<D> args(m_, instruction, *instruction.desc);
    args.storeParameter(at, local.type, value);
  }
}

}  // namespace rungproof
