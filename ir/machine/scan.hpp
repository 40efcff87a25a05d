// Scan<D, Hooks>: one pass of the program over a domain. It walks instructions through the dispatch table. What moves
// the flow - jumps, loops, calls, the entry of interrupts - is the matter of each family: its members of Scan stand in
// its control.hpp. Whoever runs programs includes ir/families/run.hpp, which has them all. Hooks: those of the walk
// (ir/flow_walk.hpp); a hook entry(step), if there is one, gives the function to run for the instruction, nullptr for
// control instructions.
#pragma once

#include "ir/flow_walk.hpp"
#include "ir/machine/dispatch.hpp"
#include "ir/machine/plan.hpp"

namespace rungproof {

template <class D, class Hooks>
class Scan : private FlowWalk<Scan<D, Hooks>, Machine<D>, Hooks> {
  using Base = FlowWalk<Scan<D, Hooks>, Machine<D>, Hooks>;
  friend Base;
  using Base::branch;
  using Base::hooks_;
  using Base::inside;
  using Base::m_;
  using Base::walk;
  using typename Base::Walk;

 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  Scan(Machine<D>& machine, Hooks& hooks, int loopLimit = 256, std::size_t stepLimit = ~std::size_t{0})
      : Base(machine, hooks, loopLimit, stepLimit),
        dispatch_(machine.plan.form() == StatementForm::Accumulators  ? step7DispatchTable<D>()
                  : machine.plan.form() == StatementForm::Expressions ? iecDispatchTable<D>()
                                                                      : dispatchTable<D>()) {}

  Machine<D>& machine() { return m_; }

  /// Runs the program once.
  void program() {
    if (m_.plan.form() == StatementForm::Accumulators) return step7Program();
    if (m_.plan.form() == StatementForm::Expressions) return iecProgram();
    rungProgram();
  }

  /// Runs interrupt routine or block `number` where `condition` holds.
  void interrupt(int number, Bool condition) {
    if (m_.plan.form() == StatementForm::Accumulators) return interruptBlock(number, condition);
    rungInterrupt(number, condition);
  }

 private:
  struct Context {
    LogicStack<D> stack;
    Bool scrActive;
    unsigned frame;
    const Instruction* current;
  };

  void enterStack(Bool top) {
    m_.stack.fill(m_.d.constant(false));
    m_.stack[0] = top;
    m_.scrActive = m_.d.constant(true);
  }
  /// Called block: stack 1, 0, ... (001:6765), local memory undefined (001:1373).
  Context enter(unsigned frame) {
    Context saved{m_.stack, m_.scrActive, m_.frame, m_.current};
    enterStack(m_.d.constant(true));
    m_.frame = frame;
    return saved;
  }
  void freshLocals(unsigned frame) { freshBytes(frame * frameBytes, frameBytes); }
  void leave(const Context& saved) {
    m_.stack = saved.stack;
    m_.scrActive = saved.scrActive;
    m_.frame = saved.frame;
    m_.current = saved.current;
  }

  /// Runs one step; walk() has set the machine's `current`.
  void execute(Walk& w, std::uint32_t at) {
    const FlowStep& step = w.flow.steps[at];
    if (m_.plan.form() == StatementForm::Accumulators && step.instruction->desc->control != Control::None) {
      step7Control(w, at);
    } else if (m_.plan.form() == StatementForm::Expressions && step.instruction->desc->control != Control::None) {
      iecControl(w, at);
    } else if constexpr (requires { hooks_.entry(step); }) {
      if (const Execute<D> run = hooks_.entry(step); run != nullptr) {
        run(m_, *step.instruction);
      } else {
        control(w, at);
      }
    } else if (step.instruction->desc->control == Control::None) {
      dispatch_[step.instruction->desc->opcode](m_, *step.instruction);
    } else {
      control(w, at);
    }
    if (m_.plan.form() == StatementForm::Accumulators) serveError();
  }
  // ir/s7200/control.hpp
  void rungProgram();
  void rungInterrupt(int number, Bool condition);
  void control(Walk& w, std::uint32_t at);
  void call(const Instruction& instruction);
  void copyIn(const Instruction& instruction, const Pou& callee, unsigned calleeFrame);
  void copyOut(const Instruction& instruction, const Pou& callee, unsigned calleeFrame);
  void forLoop(Walk& w, std::uint32_t at);
  void nextRound(Walk& w, std::uint32_t at);
  void stop(Walk& w);
  // ir/iec/control.hpp
  void iecProgram();
  void iecControl(Walk& w, std::uint32_t at);
  // ir/s7300/control.hpp
  void step7Program();
  void organizationBlock(int number, Bool condition);
  void interruptBlock(int number, Bool condition);
  void startInformation(std::uint32_t base, int number, const Step7Registers<D>& interrupted);
  void freshBytes(std::uint32_t base, std::uint32_t count);
  void step7Control(Walk& w, std::uint32_t at);
  void distribute(Walk& w, std::uint32_t at);
  void step7Call(const Instruction& instruction);
  void enterBlock(const Flow& callee, const Instruction& instruction);
  void forgetOutput(const LocalVariable& formal, const Operand& actual, std::uint32_t number);
  std::vector<std::pair<std::uint32_t, HandedPointer<D>>> pointersOf(const Instruction& call, const Pou& callee,
                                                                     std::size_t firstActual);
  void systemBlock(const Instruction& call);
  void openActuals(const Instruction& call, std::uint32_t firstIndex);
  void serveError();

  std::span<const Execute<D>> dispatch_;
  Bool ended_ = m_.d.constant(false);  ///< STOP has ended the interrupt routine that runs
};

}  // namespace rungproof
