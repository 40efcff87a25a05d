// Builds the system of both programs in OLD's graph.
#include "analysis/equivalence/product.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/encoding/monitor.hpp"
#include "analysis/graph/evaluate.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// What both programs find alike whatever they do: how the CPU reads its open points, and the phases of its clocks.
/// `hasClocks`: both have clock memory.
bool isOfTheCpu(Reg reg, bool hasClocks) {
  return reg == Reg::Reading || reg == Reg::PhaseSecond || reg == Reg::PhaseMinute ||
         (hasClocks && reg == Reg::ClockPhase);
}
bool isEdge(Reg reg) { return reg == Reg::EdgeMemory || reg == Reg::EdgeSeen; }
bool isOfTimer(Reg reg) {
  return reg == Reg::TimerCurrent || reg == Reg::TimerBit || reg == Reg::TimerRunning || reg == Reg::TimerPreset ||
         reg == Reg::TimerInput || reg == Reg::S5Rest || reg == Reg::S5Base || reg == Reg::S5AtEnd ||
         reg == Reg::S5Free;
}
bool isOfCounter(Reg reg) {
  return reg == Reg::CounterCurrent || reg == Reg::CounterBit || reg == Reg::CounterUp || reg == Reg::CounterDown ||
         reg == Reg::S7Set || reg == Reg::S7Free;
}
bool isOfFastCounter(Reg reg) {
  return reg == Reg::HscCurrent || reg == Reg::HscPreset || reg == Reg::HscMode || reg == Reg::HscEnabled ||
         reg == Reg::HscUp || reg == Reg::HscSetup;
}
bool isOfPulses(Reg reg) { return reg >= Reg::PulseBusy && reg <= Reg::PulseNextIsMs; }
/// The profile table of a pulse train stands in V memory where SMW168 and SMW178 say (001:4596).
bool isPulseTableAddress(const Place& place) {
  if (place.isRegister || place.area != Area::SM) return false;
  for (std::uint32_t output = 0; output < pulseOutputCount; ++output) {
    if (place.byte() == profileWord(output) || place.byte() == profileWord(output) + 1) return true;
  }
  return false;
}
/// The area whose addresses number a register; nothing for registers that no address names.
std::optional<Area> areaOfRegister(Reg reg) {
  if (isOfTimer(reg)) return Area::T;
  if (isOfCounter(reg)) return Area::C;
  if (isOfFastCounter(reg)) return Area::HC;
  if (reg == Reg::Accumulator) return Area::AC;
  if (reg == Reg::PhysicalInput) return Area::I;
  return std::nullopt;
}

/// The places of a program that shape its state, so that the other one cuts its memory in the same way.
void observe(EncoderOptions& options, const Program& program, const AddressPairs* pairs) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (const Operand& operand : instruction.operands) {
          const bool isShaping =
              operand.kind == OperandKind::Direct && !isWholeValue(operand.area) && operand.area != Area::L;
          if (!isShaping) continue;
          const std::optional<Operand> there = pairs == nullptr ? operand : pairs->before(operand);
          if (there) options.observed.push_back(*there);
        }
      }
    }
  }
}

EncoderOptions shaped(EncoderOptions options, const Program& own, const Program& other, const AddressPairs* pairs,
                      std::shared_ptr<Trail> trail, RequestRecord& requests) {
  observe(options, other, pairs);
  observeRequests(options, own);
  observeRequests(options, other);
  options.trail = std::move(trail);
  options.atInstruction = [&requests](Machine<Graph>& machine, const Instruction& instruction) {
    requests.at(machine, instruction);
  };
  return options;
}

Place observedPlace(const ComparedRange& range) {
  const Address& address = range.first;
  if (range.bits > 1) return memoryPlace(address.area, address.index / 8, widthOfBits(static_cast<int>(range.bits)));
  if (address.area == Area::T) return registerPlace(Reg::TimerBit, address.index);
  if (address.area == Area::C) return registerPlace(Reg::CounterBit, address.index);
  return bitPlace(address);
}
}  // namespace

std::string nameOfBit(const Address& address) { return nameOf(observedPlace({address})); }

