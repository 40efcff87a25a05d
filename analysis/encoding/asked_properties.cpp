// Builds monitors into the transition system.
#include "analysis/encoding/asked_properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "analysis/encoding/monitor.hpp"
#include "analysis/encoding/state_rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

void addObserved(const Property& property, EncoderOptions& options) {
  for (const Operand* operand : addressesOf(property)) options.observed.push_back(*operand);
}

constexpr const char* realReason = "the result of its REAL operation is taken as any value";

/// Whether the operand begins with a module's word at `index`.
bool beginsAt(const Operand& operand, std::uint32_t index) {
  return (operand.area == Area::AI || operand.area == Area::PI) && operand.offset == index;
}

}  // namespace

struct AskedProperties::Leaf {
  AskedProperties& owner;
  Graph::Bits operator()(const Operand& operand, int width) { return {owner.leaf(operand, width)}; }
};

AskedProperties::AskedProperties(const Program& program, const PropertySet& set, const std::vector<Property>& goals,
                                 EncoderOptions options, ExecutionRecord* record) {
  for (const Property& property : goals) {
    addObserved(property, options);
    for (Expr& said : statementsIn(property)) options.statements.push_back(std::move(said));
  }
  std::vector<const Property*> everyInstruction;
  for (const Property& property : goals) {
    if (!property.atEveryInstruction) continue;
    everyInstruction.push_back(&property);
    for (const Operand* operand : addressesOf(property)) options.watched.push_back(*operand);
  }
  for (const Property& property : set.properties) {
    if (!property.isGoal()) addObserved(property, options);
  }
  for (const ExternalRange& range : set.externals) {
    const std::uint32_t last = range.last.offset + static_cast<std::uint32_t>(bytes(range.last.width)) - 1;
    const bool areBits = range.first.width == Width::Bit;
    options.externals.push_back({range.first.area, range.first.offset, last,
                                 static_cast<std::uint8_t>(areBits ? range.first.bit : 0),
                                 static_cast<std::uint8_t>(areBits ? range.last.bit : 7)});
  }
  options.initialRetentive = options.initialRetentive || set.initialRetentive;

  // Properties over single instructions look at the machine as it is there; their edges and cells are of scan ends.
  std::vector<Node> badSoFar(everyInstruction.size(), noNode);
  const Instruction* last = nullptr;
  std::vector<std::pair<const Instruction*, std::size_t>>
      ends;  // nodes that each instruction had made when the next one began
  const auto listener = std::move(options.atInstruction);
  options.atInstruction = [&](Machine<Graph>& machine, const Instruction& instruction) {
    if (listener) listener(machine, instruction);
    Graph& graph = machine.d;
    ends.emplace_back(last, graph.size());
    last = &instruction;
    if (record != nullptr) record->at(machine, instruction);
    for (std::size_t i = 0; i < everyInstruction.size(); ++i) {
      const auto here = [&](const Operand& o, int width) -> Graph::Bits {
        return machine.load(o.area, o.offset, widthOfBits(width), o.bit);
      };
      std::vector<Graph::Bits> none(everyInstruction[i]->cells.size(), graph.literal(0, 1)), ignored = none;
      const Moment<Graph> moment{machine.getBit(Reg::FirstScan), graph.literal(0, 1), 1};
      const Graph::Bool bad =
          Monitor<Graph, decltype(here)>(graph, *everyInstruction[i], here, moment, none, ignored).evaluate();
      const Graph::Bool now = graph.land(machine.guard, bad);
      badSoFar[i] = badSoFar[i] == noNode ? now.node : graph.lor({badSoFar[i]}, now).node;
    }
  };

  encoding_ = std::make_unique<EncodedScan>(program, options);
  ends.emplace_back(last, encoding_->graph().size());
  for (std::size_t i = 1; i < ends.size(); ++i) approximateReals(ends[i].first, ends[i - 1].second, ends[i].second);
  const std::size_t ofProgram = encoding_->graph().size();
  chooseTimeBases(set, goals);
  std::size_t next = 0;
  for (const Property& property : goals) {
    goals_.push_back({inItsBase(property), noNode, {}});
    addMonitor(goals_.back());
    goals_.back().answer = atScanEnd(goals_.back().answer);
    if (property.atEveryInstruction) {
      const Node within = badSoFar[next++];
      if (within != noNode) goals_.back().answer = encoding_->graph().lor({goals_.back().answer}, {within}).node;
    }
  }
  for (const Property& property : set.properties) {
    if (property.isGoal()) continue;
    assumptions_.push_back({inItsBase(property), noNode, {}});
    addMonitor(assumptions_.back());
    assumeOfEachRead(assumptions_.back());
    assumptions_.back().answer = encoding_->graph().lor({assumptions_.back().answer}, {encoding_->faulted()}).node;
  }
  approximateReals(nullptr, ofProgram, encoding_->graph().size());
  // Last: cells that only a property asks for have had their carriers added now.
  approximations_.insert(approximations_.begin(), encoding_->approximations().begin(),
                         encoding_->approximations().end());
}

