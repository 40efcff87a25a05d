// Abstract evaluation and the fixpoint over the transition relation.
#include "analysis/encoding/pointer_values.hpp"

#include <algorithm>

#include "analysis/encoding/pointer_walk.hpp"
#include "analysis/graph/evaluate.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostCases = 16;    ///< values of a variable that are tried one by one
constexpr std::size_t mostTried = 6;     ///< variables
constexpr std::size_t longCone = 1500;   ///< nodes of a next function: to walk through it takes long
constexpr std::size_t mostOfRange = 64;  ///< values within bounds that are taken for what it becomes instead

/// Rounds in which sets may grow before bounds are widened.
constexpr int roundsBeforeWidening = 6;
constexpr int nestedChoices = 4;  ///< that a bound is followed through

}  // namespace

std::vector<Node> partsOf(const Graph& graph, Node root) {
  std::vector<Node> parts, open{root};
  std::set<Node> met{root};
  while (!open.empty()) {
    const NodeData& node = graph[open.back()];
    if (node.op == Op::Variable) parts.push_back(open.back());
    open.pop_back();
    for (const Node child : node.child) {
      const bool isValue = child != noNode && node.op != Op::Constant && graph[child].width > 1;
      if (isValue && met.insert(child).second) open.push_back(child);
    }
  }
  return parts;
}

std::vector<Node> variablesOf(const Graph& graph, Node root) {
  std::vector<Node> result;
  const Node roots[] = {root};
  for (const Node n : coneOf(graph, roots)) {
    if (graph[n].op == Op::Variable) result.push_back(n);
  }
  return result;
}

ValueEvaluator::ValueEvaluator(const Graph& graph, const VariableValues& known) : graph_(graph), variables_(known) {
  for (const auto& [n, values] : known) {
    if (graph[n].op == Op::Variable) continue;
    isKnown_.resize(graph.size());
    isKnown_[indexOf(n)] = true;
  }
}

ValueSet ValueEvaluator::evaluate(Node n, std::size_t limit) {
  const NodeData& node = graph_[n];
  ValueSet result;
  if (node.op == Op::Variable) {
    if (n == fixed_) {
      result = fixedValue_;
    } else {
      const auto found = variables_.find(n);
      result = found == variables_.end() ? ValueSet::any(node.width) : found->second;
    }
  } else if (node.op == Op::Constant) {
    result = ValueSet::of(node.value);
  } else if (node.op == Op::Ite && node.width > 1) {
    const std::uint64_t mask = Graph::maskOf(node.width);
    result = choice(n, {{0, mask}, {0, mask}}, limit, 0);
  } else {
    std::array<const ValueSet*, 3> operand{};
    std::array<int, 2> widths{};
    for (std::size_t i = 0; i < 3 && node.child[i] != noNode; ++i) {
      operand[i] = &values_[indexOf(node.child[i])];
      if (i < 2) widths[i] = graph_[node.child[i]].width;
    }
    result = ValueSet::combine(node, widths, operand, limit);
  }
  if (indexOf(n) < isKnown_.size() && isKnown_[indexOf(n)]) {
    const Graph::Facts& known = variables_.at(n).facts();
    result.restrict(known.low, known.high, limit);
  }
  if (const auto bounds = unsigned_.find(n); bounds != unsigned_.end())
    result.restrict(bounds->second.low, bounds->second.high, limit);
  if (const auto bounds = signed_.find(n); bounds != signed_.end()) {
    const std::uint64_t mask = Graph::maskOf(node.width), sign = mask ^ mask >> 1;
    const std::uint64_t low = bounds->second.low ^ sign, high = bounds->second.high ^ sign;
    if (low <= high) result.restrict(low, high, limit);
  }
  return result;
}

