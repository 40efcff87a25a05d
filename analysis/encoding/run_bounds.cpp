// Bounds of one cell are proved first: those of two cells rest on them.
#include "analysis/encoding/run_bounds.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <set>

#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/z3_terms.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostConstantsTried = 12;
constexpr std::size_t mostPairsTried = 80;
/// Z3 looks at no clock while it takes conditions in, and that of one SCAT took it minutes.
constexpr std::size_t mostNodesTried = 20'000;
constexpr int samples = 300;  ///< random states that weed out bounds
/// Of one proof, as Z3 counts its work: what is found must not depend on what else the machine does.
constexpr unsigned proofSteps = 1'000'000;
constexpr unsigned proofLimit = 8000;                    ///< ms of one proof, on a busy machine
constexpr std::chrono::milliseconds searchLimit{20000};  ///< for all proofs, likewise

/// What devices write beside the routines is bound to nothing.
bool isOfDevices(const Place& place) { return place.isRegister || place.area == Area::SM; }

}  // namespace

Node RunBounds::Bound::holdsForOne(Graph& graph, Ends ends) const {
  const int w = graph[ends.before].width;
  const auto isWithin = [&](Node limit) {
    switch (kind) {
      case Kind::AtLeast: return graph.ule({limit}, {ends.after}, w);
      case Kind::AtMost: return graph.ule({ends.after}, {limit}, w);
      case Kind::SignedAtLeast: return graph.sle({limit}, {ends.after}, w);
      case Kind::SignedAtMost: return graph.sle({ends.after}, {limit}, w);
      default: return graph.equal({ends.after}, {limit}, w);
    }
  };
  Graph::Bool result = isWithin(ends.before);
  for (const std::uint64_t constant : constants) result = graph.lor(result, isWithin(graph.constantNode(constant, w)));
  return result.node;
}

Node RunBounds::Bound::holdsForTwo(Graph& graph, Ends a, Ends b) const {
  const int w = graph[a.before].width;
  const auto stays = [&](auto&& is) {
    return graph.lor(graph.lnot(is(Graph::Bits{a.before}, Graph::Bits{b.before})),
                     is(Graph::Bits{a.after}, Graph::Bits{b.after}));
  };
  const auto sum = [&](Node x, Node y) { return graph.add({x}, {y}, w); };
  const auto difference = [&](Node x, Node y) { return graph.sub({x}, {y}, w); };
  const Graph::Bool isSameSum = graph.equal(sum(a.before, b.before), sum(a.after, b.after), w);
  const Graph::Bool isSameDistance = graph.equal(difference(b.before, a.before), difference(b.after, a.after), w);
  /// `same` as well, where `is` was so before.
  const auto staysWith = [&](Graph::Bool same, auto&& is) {
    const Graph::Bool was = is(Graph::Bits{a.before}, Graph::Bits{b.before});
    return graph.lor(graph.lnot(was), graph.land(same, is(Graph::Bits{a.after}, Graph::Bits{b.after}))).node;
  };
  const auto isPositive = [&](Graph::Bits x) { return graph.sle(graph.literal(0, w), x, w); };
  const auto isOn = [](Graph::Bits bit) { return Graph::Bool{bit.node}; };
  switch (kind) {
    case Kind::Sum: return isSameSum.node;
    case Kind::Difference: return isSameDistance.node;
    case Kind::Parts: return staysWith(isSameSum, [&](auto x, auto y) { return graph.ule(x, graph.add(x, y, w), w); });
    case Kind::SignedParts:
      return staysWith(isSameSum, [&](auto x, auto y) {
        return graph.land(graph.land(isPositive(x), isPositive(y)), isPositive(graph.add(x, y, w)));
      });
    case Kind::Behind: return staysWith(isSameDistance, [&](auto x, auto y) { return graph.ule(x, y, w); });
    case Kind::SignedBehind:
      return staysWith(isSameDistance,
                       [&](auto x, auto y) { return graph.land(graph.sle(x, y, w), isPositive(graph.sub(y, x, w))); });
    case Kind::NotAbove: return stays([&](auto x, auto y) { return graph.ule(x, y, w); }).node;
    case Kind::Below: return stays([&](auto x, auto y) { return graph.ult(x, y, w); }).node;
    case Kind::SignedNotAbove: return stays([&](auto x, auto y) { return graph.sle(x, y, w); }).node;
    case Kind::SignedBelow: return stays([&](auto x, auto y) { return graph.lnot(graph.sle(y, x, w)); }).node;
    case Kind::NotBoth: return stays([&](auto x, auto y) { return graph.lnot(graph.land(isOn(x), isOn(y))); }).node;
    default: return stays([&](auto x, auto y) { return graph.lor(isOn(x), isOn(y)); }).node;
  }
}

