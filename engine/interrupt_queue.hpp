// The three interrupt queues of the CPU: communication, I/O, timed (001:5480-5500). An attached event enters the queue
// of its group; a full queue loses it. The highest group that is not empty is served first, inside a group in order of
// arrival; events that arrive at the same moment stand in the order of their rank (table 6-50, the manual leaves
// the combination open). Organization blocks of an S7-300/400 go by their priority, and by arrival where it is the
// same. Covered by tests/engine/interrupt_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/event.hpp"

namespace rungproof {

class InterruptQueue {
 public:
  explicit InterruptQueue(const Target& target);

  /// What is to be served: the event, and the number of the routine that it had when it came.
  struct Waiting {
    int event;
    int routine;
  };

  /// Takes event 0..44 that occurred at `moment` (any unit that does not decrease). False: the queue is full, the event
  /// is lost.
  bool add(int event, std::uint64_t moment, int routine = 0);
  /// The event to be served next; nothing: none waits.
  std::optional<int> next() const;
  /// What is to be served next, removed from its queue.
  std::optional<Waiting> take();
  /// One entry of that event, removed out of its turn; nothing: none waits.
  std::optional<Waiting> take(int event);
  /// CEVNT, or DTCH by Choice::DetachedEvents: drops all entries of that event (001:5357).
  void drop(int event);
  /// STOP in an interrupt routine drops everything that waits (001:5695).
  void clear();

  bool empty() const;
  bool empty(EventGroup group) const { return queue(group).empty(); }
  std::size_t size(EventGroup group) const { return queue(group).size(); }

 private:
  struct Entry {
    int event;
    std::uint64_t moment;
    int routine;
  };
  const std::vector<Entry>& queue(EventGroup group) const { return queues_[static_cast<std::size_t>(group)]; }
  std::vector<Entry>& queue(EventGroup group) { return queues_[static_cast<std::size_t>(group)]; }

  std::array<std::size_t, eventGroupCount> depth_;
  std::array<std::vector<Entry>, eventGroupCount> queues_;
};

}  // namespace rungproof