/// Narrows bounds of `subject` by comparisons of it with constants that the condition, or its negation, contains.
ValueEvaluator::Bounded ValueEvaluator::boundedBy(Node subject, Node condition, bool isTrue, Bounded bounds) const {
  std::vector<std::pair<Node, bool>> open{{condition, isTrue}};
  const auto narrow = [](Bounds& to, const std::optional<Bounds>& by) {
    if (by) to = {std::max(to.low, by->low), std::min(to.high, by->high)};
  };
  while (!open.empty()) {
    const auto [n, isSo] = open.back();
    open.pop_back();
    const NodeData& node = graph_[n];
    if (node.op == Op::Not) {
      open.emplace_back(node.child[0], !isSo);
    } else if (node.op == Op::And) {
      if (isSo) open.insert(open.end(), {{node.child[0], true}, {node.child[1], true}});
    } else if (const std::optional<Limit> limit = limitOf(n, isSo); limit && limit->subject == subject) {
      narrow(bounds.asUnsigned, limit->asUnsigned);
      narrow(bounds.asSigned, limit->asSigned);
    }
  }
  return bounds;
}

bool ValueEvaluator::isFree(const Bounded& bounds, int width) const {
  const auto isAll = [&](const Bounds& b) { return b.low == 0 && b.high == Graph::maskOf(width); };
  return isAll(bounds.asUnsigned) && isAll(bounds.asSigned);
}

/// Only what is compared somewhere can be bounded by the condition that chooses it.
void ValueEvaluator::collectCompared() {
  const std::size_t first = isCompared_.size();
  isCompared_.resize(graph_.size());
  for (std::size_t i = first; i < isCompared_.size(); ++i) {
    if (const std::optional<Limit> limit = limitOf(static_cast<Node>(i))) isCompared_[indexOf(limit->subject)] = true;
  }
}

/// The values of x + 1, or of x in more bits, where the condition bounds x: x < 16 ? x + 1 : x. Nothing: it does not.
std::optional<ValueSet> ValueEvaluator::boundedByPart(Node n, Node condition, bool isTrue, std::size_t limit,
                                                      int depth) const {
  const NodeData& node = graph_[n];
  if ((node.op != Op::Add && node.op != Op::Zext) || isCompared_[indexOf(n)]) return std::nullopt;
  const bool isSecond = node.op == Op::Add && graph_[node.child[0]].op == Op::Constant;
  const Node part = node.child[isSecond ? 1 : 0], constant = node.child[isSecond ? 0 : 1];
  if (!isCompared_[indexOf(part)] || (node.op == Op::Add && graph_[constant].op != Op::Constant)) return std::nullopt;
  const int width = graph_[part].width;
  const std::uint64_t mask = Graph::maskOf(width);
  const Bounded inside = boundedBy(part, condition, isTrue, {{0, mask}, {0, mask}});
  if (isFree(inside, width)) return std::nullopt;
  const ValueSet values = choice(part, inside, limit, depth + 1);
  if (values.isEmpty()) return values;
  const ValueSet* other = node.op == Op::Add ? &at(constant) : nullptr;
  return ValueSet::combine(node, {width, width}, {isSecond ? other : &values, isSecond ? &values : other, nullptr},
                           limit);
}

/// The values of a node within bounds; of a choice, those of each alternative where it is chosen: x > 9 ? 9 : x.
ValueSet ValueEvaluator::choice(Node n, const Bounded& bounds, std::size_t limit, int depth) const {
  const NodeData& node = graph_[n];
  ValueSet result;
  if (node.op == Op::Ite && depth < nestedChoices) {
    const ValueSet& condition = at(node.child[0]);
    for (const bool isTrue : {true, false}) {
      if (!condition.contains(isTrue ? 1 : 0)) continue;
      const Node chosen = node.child[isTrue ? 1 : 2];
      if (const std::optional<ValueSet> whole = boundedByPart(chosen, node.child[0], isTrue, limit, depth)) {
        ValueSet part = *whole;
        if (!isFree(bounds, node.width)) part.restrict(bounds.asUnsigned.low, bounds.asUnsigned.high, limit);
        result.join(part, limit);
        continue;
      }
      const Bounded inside = isCompared_[indexOf(chosen)] ? boundedBy(chosen, node.child[0], isTrue, bounds) : bounds;
      result.join(isFree(inside, node.width) ? at(chosen) : choice(chosen, inside, limit, depth + 1), limit);
    }
    return result;
  }
  // Signed bounds are shifted: those of negative numbers stand below those of the others.
  const std::uint64_t mask = Graph::maskOf(node.width), sign = mask ^ mask >> 1;
  for (const std::uint64_t half : {std::uint64_t{0}, sign}) {
    const std::uint64_t first = half ^ sign, last = first + (mask >> 1);  // of this half, shifted
    const std::uint64_t low = std::max(first, bounds.asSigned.low), high = std::min(last, bounds.asSigned.high);
    if (low > high) continue;
    const std::uint64_t least = std::max(low ^ sign, bounds.asUnsigned.low);
    const std::uint64_t most = std::min(high ^ sign, bounds.asUnsigned.high);
    if (least > most) continue;
    ValueSet part = at(n);
    part.restrict(least, most, limit);
    result.join(part, limit);
  }
  return result;
}

