// Sets of values and their operations.
#include "analysis/graph/value_set.hpp"

#include <algorithm>

#include "analysis/graph/evaluate.hpp"

namespace rungproof {

namespace {

Graph::Facts joined(const Graph::Facts& a, const Graph::Facts& b) {
  return {a.zeros & b.zeros, a.ones & b.ones, std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace

ValueSet ValueSet::any(int width) { return within(Graph::anyValue(width)); }

ValueSet ValueSet::of(std::uint64_t value) {
  ValueSet set;
  set.kind_ = Kind::Single;
  set.facts_ = Graph::exactly(value);
  return set;
}

ValueSet ValueSet::within(const Graph::Facts& facts) {
  if (facts.low == facts.high) return of(facts.low);
  ValueSet set;
  set.kind_ = Kind::Range;
  set.facts_ = facts;
  return set;
}

ValueSet ValueSet::list(std::vector<std::uint64_t> values, std::size_t limit) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.empty()) return {};
  if (values.size() == 1) return of(values[0]);
  ValueSet set;
  for (const std::uint64_t value : values) set.facts_ = joined(set.facts_, Graph::exactly(value));
  const bool isShort = values.size() <= limit && set.facts_.high > 1;
  set.kind_ = isShort ? Kind::List : Kind::Range;
  if (isShort) set.values_ = std::move(values);
  return set;
}

std::vector<std::uint64_t> ValueSet::values() const {
  if (kind_ == Kind::Single) return {facts_.low};
  return values_;
}

bool ValueSet::contains(std::uint64_t value) const {
  if (kind_ == Kind::List) return std::binary_search(values_.begin(), values_.end(), value);
  return facts_.low <= value && value <= facts_.high && (value & facts_.zeros) == 0 && (~value & facts_.ones) == 0;
}

bool ValueSet::includes(const ValueSet& other) const {
  const ValueSet listed = kind_ == Kind::List ? other.listedIfFew(values_.size()) : other;
  if (listed.isListed())
    return std::ranges::all_of(listed.values(), [&](std::uint64_t value) { return contains(value); });
  const Graph::Facts &own = facts_, &its = other.facts_;
  return kind_ == Kind::Range && own.low <= its.low && its.high <= own.high && (own.zeros & ~its.zeros) == 0 &&
         (own.ones & ~its.ones) == 0;
}

bool ValueSet::join(const ValueSet& other, std::size_t limit) {
  if (other.isEmpty()) return false;
  if (isEmpty()) {
    *this = other;
    return true;
  }
  if (isSingle() && other == *this) return false;
  ValueSet result;
  if (isListed() && other.isListed()) {
    std::vector<std::uint64_t> all = values();
    const std::vector<std::uint64_t> more = other.values();
    all.insert(all.end(), more.begin(), more.end());
    result = list(std::move(all), limit);
  } else {
    result = within(joined(facts_, other.facts_));
  }
  if (result == *this) return false;
  *this = std::move(result);
  return true;
}

void ValueSet::widen(const ValueSet& before, int width) {
  if (isListed()) return;
  if (facts_.low < before.facts_.low) facts_.low = 0;
  if (facts_.high > before.facts_.high) facts_.high = Graph::maskOf(width);
}

void ValueSet::restrict(std::uint64_t low, std::uint64_t high, std::size_t limit) {
  if (isListed()) {
    std::vector<std::uint64_t> left = values();
    std::erase_if(left, [&](std::uint64_t value) { return value < low || value > high; });
    *this = list(std::move(left), limit);
    return;
  }
  facts_.low = std::max(facts_.low, low);
  facts_.high = std::min(facts_.high, high);
  if (facts_.low > facts_.high) {
    *this = {};
    return;
  }
  // Constant low bits make a stride.
  std::uint64_t stride = 1;
  while (stride < (1ULL << 32) && ((facts_.zeros | facts_.ones) & stride) != 0) stride <<= 1;
  if ((facts_.high - facts_.low) / stride >= limit) return;
  std::vector<std::uint64_t> listed;
  std::uint64_t value = (facts_.low & ~(stride - 1)) | (facts_.ones & (stride - 1));
  if (value < facts_.low) value += stride;
  for (; value >= facts_.low && value <= facts_.high; value += stride) {
    if (contains(value)) listed.push_back(value);
    if (listed.size() > limit) return;
    if (value > ~0ULL - stride) break;
  }
  *this = list(std::move(listed), limit);
}

ValueSet ValueSet::listedIfFew(std::size_t limit) const {
  ValueSet result = *this;
  if (!isListed()) result.restrict(facts_.low, facts_.high, limit);
  return result;
}

ValueSet ValueSet::combine(const NodeData& node, std::array<int, 2> childWidth, std::array<const ValueSet*, 3> operand,
                           std::size_t limit) {
  if (node.op == Op::Ite) {
    const Graph::Facts& condition = operand[0]->facts();
    if (condition.low == 1) return *operand[1];
    if (condition.high == 0) return *operand[2];
    ValueSet result = *operand[1];
    result.join(*operand[2], limit);
    return result;
  }
  if (node.op == Op::Mul || node.op == Op::Add) {
    // An index times the size of a row leaves gaps, which bounds do not tell: 0 to 7 times 48 is eight values.
    const auto isOfMany = [](const ValueSet& set) { return set.isListed() && !set.isSingle(); };
    const bool leavesGaps = node.op == Op::Mul || isOfMany(*operand[0]) || isOfMany(*operand[1]);
    const ValueSet left = leavesGaps ? operand[0]->listedIfFew(limit) : *operand[0];
    const ValueSet right = leavesGaps ? operand[1]->listedIfFew(limit) : *operand[1];
    if (left != *operand[0] || right != *operand[1]) return combine(node, childWidth, {&left, &right, nullptr}, limit);
  }
  std::array<std::vector<std::uint64_t>, 3> values;
  std::array<Graph::Facts, 3> facts{};
  std::size_t combinations = 1;
  bool allListed = node.width > 1 || std::all_of(operand.begin(), operand.end(),
                                                 [](const ValueSet* o) { return o == nullptr || o->isListed(); });
  for (std::size_t i = 0; i < 3; ++i) {
    if (operand[i] == nullptr) {
      values[i] = {0};
      continue;
    }
    if (operand[i]->isEmpty()) return {};
    facts[i] = operand[i]->facts();
    if (!allListed) continue;
    const bool isTruth = facts[i].high == 1;
    allListed = operand[i]->isListed() || isTruth;
    if (!allListed) continue;
    values[i] = operand[i]->isListed() ? operand[i]->values() : std::vector<std::uint64_t>{0, 1};
    combinations *= values[i].size();
  }
  if (allListed && combinations <= 8 * limit) {
    std::vector<std::uint64_t> results;
    for (const std::uint64_t a : values[0]) {
      for (const std::uint64_t b : values[1]) {
        for (const std::uint64_t c : values[2])
          results.push_back(evaluateOperation(node.op, node.width, childWidth, {a, b, c}, node.value) &
                            Graph::maskOf(node.width));
      }
    }
    return list(std::move(results), limit);
  }
  return within(Graph::combine(node.op, node.width, node.value, childWidth, facts));
}

Graph::Bool isIn(Graph& graph, Node value, const ValueSet& set) {
  const int w = graph[value].width;
  const Graph::Bits v{value};
  if (set.isListed()) {
    Graph::Bool result = graph.constant(false);
    for (const std::uint64_t one : set.values()) result = graph.lor(result, graph.equal(v, graph.literal(one, w), w));
    return result;
  }
  const Graph::Facts& facts = set.facts();
  const std::uint64_t mask = Graph::maskOf(w), zeros = facts.zeros & mask, ones = facts.ones & mask;
  Graph::Bool result = graph.constant(true);
  if (facts.low > 0) result = graph.land(result, graph.ule(graph.literal(facts.low, w), v, w));
  if (facts.high < mask) result = graph.land(result, graph.ule(v, graph.literal(facts.high, w), w));
  const auto masked = [&](std::uint64_t bits, std::uint64_t expected) {
    if (bits == 0) return;
    const Graph::Bits part = graph.band(v, graph.literal(bits, w), w);
    result = graph.land(result, graph.equal(part, graph.literal(expected, w), w));
  };
  masked(zeros, 0);
  masked(ones, ones);
  return result;
}

}  // namespace rungproof
