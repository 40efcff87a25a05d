// Recording and comparing footprints.
#include "analysis/encoding/footprint.hpp"

#include <algorithm>

#include "ir/s7200/event_cause.hpp"

namespace rungproof {

namespace {

constexpr int kindShift = 32;                // below it a bit of an area, or the number of a register
constexpr std::uint64_t firstRegister = 32;  // areas come before

bool meet(const FootprintKeys& a, const FootprintKeys& b) {
  const FootprintKeys& fewer = a.size() < b.size() ? a : b;
  const FootprintKeys& more = a.size() < b.size() ? b : a;
  return std::any_of(fewer.begin(), fewer.end(), [&](std::uint64_t key) { return more.contains(key); });
}

/// Saved at the entry of a routine and restored behind it (001:5430).
bool isRestored(const Place& place) {
  if (place.isRegister) return place.reg == Reg::Accumulator || place.reg == Reg::Eno;
  return place.area == Area::SM && place.byte() == 1;
}

}  // namespace

bool Footprint::conflictsWith(const Footprint& other) const {
  return meet(writes, other.writes) || meet(writes, other.reads) || meet(reads, other.writes);
}

std::set<std::uint32_t> indicesIn(const Footprint& footprint, std::span<const Reg> kinds) {
  std::set<std::uint32_t> indices;
  for (const FootprintKeys* keys : {&footprint.reads, &footprint.writes}) {
    for (const Reg reg : kinds) {
      const std::uint64_t kind = (firstRegister + static_cast<std::uint64_t>(reg)) << kindShift;
      const std::uint64_t next = kind + (std::uint64_t{1} << kindShift);
      for (auto key = keys->lower_bound(kind); key != keys->end() && *key < next; ++key)
        indices.insert(static_cast<std::uint32_t>(*key - kind));
    }
  }
  return indices;
}

void addKeys(const Place& place, FootprintKeys& keys) {
  if (place.isRegister) {
    keys.insert((firstRegister + static_cast<std::uint64_t>(place.reg)) << kindShift | place.at);
    return;
  }
  for (std::uint32_t i = 0; i < place.width; ++i)
    keys.insert(static_cast<std::uint64_t>(place.area) << kindShift | (place.at + i));
}

std::vector<Place> placesOf(const FootprintKeys& keys) {
  std::vector<Place> places;
  for (const std::uint64_t key : keys) {
    const std::uint64_t kind = key >> kindShift;
    const auto at = static_cast<std::uint32_t>(key);
    if (kind >= firstRegister) {
      places.push_back(registerPlace(static_cast<Reg>(kind - firstRegister), at));
      continue;
    }
    const bool isNewByte = places.empty() || places.back().isRegister ||
                           places.back().area != static_cast<Area>(kind) || places.back().at / 8 != at / 8;
    const bool isWhole = at % 8 == 0 && [&] {
      for (std::uint32_t i = 1; i < 8; ++i) {
        if (!keys.contains(key + i)) return false;
      }
      return true;
    }();
    if (isWhole)
      places.push_back({false, static_cast<Area>(kind), Reg::Accumulator, at, 8});
    else if (isNewByte || places.back().width == 1)
      places.push_back({false, static_cast<Area>(kind), Reg::Accumulator, at, 1});
  }
  return places;
}

void addCauseKeys(int event, Footprint& footprint) {
  const auto reads = [&](const Place& place) { addKeys(place, footprint.reads); };
  const auto changes = [&](const Place& place) {
    addKeys(place, footprint.reads);
    addKeys(place, footprint.writes);
  };
  if (isTimedEvent(event)) {
    const TimedRegisters registers = timedRegisters(static_cast<std::uint32_t>(timerOfEvent(event)));
    reads(registerPlace(registers.period, registers.at));
    if (isDelayEvent(event)) changes(registerPlace(registers.period, registers.at));  // it comes once
  }
  if (const auto counter = counterEvent(event)) {
    reads(registerPlace(Reg::HscMode, counter->counter));
    reads(registerPlace(Reg::HscEnabled, counter->counter));
  }
  if (isPulseEvent(event)) {
    const std::uint32_t output = outputOfTrain(event);
    reads(registerPlace(Reg::PulseIsPwm, output));
    for (const Reg reg :
         {Reg::PulseBusy, Reg::PulsePending, Reg::PulseCycle, Reg::PulseCount, Reg::PulseIsMs, Reg::PulseSegments})
      changes(registerPlace(reg, output));
    changes(memoryPlace(Area::SM, pulseStatus(output), Width::Bit, pulseIdle));
  }
  if (const auto port = portEvent(event)) {
    changes(registerPlace(Reg::PortBusy, port->port));
    reads(memoryPlace(Area::SM, port->port == 0 ? 30 : 130, Width::Byte));
    switch (port->kind) {
      case PortEvent::Character:
        changes(memoryPlace(Area::SM, 2, Width::Byte));
        changes(memoryPlace(Area::SM, 3, Width::Bit, 0));
        break;
      case PortEvent::Transmitted: changes(memoryPlace(Area::SM, 4, Width::Bit, 5 + port->port)); break;
      case PortEvent::Message: changes(memoryPlace(Area::SM, port->port == 0 ? 86 : 186, Width::Byte)); break;
    }
  }
}

void Footprints::record(std::uint32_t instruction, int routine, const Touch& touch) {
  if (!touch.place.isRegister && touch.place.area == Area::L) return;
  Footprint& own = ofInstruction[instruction];
  addKeys(touch.place, touch.isWrite ? own.writes : own.reads);
  if (routine < 0 || (touch.isWrite && isRestored(touch.place))) return;
  Footprint& all = ofRoutine[routine];
  addKeys(touch.place, touch.isWrite ? all.writes : all.reads);
}

bool Footprints::merge(const Footprints& other) {
  bool isNew = false;
  const auto add = [&](Footprint& to, const Footprint& from) {
    const std::size_t before = to.reads.size() + to.writes.size();
    to.reads.insert(from.reads.begin(), from.reads.end());
    to.writes.insert(from.writes.begin(), from.writes.end());
    isNew = isNew || to.reads.size() + to.writes.size() > before;
  };
  for (const auto& [instruction, footprint] : other.ofInstruction) add(ofInstruction[instruction], footprint);
  for (const auto& [routine, footprint] : other.ofRoutine) add(ofRoutine[routine], footprint);
  return isNew;
}

}  // namespace rungproof