void ValueEvaluator::run(std::span<const Node> cone, std::size_t limit) {
  values_.resize(graph_.size());
  collectCompared();
  for (const Node n : cone) values_[indexOf(n)] = evaluate(n, limit);
}

ValueSet ValueEvaluator::valuesOf(Node root, Node guard, std::size_t limit) {
  unsigned_.clear();
  signed_.clear();
  collectBounds(guard);
  const Node roots[] = {root};
  run(coneOf(graph_, roots), limit);
  unsigned_.clear();
  signed_.clear();
  return at(root);
}

ValueSet ValueEvaluator::valuesByCase(Node root, Node guard, std::size_t limit) {
  const ValueSet values = valuesOf(root, guard, limit).listedIfFew(limit);
  if (values.isListed()) return values;
  std::size_t tried = 0;
  for (const Node n : variablesOf(graph_, root)) {
    const auto known = variables_.find(n);
    if (known == variables_.end()) continue;
    const ValueSet cases = known->second.listedIfFew(mostCases);
    if (!cases.isListed() || cases.isSingle() || cases.isEmpty()) continue;
    if (++tried > mostTried) break;
    ValueSet found;
    fixed_ = n;
    for (const std::uint64_t value : cases.values()) {
      fixedValue_ = ValueSet::of(value);
      found.join(valuesOf(root, guard, limit).listedIfFew(limit), limit);
      if (!found.isListed()) break;
    }
    fixed_ = noNode;
    if (found.isListed()) return found;
  }
  return values;
}

ValueSet ValueEvaluator::valuesWith(std::span<const Node> cone, Node variable, const ValueSet& value,
                                    std::size_t limit) {
  fixed_ = variable;
  fixedValue_ = value;
  run(cone, limit);
  fixed_ = noNode;
  return at(cone.back());
}

/// What a comparison with a constant, or the negation of one, says of what it compares; nothing if it says no bounds.
std::optional<ValueEvaluator::Limit> ValueEvaluator::limitOf(Node n, bool isTrue) const {
  const bool isNot = graph_[n].op == Op::Not, isNegated = isNot == isTrue;
  const NodeData& test = graph_[isNot ? graph_[n].child[0] : n];
  if (test.op == Op::Extract && test.width == 1 && test.value + 1 == graph_[test.child[0]].width) {
    // The sign bit: what x < 0 has become.
    const std::uint64_t all = Graph::maskOf(graph_[test.child[0]].width), half = all ^ all >> 1;
    return Limit{test.child[0], std::nullopt, isNegated ? Bounds{half, all} : Bounds{0, half - 1}};
  }
  const bool isOrEqual = test.op == Op::Ule || test.op == Op::Sle;
  if (test.op != Op::Equal && test.op != Op::Ult && test.op != Op::Slt && !isOrEqual) return std::nullopt;
  const bool isRight = graph_[test.child[1]].op == Op::Constant;
  if (!isRight && graph_[test.child[0]].op != Op::Constant) return std::nullopt;
  const Node subject = test.child[isRight ? 0 : 1];
  const std::uint64_t mask = Graph::maskOf(graph_[subject].width), sign = mask ^ mask >> 1;
  const std::uint64_t raw = graph_[test.child[isRight ? 1 : 0]].value;
  if (test.op == Op::Equal) {
    if (isNegated) return std::nullopt;
    return Limit{subject, Bounds{raw, raw}, Bounds{raw ^ sign, raw ^ sign}};
  }
  // x <= k is the negation of k < x.
  const bool isSigned = test.op == Op::Slt || test.op == Op::Sle;
  const bool isBelow = isRight != isOrEqual, isRefuted = isNegated != isOrEqual;
  const std::uint64_t k = isSigned ? raw ^ sign : raw;
  Bounds bounds{0, mask};
  if (isBelow) {
    if (isRefuted)
      bounds.low = k;
    else
      bounds.high = k - 1;
  } else {
    if (isRefuted)
      bounds.high = k;
    else
      bounds.low = k + 1;
  }
  return isSigned ? Limit{subject, std::nullopt, bounds} : Limit{subject, bounds, std::nullopt};
}