ProgramProduct::ProgramProduct(const Side& before, const Side& after, const ProgramMatch& match,
                               const ProductOptions& options)
    : options_(options),
      match_(match),
      old_(*before.program, before.set, {},
           shaped(options.encoder, *before.program, *after.program, &options.pairs, options.trailBefore, oldRequests_)),
      new_(*after.program, after.set, {},
           shaped(options.encoder, *after.program, *before.program, nullptr, options.trailAfter, newRequests_)),
      relations_(old_.encoding(), new_.encoding()) {
  isSame_ = isSameProgram(before, after);
  for (const NetworkPair& pair : match_.networks) {
    if (!pair.isSame || !pair.after) continue;
    for (const Instruction& instruction :
         after.program->pous[pair.after->pou].networks[pair.after->network].instructions)
      sameInstructions_.insert(instruction.id);
  }
  pulseForms_ = {pulseForm(before.program->target), pulseForm(after.program->target)};
  for (const Cell& cell : old_.encoding().cells()) {
    for (std::uint32_t i = 0; !cell.place.isRegister && i < cell.place.width; ++i) {
      const Address bit = bitOf(cell.place, i);
      oldBits_.emplace(bit.area, bit.index);
    }
  }
  collectOutputs();
  addPulses();
  findClocks();
  firstScan_ = old_.encoding().firstScan();
  oldRuns_ = old_.encoding().atEnd(registerPlace(Reg::Running, 0));
  newRuns_ = new_.encoding().atEnd(registerPlace(Reg::Running, 0));
  for (const Property& assumption : options_.assumptions) {
    for (const Expr* expr : {&assumption.first, &assumption.second}) {
      for (const ExprNode& n : expr->nodes) {
        if (n.op == ExprOp::Address)
          assumedLeaf(nullptr, n.operand, n.type == ExprType::Truth ? 1 : numberBits(n.operand));
      }
    }
  }
  for (const std::uint32_t port : usedPorts()) {
    for (AskedProperties* side : {&old_, &new_}) {
      if (side->encoding().holds(portPlace(port))) side->encoding().atEnd(portPlace(port));
    }
  }
  newSystem_ = new_.system();
  for (const KeptCell& cell : new_.encoding().keptCells()) kept_.insert(cell.node);
  findPartners();
  SideCopy touched(old_.encoding().graph(), new_.encoding().graph(), "");
  replaceCells(touched);  // OLD gets all inputs that NEW reads before its system is taken
  if (options_.steadyInputs) {
    for (AskedProperties* side : {&old_, &new_}) {
      for (const ExternalInput& e : side->encoding().externals()) {
        if (e.site.kind != External::ImmediateInput) continue;
        const Address address{Area::I, e.site.index};
        const auto before = side == &old_ ? std::optional(address) : options_.pairs.before(address);
        if (before) old_.encoding().atStart(bitPlace(*before));
      }
    }
  }
  oldSystem_ = old_.system();
  for (AskedProperties* side : {&old_, &new_}) side->encoding().graph().decideBy(nullptr);
}

std::vector<std::string> ProgramProduct::newStateNames() const {
  std::vector<std::string> names;
  const Graph& graph = *newSystem_.graph;
  for (const StateVariable& state : newSystem_.states)
    names.push_back(kept_.contains(state.node) ? "" : graph.variables()[graph[state.node].value].name);
  return names;
}

void ProgramProduct::addOutput(std::set<std::pair<Area, std::uint32_t>>& known, const Address& before) {
  const ComparedRange range = options_.pairs.comparedFrom(before);
  if (!known.emplace(range.first.area, range.first.index).second) return;
  Output& output = outputs_.emplace_back();
  output.before = range.first;
  output.bits = range.bits;
  output.oldValue = old_.encoding().atEnd(observedPlace(range));
  output.after = options_.pairs.after(range.first);
  if (!output.after) return;
  const Place after = observedPlace({*output.after, range.bits});
  if (new_.encoding().holds(after)) output.newValue = new_.encoding().atEnd(after);
}

