// The instructions that need no device: contacts, coils, moves, comparisons, ends.
#include <bit>
#include <cmath>

#include "machine.hpp"

namespace rungproof::referee {

void Machine::join(Joint joint, bool value) {
  if (joint == Joint::Load) {
    for (std::size_t n = 8; n > 0; --n) stack_[n] = stack_[n - 1];
    stack_[0] = value;
  } else if (joint == Joint::And) {
    stack_[0] = stack_[0] && value;
  } else {
    stack_[0] = stack_[0] || value;
  }
}

void Machine::execute(const Instruction& i) {
  const bool power = stack_[0];
  const auto drop = [this] {
    for (std::size_t n = 0; n < 8; ++n) stack_[n] = stack_[n + 1];
    stack_[8] = random_.chance(50);  // unknown (001:2868)
  };
  switch (i.op) {
    case Op::Contact: return join(i.joint, readBit(i.a, i.immediate) != i.negated);
    case Op::Compare: return compare(i);
    case Op::Not: stack_[0] = !power; return;
    case Op::EdgeUp:
    case Op::EdgeDown: return edge(i);
    case Op::Assign: return writeBits(i.a, 1, power);
    case Op::AndLoad:
    case Op::OrLoad: {
      const bool other = stack_[1];
      drop();
      stack_[0] = i.op == Op::AndLoad ? power && other : power || other;
      return;
    }
    case Op::Push: return join(Joint::Load, power);
    case Op::Top: stack_[0] = stack_[1]; return;
    case Op::Pop: return drop();
    case Op::OnDelay:
    case Op::RetentiveOnDelay:
    case Op::OffDelay: return timer(i);
    case Op::CountUp:
    case Op::CountDown:
    case Op::CountUpDown: return counter(i);
    case Op::Nop: return;
    default: break;
  }
  if (!power) return;  // a box without power flow does nothing (001:2274)
  switch (i.op) {
    case Op::Set: return writeBits(i.a, static_cast<int>(i.b.value), true);
    case Op::Reset: return writeBits(i.a, static_cast<int>(i.b.value), false);
    case Op::Move: return write(i.b, i.width, read(i.a, i.width));
    case Op::Increment: return step(i, 1);
    case Op::Decrement: return step(i, -1);
    case Op::AddInteger: {
      const std::int64_t sum = read(i.a, 'W') + read(i.b, 'W');
      if (sum >= -32768 && sum <= 32767) write(i.b, 'W', sum);  // operands stay as they were on overflow (001:4814)
      return;
    }
    case Op::Attach: return attach(i);
    case Op::Detach: return detach(static_cast<int>(i.a.value));
    case Op::ClearEvents:
      for (auto& queue : queues_) std::erase_if(queue, [&](const Entry& e) { return e.event == i.a.value; });
      return;
    case Op::Enable:
    case Op::Disable:
      if (inRoutine_) return runTimeError();  // 0004 (001:5337)
      interruptsEnabled_ = i.op == Op::Enable;
      setSystemBit(4, 4, interruptsEnabled_);
      return;
    case Op::ReturnFromInterrupt: routineEnds_ = inRoutine_; return;
    case Op::Receive: return receive(i);
    case Op::Transmit: return transmit(i);
    case Op::NetRead:
    case Op::NetWrite: return network(i);
    case Op::DefineCounter: return defineCounter(i);
    case Op::HighSpeed: return highSpeed(i);
    case Op::PulseOutput: return pulseOutput(i);
    case Op::ReadClock: return storeClock(i.a);
    case Op::End: scanEnds_ = true; return;
    case Op::Stop:
      tell("STOP");
      runEnds_ = true;
      if (inRoutine_) {
        // The routine ends, queued events are ignored, the rest of the scan is done (001:5695).
        routineEnds_ = true;
        for (auto& queue : queues_) queue.clear();
        interruptsEnabled_ = false;
      } else if (stopAtOnce_) {
        noScanEnd_ = true;
      }
      return;
    case Op::Call: return callSubroutine(i);
    case Op::ReturnIf: subroutineEnds_ = true; return;
    default: return;
  }
}

void Machine::callSubroutine(const Instruction& i) {
  const auto saved = stack_;
  stack_ = {true};
  const auto found = program_.subroutines.find(i.a.offset);
  if (found != program_.subroutines.end()) runBlock(found->second);
  subroutineEnds_ = false;
  stack_ = saved;
}

std::int64_t Machine::read(const Operand& o, char width) const {
  std::int64_t value = 0;
  switch (o.area) {
    case Area::Number: return width == 'B' ? o.value & 0xFF : o.value;
    case Area::T: return timers_[static_cast<std::size_t>(o.offset)].current;
    case Area::C: return counters_[static_cast<std::size_t>(o.offset)].current;
    case Area::HC: return highSpeed_[static_cast<std::size_t>(o.offset)].current;
    case Area::AC: value = accumulators_[static_cast<std::size_t>(o.offset)]; break;
    default: value = load(o.area, o.offset, width == 'B' ? 1 : width == 'W' ? 2 : 4); break;
  }
  if (width == 'B') return value & 0xFF;
  return width == 'W' ? static_cast<std::int16_t>(value) : static_cast<std::int32_t>(value);
}

void Machine::write(const Operand& o, char width, std::int64_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  if (o.area == Area::AC) {
    const std::uint32_t mask = width == 'B' ? 0xFFU : width == 'W' ? 0xFFFFU : 0xFFFFFFFFU;
    std::uint32_t& to = accumulators_[static_cast<std::size_t>(o.offset)];
    to = (to & ~mask) | (bits & mask);
  } else if (o.area == Area::T) {
    timers_[static_cast<std::size_t>(o.offset)].current = static_cast<std::int16_t>(value);
  } else if (o.area == Area::C) {
    counters_[static_cast<std::size_t>(o.offset)].current = static_cast<std::int16_t>(value);
  } else {
    store(o.area, o.offset, width == 'B' ? 1 : width == 'W' ? 2 : 4, bits);
  }
}

bool Machine::readBit(const Operand& o, bool immediate) const {
  if (immediate) return terminals_.at(static_cast<std::size_t>(o.offset * 8 + o.bit));
  if (o.area == Area::T) return timers_[static_cast<std::size_t>(o.offset)].bit;
  if (o.area == Area::C) return counters_[static_cast<std::size_t>(o.offset)].bit;
  return (load(o.area, o.offset, 1) >> o.bit & 1U) != 0;
}

/// Consecutive bits, or timers and counters: R clears the current value too (001:2791).
void Machine::writeBits(const Operand& o, int count, bool value) {
  for (int n = 0; n < count; ++n) {
    if (o.area == Area::T) {
      if (value) timers_[static_cast<std::size_t>(o.offset + n)].bit = true;
      if (!value) resetTimer(o.offset + n);
    } else if (o.area == Area::C) {
      CounterState& c = counters_[static_cast<std::size_t>(o.offset + n)];
      c.bit = value;
      if (!value) c.current = 0;
    } else {
      const int byte = o.offset + (o.bit + n) / 8;
      const int bit = (o.bit + n) % 8;
      const std::uint32_t old = load(o.area, byte, 1);
      store(o.area, byte, 1, value ? old | 1U << bit : old & ~(1U << bit));
    }
  }
}

/// Comparisons run without power flow too, and an illegal REAL is fatal (001:3384).
void Machine::compare(const Instruction& i) {
  const std::int64_t a = read(i.a, i.width);
  const std::int64_t b = read(i.b, i.width);
  double left = static_cast<double>(a);
  double right = static_cast<double>(b);
  if (i.width == 'R') {
    left = std::bit_cast<float>(static_cast<std::uint32_t>(a));
    right = std::bit_cast<float>(static_cast<std::uint32_t>(b));
    if (!std::isfinite(left) || !std::isfinite(right)) {
      tell("fatal: illegal REAL in a comparison");
      runEnds_ = noScanEnd_ = true;
      return;
    }
  }
  bool holds = false;
  switch (i.relation) {
    case Relation::Equal: holds = left == right; break;
    case Relation::NotEqual: holds = left != right; break;
    case Relation::Less: holds = left < right; break;
    case Relation::LessEqual: holds = left <= right; break;
    case Relation::Greater: holds = left > right; break;
    case Relation::GreaterEqual: holds = left >= right; break;
  }
  join(i.joint, holds);
}

/// The first scan stores the state and reports no edge (001:2763).
void Machine::edge(const Instruction& i) {
  const auto at = static_cast<std::size_t>(i.edge);
  const bool before = edgeMemory_[at];
  const bool now = stack_[0];
  edgeMemory_[at] = now;
  stack_[0] = scanNumber_ > 1 && (i.op == Op::EdgeUp ? now && !before : before && !now);
}

/// INC and DEC. What a result outside the range leaves is open; the generator keeps away from it (001:4999).
void Machine::step(const Instruction& i, int by) { write(i.a, i.width, read(i.a, i.width) + by); }

std::int64_t Machine::valueOf(const Operand& o) const {
  if (o.bit >= 0) return readBit(o, false) ? 1 : 0;
  return read(o, o.bytes == 1 ? 'B' : o.bytes == 2 ? 'W' : 'D');
}

bool Machine::bitOf(const Operand& o) const { return readBit(o, false); }

}  // namespace rungproof::referee
