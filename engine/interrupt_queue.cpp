// Queues of interrupt events.
#include "engine/interrupt_queue.hpp"

#include <algorithm>

#include "ir/check.hpp"
#include "ir/s7200/event_cause.hpp"

namespace rungproof {

InterruptQueue::InterruptQueue(const Target& target) {
  for (std::size_t group = 0; group < depth_.size(); ++group)
    depth_[group] = queueDepth(target, static_cast<EventGroup>(group));
}

bool InterruptQueue::add(int event, std::uint64_t moment, int routine) {
  CHECK(event >= 0 && event < blockEventEnd, "no such event");
  const EventInfo info = eventInfo(event);
  std::vector<Entry>& entries = queue(info.group);
  if (entries.size() >= depth_[static_cast<std::size_t>(info.group)]) return false;
  const auto later = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
    return (entry.moment == moment || isBlockEvent(event)) && eventInfo(entry.event).rank > info.rank;
  });
  entries.insert(later, {event, moment, routine});
  return true;
}

std::optional<InterruptQueue::Waiting> InterruptQueue::take() {
  for (const std::vector<Entry>& entries : queues_) {
    if (!entries.empty()) return take(entries.front().event);
  }
  return std::nullopt;
}

std::optional<InterruptQueue::Waiting> InterruptQueue::take(int event) {
  std::vector<Entry>& entries = queue(eventInfo(event).group);
  const auto first = std::ranges::find(entries, event, &Entry::event);
  if (first == entries.end()) return std::nullopt;
  const Waiting waiting{event, first->routine};
  entries.erase(first);
  return waiting;
}

std::optional<int> InterruptQueue::next() const {
  for (const std::vector<Entry>& entries : queues_) {
    if (!entries.empty()) return entries.front().event;
  }
  return std::nullopt;
}

void InterruptQueue::drop(int event) {
  std::erase_if(queue(eventInfo(event).group), [&](const Entry& entry) { return entry.event == event; });
}

void InterruptQueue::clear() {
  for (std::vector<Entry>& entries : queues_) entries.clear();
}

bool InterruptQueue::empty() const {
  return std::all_of(queues_.begin(), queues_.end(), [](const std::vector<Entry>& entries) { return entries.empty(); });
}

}  // namespace rungproof
