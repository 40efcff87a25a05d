// Leaves as properties read them, and the monitor over the concrete domain.
#include "analysis/witness/follower.hpp"

#include <algorithm>

#include "analysis/encoding/monitor.hpp"
#include "analysis/witness/witness.hpp"

namespace rungproof {

namespace {

/// The last value that the scan read from that analog input; where it is sampled once a scan, the sample.
std::uint64_t analog(const Concrete::Store& state, const ReplayScan& scan, std::uint32_t address) {
  std::uint64_t value = state.load(Area::AI, address * 8, 16);
  for (const ExternalValue& external : scan.externals) {
    if (external.site.kind == External::AnalogInput && external.site.index == address) value = external.value;
  }
  return value;
}

/// A byte, word or double word of a module out of the words that begin at its addresses.
template <class WordAt>
std::uint64_t moduleValue(const Operand& operand, int width, WordAt wordAt) {
  const std::uint64_t word = wordAt(operand.offset);
  if (operand.area == Area::AI) return word;
  return width == 32 ? word << 16 | wordAt(operand.offset + 2) : width == 16 ? word : word >> 8;
}

bool isOfModule(const Operand& operand) { return operand.area == Area::AI || operand.area == Area::PI; }

}  // namespace

Follower::Follower(const Property& property) : property_(property), cells_(property.cells.size(), 0) {
  const auto asksForFirstScan = [](const Expr& expr) {
    return std::any_of(expr.nodes.begin(), expr.nodes.end(),
                       [](const ExprNode& n) { return n.op == ExprOp::FirstScan; });
  };
  isStateless_ = cells_.empty() && !asksForFirstScan(property.first) && !asksForFirstScan(property.second);
  if (isStateless_) read_ = addressesOf(property);
}

std::uint64_t Follower::leaf(const Concrete::Store& state, const ReplayScan& scan, const Operand& operand,
                             int width) const {
  if (isOfModule(operand))
    return moduleValue(operand, width, [&](std::uint32_t at) { return analog(state, scan, at); });
  Operand address = operand;
  if (hasBitAndWord(operand.area)) address.width = width == 1 ? Width::Bit : width == 32 ? Width::DWord : Width::Word;
  return valueIn(state, address);
}

/// T and C are compared as bit and as current value.
bool Follower::isUnchanged(const Concrete::Store& state, const ReplayScan& scan) {
  const bool isFirst = seen_.empty();
  bool isSame = !isFirst;
  std::size_t at = 0;
  const auto compare = [&](std::uint64_t value) {
    if (isFirst)
      seen_.push_back(value);
    else if (seen_[at] != value) {
      seen_[at] = value;
      isSame = false;
    }
    ++at;
  };
  for (const Operand* operand : read_) {
    const bool isTwofold = hasBitAndWord(operand->area);
    compare(leaf(state, scan, *operand, 1));
    if (isTwofold) compare(leaf(state, scan, *operand, operand->width == Width::DWord ? 32 : 16));
  }
  return isSame && !read_.empty();
}

bool Follower::evaluate(Concrete& domain, const Concrete::Store& state, const ReplayScan& scan, bool isFirst) {
  const auto look = [&](const Operand& o, int width) { return leaf(state, scan, o, width); };
  std::vector<std::uint64_t> after = cells_;
  const Moment<Concrete> moment{isFirst, scan.lengthMs, 32};
  if (!isStateless_ || !isUnchanged(state, scan)) {
    answer_ = Monitor<Concrete, decltype(look)>(domain, property_, look, moment, cells_, after).evaluate();
    cells_ = std::move(after);
  }
  if (property_.isGoal() || !cells_.empty()) return answer_;
  // As the encoding asks it (asked_properties.cpp): what is assumed of an analog input holds at each read of it.
  return answer_ && std::ranges::all_of(scan.externals, [&](const ExternalValue& read) {
           if (read.site.kind != External::AnalogInput) return true;
           const ExternalValue* next = &read == &scan.externals.back() ? nullptr : &read + 1;
           const bool isPair = next != nullptr && next->site.kind == read.site.kind &&
                               next->site.instruction == read.site.instruction &&
                               next->site.index == read.site.index + 2;
           const auto wordAt = [&](std::uint32_t at) {
             return at == read.site.index ? read.value : isPair ? next->value : analog(state, scan, at);
           };
           const auto then = [&](const Operand& o, int width) {
             const bool isHere = isOfModule(o) && o.offset == read.site.index;
             return isHere ? moduleValue(o, width, wordAt) : leaf(state, scan, o, width);
           };
           std::vector<std::uint64_t> none, ignored;
           return Monitor<Concrete, decltype(then)>(domain, property_, then, moment, none, ignored).evaluate();
         });
}

}  // namespace rungproof
