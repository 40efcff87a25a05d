// Values by site, in the order of execution.
#include "engine/given_values.hpp"

#include <algorithm>

#include "engine/real_time_clock.hpp"

namespace rungproof {

std::uint64_t quietExternal(const ExternalSite& site) {
  return site.kind == External::ClockByte ? RealTimeClock{}.byteAt(site.index, 0) : 0;
}

void GivenValues::load(const std::vector<ExternalValue>& values) {
  finish();
  sites_.clear();
  next_ = 0;
  givesUnknownBits_ = unknown_ != 0 || std::ranges::any_of(values, [](const ExternalValue& value) {
                        return isOpen(value.site.kind) && value.value != 0;
                      });
  const auto isGiven = [&](const ExternalValue& value) { return givesUnknownBits_ || !isOpen(value.site.kind); };
  for (const ExternalValue& value : values) {
    if (isGiven(value)) sites_.push_back({key(value.site), {}, 0});
  }
  std::sort(sites_.begin(), sites_.end(), [](const Site& a, const Site& b) { return a.key < b.key; });
  sites_.erase(std::unique(sites_.begin(), sites_.end(), [](const Site& a, const Site& b) { return a.key == b.key; }),
               sites_.end());
  for (const ExternalValue& value : values) {
    if (isGiven(value)) at(key(value.site))->values.push_back(value.value);
  }
}

void GivenValues::begin() {
  finish();
  for (Site& site : sites_) site.next = 0;
  isBegun_ = true;
}

std::uint64_t GivenValues::external(const ExternalSite& site, int width) {
  const Key wanted = key(site);
  const bool isNext =
      (next_ == 0 || sites_[next_ - 1].key < wanted) && (next_ == sites_.size() || sites_[next_].key >= wanted);
  if (!isNext) next_ = static_cast<std::size_t>(at(wanted) - sites_.begin());
  if (next_ < sites_.size() && sites_[next_].key == wanted) {
    Site& found = sites_[next_++];
    if (found.next < found.values.size()) return found.values[found.next++];
    // A loop that the prover follows for so many rounds reads an input that stays as it is.
    if (site.kind == External::ImmediateInput && !found.values.empty()) return found.values.back();
  }
  if (site.kind == External::AnalogInput) return state_->load(Area::AI, site.index * 8, width);
  return isUnknown(site.kind) ? unknown_ : quietExternal(site);
}

std::vector<GivenValues::Site>::iterator GivenValues::at(const Key& key) {
  return std::lower_bound(sites_.begin(), sites_.end(), key,
                          [](const Site& site, const Key& k) { return site.key < k; });
}

/// Counts what the scan left.
void GivenValues::finish() {
  for (const Site& site : sites_) unused_ += isBegun_ ? site.values.size() - site.next : 0;
  isBegun_ = false;
}

}  // namespace rungproof
