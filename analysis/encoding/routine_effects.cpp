// Routines on a state of free variables, one cell each.
#include "analysis/encoding/routine_effects.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <unordered_map>

#include "analysis/encoding/exact_reals.hpp"
#include "analysis/encoding/kept_states.hpp"
#include "analysis/encoding/scan_encoding.hpp"
#include "analysis/encoding/seen_states.hpp"
#include "analysis/graph/evaluate.hpp"
#include "ir/families/run.hpp"

namespace rungproof {

namespace {

constexpr std::size_t trialSteps = 3000;        ///< instructions of a routine, loops unrolled
constexpr int trialLoops = 40;                  ///< rounds of a loop
constexpr std::size_t mostRoutinesPaired = 12;  ///< more are not tried in both orders
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

  const Program& program() const { return *plan_.program; }

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

RoutineEffects::RoutineEffects(const Plan& plan, const MemoryLayout& layout, const std::set<int>& routines,
                               bool isOfDevices, const std::vector<Expr>& statements)
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
  if (!isOnePassEnough_ && isComplete_) findBounds(trial, plan, layout, statements);
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
    for (const Node fact : bounds_.facts(graph, cells, runs)) facts.push_back(fact);
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
  bounds_.forget(place);
}

}  // namespace rungproof