/// Of alternatives about one subject: x > 0 or x = 0.
std::optional<ValueEvaluator::Limit> ValueEvaluator::limitOfAny(std::span<const Node> alternatives) const {
  std::optional<Limit> result;
  for (const Node n : alternatives) {
    const std::optional<Limit> next = limitOf(n);
    if (!next || (result && next->subject != result->subject)) return std::nullopt;
    if (!result) {
      result = next;
      continue;
    }
    const auto join = [](std::optional<Bounds>& to, const std::optional<Bounds>& from) {
      if (to && from)
        to = Bounds{std::min(to->low, from->low), std::max(to->high, from->high)};
      else
        to.reset();
    };
    join(result->asUnsigned, next->asUnsigned);
    join(result->asSigned, next->asSigned);
  }
  return result;
}

/// Comparisons with constants among the conjuncts of the guard.
void ValueEvaluator::collectBounds(Node guard) {
  std::vector<Node> open{guard};
  while (!open.empty()) {
    const Node n = open.back();
    open.pop_back();
    if (graph_[n].op != Op::Constant) unsigned_[n] = {1, 1};
    if (graph_[n].op == Op::Not) unsigned_[graph_[n].child[0]] = {0, 0};
    if (graph_[n].op == Op::And) {
      open.push_back(graph_[n].child[0]);
      open.push_back(graph_[n].child[1]);
      continue;
    }
    std::optional<Limit> limit = limitOf(n);
    if (!limit && graph_[n].op == Op::Not && graph_[graph_[n].child[0]].op == Op::And) {
      std::vector<Node> alternatives, parts{graph_[n].child[0]};
      bool isUnderstood = true;
      while (!parts.empty()) {
        const NodeData& part = graph_[parts.back()];
        parts.pop_back();
        if (part.op == Op::And)
          parts.insert(parts.end(), {part.child[0], part.child[1]});
        else if (part.op == Op::Not)
          alternatives.push_back(part.child[0]);
        else
          isUnderstood = false;
      }
      if (isUnderstood) limit = limitOfAny(alternatives);
    }
    const auto narrow = [&](std::unordered_map<Node, Bounds>& table, const std::optional<Bounds>& bounds) {
      if (!bounds) return;
      const auto [place, isNew] = table.try_emplace(limit->subject, *bounds);
      if (isNew) return;
      place->second.low = std::max(place->second.low, bounds->low);
      place->second.high = std::min(place->second.high, bounds->high);
    };
    if (!limit) continue;
    narrow(unsigned_, limit->asUnsigned);
    narrow(signed_, limit->asSigned);
  }
  // Where the sign bit is known, a signed comparison has become one of the bits below it.
  for (const auto& [part, bounds] : std::vector<std::pair<Node, Bounds>>(unsigned_.begin(), unsigned_.end())) {
    const NodeData& slice = graph_[part];
    if (slice.op != Op::Extract || slice.value != 0 || slice.width + 1 != graph_[slice.child[0]].width) continue;
    const std::uint64_t half = Graph::maskOf(slice.width) + 1;
    const auto sign = signed_.find(slice.child[0]);
    if (sign == signed_.end()) continue;
    const bool isPositive = sign->second.low >= half, isNegative = sign->second.high < half;
    if (!isPositive && !isNegative) continue;
    const auto [whole, isNew] = unsigned_.try_emplace(slice.child[0], Bounds{0, Graph::maskOf(slice.width + 1)});
    const std::uint64_t base = isNegative ? half : 0;
    whole->second = {std::max(whole->second.low, base + bounds.low), std::min(whole->second.high, base + bounds.high)};
  }
  boundParts();
}