Node RunBounds::Bound::holds(Graph& graph, const EndsOf& ends) const {
  return isOfTwo() ? holdsForTwo(graph, ends(place), ends(other)) : holdsForOne(graph, ends(place));
}

/// Proposals about the cells of some runs, and which of them hold.
class RunBounds::Search {
 public:
  Search(Graph& graph, const std::vector<Cell>& cells, const std::vector<Run>& runs)
      : graph_(graph), cells_(cells), runs_(runs), end_(std::chrono::steady_clock::now() + searchLimit) {
    std::vector<Node> roots;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      at_.emplace(cells[i].place, i);
      roots.push_back(cells[i].now);
    }
    for (const Run& run : runs) {
      for (const auto& [index, after] : run) roots.push_back(after);
    }
    cone_ = coneOf(graph, roots);
    for (const Node n : cone_) {
      if (graph[n].op == Op::Variable) variables_.push_back(n);
      if (graph[n].op == Op::Constant) constants_[graph[n].width].insert(graph[n].value);
    }
    roots_ = std::move(roots);
  }

  std::vector<Bound> bounds() {
    if (cone_.size() > mostNodesTried) return {};
    std::vector<Bound> ofOne = proposedForOne(), ofTwo = proposedForTwo();
    weed(ofOne, ofTwo);
    leaveOutWeaker(ofOne);
    prove(ofOne, {});
    leaveOutImplied(ofTwo, ofOne);
    prove(ofTwo, ofOne);
    leaveOutWeakerOfTwo(ofTwo, ofOne);
    ofOne.insert(ofOne.end(), ofTwo.begin(), ofTwo.end());
    return ofOne;
  }

 private:
  std::vector<Bound> proposedForOne() const;
  std::vector<Bound> proposedForTwo() const;
  void weed(std::vector<Bound>& ofOne, std::vector<Bound>& ofTwo);
  static void leaveOutWeaker(std::vector<Bound>& bounds);
  static void leaveOutWeakerOfTwo(std::vector<Bound>& bounds, const std::vector<Bound>& ofOne);
  void leaveOutImplied(std::vector<Bound>& ofTwo, const std::vector<Bound>& ofOne) const;
  void prove(std::vector<Bound>& bounds, const std::vector<Bound>& given);

  Graph& graph_;
  const std::vector<Cell>& cells_;
  const std::vector<Run>& runs_;
  const std::chrono::steady_clock::time_point end_;
  std::map<Place, std::size_t> at_;
  std::vector<Node> roots_, cone_, variables_;
  std::map<int, std::set<std::uint64_t>> constants_;  ///< of the routines, by width
};

std::vector<RunBounds::Bound> RunBounds::Search::proposedForOne() const {
  using enum Kind;
  std::vector<Bound> bounds;
  for (const Cell& cell : cells_) {
    if (cell.hasNoBounds() || !cell.isWritten) continue;
    const int width = cell.place.width;
    std::vector<std::uint64_t> known;
    if (const auto some = constants_.find(width); some != constants_.end())
      known.assign(some->second.begin(), some->second.end());
    for (const std::uint64_t c : std::vector<std::uint64_t>(known)) known.push_back((c + 1) & Graph::maskOf(width));
    known.push_back(0);
    std::ranges::sort(known);
    known.erase(std::ranges::unique(known).begin(), known.end());
    if (known.size() > mostConstantsTried) known.resize(mostConstantsTried);
    const std::vector<Kind> kinds =
        width == 1 ? std::vector{AtLeast, AtMost} : std::vector{AtLeast, AtMost, SignedAtLeast, SignedAtMost};
    for (const Kind kind : kinds) {
      bounds.push_back({kind, cell.place});
      for (const std::uint64_t c : known) {
        if (width > 1) bounds.push_back({kind, cell.place, {c}});
      }
    }
    if (width > 1) bounds.push_back({OneOf, cell.place, known});
  }
  return bounds;
}

