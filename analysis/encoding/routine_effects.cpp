// Routines on a state of free variables, one cell each.
#include "analysis/encoding/routine_effects.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <random>
#include <unordered_map>

#include "analysis/encoding/exact_reals.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/z3_terms.hpp"
#include "ir/s7200/scan.hpp"

namespace rungproof {

namespace {

constexpr std::size_t trialSteps = 3000;        ///< instructions of a routine, loops unrolled
constexpr int trialLoops = 40;                  ///< rounds of a loop
constexpr std::size_t mostRoutinesPaired = 12;  ///< more are not tried in both orders
constexpr std::size_t mostConstantsTried = 12;
/// Z3 looks at no clock while it takes conditions in, and that of one SCAT took it minutes.
constexpr std::size_t mostNodesTried = 20'000;
constexpr int samples = 300;                            ///< random states that weed out bounds
constexpr unsigned proofLimit = 400;                    ///< ms of one proof
constexpr std::chrono::milliseconds searchLimit{3000};  ///< for all proofs

bool isKeptAround(const Place& place) {
  if (place.isRegister) return place.reg == Reg::Accumulator || place.reg == Reg::Eno;
  return place.area == Area::L || (place.area == Area::SM && place.byte() == 1);
}

/// Proofs about REAL arithmetic come to no end: what it decides has no bounds.
bool usesReals(const Graph& graph, Node node) {
  return std::ranges::any_of(coneOf(graph, std::vector{node}), [&](Node n) { return isRealOperation(graph[n].op); });
}

}  // namespace

/// Runs of routines on one graph; each run has a memory of its own that begins with the same variables.
class RoutineEffects::Trial final : private CellSource, private Graph::Listener {
 public:
  using Runs = std::map<std::vector<int>, Decisions>;
  /// `runs`: what they are told is left there, or with Rewriting::None followed.
  Trial(const Plan& plan, const MemoryLayout& layout, Rewriting rewriting, Runs& runs)
      : graph(rewriting), plan_(plan), layout_(layout), runs_(runs) {
    graph.listen(this);
  }

  /// The memory after these routines ran one after the other.
  std::unique_ptr<Graph::Store> run(const std::vector<int>& routines, Node* halts = nullptr) {
    Decisions& decisions = runs_[routines];
    decisions.next = 0;
    if (!graph.isAsWritten()) decisions.made.clear();
    CellSource& source = *this;
    auto store = std::make_unique<Graph::Store>(graph, layout_, source, plan_);
    Machine<Graph> machine(graph, *store, plan_);
    graph.decideBy(&decisions);
    graph.decideUnder(&machine.guard);
    store->follow(&machine);
    // A queue may overflow between two runs: SM4.0 to SM4.2 change.
    store->observe([this, &written = *store](const Touch& touch) {
      const Place& p = touch.place;
      // What is written without a look at it needs a cell as well: another run may leave something else there.
      if (touch.isWrite && (p.isRegister || p.area != Area::L)) written.value(p);
      const bool isOverflow = !p.isRegister && p.area == Area::SM && p.byte() <= 4 && p.at + p.width > 4 * 8 + 5;
      readsOverflow = readsOverflow || (isOverflow && !touch.isWrite);
    });
    store_ = store.get();
    Hooks hooks{*this};
    Scan<Graph, Hooks> scan(machine, hooks, trialLoops, trialSteps);
    for (const int routine : routines) scan.interrupt(routine, graph.constant(true));
    if (halts != nullptr) *halts = machine.halted.node;
    if (graph.truthEverywhere(machine.halted) != false) mayHalt = true;
    graph.decideBy(nullptr);
    graph.decideUnder(nullptr);
    store->follow(nullptr);
    store->observe({});
    return store;
  }
  /// What stood there before the run.
  Node start(const Place& place) { return cellAt(place).start; }

  Graph graph;
  bool isComplete = true;
  bool mayHalt = false;
  bool readsOverflow = false;

