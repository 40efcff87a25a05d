// Looks addresses up in the runs of the map.
#include "analysis/equivalence/address_pairs.hpp"

#include <algorithm>

namespace rungproof {

namespace {

bool coversAddress(const Address& first, std::uint32_t count, const Address& address) {
  return address.area == first.area && address.index >= first.index && address.index - first.index < count;
}

constexpr std::uint32_t analogBits = 16;
Address wordOf(const Address& address) { return {address.area, address.index / analogBits * analogBits}; }

}  // namespace

Address addressOf(const Operand& operand) {
  if (operand.area == Area::PI) return {Area::AI, operand.offset};
  if (isWholeValue(operand.area)) return {operand.area, operand.offset};
  return {operand.area, operand.offset * 8 + (operand.width == Width::Bit ? operand.bit : 0U)};
}

Operand operandAt(const Address& address) {
  if (isWholeValue(address.area)) return direct(address.area, Width::Bit, address.index);
  if (isAnalogue(address.area)) return direct(address.area, Width::Word, wordOf(address).index / 8);
  return direct(address.area, Width::Bit, address.index / 8, address.index % 8);
}

std::uint32_t extentOf(const Operand& operand) {
  if (operand.area == Area::PI && operand.width == Width::DWord) return 3;  // the words at its beginning and 2 behind
  return isWholeValue(operand.area) ? 1 : static_cast<std::uint32_t>(bits(operand.width));
}

bool AddressPairs::add(Address before, Address after, std::uint32_t count) {
  const auto meet = [](Address a, std::uint32_t m, Address b, std::uint32_t n) {
    return coversAddress(a, m, b) || coversAddress(b, n, a);
  };
  const bool isTaken = std::ranges::any_of(runs_, [&](const Run& run) {
    return meet(run.before, run.count, before, count) || meet(run.after, run.count, after, count);
  });
  if (isTaken) return false;
  runs_.push_back({before, after, count});
  return true;
}

bool AddressPairs::addEvent(int before, int after) {
  if (std::ranges::any_of(events_, [&](const auto& pair) { return pair.first == before || pair.second == after; }))
    return false;
  events_.emplace_back(before, after);
  return true;
}

std::optional<int> AddressPairs::eventBefore(int after) const {
  for (const auto& [old, now] : events_) {
    if (now == after) return old;
  }
  if (std::ranges::any_of(events_, [&](const auto& pair) { return pair.first == after; })) return std::nullopt;
  return after;
}

std::optional<Address> AddressPairs::before(Address after) const {
  for (const Run& run : runs_) {
    if (coversAddress(run.after, run.count, after))
      return Address{run.before.area, run.before.index + (after.index - run.after.index)};
  }
  const bool isGivenAway =
      std::ranges::any_of(runs_, [&](const Run& run) { return coversAddress(run.before, run.count, after); });
  if (isGivenAway || isSeparate_) return std::nullopt;
  return after;
}

std::optional<Address> AddressPairs::after(Address before) const {
  for (const Run& run : runs_) {
    if (coversAddress(run.before, run.count, before))
      return Address{run.after.area, run.after.index + (before.index - run.before.index)};
  }
  const bool isGivenAway =
      std::ranges::any_of(runs_, [&](const Run& run) { return coversAddress(run.after, run.count, before); });
  if (isGivenAway || isSeparate_) return std::nullopt;
  return before;
}

ComparedRange AddressPairs::comparedFrom(Address before) const {
  for (const ComparedRange& whole : wholes_) {
    if (!coversAddress(whole.first, whole.bits, before)) continue;
    const std::optional<Address> there = after(whole.first);
    bool isTogether = there.has_value();
    for (std::uint32_t i = 1; i < whole.bits && isTogether; ++i)
      isTogether = after(Address{whole.first.area, whole.first.index + i}) == Address{there->area, there->index + i};
    if (isTogether) return whole;
  }
  if (!isAnalogue(before.area) || isWholeValue(before.area)) return {before};
  const Address first = wordOf(before);
  const std::optional<Address> there = after(first);
  for (std::uint32_t i = 1; i < analogBits; ++i) {
    const std::optional<Address> next = after(Address{first.area, first.index + i});
    const bool isTogether = there ? next == Address{there->area, there->index + i} : !next;
    if (!isTogether) return {before};
  }
  const bool isWord = !there || (isAnalogue(there->area) && wordOf(*there) == *there);
  return isWord ? ComparedRange{first, analogBits} : ComparedRange{before};
}

ComparedRange AddressPairs::comparedAlone(Address after) const {
  if (!isAnalogue(after.area) || isWholeValue(after.area)) return {after};
  const Address first = wordOf(after);
  for (std::uint32_t i = 0; i < analogBits; ++i) {
    if (before(Address{first.area, first.index + i})) return {after};
  }
  return {first, analogBits};
}

bool AddressPairs::names(Address after) const {
  return std::ranges::any_of(runs_, [&](const Run& run) { return coversAddress(run.after, run.count, after); });
}

std::optional<Operand> AddressPairs::before(const Operand& after) const {
  const Address first = addressOf(after);
  const std::optional<Address> start = before(first);
  if (!start || isWholeValue(start->area) != isWholeValue(first.area)) return std::nullopt;
  for (std::uint32_t i = 1; i < extentOf(after); ++i) {
    const std::optional<Address> next = before(Address{first.area, first.index + i});
    if (!next || next->area != start->area || next->index != start->index + i) return std::nullopt;
  }
  Operand result = after;
  result.area = after.area == Area::PI ? Area::PI : start->area;
  if (isWholeValue(start->area)) {
    result.offset = start->index;
  } else {
    if (after.width != Width::Bit && start->index % 8 != 0) return std::nullopt;
    result.offset = start->index / 8;
    result.bit = static_cast<std::uint8_t>(after.width == Width::Bit ? start->index % 8 : 0);
  }
  return result;
}

}  // namespace rungproof
