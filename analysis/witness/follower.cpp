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
  if (operand.area == Area::AI) return analog(state, scan, operand.offset);
  if (operand.area == Area::PI) {
    const std::uint64_t word = analog(state, scan, operand.offset);
    return width == 32 ? word << 16 | analog(state, scan, operand.offset + 2) : width == 16 ? word : word >> 8;
  }
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
  if (isStateless_ && isUnchanged(state, scan)) return answer_;
  const auto look = [&](const Operand& o, int width) { return leaf(state, scan, o, width); };
  std::vector<std::uint64_t> after = cells_;
  const Moment<Concrete> moment{isFirst, scan.lengthMs, 32};
  answer_ = Monitor<Concrete, decltype(look)>(domain, property_, look, moment, cells_, after).evaluate();
  cells_ = std::move(after);
  return answer_;
}

}  // namespace rungproof
