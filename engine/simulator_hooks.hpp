// What the walk over the program calls back: time and interrupts in front of every instruction, library blocks, fresh
// local memory. Part of the simulator, kept apart because only its own sources see the walk.
#pragma once

#include <algorithm>
#include <span>

#include "engine/simulator.hpp"
#include "ir/families/run.hpp"
#include "ir/s7200/call_contract.hpp"

namespace rungproof {

struct Simulator::Hooks {
  Simulator& simulator;

  void before(Runner& runner, const FlowStep& step) {
    Simulator& s = simulator;
    const Cost& cost = s.costs_[step.id()];
    s.position_ += s.pending_;
    s.pending_ = 0;
    if (s.position_ >= s.nextMs_ || s.attention_) s.boundary(runner, &step);
    s.pending_ = cost.time[runner.machine().powerFlow() ? 1 : 0];
  }

  /// Of a block that only its call describes, a stimulus has to say what it writes: it may take all for inputs.
  void callWithoutBody(Runner& runner, const Instruction& instruction) {
    const CallContract* contract = simulator.contracts_->of(instruction);
    if (contract == nullptr) return;
    const bool isLibrary = contract->source == CallContract::Source::Library;
    if (simulator.outside_ == nullptr && !isLibrary && !simulator.devices_.hasLibraryOutput(contract->name)) return;
    simulator.calledBlock_ = &contract->name;
    callByContract(runner.machine(), instruction, *contract);
  }

  Execute<Concrete> entry(const FlowStep& step) const { return simulator.costs_[step.id()].run; }

  /// Local memory of a block that begins, from `base` on.
  void freshBytes(Runner& runner, std::uint32_t base, std::uint32_t count) {
    const Activation<Concrete>* running = runner.machine().step7.running;
    const bool isStart =
        simulator.outside_ == nullptr && running != nullptr && running->call == nullptr && running->localBase == base;
    const std::span<std::uint8_t> memory = std::span(simulator.store_.area(Area::L)).subspan(base, count);
    if (simulator.unknownIsZero_ && !isStart) {
      std::ranges::fill(memory, std::uint8_t{0});
      return;
    }
    for (std::uint32_t byte = 0; byte < count; ++byte) {
      std::uint64_t value = simulator.unknownIsZero_ ? 0 : runner.machine().external(External::LocalMemory, byte, 8);
      if (isStart) value = simulator.startByte(numberOfBlock(running->pou->number), byte, value);
      memory[byte] = static_cast<std::uint8_t>(value);
    }
  }
};

}  // namespace rungproof