 private:
  struct Hooks {
    Trial& trial;
    void before(Scan<Graph, Hooks>&, const FlowStep&) {}
    void callWithoutBody(Scan<Graph, Hooks>&, const Instruction&) { trial.isComplete = false; }
    void freshLocal(Scan<Graph, Hooks>&, std::uint32_t base, std::uint32_t byte) {
      trial.store_->forgetLocal(base, byte, 0);
    }
  };

  Cell cellAt(const Place& place) override {
    const auto [found, isNew] = cells_.try_emplace(place, noNode);
    if (isNew) found->second = graph.variable(nameOf(place), place.width, true);
    return {place, CellKind::State, found->second};
  }
  Node localByte(std::uint32_t, std::uint32_t) override { return graph.variable("local", 8, false); }
  Graph::Bits external(const ExternalSite&, int width) override { return {graph.variable("external", width, false)}; }
  void report(Hazard hazard, Graph::Bool, const Instruction*) override {
    if (hazard == Hazard::LoopBound) isComplete = false;
  }
  Graph::Bool targets(Machine<Graph>&, Graph::Bits, Width, Ref<Graph>&) override {
    isComplete = false;
    return graph.constant(false);
  }
  std::optional<std::vector<std::uint64_t>> locations(Machine<Graph>&, Graph::Bits) override { return std::nullopt; }
  std::optional<std::vector<std::uint64_t>> locationsInBlock(Machine<Graph>&, Graph::Bits, Width) override {
    return std::nullopt;
  }
  Graph::Bits unresolved(Machine<Graph>&, int width) override {
    isComplete = false;
    return {graph.variable("unresolved", width, false)};
  }
  void havoc(Machine<Graph>&) override { isComplete = false; }

