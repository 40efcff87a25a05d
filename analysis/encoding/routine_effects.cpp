// Routines on a state of free variables, one cell each.
#include "analysis/encoding/routine_effects.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <unordered_map>

#include "analysis/encoding/exact_reals.hpp"
#include "analysis/encoding/kept_states.hpp"
#include "analysis/encoding/pointer_targets.hpp"
#include "analysis/encoding/scan_encoding.hpp"
#include "analysis/encoding/seen_states.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/z3_terms.hpp"
#include "ir/families/run.hpp"

namespace rungproof {

namespace {

constexpr std::size_t trialSteps = 3000;        ///< instructions of a routine, loops unrolled
constexpr int trialLoops = 40;                  ///< rounds of a loop
constexpr std::size_t mostRoutinesPaired = 12;  ///< more are not tried in both orders
constexpr std::size_t mostTargets = 256;        ///< of a pointer
constexpr int closingRounds = 40;               ///< until values that still grow are given up
constexpr unsigned closingMs = 8000;            ///< of one proof, on a busy machine
constexpr unsigned closingSteps = 1'000'000;    ///< of one proof, as Z3 counts
constexpr int exactRounds = 6;                  ///< in which they grow one by one; then to the next constant
constexpr std::uint32_t lastSystemStatus = 5;   ///< byte of SM that the system may write at any time

bool isKeptAround(const Place& place) {
  if (place.isRegister) return place.reg == Reg::Accumulator || place.reg == Reg::Eno;
  return place.area == Area::L || (place.area == Area::SM && place.byte() == 1);
}

/// Memory that nothing but programs writes: what no routine writes is the same after all runs.
bool canStayBeside(const Place& place, const Program& program) {
  const bool isClock = place.area == Area::M && program.clockMemory && place.byte() == *program.clockMemory;
  return !place.isRegister && !isClock &&
         (place.area == Area::V || place.area == Area::M || place.area == Area::Q || place.area == Area::S ||
          place.area == Area::DB);
}

/// Memory that nothing but programs writes while routines run: of the special memory only what no event brings along.
bool isOfRules(const Place& place, const Program& program, const Footprint& ofDevices) {
  if (canStayBeside(place, program)) return true;
  Footprint own;
  addKeys(place, own.reads);
  const bool isSpecial = !place.isRegister && place.area == Area::SM && place.byte() > lastSystemStatus;
  return isSpecial && !ofDevices.conflictsWith(own);
}

/// Proofs about REAL arithmetic come to no end: what it decides has no bounds.
bool usesReals(const Graph& graph, Node node) {
  return std::ranges::any_of(coneOf(graph, std::vector{node}), [&](Node n) { return isRealOperation(graph[n].op); });
}

/// The next constant of the routines, or the end of the width, where values grow without an end in sight.
ValueSet grown(const Graph& graph, const ValueSet& before, const ValueSet& after, int width) {
  const std::uint64_t mask = Graph::maskOf(width);
  Graph::Facts facts = after.facts();
  std::set<std::uint64_t> stops{0, mask};
  for (std::uint32_t n = 0; n < graph.size(); ++n) {
    const NodeData& node = graph[static_cast<Node>(n)];
    if (node.op != Op::Constant) continue;
    for (const std::uint64_t stop : {node.value - 1, node.value, node.value + 1}) stops.insert(stop & mask);
  }
  if (facts.high > before.facts().high) facts.high = *stops.lower_bound(facts.high);
  if (facts.low < before.facts().low) facts.low = *std::prev(stops.upper_bound(facts.low));
  facts.zeros = ~mask;
  facts.ones = 0;
  return ValueSet::within(facts).listedIfFew(pointerValueLimit);
}

}  // namespace

/// Runs of routines on one graph; each run has a memory of its own that begins with the same variables.
class RoutineEffects::Trial final : private CellSource, private Graph::Listener {
 public:
  using Runs = std::map<std::vector<int>, Decisions>;
  /// `runs`: what they are told is left there, or with Rewriting::None followed. `entry`: nullptr: pointers are not
  /// followed.
  Trial(const Plan& plan, const MemoryLayout& layout, Rewriting rewriting, Runs& runs, const EntryValues* entry)
      : graph(rewriting), plan_(plan), layout_(layout), runs_(runs), entry_(entry) {
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
    store->observe([this, &machine, &written = *store](const Touch& touch) {
      const Place& p = touch.place;
      const bool isThroughPointer =
          machine.current != nullptr && std::ranges::any_of(machine.current->operands, [](const Operand& o) {
            return o.kind == OperandKind::Indirect;
          });
      if (touch.isWrite && isThroughPointer) behindPointers.insert(p);
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

  const Program& program() const { return *plan_.program; }
  ValueSet valuesWhere(Node node, Node guard) {
    return ValueEvaluator(graph, known_).valuesOf(node, guard, mostTargets);
  }
  /// That routines begin with the values that they are known to begin with.
  Graph::Bool beginsAsKnown() {
    Graph::Bool result = graph.constant(true);
    if (entry_ == nullptr) return result;
    for (const auto& [place, values] : *entry_) result = graph.land(result, isIn(graph, start(place), values));
    return result;
  }

  Graph graph;
  std::set<Place> pointerCells;        ///< that pointers are made of
  std::set<Place> behindPointers;      ///< that they can lead to
  std::vector<Graph::Bool> listFacts;  ///< as written: that lists of values are complete
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
    if (isNew) {
      const auto entry = entry_ == nullptr ? EntryValues::const_iterator() : entry_->find(place);
      const bool isKnown = entry_ != nullptr && entry != entry_->end();
      const int width = isKnown ? bitsFor(entry->second, place.width) : place.width;
      const Node variable = graph.variable(nameOf(place), width, true);
      found->second = graph.make(Op::Zext, place.width, variable);
      placeOf_.emplace(variable, place);
      if (isKnown) known_[variable] = entry->second;
    }
    return {place, CellKind::State, found->second};
  }
  Node localByte(std::uint32_t, std::uint32_t) override { return graph.variable("local", 8, false); }
  Graph::Bits external(const ExternalSite&, int width) override { return {graph.variable("external", width, false)}; }
  void report(Hazard hazard, Graph::Bool, const Instruction*) override {
    if (hazard == Hazard::LoopBound) isComplete = false;
  }
  /// All values that the pointer can have here; nothing if they are too many.
  std::optional<std::vector<std::uint64_t>> targetsOf(Node pointer, Node guard) {
    const auto values = graph.listed([&]() -> std::optional<std::vector<std::uint64_t>> {
      if (entry_ == nullptr) return std::nullopt;
      const ValueSet set = whereItLeads(pointer, guard);
      note(partsOf(graph, pointer));
      if (!set.isListed()) note(variablesOf(graph, pointer));
      return set.isListed() ? std::optional(set.values()) : std::nullopt;
    });
    if (!values)
      isComplete = false;
    else if (graph.isAsWritten())
      listFacts.push_back(graph.lor(graph.lnot({guard}), isAmong(graph, pointer, *values)));
    return values;
  }
  ValueSet whereItLeads(Node pointer, Node guard) {
    return listedOrBounded(graph, pointer, guard, mostTargets, [this](Node node, Node condition) {
      return ValueEvaluator(graph, known_).valuesByCase(node, condition, mostTargets);
    });
  }
  void note(const std::vector<Node>& parts) {
    for (const Node n : parts) {
      if (const auto place = placeOf_.find(n); place != placeOf_.end()) pointerCells.insert(place->second);
    }
  }
  Graph::Bool targets(Machine<Graph>& machine, Graph::Bits pointer, Width width, Ref<Graph>& ref) override {
    const auto values = targetsOf(pointer.node, machine.guard.node);
    if (!values) return graph.constant(false);
    return leadTo(graph, machine, pointer, width, *values, ref, [](std::uint32_t) {});
  }
  std::optional<std::vector<std::uint64_t>> locations(Machine<Graph>& machine, Graph::Bits location) override {
    return targetsOf(location.node, machine.guard.node);
  }
  std::optional<std::vector<std::uint64_t>> locationsInBlock(Machine<Graph>& machine, Graph::Bits location,
                                                             Width width) override {
    const auto start = graph.listed([&]() -> std::optional<std::vector<std::uint64_t>> {
      if (entry_ == nullptr) return std::nullopt;
      note(partsOf(graph, location.node));
      return startOfBlock(whereItLeads(location.node, machine.guard.node));
    });
    if (!start || start->empty()) return std::nullopt;
    Graph::Bool isInBlock{};
    auto places = placesInBlock(graph, plan_, location, start->front(), width, mostTargets, isInBlock);
    if (graph.isAsWritten()) listFacts.push_back(graph.lor(graph.lnot(machine.guard), isInBlock));
    return places;
  }
  Graph::Bits unresolved(Machine<Graph>&, int width) override {
    isComplete = false;
    return {graph.variable("unresolved", width, false)};
  }
  void havoc(Machine<Graph>&) override { isComplete = false; }

  const Plan& plan_;
  const MemoryLayout& layout_;
  Runs& runs_;
  const EntryValues* entry_;
  std::map<Place, Node> cells_;
  std::unordered_map<Node, Place> placeOf_;
  VariableValues known_;
  Graph::Store* store_ = nullptr;
};

/// Finds the cells that pointers are made of, and values that each run keeps: those that were seen, and what runs make
/// of them.
void RoutineEffects::closeEntry(const Plan& plan, const MemoryLayout& layout, const std::set<int>& routines) {
  std::vector<int> events;
  for (const auto& [event, attached] : attachmentsOf(plan)) events.push_back(event);
  bool isClosed = false;
  for (int round = 0; !isClosed; ++round) {
    isClosed = true;
    Trial::Runs runs;
    Trial trial(plan, layout, Rewriting::Full, runs, &entry_);
    std::set<Place> wanted;
    for (const int routine : routines) {
      const auto store = trial.run({routine});
      for (const Place& place : trial.pointerCells) {
        if (canStayBeside(place, trial.program()) && !entry_.contains(place)) wanted.insert(place);
      }
      std::vector<Node> after;
      Graph::Bool isKept = trial.graph.constant(true);
      for (const auto& [place, values] : entry_) {
        after.push_back(store->value(place));
        isKept = trial.graph.land(isKept, isIn(trial.graph, after.back(), values));
      }
      if (trial.graph.truth(isKept) == true) continue;
      std::vector<std::uint64_t> found;
      const std::vector<Node> conditions{trial.beginsAsKnown().node, trial.graph.lnot(isKept).node};
      const auto breaks = satisfiable(trial.graph, conditions, closingMs, after, &found, closingSteps);
      if (breaks == false) continue;
      isClosed = false;
      const bool isGivenUp = !breaks || round >= closingRounds;
      std::size_t i = 0;
      for (auto& [place, values] : entry_) {
        const ValueSet before = values;
        if (isGivenUp)
          values = ValueSet::any(place.width);
        else if (values.join(ValueSet::of(found[i]), mostTargets) && round >= exactRounds)
          values = grown(trial.graph, before, values, place.width);
        ++i;
      }
    }
    if (wanted.empty()) continue;
    isClosed = false;
    const std::vector<Place> places(wanted.begin(), wanted.end());
    for (const auto& state : seenStates(plan, events, places)) {
      for (const auto& [place, value] : state) entry_[place].join(ValueSet::of(value), mostTargets);
    }
    for (const Place& place : places) entry_.try_emplace(place, ValueSet::any(place.width));
  }
}

RoutineEffects::RoutineEffects(const Plan& plan, const MemoryLayout& layout, const Given& given)
    : isOnePassEnough_(!given.isOfDevices), entry_(given.entry) {
  const std::set<int>& routines = given.routines;
  if (given.followsPointers) closeEntry(plan, layout, routines);
  Trial trial(plan, layout, Rewriting::Full, runs_, given.followsPointers ? &entry_ : nullptr);
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
  if (!isOnePassEnough_ && isComplete_) findBounds(trial, plan, layout, given.statements);
  if (isComplete_)
    bounds_.begin(entry_);
  else
    entry_.clear();
}

void RoutineEffects::findBounds(Trial& trial, const Plan& plan, const MemoryLayout& layout,
                                const std::vector<Expr>& statements) {
  Graph& graph = trial.graph;
  std::vector<RunBounds::Cell> cells;
  std::map<Place, std::size_t> at;
  const auto add = [&](const Place& place, bool isWritten) {
    if (!at.try_emplace(place, cells.size()).second) return;
    const Node now = trial.start(place);
    const Node before = isWritten ? graph.variable("before " + nameOf(place), place.width, true) : now;
    cells.push_back({place, before, now, isWritten});
  };
  for (const auto& [routine, places] : written_) {
    for (const Place& place : places) add(place, true);
  }
  // One run of each routine from a state that has come about by some.
  std::vector<RunBounds::Run> runs;
  for (const auto& [routine, places] : written_) {
    const auto store = trial.run({routine});
    RunBounds::Run& run = runs.emplace_back();
    for (const Place& place : places) {
      run.emplace_back(at.at(place), store->value(place));
      RunBounds::Cell& cell = cells[run.back().first];
      cell.isBehindPointer = trial.behindPointers.contains(place);
      cell.isOfReals = cell.isOfReals || usesReals(graph, run.back().second);
    }
    for (const Cell& cell : store->cells()) {
      if (canStayBeside(cell.place, trial.program())) add(cell.place, false);
    }
  }
  RuleHints hints;
  std::vector<Node> roots;
  for (const RunBounds::Run& run : runs) {
    for (const auto& [index, after] : run) roots.push_back(after);
  }
  const auto addConstant = [&](std::uint64_t value, int width) {
    if (width > 1) hints.constants[width].insert(value & Graph::maskOf(width));
  };
  for (const Node n : coneOf(graph, roots)) {
    if (graph[n].op == Op::Constant) addConstant(graph[n].value, graph[n].width);
  }
  for (const Expr& statement : statements) {
    auto said = SaidOfMemory::of(statement, layout);
    if (said == nullptr) continue;
    for (const Place& place : said->places()) {
      if (canStayBeside(place, trial.program())) add(place, false);
    }
    for (const ExprNode& n : statement.nodes) {
      if (n.op != ExprOp::Constant) continue;
      for (const int width : {8, 16, 32}) addConstant(static_cast<std::uint64_t>(n.value), width);
    }
    hints.said.push_back(std::move(said));
  }
  bounds_.find(graph, cells, runs);
  std::vector<Place> places;
  std::vector<int> events;
  Footprint ofDevices;
  for (const auto& [event, attached] : attachmentsOf(plan)) {
    events.push_back(event);
    addCauseKeys(event, ofDevices);
  }
  std::vector<RunBounds::Cell> ofRules;
  std::vector<std::size_t> number(cells.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!isOfRules(cells[i].place, trial.program(), ofDevices)) continue;
    number[i] = ofRules.size();
    ofRules.push_back(cells[i]);
    places.push_back(cells[i].place);
  }
  for (RunBounds::Run& run : runs) {
    std::erase_if(run, [&](const auto& left) { return number[left.first] == cells.size(); });
    for (auto& [index, after] : run) index = number[index];
  }
  hints.seen = seenStates(plan, events, places);
  bounds_.add(keptStates(graph, ofRules, runs, hints));
}

std::vector<Node> RoutineEffects::facts(Trial& trial) const {
  Graph& graph = trial.graph;
  std::vector<Node> facts;
  const Graph::Bool isElsewhere = graph.lnot(trial.beginsAsKnown());
  const auto say = [&](Graph::Bool fact) { facts.push_back(graph.lor(isElsewhere, fact).node); };
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
  if (!isOnePassEnough_ || !entry_.empty()) {
    std::set<Place> all;
    for (const auto& [routine, places] : written_) all.insert(places.begin(), places.end());
    std::vector<RunBounds::Cell> cells;
    std::map<Place, std::size_t> at;
    for (const Place& place : bounds_.places()) {
      const Node now = trial.start(place);
      const bool isWritten = all.contains(place);
      at.emplace(place, cells.size());
      cells.push_back(
          {place, isWritten ? graph.variable("before " + nameOf(place), place.width, false) : now, now, isWritten});
    }
    std::vector<RunBounds::Run> runs;
    for (const auto& [routine, store] : once) {
      RunBounds::Run& run = runs.emplace_back();
      for (const Place& place : written_.at(routine)) {
        if (at.contains(place)) run.emplace_back(at.at(place), store->value(place));
      }
    }
    for (const Node fact : bounds_.facts(graph, cells, runs)) say({fact});
  }
  for (const Graph::Bool fact : trial.listFacts) say(fact);
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
  Trial trial(plan, layout, Rewriting::None, runs, &entry_);
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
  entry_.erase(place);
  for (auto& [routine, places] : written_) std::erase(places, place);
  bounds_.forget(place);
}

}  // namespace rungproof