/// What bounds a number bounds the parts that it is joined from: below 10, a word's high byte is 0 and its low byte is
/// below 10.
void ValueEvaluator::boundParts() {
  std::vector<Node> open;
  for (const auto* table : {&unsigned_, &signed_}) {
    for (const auto& [n, bounds] : *table) open.push_back(n);
  }
  const auto boundsOf = [&](Node n) {
    const std::uint64_t half = (Graph::maskOf(graph_[n].width) >> 1) + 1;
    Bounds result{0, Graph::maskOf(graph_[n].width)};
    if (const auto known = unsigned_.find(n); known != unsigned_.end()) result = known->second;
    const auto known = signed_.find(n);
    if (known != signed_.end() && known->second.low >= half)
      result = {std::max(result.low, known->second.low - half), std::min(result.high, known->second.high - half)};
    return result;
  };
  while (!open.empty()) {
    const Node n = open.back();
    open.pop_back();
    const NodeData node = graph_[n];
    if (node.op != Op::Concat) continue;
    const Node high = node.child[0], low = node.child[1];
    const int lowWidth = graph_[low].width;
    const std::uint64_t half = (Graph::maskOf(node.width) >> 1) + 1;
    Bounds whole = boundsOf(n);
    const auto order = signed_.find(n);
    const bool isPositive = boundsOf(high).high <= Graph::maskOf(graph_[high].width) >> 1;
    if (order != signed_.end() && isPositive && order->second.high >= half)
      whole = {std::max(whole.low, std::max(order->second.low, half) - half),
               std::min(whole.high, order->second.high - half)};
    if (whole.low > whole.high) continue;
    const Bounds above{std::max(boundsOf(high).low, whole.low >> lowWidth),
                       std::min(boundsOf(high).high, whole.high >> lowWidth)};
    if (above.low > above.high) continue;
    unsigned_[high] = above;
    open.push_back(high);
    if (above.low != above.high) continue;
    const std::uint64_t base = above.low << lowWidth;
    const Bounds below{std::max(boundsOf(low).low, whole.low > base ? whole.low - base : 0),
                       std::min(boundsOf(low).high, whole.high - base)};
    if (below.low > below.high) continue;
    unsigned_[low] = below;
    open.push_back(low);
  }
}

std::vector<Node> firstScansOf(const TransitionSystem& system) {
  const Graph& graph = *system.graph;
  const auto is = [&](Node n, std::uint64_t value) {
    return n != noNode && graph[n].op == Op::Constant && graph[n].value == value;
  };
  std::vector<Node> result;
  for (const StateVariable& s : system.states) {
    if (graph[s.node].width == 1 && is(s.init, 1) && is(s.next, 0)) result.push_back(s.node);
  }
  return result;
}

namespace {

/// Value by value: what does the cell become from each of its values? What it starts with counts in the first scan,
/// what it has become in all others: a pointer that the first scan sets is never advanced from 0, nor from what
/// retentive memory holds. False if they become too many.
class PointerCells {
 public:
  PointerCells(const TransitionSystem& system, ValueEvaluator& evaluator, VariableValues& known, VariableValues& later,
               const std::function<void()>& interruption)
      : graph_(*system.graph),
        firstScans_(firstScansOf(system)),
        evaluator_(evaluator),
        known_(known),
        later_(later),
        interruption_(interruption) {}

  bool follow(const StateVariable& cell, bool& isChanged) {
    const Node next[] = {cell.next};
    cone_ = coneOf(graph_, next);
    std::set<std::uint64_t> found;
    const ValueSet start = known_.at(cell.node);
    if (firstScans_.empty()) {
      if (!start.isListed()) return false;
      for (const std::uint64_t v : start.values()) found.insert(v);
    } else {
      if (const auto before = later_.find(cell.node); before != later_.end()) {
        for (const std::uint64_t v : before->second.values()) found.insert(v);
      }
      const VariableValues before = known_;
      for (const Node n : firstScans_) known_[n] = ValueSet::of(1);
      const ValueSet second = evaluator_.valuesWith(cone_, cell.node, initialOf(cell), pointerValueLimit);
      for (const Node n : firstScans_) known_[n] = before.at(n);
      if (!second.isListed()) return false;
      for (const std::uint64_t v : second.values()) found.insert(v);
    }
    if (!close(cell.node, found)) return false;
    ValueSet values;
    for (const std::uint64_t v : found) values.join(ValueSet::of(v), pointerValueLimit);
    if (!firstScans_.empty()) isChanged = later_[cell.node].join(values, pointerValueLimit) || isChanged;
    isChanged = known_.at(cell.node).join(values, pointerValueLimit) || isChanged;
    return true;
  }

