// Recording and comparing footprints.
#include "analysis/encoding/footprint.hpp"

#include <algorithm>

namespace rungproof {

namespace {

bool meet(const std::set<std::uint32_t>& a, const std::set<std::uint32_t>& b) {
  const std::set<std::uint32_t>& fewer = a.size() < b.size() ? a : b;
  const std::set<std::uint32_t>& more = a.size() < b.size() ? b : a;
  return std::any_of(fewer.begin(), fewer.end(), [&](std::uint32_t key) { return more.contains(key); });
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

void addKeys(const Place& place, std::set<std::uint32_t>& keys) {
  if (place.isRegister) {
    keys.insert((32U + static_cast<std::uint32_t>(place.reg)) << 24 | place.at);
    return;
  }
  for (std::uint32_t i = 0; i < place.width; ++i)
    keys.insert(static_cast<std::uint32_t>(place.area) << 24 | (place.at + i));
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