/// Outputs of OLD and what stands for them in NEW; then outputs of NEW without partner.
void ProgramProduct::collectOutputs() {
  std::set<std::pair<Area, std::uint32_t>> known;
  if (!options_.observed.empty()) {
    for (const Operand& operand : options_.observed) {
      const Address first = addressOf(operand);
      for (std::uint32_t i = 0; i < extentOf(operand); ++i) addOutput(known, {first.area, first.index + i});
    }
    return;
  }
  for (const ComparedRange& range : options_.pairs.comparedToo()) {
    for (std::uint32_t i = 0; i < range.bits; ++i) addOutput(known, {range.first.area, range.first.index + i});
  }
  const auto bitsOf = [](EncodedScan& encoding) {
    std::vector<Address> found;
    for (const Place& place : encoding.places()) {
      if (place.isRegister || !isOutputArea(place.area)) continue;
      for (std::uint32_t i = 0; i < place.width; ++i) found.push_back(bitOf(place, i));
    }
    std::ranges::sort(found, {}, [](const Address& a) { return std::pair(a.area, a.index); });
    return found;
  };
  for (const Address& address : bitsOf(old_.encoding())) addOutput(known, address);
  std::set<std::pair<Area, std::uint32_t>> alone;
  for (const Address& address : bitsOf(new_.encoding())) {
    const std::optional<Address> before = options_.pairs.before(address);
    if (before && old_.encoding().holds(bitPlace(*before))) {
      addOutput(known, *before);
      continue;
    }
    const ComparedRange range = options_.pairs.comparedAlone(address);
    if (!alone.emplace(range.first.area, range.first.index).second) continue;
    outputs_.push_back(
        {std::nullopt, range.first, noNode, new_.encoding().atEnd(observedPlace(range)), std::nullopt, range.bits});
  }
}

/// The register of OLD that stands for one of NEW; nothing if none does.
std::optional<Place> ProgramProduct::oldRegister(const Place& place) {
  Place there = place;
  if (isEdge(place.reg)) {
    const std::vector<std::uint32_t>& edges = new_.encoding().plan().edge;
    const std::vector<std::uint32_t>& oldEdges = old_.encoding().plan().edge;
    const auto own = std::ranges::find(edges, place.at);
    if (own == edges.end()) return std::nullopt;
    const std::uint32_t instruction = match_.beforeOf[static_cast<std::size_t>(own - edges.begin())];
    if (instruction == noPartner || oldEdges[instruction] == noPartner) return std::nullopt;
    there.at = oldEdges[instruction];
  } else if (place.reg == Reg::EventRoutine) {
    const std::optional<int> event = options_.pairs.eventBefore(static_cast<int>(place.at));
    if (!event) return std::nullopt;
    there.at = static_cast<std::uint32_t>(*event);
  } else if (const std::optional<Area> area = areaOfRegister(place.reg)) {
    const auto number = options_.pairs.before(Address{*area, place.at});
    if (!number || number->area != *area) return std::nullopt;
    there.at = number->index;
  }
  if (!old_.encoding().holds(there)) return std::nullopt;
  return there;
}

/// What OLD has at a place of NEW, at the start or at the end of the scan; noNode: nothing stands for it.
Node ProgramProduct::oldValue(const Place& place, bool atEnd) {
  EncodedScan& encoding = old_.encoding();
  const auto at = [&](const Place& there) { return atEnd ? encoding.atEnd(there) : encoding.atStart(there); };
  if (place.isRegister) {
    const std::optional<Place> there = oldRegister(place);
    return there ? at(*there) : noNode;
  }
  std::vector<Address> bits;
  for (std::uint32_t i = 0; i < place.width; ++i) {
    const auto bit = options_.pairs.before(bitOf(place, i));
    if (!bit || isWholeValue(bit->area) || !encoding.holds(bitPlace(*bit))) return noNode;
    bits.push_back(*bit);
  }
  const Place first = bitPlace(bits.front());
  bool isTogether = true;
  for (std::uint32_t i = 1; i < place.width; ++i) isTogether = isTogether && bits[i] == bitOf(first, i);
  if (isTogether) {
    const Node whole = at({false, first.area, {}, first.at, place.width});
    if (whole != noNode) return whole;
  }
  Graph& graph = encoding.graph();
  Node value = at(bitPlace(bits.front()));
  for (std::uint32_t i = 1; i < place.width; ++i)
    value = graph.make(Op::Concat, static_cast<int>(i) + 1, value, at(bitPlace(bits[i])));
  return value;
}