/// What is assumed of an analog input holds at each read of it, and not only at the last. What is remembered from scan
/// to scan is asked of the last.
void AskedProperties::assumeOfEachRead(AskedProperty& assumed) {
  if (!assumed.property.cells.empty()) return;
  Graph& graph = encoding_->graph();
  const std::vector<const Operand*> named = addressesOf(assumed.property);
  std::vector<Graph::Bits> none, ignored;
  const Moment<Graph> moment{{encoding_->firstScan()}, graph.literal(0, 1), 1};
  const std::vector<ExternalInput> externals = encoding_->externals();
  for (std::size_t i = 0; i < externals.size(); ++i) {
    const ExternalInput& read = externals[i];
    const std::uint32_t index = read.site.index;
    const auto isRead = [&](const Operand* operand) { return beginsAt(*operand, index); };
    if (read.site.kind != External::AnalogInput || read.node == noNode || std::ranges::none_of(named, isRead)) continue;
    const auto then = [&](const Operand& o, int width) -> Graph::Bits {
      if (!beginsAt(o, index)) return {leaf(o, width)};
      if (width == 16) return {read.node};
      if (width == 8) return graph.extract({read.node}, 15, 8);
      // The second word of a double word is read with the first.
      const bool isPair =
          i + 1 < externals.size() && externals[i + 1].node != noNode && externals[i + 1].site.kind == read.site.kind &&
          externals[i + 1].site.instruction == read.site.instruction && externals[i + 1].site.index == index + 2;
      const Node second = isPair ? externals[i + 1].node : leaf(direct(o.area, Width::Word, index + 2), 16);
      return graph.concat({read.node}, 16, {second}, 16);
    };
    const Graph::Bool holds =
        Monitor<Graph, decltype(then)>(graph, assumed.property, then, moment, none, ignored).evaluate();
    assumed.answer = graph.land({assumed.answer}, graph.lor(graph.lnot({read.guard}), holds)).node;
  }
}

/// REAL operations among the nodes from `first` to `end`, made by that instruction.
void AskedProperties::approximateReals(const Instruction* place, std::size_t first, std::size_t end) {
  const Graph& graph = encoding_->graph();
  std::vector<Node> operations;
  for (std::size_t i = first; i < end; ++i) {
    const Op op = graph[static_cast<Node>(i)].op;
    if (isRealOperation(op) && !isRealComparison(op)) operations.push_back(static_cast<Node>(i));
  }
  if (operations.empty()) return;
  const auto known = std::find_if(approximations_.begin(), approximations_.end(),
                                  [&](const Approximation& a) { return a.place == place && a.reason == realReason; });
  if (known != approximations_.end())
    known->carriers.insert(known->carriers.end(), operations.begin(), operations.end());
  else
    approximations_.push_back(
        {place, place == nullptr ? "a REAL operation in a property: its result is taken as any value" : realReason,
         std::move(operations)});
}

/// Clocks count in the finest base of the timers that their property depends on.
void AskedProperties::chooseTimeBases(const PropertySet& set, const std::vector<Property>& goals) {
  std::vector<const Property*> timed;
  for (const std::vector<Property>* list : {&goals, &set.properties}) {
    for (const Property& property : *list) {
      if (hasClock(property)) timed.push_back(&property);
    }
  }
  if (timed.empty()) return;
  const Graph& graph = encoding_->graph();
  const auto leavesOf = [&](const Property& property) {
    std::vector<Node> leaves;
    for (const Expr* expr : {&property.first, &property.second}) {
      for (const ExprNode& n : expr->nodes) {
        if (n.op == ExprOp::Address)
          leaves.push_back(leaf(n.operand, n.type == ExprType::Truth ? 1 : numberBits(n.operand)));
      }
    }
    return leaves;
  };
  for (const Property* property : timed)
    leavesOf(*property);  // all are touched before the next-state functions are read
  const std::shared_ptr<Trail>& trail = encoding_->options().trail;
  if (trail && trail->isFollowed) {
    timeBases_ = trail->timeBases;
    return;
  }
  std::unordered_map<std::uint32_t, Node> next;
  for (const StateVariable& state : encoding_->system().states) next[indexOf(state.node)] = state.next;
  std::unordered_map<std::uint32_t, int> resolution;
  for (const Cell& cell : encoding_->cells()) {
    if (cell.place.isRegister && cell.place.reg == Reg::TimerCurrent)
      resolution[indexOf(cell.start)] = timerResolution(static_cast<int>(cell.place.at));
  }
  for (const Property* property : timed) {
    int finest = 0;
    std::vector<Node> open = leavesOf(*property);
    std::unordered_set<std::uint32_t> seen;
    while (!open.empty()) {
      const Node n = open.back();
      open.pop_back();
      if (n == noNode || !seen.insert(indexOf(n)).second) continue;
      if (const auto timer = resolution.find(indexOf(n)); timer != resolution.end())
        finest = finest == 0 ? timer->second : std::min(finest, timer->second);
      if (const auto state = next.find(indexOf(n)); state != next.end()) open.push_back(state->second);
      if (graph[n].op == Op::Variable) continue;
      for (const Node child : graph[n].child) open.push_back(child);
    }
    timeBases_[property->name] = std::max(finest, 1);
  }
  if (trail) trail->timeBases = timeBases_;
}

