// Trains and their ends.
#include "engine/pulse_outputs.hpp"

#include <algorithm>

namespace rungproof {

namespace {

constexpr std::array<std::uint32_t, 2> pulseStatusByte = {66, 76};
constexpr std::uint32_t abortedByIncrement = 4, idle = 7;
constexpr std::int64_t shortestCycle = 2, longestCycle = 65535;  // 001:4570, 001:4600

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

PulseOutputs::Train PulseOutputs::trainOf(const Concrete::Store& store, std::uint32_t output) {
  Train train;
  train.isRunning = true;
  const std::int64_t unit = store.get(Reg::PulseIsMs, output) != 0 ? 1000 : 1;
  const auto segments = static_cast<std::uint32_t>(store.get(Reg::PulseSegments, output));
  if (segments == 0) {
    train.segments.push_back(
        {static_cast<std::int64_t>(store.get(Reg::PulseCycle, output)) * unit, 0, store.get(Reg::PulseCount, output)});
    return train;
  }
  const auto table = static_cast<std::uint32_t>(store.get(Reg::PulseTable, output));
  for (std::uint32_t i = 0; i < segments && !train.isAborted; ++i) {
    const std::uint32_t at = (table + 1 + i * 8) * 8;
    const auto cycle = static_cast<std::int64_t>(store.load(Area::V, at, 16));
    const std::int64_t change = Concrete::toSigned(store.load(Area::V, at + 16, 16), 16);
    std::uint64_t count = store.load(Area::V, at + 32, 32);
    const std::int64_t room = change > 0   ? (longestCycle - cycle) / change
                              : change < 0 ? (cycle - shortestCycle) / -change
                                           : 0;
    if (change != 0 && count > static_cast<std::uint64_t>(std::max<std::int64_t>(room, 0)) + 1) {
      count = static_cast<std::uint64_t>(std::max<std::int64_t>(room, 0)) + 1;
      train.isAborted = true;
    }
    train.segments.push_back({cycle * unit, change * unit, count});
  }
  return train;
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

std::array<std::uint32_t, 2> PulseOutputs::passMillisecond(Concrete::Store& store, const RaiseEvent& raise) {
  std::array<std::uint32_t, 2> made{};
  for (std::uint32_t output = 0; output < 2; ++output) {
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
        store.save(Area::SM, (output == 0 ? 166U : 176U) * 8, 8, segmentAt(train, train.passedUs) + 1, true);
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
    store.save(Area::SM, pulseStatusByte[output] * 8 + idle, 1, 1, true);
    if (wasAborted) store.save(Area::SM, pulseStatusByte[output] * 8 + abortedByIncrement, 1, 1, true);
  }
  raise(output == 0 ? 19 : 20);
}

}  // namespace rungproof
