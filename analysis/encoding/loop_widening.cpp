// Written places are kept in the form in which instructions write them, so that a word becomes one free word.
#include "analysis/encoding/loop_widening.hpp"

#include <algorithm>

namespace rungproof {

namespace {

std::vector<Place> partsOf(const Place& place) {
  if (place.isRegister) return {place};
  std::vector<Place> parts;
  for (std::uint32_t i = 0; i < place.width; ++i)
    parts.push_back({false, place.area, Reg::Accumulator, place.at + i, 1});
  return parts;
}

}  // namespace

void LoopWidening::note(const Place& place) {
  if (loops_.empty()) return;
  const std::vector<Place> parts = partsOf(place);
  for (auto& [branch, loop] : loops_) {
    if (std::ranges::all_of(parts, [&](const Place& p) { return loop.parts.contains(p); })) continue;
    loop.later.insert(place);
  }
}

void LoopWidening::block() {
  for (auto& [branch, loop] : loops_) loop.isBlocked = true;
}

RoundsLeft LoopWidening::next(Branch branch, Node scr) {
  const auto [place, isNew] = loops_.try_emplace(branch);
  Loop& loop = place->second;
  if (isNew) {
    loop.scr = scr;
    return RoundsLeft::Follow;
  }
  const bool isBlocked = loop.isBlocked, changesScr = loop.scr != noNode && loop.scr != scr;
  if (changesScr) loop.scr = noNode;
  if (isBlocked || (loop.later.empty() && !changesScr)) {
    loops_.erase(place);
    return isBlocked ? RoundsLeft::LeftOut : RoundsLeft::Endless;
  }
  for (const Place& written : loop.later) {
    for (const Place& part : partsOf(written)) loop.parts.insert(part);
  }
  loop.written.merge(loop.later);
  loop.later.clear();
  return RoundsLeft::Follow;
}

bool LoopWidening::freesScr(Branch branch) const {
  const auto found = loops_.find(branch);
  return found != loops_.end() && found->second.scr == noNode;
}

std::vector<Place> LoopWidening::freed(Branch branch) const {
  const auto found = loops_.find(branch);
  if (found == loops_.end()) return {};
  std::vector<Place> byWidth(found->second.written.begin(), found->second.written.end());
  std::ranges::stable_sort(byWidth, [](const Place& a, const Place& b) { return a.width > b.width; });
  std::set<Place> done;
  std::vector<Place> result;
  for (const Place& place : byWidth) {
    const std::vector<Place> parts = partsOf(place);
    if (std::ranges::none_of(parts, [&](const Place& p) { return done.contains(p); })) {
      result.push_back(place);
    } else {
      for (const Place& part : parts) {
        if (!done.contains(part)) result.push_back(part);
      }
    }
    done.insert(parts.begin(), parts.end());
  }
  return result;
}

}  // namespace rungproof