  const Plan& plan_;
  const MemoryLayout& layout_;
  Runs& runs_;
  std::map<Place, Node> cells_;
  Graph::Store* store_ = nullptr;
};

Node RoutineEffects::Bound::holds(Graph& graph, Node before, Node after) const {
  const int w = graph[before].width;
  const auto isWithin = [&](Node limit) {
    switch (kind) {
      case Kind::AtLeast: return graph.ule({limit}, {after}, w);
      case Kind::AtMost: return graph.ule({after}, {limit}, w);
      case Kind::SignedAtLeast: return graph.sle({limit}, {after}, w);
      case Kind::SignedAtMost: return graph.sle({after}, {limit}, w);
      case Kind::OneOf: return graph.equal({after}, {limit}, w);
    }
    return graph.constant(true);
  };
  Graph::Bool result = isWithin(before);
  for (const std::uint64_t constant : constants) result = graph.lor(result, isWithin(graph.constantNode(constant, w)));
  return result.node;
}

Graph::Bool RoutineEffects::mayBecome(Graph& graph, const Place& place, Node before, Node after) const {
  Graph::Bool result = graph.constant(true);
  const auto found = bounds_.find(place);
  if (found == bounds_.end()) return result;
  for (const Bound& bound : found->second) result = graph.land(result, {bound.holds(graph, before, after)});
  return result;
}

RoutineEffects::RoutineEffects(const Plan& plan, const MemoryLayout& layout, const std::set<int>& routines,
                               bool isOfDevices)
    : isOnePassEnough_(!isOfDevices) {
  Trial trial(plan, layout, Rewriting::Full, runs_);
  const auto differ = [&](Graph::Store& a, Graph::Store& b) {
    std::set<Place> all;
    for (const Graph::Store* store : {&a, &b}) {
      for (const Cell& cell : store->cells()) all.insert(cell.place);
    }
    return std::ranges::any_of(
        all, [&](const Place& place) { return !isKeptAround(place) && a.value(place) != b.value(place); });
  };
  for (const int routine : routines) {
    trial.mayHalt = false;
    const auto once = trial.run({routine});
    if (trial.mayHalt) halting_.insert(routine);
    std::vector<Place>& written = written_[routine];
    const std::vector<Cell> cells = once->cells();
    for (const Cell& cell : cells) {
      if (!isKeptAround(cell.place) && once->value(cell.place) != cell.start) written.push_back(cell.place);
    }
    // Whether the other routine comes at all may depend on it.
    if (std::ranges::any_of(written, [](const Place& p) {
          const bool locks = p.reg == Reg::EventRoutine && isBlockEvent(static_cast<int>(p.at));
          return p.isRegister && (p.reg == Reg::DelayPeriod || locks);
        }))
      isOnePassEnough_ = false;
    std::ranges::sort(written);
    isOnePassEnough_ =
        isOnePassEnough_ && !trial.mayHalt && !trial.readsOverflow && !differ(*once, *trial.run({routine, routine}));
  }
  isOnePassEnough_ = isOnePassEnough_ && routines.size() <= mostRoutinesPaired;
  for (auto a = routines.begin(); a != routines.end() && isOnePassEnough_; ++a) {
    for (auto b = std::next(a); b != routines.end() && isOnePassEnough_; ++b)
      isOnePassEnough_ = !differ(*trial.run({*a, *b}), *trial.run({*b, *a}));
  }
  isComplete_ = trial.isComplete;
  isOnePassEnough_ = isOnePassEnough_ && isComplete_;
  if (!isOnePassEnough_ && isComplete_) findBounds(trial);
}

void RoutineEffects::findBounds(Trial& trial) {
  Graph& graph = trial.graph;
  struct Written {
    Place place;
    Node before, now;
    std::vector<Bound> bounds;
  };
  std::vector<Written> all;
  std::map<Place, std::size_t> at;
  for (const auto& [routine, places] : written_) {
    for (const Place& place : places) {
      if (!at.try_emplace(place, all.size()).second) continue;
      all.push_back({place, graph.variable("before " + nameOf(place), place.width, true), trial.start(place), {}});
    }
  }
  // One run of each routine from a state that has come about by some.
  std::vector<std::vector<std::pair<std::size_t, Node>>> runs;
  std::vector<Node> roots;
  for (const auto& [routine, places] : written_) {
    const auto store = trial.run({routine});
    auto& run = runs.emplace_back();
    for (const Place& place : places) {
      run.emplace_back(at.at(place), store->value(place));
      roots.push_back(run.back().second);
    }
  }
  const std::vector<Node> cone = coneOf(graph, roots);
  if (cone.size() > mostNodesTried) return;          // no bounds: what is written may become anything
  std::map<int, std::set<std::uint64_t>> constants;  // by width
  std::vector<Node> variables;
  for (const Node n : cone) {
    if (graph[n].op == Op::Variable) variables.push_back(n);
    if (graph[n].op == Op::Constant) constants[graph[n].width].insert(graph[n].value);
  }
  std::vector<bool> isOfReals(all.size(), false);
  for (const auto& run : runs) {
    for (const auto& [index, after] : run) isOfReals[index] = isOfReals[index] || usesReals(graph, after);
  }
  for (std::size_t index = 0; index < all.size(); ++index) {
    if (isOfReals[index]) continue;
    Written& w = all[index];
    const int width = w.place.width;
    std::vector<std::uint64_t> known(constants[width].begin(), constants[width].end());
    for (const std::uint64_t c : std::vector<std::uint64_t>(known)) known.push_back((c + 1) & Graph::maskOf(width));
    known.push_back(0);
    std::ranges::sort(known);
    known.erase(std::ranges::unique(known).begin(), known.end());
    if (known.size() > mostConstantsTried) known.resize(mostConstantsTried);
    using enum Bound::Kind;
    const std::vector<Bound::Kind> kinds =
        width == 1 ? std::vector{AtLeast, AtMost} : std::vector{AtLeast, AtMost, SignedAtLeast, SignedAtMost};
    for (const Bound::Kind kind : kinds) {
      w.bounds.push_back({kind, {}});
      for (const std::uint64_t c : known) {
        if (width > 1) w.bounds.push_back({kind, {c}});
      }
    }
    if (width > 1) w.bounds.push_back({OneOf, known});
  }
  // Nothing has happened before the first run: bounds that one run from there breaks are no bounds.
  std::mt19937_64 random(1);
  Evaluator evaluator(graph, roots);
  for (int sample = 0; sample < samples; ++sample) {
    for (const Node v : variables) {
      const int width = graph[v].width;
      std::uint64_t value = random();
      const auto& some = constants[width];
      if (random() % 2 == 0 && !some.empty())
        value = *std::next(some.begin(), static_cast<std::ptrdiff_t>(random() % some.size())) + random() % 3 - 1;
      evaluator.set(v, value & Graph::maskOf(width));
    }
    evaluator.run();
    for (const auto& run : runs) {
      for (const auto& [index, after] : run) {
        Written& w = all[index];
        const bool isRead = std::ranges::find(variables, w.now) != variables.end();
        const std::uint64_t unread = random() & Graph::maskOf(w.place.width);
        const Node from = graph.constantNode(isRead ? evaluator[w.now] : unread, w.place.width);
        const Node to = graph.constantNode(evaluator[after], w.place.width);
        std::erase_if(w.bounds, [&](const Bound& b) { return graph[b.holds(graph, from, to)].value == 0; });
      }
    }
  }
  // A bound without a constant says more than the same with one.
  for (Written& w : all) {
    const std::vector<Bound> given = w.bounds;
    std::erase_if(w.bounds, [&](const Bound& bound) {
      return !bound.constants.empty() && std::ranges::any_of(given, [&](const Bound& other) {
        return other.kind == bound.kind && other.constants.empty();
      });
    });
  }
  const auto end = std::chrono::steady_clock::now() + searchLimit;
  // Those that are left are proved together: a state in which one run breaks some of them takes these out.
  for (;;) {
    std::vector<Node> conditions, kept;
    for (const Written& w : all) {
      for (const Bound& bound : w.bounds) conditions.push_back(bound.holds(graph, w.before, w.now));
    }
    Graph::Bool isBroken = graph.constant(false);
    for (const auto& run : runs) {
      for (const auto& [index, after] : run) {
        for (const Bound& bound : all[index].bounds) {
          kept.push_back(bound.holds(graph, all[index].before, after));
          isBroken = graph.lor(isBroken, graph.lnot({kept.back()}));
        }
      }
    }
    conditions.push_back(isBroken.node);
    std::vector<std::uint64_t> values;
    const std::optional<bool> broken =
        graph.truth(isBroken) == false ? false : satisfiable(graph, conditions, proofLimit, kept, &values);
    if (broken == false) break;
    // What is not decided in time is not claimed.
    if (!broken || std::chrono::steady_clock::now() >= end) {
      for (Written& w : all) w.bounds.clear();
      break;
    }
    std::vector<std::set<std::size_t>> refuted(all.size());
    auto value = values.begin();
    for (const auto& run : runs) {
      for (const auto& [index, after] : run) {
        for (std::size_t i = 0; i < all[index].bounds.size(); ++i) {
          if (*value++ == 0) refuted[index].insert(i);
        }
      }
    }
    for (std::size_t index = 0; index < all.size(); ++index) {
      std::size_t i = 0;
      std::erase_if(all[index].bounds, [&](const Bound&) { return refuted[index].contains(i++); });
    }
  }
  for (Written& w : all) bounds_[w.place] = std::move(w.bounds);
}

std::vector<Node> RoutineEffects::facts(Trial& trial) const {
  Graph& graph = trial.graph;
  std::vector<Node> facts;
  const auto say = [&](Graph::Bool fact) { facts.push_back(fact.node); };
  const auto same = [&](Node a, Node b) { return graph.equal({a}, {b}, graph[a].width); };
  std::map<int, std::unique_ptr<Graph::Store>> once;
  for (const auto& [routine, places] : written_) {
    Node halts = noNode;
    Graph::Store& store = *once.emplace(routine, trial.run({routine}, &halts)).first->second;
    const std::vector<Cell> cells = store.cells();
    for (const Cell& cell : cells) {
      const Node after = store.value(cell.place);
      const bool isSaid = isKeptAround(cell.place) || std::ranges::binary_search(places, cell.place);
      if (!isSaid && after != cell.start) say(same(after, cell.start));
    }
    if (!halting_.contains(routine)) say(graph.lnot({halts}));
  }
  const auto agree = [&](Graph::Store& a, Graph::Store& b) {
    std::set<Place> all;
    for (const Graph::Store* store : {&a, &b}) {
      for (const Cell& cell : store->cells()) all.insert(cell.place);
    }
    for (const Place& place : all) {
      if (!isKeptAround(place)) say(same(a.value(place), b.value(place)));
    }
  };
  for (auto a = once.begin(); a != once.end() && isOnePassEnough_; ++a) {
    agree(*a->second, *trial.run({a->first, a->first}));
    for (auto b = std::next(a); b != once.end(); ++b)
      agree(*trial.run({a->first, b->first}), *trial.run({b->first, a->first}));
  }
  if (!isOnePassEnough_) {
    std::map<Place, Node> before;
    Graph::Bool areWithin = graph.constant(true);
    for (const auto& [place, bounds] : bounds_) {
      const Node from = graph.variable("before " + nameOf(place), place.width, false);
      before.emplace(place, from);
      for (const Bound& bound : bounds) {
        say({bound.holds(graph, from, from)});
        areWithin = graph.land(areWithin, {bound.holds(graph, from, trial.start(place))});
      }
    }
    for (const auto& [routine, store] : once) {
      for (const Place& place : written_.at(routine)) {
        const auto bounds = bounds_.find(place);
        if (bounds == bounds_.end()) continue;
        for (const Bound& bound : bounds->second)
          say(graph.lor(graph.lnot(areWithin), {bound.holds(graph, before.at(place), store->value(place))}));
      }
    }
  }
  for (const Graph::Decided& d : graph.decided()) {
    const int w = graph[d.node].width;
    const Graph::Bool fact = graph.equal({d.node}, graph.literal(d.value, w), w);
    say(d.guard == noNode ? fact : graph.lor(graph.lnot({d.guard}), fact));
  }
  if (!trial.isComplete || (isOnePassEnough_ && trial.readsOverflow)) say(graph.constant(false));
  return facts;
}

std::vector<Node> RoutineEffects::asFacts(Graph& graph, const Plan& plan, const MemoryLayout& layout) const {
  if (!isComplete_) return {};  // nothing is said of them
  Trial::Runs runs = runs_;
  Trial trial(plan, layout, Rewriting::None, runs);
  std::vector<Node> roots;
  try {
    roots = facts(trial);
  } catch (const DecisionsDiverge&) {
    return {graph.constantNode(0, 1)};
  }
  const Graph& from = trial.graph;
  std::unordered_map<std::uint32_t, Node> copies;
  for (const Node n : coneOf(from, roots)) {
    const NodeData& node = from[n];
    std::array<Node, 3> child = node.child;
    for (Node& c : child) c = c == noNode ? c : copies.at(indexOf(c));
    Node copy = noNode;
    if (node.op == Op::Constant)
      copy = graph.constantNode(node.value, node.width);
    else if (node.op == Op::Variable)
      copy = graph.variable("routine alone: " + from.variables()[node.value].name, node.width, false);
    else
      copy = graph.make(node.op, node.width, child[0], child[1], child[2], node.value);
    copies.emplace(indexOf(n), copy);
  }
  for (Node& root : roots) root = copies.at(indexOf(root));
  return roots;
}

void RoutineEffects::forget(const Place& place) {
  for (auto& [routine, places] : written_) std::erase(places, place);
  bounds_.erase(place);
}

}  // namespace rungproof