/// Of two families: what OLD has there is its own only where it uses it, and timers and counters are not alike.
bool ProgramProduct::isSharedPlace(const Place& newPlace) {
  const Dialect &before = old_.encoding().plan().dialect(), &after = new_.encoding().plan().dialect();
  if (before.set == after.set) return true;
  if (newPlace.isRegister) {
    const bool haveLastScan = before.run.keepsLastScan && after.run.keepsLastScan;
    return !isOfTimer(newPlace.reg) && !isOfCounter(newPlace.reg) && (newPlace.reg != Reg::LastScan || haveLastScan);
  }
  for (std::uint32_t i = 0; i < newPlace.width; ++i) {
    const auto bit = options_.pairs.before(bitOf(newPlace, i));
    if (!bit || !oldBits_.contains({bit->area, bit->index})) return false;
  }
  return true;
}

bool ProgramProduct::startsAlike(Node oldStart, const StateVariable& newState) const {
  const Graph& graph = *oldSystem_.graph;
  const Node roots[] = {oldStart};
  Evaluator evaluator(graph, roots);
  bool isFree = false;
  for (const Node n : coneOf(graph, roots)) {
    if (graph[n].op != Op::Variable) continue;
    const auto state = std::ranges::find(oldSystem_.states, n, &StateVariable::node);
    if (state == oldSystem_.states.end()) return false;  // an input is no memory
    if (state->init == noNode)
      isFree = true;
    else
      evaluator.set(n, graph[state->init].value);
  }
  if (isFree || newState.init == noNode) return isFree && newState.init == noNode;
  evaluator.run();
  return evaluator[oldStart] == (*newSystem_.graph)[newState.init].value;
}

void ProgramProduct::findPartners() {
  std::map<Node, Place> places;
  for (const Cell& cell : new_.encoding().cells()) {
    if (cell.kind == CellKind::State) places.emplace(cell.start, cell.place);
  }
  partners_.resize(newSystem_.states.size());
  const bool haveClocks = old_.encoding().plan().program->clockMemory && new_.encoding().plan().program->clockMemory;
  for (std::size_t i = 0; i < partners_.size(); ++i) {
    const auto place = places.find(newSystem_.states[i].node);
    if (place == places.end() || kept_.contains(place->first)) continue;
    const bool isWorld = place->second.isRegister && isOfTheCpu(place->second.reg, haveClocks);
    if (!isWorld && !isSharedPlace(place->second)) continue;
    partners_[i] = {oldValue(place->second, false), oldValue(place->second, true), isWorld};
  }
  oldSystem_ = old_.system();  // with all cells that the partners have touched
  const auto nameIn = [](const TransitionSystem& system, const StateVariable& state) -> const std::string& {
    return system.graph->variables()[(*system.graph)[state.node].value].name;
  };
  std::map<std::string, const StateVariable*> byName;
  for (const StateVariable& state : oldSystem_.states) byName.emplace(nameIn(oldSystem_, state), &state);
  for (std::size_t i = 0; i < partners_.size(); ++i) {
    const StateVariable& state = newSystem_.states[i];
    if (places.contains(state.node) || kept_.contains(state.node)) continue;
    const auto same = byName.find(nameIn(newSystem_, state));  // what waits in queues, cells of assumptions
    const bool isAlike =
        same != byName.end() && (*oldSystem_.graph)[same->second->node].width == (*newSystem_.graph)[state.node].width;
    if (isAlike) partners_[i] = {same->second->node, same->second->next};
  }
  const std::vector<StateVariable>& oldTime = old_.encoding().time().states();
  const std::vector<StateVariable>& newTime = new_.encoding().time().states();
  CHECK(oldTime.size() == newTime.size(), "both programs have one time");
  for (std::size_t i = 0; i < partners_.size(); ++i) {
    const StateVariable& state = newSystem_.states[i];
    const auto clock = std::ranges::find(newTime, state.node, &StateVariable::node);
    if (clock != newTime.end()) {
      partners_[i] = {oldTime[static_cast<std::size_t>(clock - newTime.begin())].node, noNode, true};
      continue;
    }
    const bool isKept = partners_[i].start != noNode && startsAlike(partners_[i].start, state);
    if (!isKept) partners_[i] = {};
  }
}