std::vector<RunBounds::Bound> RunBounds::Search::proposedForTwo() const {
  using enum Kind;
  std::vector<Bound> bounds;
  std::size_t pairs = 0;
  for (const Cell& a : cells_) {
    for (const Cell& b : cells_) {
      if (!(a.place < b.place) || a.place.width != b.place.width || a.hasNoBounds() || b.hasNoBounds()) continue;
      if (!a.isWritten && !b.isWritten) continue;
      if (isOfDevices(a.place) || isOfDevices(b.place)) continue;
      if (++pairs > mostPairsTried) return bounds;
      const auto propose = [&](Kind kind, const Place& one, const Place& other) {
        bounds.push_back({kind, one, {}, other});
      };
      const bool areBits = a.place.width == 1;
      const bool isSigned = a.place.width > 8;  // as programs compare them
      const auto proposeBoth = [&](Kind kind) {
        propose(kind, a.place, b.place);
        propose(kind, b.place, a.place);
      };
      if (a.isWritten && b.isWritten) {
        propose(Difference, a.place, b.place);
        if (!areBits) {
          propose(Sum, a.place, b.place);
          propose(isSigned ? SignedParts : Parts, a.place, b.place);
          proposeBoth(isSigned ? SignedBehind : Behind);
        }
      }
      proposeBoth(isSigned ? SignedNotAbove : NotAbove);
      if (!areBits) proposeBoth(isSigned ? SignedBelow : Below);
      if (!areBits) continue;
      propose(NotBoth, a.place, b.place);
      propose(NotNeither, a.place, b.place);
    }
  }
  return bounds;
}

/// Nothing has happened before the first run: bounds that one run from there breaks are no bounds.
void RunBounds::Search::weed(std::vector<Bound>& ofOne, std::vector<Bound>& ofTwo) {
  std::mt19937_64 random(1);
  Evaluator evaluator(graph_, roots_);
  std::vector<Node> from(cells_.size(), noNode), to;
  for (int sample = 0; sample < samples; ++sample) {
    const std::uint64_t common = random();
    // Cells that are compared with each other stand close together in some of the states.
    const auto some = [&](int width) {
      const std::uint64_t value = random();
      const auto& known = constants_[width];
      const std::uint64_t way = random() % 4;
      if (way == 0) return (common + value % 3 - 1) & Graph::maskOf(width);
      if (way > 2 || known.empty()) return value & Graph::maskOf(width);
      const std::uint64_t one = *std::next(known.begin(), static_cast<std::ptrdiff_t>(value % known.size()));
      return (one + random() % 3 - 1) & Graph::maskOf(width);
    };
    for (const Node v : variables_) evaluator.set(v, some(graph_[v].width));
    evaluator.run();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      from[i] = graph_.constantNode(evaluator[cells_[i].now], cells_[i].place.width);
    }
    for (const Run& run : runs_) {
      to = from;
      for (const auto& [index, after] : run)
        to[index] = graph_.constantNode(evaluator[after], cells_[index].place.width);
      const EndsOf ends = [&](const Place& place) { return Ends{from[at_.at(place)], to[at_.at(place)]}; };
      for (std::vector<Bound>* bounds : {&ofOne, &ofTwo})
        std::erase_if(*bounds, [&](const Bound& b) { return graph_[b.holds(graph_, ends)].value == 0; });
    }
  }
}

/// A bound without a constant says more than the same with one.
void RunBounds::Search::leaveOutWeaker(std::vector<Bound>& bounds) {
  const std::vector<Bound> given = bounds;
  std::erase_if(bounds, [&](const Bound& bound) {
    return !bound.constants.empty() && std::ranges::any_of(given, [&](const Bound& other) {
      return other.kind == bound.kind && other.place == bound.place && other.constants.empty();
    });
  });
}

/// What never rises stays below what never falls.
void RunBounds::Search::leaveOutImplied(std::vector<Bound>& ofTwo, const std::vector<Bound>& ofOne) const {
  using enum Kind;
  const auto keeps = [&](const Place& place, Kind kind) {
    return !cells_[at_.at(place)].isWritten || std::ranges::any_of(ofOne, [&](const Bound& bound) {
      return bound.kind == kind && bound.place == place && bound.constants.empty();
    });
  };
  std::erase_if(ofTwo, [&](const Bound& bound) {
    if (bound.kind < NotAbove || bound.kind > SignedBelow) return false;
    const bool isSigned = bound.kind >= SignedNotAbove;
    return keeps(bound.place, isSigned ? SignedAtMost : AtMost) &&
           keeps(bound.other, isSigned ? SignedAtLeast : AtLeast);
  });
}

