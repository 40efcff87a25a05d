// Timers of three resolutions and counters (001:6551-6611, 001:3990-4032).
#include <algorithm>

#include "machine.hpp"

namespace rungproof::referee {
namespace {

/// Table 6-74 (001:6597).
int resolutionOf(int number) {
  const int n = number % 64;
  if (number >= 101) return 100;
  if (n == 0 || n == 32) return 1;
  return (n >= 1 && n <= 4) || (n >= 33 && n <= 36) ? 10 : 100;
}

}  // namespace

/// The time base runs free: nothing ties its phase to the start of RUN or to the activation of a timer.
std::int64_t Machine::ticksBetween(int resolution, std::int64_t from, std::int64_t to) const {
  if (resolution == 1) return to - from;
  const int phase = phase_[resolution == 10 ? 0 : 1];
  return (to + phase) / resolution - (from + phase) / resolution;
}

void Machine::refresh(TimerState& t, int number, std::int64_t ticks) {
  if (!t.timing) return;
  t.current = static_cast<int>(std::min<std::int64_t>(32767, t.current + ticks));
  if (t.offDelay) {
    if (t.current < t.preset) return;
    t.current = t.preset;
    t.bit = false;
    t.timing = false;
  } else if (t.current >= t.preset) {
    t.bit = true;
  }
  if (telling_ && t.current == t.preset) tell("T" + std::to_string(number) + " at its preset");
}

void Machine::resetTimer(int number) {
  TimerState& t = timers_[static_cast<std::size_t>(number)];
  t.current = 0;
  t.bit = false;
  if (t.offDelay) t.timing = t.input = false;  // a new falling edge is needed (001:6586)
}

/// Executed in every scan; the top of the stack is its input, not its enable.
void Machine::timer(const Instruction& i) {
  TimerState& t = timers_[static_cast<std::size_t>(i.a.offset)];
  const int resolution = resolutionOf(i.a.offset);
  const bool input = stack_[0];
  t.preset = static_cast<int>(read(i.b, 'W'));
  t.offDelay = i.op == Op::OffDelay;
  const bool starts = t.offDelay ? !input && t.input : input && !t.timing;
  if (t.offDelay && input) {
    t.bit = true;
    t.current = 0;
    t.timing = false;
  } else if (!t.offDelay && !input) {
    t.timing = false;
    if (i.op == Op::OnDelay) t.current = 0;
    if (i.op == Op::OnDelay) t.bit = false;
  } else if (starts) {
    // Intervals count from the activation (001:6590).
    t.timing = true;
    if (resolution == 100) refresh(t, i.a.offset, 0);  // the bit is set when the instruction is executed (001:6611)
  } else if (t.timing && resolution == 100) {
    // How many intervals are added is settled at the start of the scan: those since the start of the scan before
    // (004:4594); what passes in scans that jump over the box is lost (004:4598).
    refresh(t, i.a.offset, ticksBetween(100, lastScanStart_, scanStart_));
  }
  t.input = input;
}

void Machine::counter(const Instruction& i) {
  CounterState& c = counters_[static_cast<std::size_t>(i.a.offset)];
  const bool reset = stack_[0];
  const bool up = i.op == Op::CountUpDown ? stack_[2] : i.op == Op::CountUp && stack_[1];
  const bool down = i.op != Op::CountUp && stack_[1];
  const bool counts = c.executed || edgeCounts_;
  const bool rises = up && !c.up && counts;
  const bool falls = down && !c.down && counts;
  const int preset = static_cast<int>(read(i.b, 'W'));
  c.up = up;
  c.down = down;
  c.executed = true;
  if (reset) {
    c.current = i.op == Op::CountDown ? preset : 0;
    c.bit = false;
    return;
  }
  if (i.op == Op::CountUp && rises && c.current < 32767) ++c.current;
  if (i.op == Op::CountDown && falls && c.current > 0) --c.current;
  if (i.op == Op::CountUpDown) c.current += (rises ? 1 : 0) - (falls ? 1 : 0);
  c.bit = i.op == Op::CountDown ? c.current == 0 : c.current >= preset;
}

}  // namespace rungproof::referee