JoinedSystem ProgramProduct::merged(const std::vector<bool>& isMerged, bool isOneScan,
                                    const std::vector<PairCondition>& conditions) {
  Graph& graph = old_.encoding().graph();
  JoinedSystem result;
  result.system = oldSystem_;
  result.copy = std::make_shared<SideCopy>(graph, new_.encoding().graph(), " (new)");
  SideCopy& copy = *result.copy;
  replaceCells(copy);
  replaceExternals(copy);
  replaceSites(copy);
  replaceEstimates(copy, isMerged);
  const auto isTaken = [&](std::size_t i) {
    return partners_[i].isWorld || (isMerged[i] && partners_[i].start != noNode);
  };
  for (std::size_t i = 0; i < partners_.size(); ++i) {
    if (isTaken(i)) copy.replace(newSystem_.states[i].node, partners_[i].start);
  }
  const auto differ = [&](Node a, Node b) { return graph.lnot(graph.equal({a}, {b}, graph[a].width)).node; };
  result.nextDiffers.assign(partners_.size(), noNode);
  for (std::size_t i = 0; i < partners_.size(); ++i) {
    const StateVariable& state = newSystem_.states[i];
    if (partners_[i].isWorld) continue;
    if (isTaken(i)) {
      result.nextDiffers[i] = differ(partners_[i].next, copy(state.next));
      if (state.init != noNode)
        result.starts.push_back(
            graph.equal({partners_[i].start}, {copy(state.init)}, graph[partners_[i].start].width).node);
    } else if (isOneScan && !kept_.contains(state.node)) {
      result.system.inputs.push_back(copy(state.node));
    } else {
      result.system.states.push_back({copy(state.node), copy(state.init), copy(state.next)});
      if (state.init == noNode && partners_[i].start != noNode)
        startAlike(result, partners_[i].start, copy(state.node));
      if (new_.isTimeState(state.node)) result.timeStates.push_back(copy(state.node));
    }
  }
  for (const StateVariable& state : oldSystem_.states) {
    if (old_.isTimeState(state.node)) result.timeStates.push_back(state.node);
  }
  for (const Node constraint : newSystem_.constraints) {
    const Node copied = copy(constraint);
    if (graph.truth({copied}) != true &&
        std::ranges::find(result.system.constraints, copied) == result.system.constraints.end())
      result.system.constraints.push_back(copied);  // not a total one: its inputs now serve two programs
  }
  addConditions(result, conditions);
  noteEstimates(result);
  if (options_.steadyInputs) holdInputs(result);
  holdClocks(result);
  assume(result);
  compareOutputs(result);
  compareRequests(result);
  result.stopDiffers = differ(oldRuns_, copy(newRuns_));
  for (const Node input : copy.newInputs()) {
    if (std::ranges::find(result.system.inputs, input) == result.system.inputs.end())
      result.system.inputs.push_back(input);
  }
  return result;
}

bool ProgramProduct::pulsesCorrespond(const std::vector<bool>& isMerged) {
  if (pulseForms_[0] != pulseForms_[1]) return false;
  const auto isPulse = [](const Cell& cell) { return cell.place.isRegister && isOfPulses(cell.place.reg); };
  const std::vector<Cell>&before = old_.encoding().cells(), &after = new_.encoding().cells();
  const bool hasTable = std::ranges::any_of(before, isPulseTableAddress, &Cell::place) ||
                        std::ranges::any_of(after, isPulseTableAddress, &Cell::place);
  std::map<Node, std::size_t> states;
  for (std::size_t i = 0; i < newSystem_.states.size(); ++i) states.emplace(newSystem_.states[i].node, i);
  const auto isAlike = [&](const Cell& cell) {
    const auto state = states.find(cell.start);
    return state == states.end() || (isMerged[state->second] && isMergeable(state->second));
  };
  std::set<std::pair<Reg, std::uint32_t>> commands;
  for (const Cell& cell : after) {
    const bool isTable = hasTable && !cell.place.isRegister && cell.place.area == Area::V;
    if ((isPulse(cell) || isTable) && cell.kind == CellKind::State && !isAlike(cell)) return false;
    if (isPulse(cell)) commands.emplace(cell.place.reg, cell.place.at);
  }
  return std::ranges::all_of(before,
                             [&](const Cell& cell) {
                               return !isPulse(cell) || commands.erase({cell.place.reg, cell.place.at}) > 0;
                             }) &&
         commands.empty();
}