/// Of two cells; what a stronger bound of the same two says already. Without a carry a sum stays so where one of its
/// parts never rises.
void RunBounds::Search::leaveOutWeakerOfTwo(std::vector<Bound>& bounds, const std::vector<Bound>& ofOne) {
  using enum Kind;
  const std::vector<Bound> given = bounds;
  const auto has = [&](const Bound& of, std::initializer_list<Kind> kinds) {
    return std::ranges::any_of(given, [&](const Bound& b) {
      return b.place == of.place && b.other == of.other && std::ranges::find(kinds, b.kind) != kinds.end();
    });
  };
  const auto neverRises = [&](const Place& place) {
    return std::ranges::any_of(
        ofOne, [&](const Bound& b) { return b.kind == AtMost && b.place == place && b.constants.empty(); });
  };
  std::erase_if(bounds, [&](const Bound& b) {
    switch (b.kind) {
      case Parts: return has(b, {Sum}) && (neverRises(b.place) || neverRises(b.other));
      case NotAbove:
      case Below: return has(b, {Behind});
      case SignedNotAbove:
      case SignedBelow: return has(b, {SignedBehind});
      default: return false;
    }
  });
}

/// Together: a state in which one run breaks some of them takes these out. What is not decided in time is not claimed.
void RunBounds::Search::prove(std::vector<Bound>& bounds, const std::vector<Bound>& given) {
  const EndsOf untilNow = [&](const Place& place) {
    const Cell& cell = cells_[at_.at(place)];
    return Ends{cell.before, cell.now};
  };
  while (!bounds.empty()) {
    std::vector<Node> conditions, kept;
    std::vector<std::size_t> keptBy;
    for (const std::vector<Bound>* held : {&given, static_cast<const std::vector<Bound>*>(&bounds)}) {
      for (const Bound& bound : *held) conditions.push_back(bound.holds(graph_, untilNow));
    }
    Graph::Bool isBroken = graph_.constant(false);
    for (const Run& run : runs_) {
      std::map<Place, Node> left;
      for (const auto& [index, after] : run) left.emplace(cells_[index].place, after);
      const EndsOf ends = [&](const Place& place) {
        const auto written = left.find(place);
        const Cell& cell = cells_[at_.at(place)];
        return Ends{cell.before, written == left.end() ? cell.now : written->second};
      };
      for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (!left.contains(bounds[i].place) && !(bounds[i].isOfTwo() && left.contains(bounds[i].other))) continue;
        kept.push_back(bounds[i].holds(graph_, ends));
        keptBy.push_back(i);
        isBroken = graph_.lor(isBroken, graph_.lnot({kept.back()}));
      }
    }
    conditions.push_back(isBroken.node);
    std::vector<std::uint64_t> values;
    const std::optional<bool> broken = graph_.truth(isBroken) == false
                                           ? false
                                           : satisfiable(graph_, conditions, proofLimit, kept, &values, proofSteps);
    if (broken == false) return;
    if (!broken || std::chrono::steady_clock::now() >= end_) return bounds.clear();
    std::set<std::size_t> refuted;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      if (values[k] == 0) refuted.insert(keptBy[k]);
    }
    std::size_t i = 0;
    std::erase_if(bounds, [&](const Bound&) { return refuted.contains(i++); });
  }
}

void RunBounds::find(Graph& graph, const std::vector<Cell>& cells, const std::vector<Run>& runs) {
  for (const Cell& cell : cells) {
    if (cell.isWritten) written_.insert(cell.place);
  }
  bounds_ = Search(graph, cells, runs).bounds();
  group();
}

void RunBounds::add(std::vector<StateRules> kept) {
  kept_ = std::move(kept);
  group();
}

void RunBounds::begin(const EntryValues& values) {
  entered_.assign(values.begin(), values.end());
  std::erase_if(entered_, [](const auto& entry) { return entry.second == ValueSet::any(entry.first.width); });
  group();
}

std::set<Place> RunBounds::placesOf(std::size_t number) const {
  std::set<Place> places;
  if (isOfEntry(number)) return {entered_[number - bounds_.size() - kept_.size()].first};
  if (number < bounds_.size()) {
    const Bound& bound = bounds_[number];
    places.insert(bound.place);
    if (bound.isOfTwo()) places.insert(bound.other);
    return places;
  }
  for (const StateRule& rule : kept_[number - bounds_.size()]) {
    const std::vector<Place> named = rule.places();
    places.insert(named.begin(), named.end());
  }
  return places;
}

