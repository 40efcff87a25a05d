// Joins neighbours and writes the list.
#include "analysis/flow/bit_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof {

namespace {

constexpr std::size_t mostRanges = 4;  ///< that are named

std::string bitAt(Area area, std::uint32_t at) {
  if (hasBitAndWord(area)) return addressName(area, Width::Bit, at);
  return addressName(area, Width::Bit, at / 8, at % 8);
}

}  // namespace

void BitRow::order() {
  std::sort(bits.begin(), bits.end());
  bits.erase(std::unique(bits.begin(), bits.end()), bits.end());
}

std::string BitRow::first() const { return bitAt(area, bits.front()); }

std::string BitRow::text() const {
  std::vector<std::string> names;
  std::size_t at = 0;
  while (at < bits.size() && names.size() < mostRanges) {
    std::size_t last = at;
    while (last + 1 < bits.size() && bits[last + 1] == bits[last] + 1) ++last;
    const std::string from = bitAt(area, bits[at]);
    names.push_back(last == at ? from : fmt::format("{} to {}", from, bitAt(area, bits[last])));
    at = last + 1;
  }
  if (at < bits.size()) names.push_back(fmt::format("{} more", bits.size() - at));
  return joined(names);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " and ";
    text += names[i];
  }
  return text;
}

}  // namespace rungproof