void ProgramProduct::addConditions(JoinedSystem& result, const std::vector<PairCondition>& conditions) {
  if (conditions.empty()) return;
  result.conditionStarts.assign(conditions.size(), noNode);
  result.conditionBreaks.assign(conditions.size(), noNode);
  addRelations(result, conditions);
  Graph& graph = old_.encoding().graph();
  const std::vector<std::string> own = newStateNames();
  std::map<std::string, std::size_t> newStates, oldStates;
  for (std::size_t i = 0; i < own.size(); ++i) newStates.emplace(own[i], i);
  for (std::size_t i = 0; i < oldSystem_.states.size(); ++i)
    oldStates.emplace(graph.variables()[graph[oldSystem_.states[i].node].value].name, i);
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    const PairCondition& condition = conditions[k];
    if (condition.condition.empty()) continue;
    const std::size_t i = newStates.at(condition.state);
    const StateVariable& bit = oldSystem_.states[oldStates.at(condition.condition)];
    const auto breaks = [&](Node guard, Node before, Node after) {
      const Graph::Bool differs = graph.lnot(graph.equal({before}, {after}, graph[before].width));
      return graph.land(condition.when ? Graph::Bool{guard} : graph.lnot({guard}), differs);
    };
    const StateVariable& state = newSystem_.states[i];
    result.conditionStarts[k] = graph.lnot(breaks(bit.node, partners_[i].start, (*result.copy)(state.node))).node;
    result.conditionBreaks[k] = breaks(bit.next, partners_[i].next, (*result.copy)(state.next)).node;
  }
  for (const Node start : result.conditionStarts) {
    if (start != noNode) result.system.constraints.push_back(start);
  }
}

/// The value of an address in an assumption about both; without `copy` it is only touched.
Node ProgramProduct::assumedLeaf(SideCopy* copy, const Operand& operand, int width) {
  const bool isNew = operand.text.starts_with(newSidePrefix);
  Operand address = operand;
  if (width != 1 || !hasBitAndWord(operand.area)) address.width = widthOfBits(width);
  const Node node = (isNew ? new_ : old_).encoding().atEnd(address, width);
  CHECK(node != noNode, "assumptions about both programs speak of memory and inputs");
  return isNew && copy != nullptr ? (*copy)(node) : node;
}

void ProgramProduct::assume(JoinedSystem& result) {
  Graph& graph = old_.encoding().graph();
  TimeModel& time = old_.encoding().time();
  for (const Property& assumption : options_.assumptions) {
    std::vector<Graph::Bits> before, after;
    for (const MonitorCell& cell : assumption.cells) before.push_back({graph.variable(cell.name, cell.width, true)});
    after = before;
    const auto look = [&](const Operand& operand, int width) -> Graph::Bits {
      return {assumedLeaf(result.copy.get(), operand, width)};
    };
    const Node ticks = time.ticksWithin(1);
    const Moment<Graph> moment{{old_.encoding().firstScan()}, {ticks}, graph[ticks].width, {}};
    const Graph::Bool holds = Monitor<Graph, decltype(look)>(graph, assumption, look, moment, before, after).evaluate();
    result.system.constraints.push_back(holds.node);
    for (std::size_t i = 0; i < before.size(); ++i)
      result.system.states.push_back({before[i].node, graph.constantNode(0, assumption.cells[i].width), after[i].node});
  }
}

/// OLD's value `latency` scans ago.
Node ProgramProduct::delayed(JoinedSystem& result, Node value, const std::string& name) {
  Graph& graph = old_.encoding().graph();
  const int width = graph[value].width;
  for (std::uint32_t i = 1; i <= options_.latency; ++i) {
    const Node before = graph.variable(fmt::format("{} {} scans ago", name, i), width, true);
    result.system.states.push_back({before, graph.constantNode(0, width), value});
    value = before;
  }
  return value;
}

/// Whether the two have differed for at least the time that they are given to settle.
Node ProgramProduct::settled(JoinedSystem& result, Node differs, const std::string& name) {
  if (options_.settleMs == 0 || old_.encoding().graph().truth({differs}) == false) return differs;
  Graph& graph = old_.encoding().graph();
  TimeModel& time = old_.encoding().time();
  const int w = std::max(time.width(), bitsFor(options_.settleMs)) + 1;
  const Node before = graph.variable(name + " differed", 1, true);
  const Node lasted = graph.variable(name + " differs for ms", w, true);
  const Node most = graph.constantNode(options_.settleMs, w);
  const Node sum = graph.make(Op::Add, w, lasted, graph.make(Op::Zext, w, time.dt()));
  const Node now = graph.make(Op::Ite, w, before, sum, graph.constantNode(0, w));
  const Node cut = graph.make(Op::Ite, w, graph.make(Op::Ult, 1, most, now), most, now);
  result.system.states.push_back({before, graph.constantNode(0, 1), differs});
  result.system.states.push_back(
      {lasted, graph.constantNode(0, w), graph.make(Op::Ite, w, differs, cut, graph.constantNode(0, w))});
  result.timeStates.push_back(lasted);
  return graph.land({differs}, {graph.make(Op::Ule, 1, most, now)}).node;
}

