// Interrupt events, their queues and routines (001:5327-5547), for the CPU 226.
#include <algorithm>

#include "machine.hpp"

namespace rungproof::referee {
namespace {

/// Communication, I/O, timed: Table 6-50 (001:5504).
std::size_t groupOf(int event) {
  if (event == 8 || event == 9 || (event >= 23 && event <= 26)) return 0;
  return event == 10 || event == 11 || event == 21 || event == 22 ? 2 : 1;
}

}  // namespace

void Machine::attach(const Instruction& i) {
  const auto event = static_cast<std::size_t>(i.b.value);
  attached_.at(event) = i.a.offset + 1;
  if (event != 10 && event != 11) return;
  // The interval is taken over here, time that has passed is discarded (001:5472).
  period_[event - 10] = load(Area::SM, static_cast<int>(34 + event - 10), 1);
  elapsed_[event - 10] = 0;
}

void Machine::detach(int event) {
  attached_.at(static_cast<std::size_t>(event)) = 0;
  if (!detachDrops_) return;
  for (auto& queue : queues_) std::erase_if(queue, [&](const Entry& e) { return e.event == event; });
}

/// An attached event enters its queue, whether interrupts are enabled or not (001:5372); a full queue loses it.
void Machine::raise(int event) {
  static constexpr std::array<std::size_t, 3> depth = {8, 16, 8};  // 001:5486
  const int routine = attached_.at(static_cast<std::size_t>(event));
  if (routine == 0) return;
  const std::size_t group = groupOf(event);
  if (queues_[group].size() >= depth[group]) {
    setSystemBit(4, static_cast<int>(group), true);
    tell("event " + std::to_string(event) + " lost, queue full");
  } else {
    queues_[group].push_back({event, routine - 1});
    tell("event " + std::to_string(event));
  }
}

/// One routine after the other, the highest group first, inside a group in order of arrival (001:5480).
void Machine::serve() {
  if (inRoutine_ || !interruptsEnabled_ || noScanEnd_) return;
  while (!noScanEnd_ && interruptsEnabled_) {
    const auto queue = std::find_if(queues_.begin(), queues_.end(), [](const auto& q) { return !q.empty(); });
    if (queue == queues_.end()) break;
    const Entry entry = queue->front();
    queue->pop_front();
    runRoutine(entry);
  }
  // Empty, and control is back in the main program (001:5491).
  if (std::all_of(queues_.begin(), queues_.end(), [](const auto& q) { return q.empty(); })) {
    for (int bit = 0; bit < 3; ++bit) setSystemBit(4, bit, false);
  }
}

/// Stack, accumulators and the bits of SMB1 are saved and restored (001:5430).
void Machine::runRoutine(const Entry& entry) {
  const auto routine = program_.interrupts.find(entry.routine);
  if (routine == program_.interrupts.end()) return;
  tell("INT_" + std::to_string(entry.routine) + " runs for event " + std::to_string(entry.event));
  if (entry.event == 8 || entry.event == 25)
    store(Area::SM, 2, 1, static_cast<std::uint32_t>(random_.any(program_.pool)));
  const auto stack = stack_;
  const auto accumulators = accumulators_;
  const std::uint32_t status = load(Area::SM, 1, 1);
  stack_ = {true};
  inRoutine_ = true;
  runBlock(routine->second);
  inRoutine_ = false;
  routineEnds_ = false;
  stack_ = stack;
  accumulators_ = accumulators;
  store(Area::SM, 1, 1, status);
}

}  // namespace rungproof::referee