Property AskedProperties::inItsBase(const Property& property) const {
  Property result = property;
  if (const auto base = timeBases_.find(property.name); base != timeBases_.end()) {
    result.timeBase = base->second;
    layoutCells(result);
  }
  return result;
}

Node AskedProperties::leaf(const Operand& operand, int width) {
  Operand address = operand;
  if (width != 1 || !hasBitAndWord(operand.area)) address.width = widthOfBits(width);
  return encoding_->atEnd(address, width);
}

void AskedProperties::addMonitor(AskedProperty& asked) {
  Graph& graph = encoding_->graph();
  std::vector<Graph::Bits> before, after;
  for (const MonitorCell& cell : asked.property.cells) before.push_back({graph.variable(cell.name, cell.width, true)});
  after = before;
  Leaf look{*this};
  TimeModel& time = encoding_->time();
  const int base = asked.property.timeBase;
  const Node ticks = time.ticksWithin(base);
  Node digits = noNode;
  if (base > 1) {
    const auto wide = [&](Node n) { return graph.make(Op::Zext, 8, n); };
    digits = wide(time.onesNow());
    if (base == 100)
      digits = graph.make(Op::Add, 8, graph.make(Op::Mul, 8, wide(time.tensNow()), graph.constantNode(10, 8)), digits);
  }
  const Moment<Graph> moment{{encoding_->firstScan()}, {ticks}, graph[ticks].width, {digits}};
  asked.answer = Monitor<Graph, Leaf>(graph, asked.property, look, moment, before, after).evaluate().node;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const MonitorCell& cell = asked.property.cells[i];
    cells_.push_back({before[i].node, graph.constantNode(0, cell.width), after[i].node});
    if (cell.width > 1 && cell.name.find(".time") != std::string::npos) timeCells_.push_back(before[i].node);
    asked.state.before.push_back(before[i].node);
    asked.state.after.push_back(after[i].node);
  }
}

/// A scan that a fatal error ends has no end.
Node AskedProperties::atScanEnd(Node condition) {
  Graph& graph = encoding_->graph();
  return graph.land({condition}, graph.lnot({encoding_->faulted()})).node;
}

Node AskedProperties::before(std::string name, Node value) {
  Graph& graph = encoding_->graph();
  const int width = graph[value].width;
  const Node cell = graph.variable(std::move(name), width, true);
  cells_.push_back({cell, graph.constantNode(0, width), value});
  return cell;
}

TransitionSystem AskedProperties::system() {
  TransitionSystem result = encoding_->system();
  result.states.insert(result.states.end(), cells_.begin(), cells_.end());
  for (const AskedProperty& assumption : assumptions_) result.constraints.push_back(assumption.answer);
  result.questions.clear();
  for (const AskedProperty& goal : goals_) result.questions.push_back({goal.property.name, goal.answer});
  result.questions.insert(result.questions.end(), extra_.begin(), extra_.end());
  return result;
}

bool AskedProperties::isTimeState(Node variable) const {
  if (std::find(timeCells_.begin(), timeCells_.end(), variable) != timeCells_.end()) return true;
  for (const StateVariable& state : encoding_->time().states()) {
    if (state.node == variable) return true;
  }
  for (const Cell& cell : encoding_->cells()) {
    if (cell.start != variable) continue;
    if (cell.place.isRegister) {
      const Reg reg = cell.place.reg;
      return reg == Reg::TimerCurrent || reg == Reg::S5Rest || reg == Reg::LastScan || reg == Reg::PhaseTen ||
             reg == Reg::PhaseHundred || reg == Reg::PhaseSecond || reg == Reg::PhaseMinute;
    }
    return cell.place.area == Area::SM && cell.place.byte() == 0;
  }
  return false;
}

std::optional<Property> premiseOf(const Property& property) {
  Property premise;
  premise.kind = PropertyKind::Reach;
  premise.name = property.name + " (premise)";
  premise.span = property.span;
  switch (property.kind) {
    case PropertyKind::Always: {
      const ExprNode& root = property.first.root();
      if (root.op != ExprOp::Implies) return std::nullopt;
      premise.first.nodes.assign(property.first.nodes.begin(), property.first.nodes.begin() + root.args[0] + 1);
      break;
    }
    case PropertyKind::LeadsToScans:
    case PropertyKind::LeadsToTime:
    case PropertyKind::OnlyAfter:
    case PropertyKind::Unless: premise.first = property.first; break;
    case PropertyKind::HeldImplies: {
      premise.first = property.first;
      ExprNode held;
      held.op = ExprOp::Held;
      held.milliseconds = property.bound;
      held.args = {static_cast<std::uint32_t>(premise.first.nodes.size() - 1)};
      premise.first.nodes.push_back(held);
      break;
    }
    default: return std::nullopt;
  }
  premise.atEveryInstruction = property.atEveryInstruction;
  premise.text = premise.first.text =
      property.kind == PropertyKind::Always ? property.first.premise : property.first.text;
  layoutCells(premise);
  return premise;
}

}  // namespace rungproof