void ProgramProduct::compareOutputs(JoinedSystem& result) {
  Graph& graph = old_.encoding().graph();
  Node counts = graph.constantNode(1, 1);
  for (std::uint32_t i = 1; i <= options_.latency; ++i) {
    const Node before = graph.variable(fmt::format("scan {} is over", i), 1, true);
    result.system.states.push_back({before, graph.constantNode(0, 1), counts});
    counts = before;
  }
  for (const Output& output : outputs_) {
    ObservedBit& bit = result.observed.emplace_back();
    bit.before = output.before;
    bit.after = output.after;
    bit.pulses = output.pulses;
    bit.bits = output.bits;
    if (output.pulses) {
      bit.name = nameOf(*output.pulses);
      const Graph::Bits there{(*result.copy)(output.newValue)};
      bit.differs =
          settled(result, pulsesDiffer(graph, output.pulses->number, {output.oldValue}, there).node, bit.name);
      continue;
    }
    bit.name = nameOfBit(output.before ? *output.before : *output.after);
    const auto width = static_cast<int>(output.bits);
    const Node zero = graph.constantNode(0, width);
    const Node left = output.oldValue == noNode ? zero : delayed(result, output.oldValue, bit.name);
    const Node right = output.newValue == noNode ? zero : (*result.copy)(output.newValue);
    const Node differs = graph.land({counts}, graph.lnot(graph.equal({left}, {right}, width))).node;
    bit.differs = settled(result, differs, bit.name);
  }
}

std::vector<Question> outputQuestions(const JoinedSystem& joined) {
  std::vector<Question> questions;
  for (const ObservedBit& bit : joined.observed) questions.push_back({bit.name + " differs", bit.differs});
  questions.push_back({"RUN differs", joined.stopDiffers});
  return questions;
}

WordTrace ProgramProduct::sideTrace(const std::vector<Node>& states, const std::vector<Node>& inputs,
                                    const TransitionSystem& asked, const WordTrace& trace) {
  std::vector<Node> roots = states;
  roots.insert(roots.end(), inputs.begin(), inputs.end());
  for (const StateVariable& state : asked.states) roots.push_back(state.next);
  Evaluator evaluator(*asked.graph, roots);
  WordTrace result;
  std::vector<std::uint64_t> now = trace.initial;
  for (const std::vector<std::uint64_t>& scan : trace.inputs) {
    for (std::size_t i = 0; i < now.size(); ++i) evaluator.set(asked.states[i].node, now[i]);
    for (std::size_t i = 0; i < scan.size(); ++i) evaluator.set(asked.inputs[i], scan[i]);
    evaluator.run();
    if (result.initial.empty()) {
      for (const Node n : states) result.initial.push_back(evaluator[n]);
    }
    std::vector<std::uint64_t>& row = result.inputs.emplace_back();
    for (const Node n : inputs) row.push_back(evaluator[n]);
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = evaluator[asked.states[i].next];
  }
  return result;
}

WordTrace ProgramProduct::oldTrace(const TransitionSystem& asked, const WordTrace& trace) {
  std::vector<Node> states;
  for (const StateVariable& state : oldSystem_.states) states.push_back(state.node);
  return sideTrace(states, oldSystem_.inputs, asked, trace);
}

WordTrace ProgramProduct::newTrace(const JoinedSystem& merged, const TransitionSystem& asked, const WordTrace& trace) {
  std::vector<Node> states, inputs;
  for (const StateVariable& state : newSystem_.states) states.push_back((*merged.copy)(state.node));
  for (const Node input : newSystem_.inputs) inputs.push_back((*merged.copy)(input));
  return sideTrace(states, inputs, asked, trace);
}

}  // namespace rungproof