 private:
  ValueSet initialOf(const StateVariable& cell) const {
    const bool isKnown = cell.init != noNode && graph_[cell.init].op == Op::Constant;
    return isKnown ? ValueSet::of(graph_[cell.init].value) : ValueSet::any(graph_[cell.node].width);
  }

  /// Closes the values under scans that are not the first one. False if they become too many.
  bool close(Node cell, std::set<std::uint64_t>& found) {
    const VariableValues before = known_;
    for (const auto& [other, values] : later_) known_[other] = values;
    for (const Node n : firstScans_) known_[n] = ValueSet::of(0);
    const bool isClosed = closeFrom(cell, found);
    known_ = before;
    return isClosed;
  }
  bool closeFrom(Node cell, std::set<std::uint64_t>& found) {
    std::vector<std::uint64_t> open(found.begin(), found.end());
    while (!open.empty()) {
      const std::uint64_t from = open.back();
      open.pop_back();
      if (interruption_) interruption_();
      ValueSet to = evaluator_.valuesWith(cone_, cell, ValueSet::of(from), pointerValueLimit);
      if (cone_.size() > longCone) to = to.listedIfFew(mostOfRange);
      if (!to.isListed()) return false;
      for (const std::uint64_t v : to.values()) {
        if (found.insert(v).second) open.push_back(v);
      }
      if (found.size() > pointerValueLimit) return false;
    }
    return true;
  }

  const Graph& graph_;
  const std::vector<Node> firstScans_;
  ValueEvaluator& evaluator_;
  VariableValues& known_;
  VariableValues& later_;
  const std::function<void()>& interruption_;
  std::vector<Node> cone_;  ///< of the next function at hand
};

}  // namespace

void closeValues(const TransitionSystem& system, const std::set<Node>& pointerCells, VariableValues& values,
                 VariableValues& later, const std::function<void()>& interruption, std::map<Node, Walk>* walks) {
  const Graph& graph = *system.graph;
  std::vector<Node> roots;
  for (const StateVariable& s : system.states) {
    roots.push_back(s.next);
    ValueSet init = ValueSet::any(graph[s.node].width);
    if (s.init != noNode && graph[s.init].op == Op::Constant) init = ValueSet::of(graph[s.init].value);
    values[s.node].join(init, pointerValueLimit);
  }
  const std::vector<Node> cone = coneOf(graph, roots);
  ValueEvaluator evaluator(graph, values);
  PointerCells pointers(system, evaluator, values, later, interruption);
  std::set<Node> walked;
  // A condition that a pointer depends on has two values at most.
  const auto isFollowed = [&](const StateVariable& s) {
    return pointerCells.contains(s.node) && graph[s.node].width > 1;
  };
  for (int round = 0;; ++round) {
    bool isChanged = false;
    if (interruption) interruption();
    evaluator.run(cone, valueLimit);
    for (const StateVariable& s : system.states) {
      if (isFollowed(s)) continue;
      const ValueSet before = values[s.node];
      ValueSet& set = values[s.node];
      if (!set.join(evaluator.at(s.next), valueLimit)) continue;
      if (round >= roundsBeforeWidening) set.widen(before, graph[s.node].width);
      isChanged = true;
    }
    for (const StateVariable& s : system.states) {
      if (!isFollowed(s) || walked.contains(s.node)) continue;
      if (!pointers.follow(s, isChanged)) {
        // Its own values do not end; perhaps another cell makes it start again.
        walked.insert(s.node);
        later.erase(s.node);
        values[s.node] = ValueSet::any(graph[s.node].width);
        if (auto walk = walkOf(system, s.node, firstScansOf(system), pointerValueLimit, interruption)) {
          ValueSet& after = later[s.node];
          for (const std::uint64_t v : walk->values) after.join(ValueSet::of(v), pointerValueLimit);
          if (s.init != noNode && graph[s.init].op == Op::Constant) {
            values[s.node] = after;
            values[s.node].join(ValueSet::of(graph[s.init].value), pointerValueLimit);
          }
          if (walks != nullptr) walks->insert_or_assign(s.node, std::move(*walk));
        }
        isChanged = true;
      }
    }
    if (!isChanged) return;
  }
}

}  // namespace rungproof
