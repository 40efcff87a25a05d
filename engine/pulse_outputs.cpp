// Trains and their ends.
#include "engine/pulse_outputs.hpp"

#include <algorithm>

namespace rungproof {

namespace {

constexpr std::int64_t shortestCycle = 2, longestCycle = 65535;  // 001:4570, 001:4600
constexpr std::uint64_t mostPulses = 0x7FFFFFFF;

/// Length in us of one pulse of a frequency in Hz; 0 counts as 1, and more than 100 kHz as that.
std::int64_t cycleOf(std::int64_t hertz) { return 1000000 / std::clamp<std::int64_t>(hertz, 1, 100000); }

}  // namespace

void PulseOutputs::command(const Concrete::Store& store, std::uint32_t output) {
  Train& train = trains_[output];
  const bool isTrain = store.get(Reg::PulseBusy, output) != 0 && store.get(Reg::PulseIsPwm, output) == 0;
  if (!isTrain) {
    train = {};
  } else if (!train.isRunning) {
    train = trainOf(store, output);
  }
}

PulseOutputs::Train PulseOutputs::trainOf(const Concrete::Store& store, std::uint32_t output) const {
  Train train;
  train.isRunning = true;
  const std::int64_t unit = store.get(Reg::PulseIsMs, output) != 0 ? 1000 : 1;
  const auto segments = static_cast<std::uint32_t>(store.get(Reg::PulseSegments, output));
  if (segments == 0) {
    const auto value = static_cast<std::int64_t>(store.get(Reg::PulseCycle, output));
    const std::int64_t cycle = form_.hasFrequency ? cycleOf(value) : value * unit;
    train.segments.push_back({cycle, 0, store.get(Reg::PulseCount, output)});
    return train;
  }
  const auto table = static_cast<std::uint32_t>(store.get(Reg::PulseTable, output));
  for (std::uint32_t i = 0; i < segments && !train.isAborted; ++i)
    train.segments.push_back(segmentIn(store, (table + 1 + i * form_.segmentBytes) * 8, unit, train.isAborted));
  return train;
}

/// The segment of a profile at that bit of V.
PulseOutputs::Segment PulseOutputs::segmentIn(const Concrete::Store& store, std::uint32_t bit, std::int64_t unitUs,
                                              bool& isAborted) const {
  if (form_.hasFrequency) {
    const auto first = static_cast<std::int64_t>(store.load(Area::V, bit, 32));
    const auto last = static_cast<std::int64_t>(store.load(Area::V, bit + 32, 32));
    const std::uint64_t count = std::clamp<std::uint64_t>(store.load(Area::V, bit + 64, 32), 1, mostPulses);
    const std::int64_t steps = static_cast<std::int64_t>(count) - 1;
    return {cycleOf(first), steps == 0 ? 0 : (cycleOf(last) - cycleOf(first)) / steps, count};
  }
  const auto cycle = static_cast<std::int64_t>(store.load(Area::V, bit, 16));
  const std::int64_t change = Concrete::toSigned(store.load(Area::V, bit + 16, 16), 16);
  std::uint64_t count = store.load(Area::V, bit + 32, 32);
  const std::int64_t room = change > 0   ? (longestCycle - cycle) / change
                            : change < 0 ? (cycle - shortestCycle) / -change
                                         : 0;
  if (change != 0 && count > static_cast<std::uint64_t>(std::max<std::int64_t>(room, 0)) + 1) {
    count = static_cast<std::uint64_t>(std::max<std::int64_t>(room, 0)) + 1;
    isAborted = true;
  }
  return {cycle * unitUs, change * unitUs, count};
}

std::uint64_t PulseOutputs::durationUs(const Segment& segment, std::uint64_t pulses) {
  const auto n = static_cast<std::int64_t>(pulses);
  return static_cast<std::uint64_t>(n * segment.cycleUs + segment.changeUs * (n * (n - 1) / 2));  // 001:4720-4782
}

std::uint64_t PulseOutputs::durationUs(const Train& train) {
  std::uint64_t sum = 0;
  for (const Segment& segment : train.segments) sum += durationUs(segment, segment.count);
  return sum;
}

std::size_t PulseOutputs::segmentAt(const Train& train, std::uint64_t timeUs) {
  std::size_t i = 0;
  for (; i + 1 < train.segments.size(); ++i) {
    const std::uint64_t length = durationUs(train.segments[i], train.segments[i].count);
    if (timeUs < length) break;
    timeUs -= length;
  }
  return i;
}

std::uint64_t PulseOutputs::pulsesAt(const Train& train, std::uint64_t timeUs) {
  std::uint64_t pulses = 0;
  for (const Segment& segment : train.segments) {
    const std::uint64_t length = durationUs(segment, segment.count);
    if (timeUs >= length) {
      pulses += segment.count;
      timeUs -= length;
      continue;
    }
    std::uint64_t low = 0, high = segment.count;  // the last number of pulses that fits
    while (low < high) {
      const std::uint64_t middle = (low + high + 1) / 2;
      if (durationUs(segment, middle) <= timeUs)
        low = middle;
      else
        high = middle - 1;
    }
    return pulses + low;
  }
  return pulses;
}

PulseCounts PulseOutputs::passMillisecond(Concrete::Store& store, const RaiseEvent& raise) {
  PulseCounts made{};
  for (std::uint32_t output = 0; output < pulseOutputCount; ++output) {
    std::uint64_t left = 1000;
    while (left > 0 && trains_[output].isRunning) {
      Train& train = trains_[output];
      const std::uint64_t before = pulsesAt(train, train.passedUs);
      const std::uint64_t rest = durationUs(train) - std::min(durationUs(train), train.passedUs);
      const std::uint64_t now = std::min(left, rest);
      train.passedUs += now;
      left -= now;
      made[output] += static_cast<std::uint32_t>(pulsesAt(train, train.passedUs) - before);
      if (train.segments.size() > 1 || store.get(Reg::PulseSegments, output) != 0) {
        store.save(Area::SM, segmentByte(output) * 8, 8, segmentAt(train, train.passedUs) + 1, true);
      }
      if (now == rest) finish(store, output, raise);
      if (now == 0 && rest == 0) break;
    }
  }
  return made;
}

/// End of a train: the waiting one starts without a gap (001:4584), otherwise the output is idle.
void PulseOutputs::finish(Concrete::Store& store, std::uint32_t output, const RaiseEvent& raise) {
  const bool wasAborted = trains_[output].isAborted;
  trains_[output] = {};
  if (store.get(Reg::PulsePending, output) != 0 && !wasAborted) {
    store.set(Reg::PulsePending, output, 0, true);
    store.set(Reg::PulseCycle, output, store.get(Reg::PulseNextCycle, output), true);
    store.set(Reg::PulseCount, output, store.get(Reg::PulseNextCount, output), true);
    store.set(Reg::PulseIsMs, output, store.get(Reg::PulseNextIsMs, output), true);
    trains_[output] = trainOf(store, output);
  } else {
    store.set(Reg::PulseBusy, output, 0, true);
    store.set(Reg::PulseSegments, output, 0, true);
    store.save(Area::SM, pulseStatus(output) * 8 + pulseIdle, 1, 1, true);
    if (wasAborted) store.save(Area::SM, pulseStatus(output) * 8 + pulseAborted, 1, 1, true);
  }
  raise(eventOfTrain(output));
}

}  // namespace rungproof