Node RunBounds::holds(Graph& graph, std::size_t number, const EndsOf& ends,
                      const std::function<bool(Graph::Bool)>& isPossible) const {
  if (number < bounds_.size()) return bounds_[number].holds(graph, ends);
  if (isOfEntry(number)) {
    const auto& [place, values] = entered_[number - bounds_.size() - kept_.size()];
    return isIn(graph, ends(place).after, values).node;
  }
  const StateRules& rules = kept_[number - bounds_.size()];
  const Graph::Bool before = allHold(graph, rules, [&](const Place& place) { return ends(place).before; });
  const Graph::Bool after = allHold(graph, rules, [&](const Place& place) { return ends(place).after; });
  if (isPossible && placesOf(number).size() == 1 && !isPossible(graph.lnot(before))) return after.node;
  return graph.lor(graph.lnot(before), after).node;
}

/// Cells that a bound of two or a set of rules connects change together or not at all.
void RunBounds::group() {
  groupOf_.clear();
  groups_.clear();
  std::map<Place, Place> root;
  for (const Place& place : written_) root.emplace(place, place);
  const auto rootOf = [&](Place place) {
    while (root.at(place) != place) place = root.at(place);
    return place;
  };
  const auto writtenOf = [&](std::size_t number) {
    std::set<Place> places = placesOf(number);
    std::erase_if(places, [&](const Place& place) { return !written_.contains(place); });
    return places;
  };
  for (std::size_t i = 0; i < count(); ++i) {
    const std::set<Place> places = writtenOf(i);
    for (const Place& place : places) root.at(rootOf(place)) = rootOf(*places.begin());
  }
  std::map<Place, std::size_t> numbers;
  for (std::size_t i = 0; i < count(); ++i) {
    const std::set<Place> places = writtenOf(i);
    if (places.empty()) continue;
    const std::size_t number = numbers.try_emplace(rootOf(*places.begin()), numbers.size()).first->second;
    groups_.resize(numbers.size());
    groups_[number].push_back(i);
  }
  for (const auto& [place, parent] : root) {
    if (const auto number = numbers.find(rootOf(place)); number != numbers.end())
      groupOf_.emplace(place, number->second);
  }
}

Graph::Bool RunBounds::mayChange(Graph& graph, const Place& place, Change& change) const {
  const auto group = groupOf_.find(place);
  if (group == groupOf_.end()) return graph.constant(true);
  const auto [known, isNew] = change.known.try_emplace(group->second, graph.constant(true));
  if (!isNew) return known->second;
  for (const std::size_t i : groups_[group->second])
    known->second = graph.land(known->second, {holds(graph, i, change.ends, change.isPossible)});
  return known->second;
}

std::vector<Place> RunBounds::places() const {
  std::set<Place> places;
  for (std::size_t i = 0; i < count(); ++i) places.merge(placesOf(i));
  return {places.begin(), places.end()};
}

std::vector<Node> RunBounds::facts(Graph& graph, const std::vector<Cell>& cells, const std::vector<Run>& runs) const {
  std::vector<Node> facts;
  std::map<Place, std::size_t> at;
  for (std::size_t i = 0; i < cells.size(); ++i) at.emplace(cells[i].place, i);
  const auto cellOf = [&](const Place& place) -> const Cell& { return cells[at.at(place)]; };
  Graph::Bool areWithin = graph.constant(true);
  for (std::size_t i = 0; i < count(); ++i) {
    if (!isOfEntry(i))
      facts.push_back(holds(graph, i, [&](const Place& p) { return Ends{cellOf(p).before, cellOf(p).before}; }));
    areWithin = graph.land(areWithin, {holds(graph, i, [&](const Place& p) {
                             return Ends{cellOf(p).before, cellOf(p).now};
                           })});
  }
  for (const Run& run : runs) {
    std::map<Place, Node> left;
    for (const auto& [index, after] : run) left.emplace(cells[index].place, after);
    for (std::size_t i = 0; i < count(); ++i) {
      const std::set<Place> places = placesOf(i);
      if (std::ranges::none_of(places, [&](const Place& place) { return left.contains(place); })) continue;
      const Node after = holds(graph, i, [&](const Place& p) {
        const auto written = left.find(p);
        return Ends{cellOf(p).before, written == left.end() ? cellOf(p).now : written->second};
      });
      facts.push_back(graph.lor(graph.lnot(areWithin), {after}).node);
    }
  }
  return facts;
}

void RunBounds::forget(const Place& place) {
  written_.erase(place);
  std::erase_if(entered_, [&](const auto& entry) { return entry.first == place; });
  std::erase_if(bounds_, [&](const Bound& bound) { return bound.isAbout(place); });
  std::erase_if(kept_, [&](const StateRules& rules) {
    return std::ranges::any_of(rules, [&](const StateRule& rule) {
      const std::vector<Place> places = rule.places();
      return std::ranges::find(places, place) != places.end();
    });
  });
  group();
}

}  // namespace rungproof
