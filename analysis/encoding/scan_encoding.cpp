// Encoding of one scan: inputs and time, the program, the end of the scan.
#include "analysis/encoding/scan_encoding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "analysis/encoding/site_name.hpp"
#include "ir/check.hpp"
#include "ir/families/run.hpp"
#include "ir/s7200/event.hpp"
#include "ir/s7200/isa/clock.hpp"
#include "ir/s7200/isa/comm.hpp"
#include "ir/s7200/special_memory.hpp"
#include "ir/s7300/place.hpp"

namespace rungproof {

namespace {

/// Boxes count ticks, everything else ms.
TimeRange timeOf(const Plan& plan, TimeRange range) {
  range.hasBases = range.hasBases || plan.counting() == Counting::Boxes;
  return range;
}

/// With what the CPU makes of choices that nobody has made.
EncoderOptions optionsFor(const Program& program, EncoderOptions options) {
  options.choices = choicesFor(program.target, options.choices);
  options.retentive = retentiveRanges(program, options.retentive);
  return options;
}

}  // namespace

ScanEncoding::ScanEncoding(const Program& program, const EncoderOptions& options, const Plan& plan,
                           const MemoryLayout& layout, const Knowledge& knowledge, const RoutineEffects* effects)
    : graph(options.trail && options.trail->isFollowed ? Rewriting::None : Rewriting::Full),
      time(graph, timeOf(plan, options.time)),
      program_(program),
      options_(optionsFor(program, options)),
      contracts_(program),
      plan_(plan),
      layout_(layout),
      knowledge_(knowledge),
      initial_(powerUpState(plan, options.choices)),
      store_(graph, layout, *this, plan),
      machine_(graph, store_, plan),
      devices_(graph, plan, knowledge.tables,
               {[this](const Place& place) { return startOfCell(place); },
                [this](std::string name, int width) { return deviceInputs[name] = input(name, width); },
                [this](const Instruction* place, std::string_view reason) {
                  Approximation& a = approximate(place, reason);
                  a.carriers.push_back(input("written by a device", 8));
                  return a.carriers.back();
                }}),
      effects_(effects) {
  graph.listen(this);
  if (knowledge.isFinal && options.trail) graph.decideBy(&options.trail->decisions);
  graph.decideUnder(&machine_.guard);
  store_.follow(&machine_);
  if (time.constraint() != noNode) {
    constraints_.push_back(time.constraint());
    totalConstraints_.push_back(time.constraint());
  }
  if (options.interrupts) attachments_ = attachmentsOf(plan);
  for (const auto& [event, routines] : attachments_) events_.push_back(event);
  std::stable_sort(events_.begin(), events_.end(), [](int a, int b) {
    return std::pair(eventInfo(a).group, eventInfo(a).rank) < std::pair(eventInfo(b).group, eventInfo(b).rank);
  });
  prepareTicks();
  prepareWatched();
  const bool records = (!knowledge.isFinal || graph.isAsWritten()) && (!events_.empty() || !tickKeys_.reads.empty());
  store_.observe([this, records](const Touch& touch) {
    if (touch.isWrite) widening_.note(touch.place);
    // Saving and restoring around a routine is not its doing.
    const bool isOfRoutine = routine_ < 0 || machine_.inInterrupt;
    if (records && isRecording_ && isOfRoutine && machine_.current != nullptr)
      footprints_.record(machine_.current->id, routine_, touch);
  });
  run();
}

void ScanEncoding::run() {
  isRecording_ = false;
  constrainStartsByType();
  store_.value(registerPlace(Reg::Running, 0));  // a cell, even if every scan ends the program without reading it
  devices_.begin(machine_);
  beginStatus(machine_);
  if (plan_.counting() == Counting::Boxes) {
    machine_.ticks100 = {time.ticks100()};
    refreshTimers(machine_, 10, {time.ticks10()});
  }
  beginScanOfTimers(machine_);
  beginEvents();
  isRecording_ = true;
  Runner runner(machine_, *this, options_.loopLimit, options_.stepLimit);
  runner.program();
  isRecording_ = false;
  machine_.current = nullptr;
  machine_.guard = graph.lnot(machine_.halted);
  boundary(runner, ScanPlace::afterProgram);
  endOfScan();
}

void ScanEncoding::endOfScan() {
  Machine<Graph>& m = machine_;
  endEvents();
  m.guard = m.halted;
  m.setBit(Reg::Running, 0, graph.constant(false));
  m.guard = graph.constant(true);
  endScanOfTimers(m, {time.saturated(time.dt(), restBits)});
  const Graph::Bits elapsed{time.dt16()};
  if (time.high() <= longestStep) {
    advanceClocks(m, elapsed);
  } else {
    // Too long for the clocks' single step: their phase becomes any phase.
    for (const auto& [phase, period] : {std::pair{Reg::PhaseSecond, 1000ULL}, std::pair{Reg::PhaseMinute, 60000ULL}}) {
      const int width = regInfo(phase).width;
      const Node any = input(std::string(regInfo(phase).name), width);
      const Node legal = graph.make(Op::Ult, 1, any, graph.constantNode(period, width));
      constraints_.push_back(legal);
      totalConstraints_.push_back(legal);
      m.set(phase, 0, {any});
    }
  }
  refreshSpecialMemory(m, elapsed);
  m.setSm(4, 7, graph.constant(false));  // nothing is forced
}

void ScanEncoding::before(Runner& runner, const FlowStep& step) {
  boundary(runner, step.instruction->id);
  if (!attachments_.empty()) noteAttachment(*step.instruction);
  if (options_.interruption) options_.interruption();
  if (!options_.atInstruction || !knowledge_.isFinal) return;
  const bool wasRecording = std::exchange(isRecording_, false);  // what is asked there is not the program's doing
  options_.atInstruction(runner.machine(), *step.instruction);
  isRecording_ = wasRecording;
}

void ScanEncoding::callWithoutBody(Runner& runner, const Instruction& instruction) {
  Machine<Graph>& m = runner.machine();
  const CallContract* contract = options_.followsContracts ? contracts_.of(instruction) : nullptr;
  if (contract == nullptr || contract->mayDoAnything) {
    havocBy(m, approximate(&instruction, "calls a block without visible text, which may change any memory"));
    return;
  }
  const auto index = static_cast<std::size_t>(
      &approximate(&instruction, fmt::format("{} has no text: what it may write is any value", contract->name)) -
      approximations.data());
  const std::size_t first = externals.size();
  callByContract(m, instruction, *contract);
  for (std::size_t i = first; i < externals.size(); ++i) {
    if (externals[i].site.kind == External::LibraryOutput) approximations[index].carriers.push_back(externals[i].node);
  }
}

void ScanEncoding::freshLocal(Runner& runner, std::uint32_t base, std::uint32_t byte) {
  const Machine<Graph>& m = runner.machine();
  if (byte == 0) localEntries_.emplace_back();
  const ExternalSite site{External::LocalMemory, byte, m.current == nullptr ? 0 : m.current->id};
  localEntries_.back().push_back(externals.size());
  externals.push_back({site, noNode, 8, m.guard.node});
  store_.forgetLocal(base, byte, static_cast<std::uint32_t>(localEntries_.size() - 1));
}

Node ScanEncoding::input(std::string name, int width) {
  inputs_.push_back(graph.variable(std::move(name), width, false));
  return inputs_.back();
}

/// A block that is moved through a pointer is one instruction, and up to 255 times 512 writes.
void ScanEncoding::accessed() {
  constexpr std::uint32_t accessesBetweenLooks = 256;
  if (++accesses_ % accessesBetweenLooks == 0 && options_.interruption) options_.interruption();
}

Node ScanEncoding::localByte(std::uint32_t entry, std::uint32_t byte) {
  ExternalInput& e = externals[localEntries_[entry][byte]];
  if (e.node == noNode) e.node = input(siteName(e.site), e.width);
  return e.node;
}

/// The current value of a high-speed counter that can count.
bool ScanEncoding::isCount(const Place& place) const {
  return place.isRegister && place.reg == Reg::HscCurrent && canCount(program_, contracts_, place.at);
}

bool ScanEncoding::isInput(const Place& place) const {
  if (place.isRegister) return place.reg == Reg::PhysicalInput;
  if (place.area == Area::I) return true;
  const std::uint32_t byte = place.byte();
  if (place.area == Area::SM) {
    const SmSource source = smSource(program_.target, byte, place.width == 1 ? place.bit() : 0);
    if (source == SmSource::Free || source == SmSource::FirstScan) return true;
  }
  // The layout begins a place where a range begins or ends, so the first bit tells for all.
  const std::uint32_t bit = byte * 8 + (place.width == 1 ? place.bit() : 0);
  return std::any_of(options_.externals.begin(), options_.externals.end(), [&](const ExternalBytes& e) {
    return e.area == place.area && e.first * 8 + e.lowBit <= bit && bit <= e.last * 8 + e.highBit;
  });
}

Node ScanEncoding::init(const Place& place) const {
  Graph& g = const_cast<Graph&>(graph);
  if (place.isRegister) {
    const bool isScanClock = place.reg == Reg::PhaseSecond || place.reg == Reg::PhaseMinute;
    if (isScanClock && !isFixed(Choice::ScanClockStart)) return noNode;
    if (place.reg == Reg::Reading && !isFixed(choiceOfReading(place.at))) return noNode;
    if (place.reg == Reg::ClockPhase || isRetained(place)) return noNode;
    return g.constantNode(initial_.get(place.reg, place.at), place.width);
  }
  if (options_.initialRetentive && isRetentive(*options_.retentive, place.area, place.byte())) return noNode;
  if (place.width == 1) return g.constantNode(initial_.load(place.area, place.byte() * 8 + place.bit(), 1), 1);
  std::uint64_t value = 0;
  for (std::uint32_t i = 0; i < place.width / 8U; ++i)
    value = value << 8 | initial_.load(place.area, (place.byte() + i) * 8, 8);
  return g.constantNode(value, place.width);
}

/// Whether a register of a timer or counter begins the run with any value.
bool ScanEncoding::isRetained(const Place& place) const {
  if (!options_.initialRetentive || !place.isRegister) return false;
  return std::ranges::any_of(std::array{Area::T, Area::C}, [&](Area area) {
    const auto registers = retainedRegisters(area, plan_.counting());
    return std::ranges::find(registers, place.reg) != registers.end() &&
           isRetentive(*options_.retentive, area, place.at);
  });
}

/// What holds of a cell that begins the run with any value.
void ScanEncoding::constrainStart(const Place& place, Node node) {
  const auto bound = [&](std::uint64_t end) {
    return graph.make(Op::Ult, 1, node, graph.constantNode(end, place.width));
  };
  Node legal = noNode;
  const bool isNumbered = plan_.counting() == Counting::Elements && isRetained(place);
  switch (place.reg) {
    case Reg::PhaseSecond: legal = bound(1000); break;
    case Reg::PhaseMinute: legal = bound(60000); break;
    case Reg::ClockPhase: legal = bound(clockPeriods[place.at]); break;
    case Reg::S5Rest: legal = bound(longestS5Time + 1); break;
    case Reg::CounterCurrent:
      if (isNumbered) legal = bound(1000);
      break;
    case Reg::CounterBit: {
      if (!isNumbered) break;
      const Graph::Bits value{startOfCell(registerPlace(Reg::CounterCurrent, place.at))};
      legal = graph.lnot(graph.lxor({node}, graph.lnot(graph.equal(value, graph.literal(0, 16), 16)))).node;
      break;
    }
    default: break;
  }
  if (legal == noNode) return;
  constraints_.push_back(legal);
  totalConstraints_.push_back(legal);
}

/// Whether a variable never held another value than those of its type: not what comes from outside, nor copies of it.
bool ScanEncoding::isOfItsType(std::uint32_t offset) const {
  std::set<std::uint32_t> met;
  std::vector<std::uint32_t> open = {offset};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    const auto limits = program_.valueLimits.find(at);
    if (limits == program_.valueLimits.end() || !limits->second.isKept) return false;
    for (int i = 0; i < limits->second.width / 8; ++i) {
      if (isInput(memoryPlace(Area::V, at + static_cast<std::uint32_t>(i), Width::Byte, 0))) return false;
    }
    for (const std::uint32_t source : limits->second.sources) {
      if (met.insert(source).second) open.push_back(source);
    }
  }
  return true;
}

/// What is kept over the loss of power was a value of its type.
void ScanEncoding::constrainStartsByType() {
  if (!options_.initialRetentive) return;
  for (const auto& [offset, limits] : program_.valueLimits) {
    if (!isRetentive(*options_.retentive, Area::V, offset) || !isOfItsType(offset)) continue;
    const int width = limits.width;
    const Graph::Bits value = store_.load(Area::V, offset * 8, width);
    const auto upTo = [&](Graph::Bits a, Graph::Bits b) {
      return limits.isSigned ? graph.sle(a, b, width) : graph.ule(a, b, width);
    };
    const auto literal = [&](std::int64_t v) { return graph.literal(static_cast<std::uint64_t>(v), width); };
    Graph::Bool legal = graph.constant(false);
    for (const auto& [low, high] : limits.runs)
      legal = graph.lor(legal, graph.land(upTo(literal(low), value), upTo(value, literal(high))));
    const Graph::Bool isFirst{startOfCell(registerPlace(Reg::FirstScan, 0))};
    const Node start = graph.lor(graph.lnot(isFirst), legal).node;
    constraints_.push_back(start);
    totalConstraints_.push_back(start);
  }
}

Cell ScanEncoding::cellAt(const Place& place) {
  const Cell cell = newCell(place);
  starts_[place] = cell.start;
  return cell;
}

/// The value that a cell has before devices write.
Node ScanEncoding::startOfCell(const Place& place) {
  if (const auto found = starts_.find(place); found != starts_.end()) return found->second;
  store_.value(place);
  return starts_.at(place);
}

Node ScanEncoding::atScan(const Cell& cell) {
  const Place& place = cell.place;
  const bool isFirstScanBit = place.area == Area::SM && place.width == 1 &&
                              smSource(program_.target, place.byte(), place.bit()) == SmSource::FirstScan;
  if (place.isRegister) return isCount(place) ? devices_.counted(place.at, cell.start) : cell.start;
  if (isFirstScanBit) return graph.make(Op::And, 1, cell.start, startOfCell(registerPlace(Reg::FirstScan, 0)));
  return devices_.seen(place, cell.start);
}

Cell ScanEncoding::newCell(const Place& place) {
  if (isInput(place)) return {place, CellKind::Input, input(nameOf(place), place.width)};
  if (const auto known = knowledge_.constants.find(place); known != knowledge_.constants.end())
    return keeping(place, known->second);
  const Node first = init(place);
  if (place.isRegister && place.reg == Reg::Reading && first != noNode) return {place, CellKind::Constant, first};
  const auto isOfDevice = [&] { return place.isRegister ? isCount(place) : devices_.mayWrite(place); };
  if (isClosed_ && !hasHavoc_ && first != noNode && !isOfDevice()) return keeping(place, graph[first].value);
  const Node node = graph.variable(nameOf(place), place.width, true);
  if (first == noNode && place.isRegister) constrainStart(place, node);
  const auto values = knowledge_.values.find(place);
  if (values != knowledge_.values.end())
    known_[node] = values->second;
  else if (first != noNode)
    known_[node] = ValueSet::of(graph[first].value);
  if (const auto later = knowledge_.later.find(place); later != knowledge_.later.end()) later_[node] = later->second;
  return {place, CellKind::State, node};
}

/// A constant; where the encoding is as written, a variable that keeps its value.
Cell ScanEncoding::keeping(const Place& place, std::uint64_t value) {
  if (!graph.isAsWritten()) return {place, CellKind::Constant, graph.constantNode(value, place.width)};
  keptCells.push_back({graph.variable(nameOf(place), place.width, true), value});
  return {place, CellKind::State, keptCells.back().node};
}

/// Whether the program has a TODW or TODWX.
bool ScanEncoding::setsClock() const {
  return std::ranges::any_of(plan_.flows, [](const Flow& flow) {
    return std::ranges::any_of(flow.steps,
                               [](const FlowStep& step) { return roleOf(*step.instruction) == Role::Todw; });
  });
}

Graph::Bits ScanEncoding::external(const ExternalSite& site, int width) {
  if (site.kind == External::AnalogInput && !options_.coversAllReadings &&
      options_.choices.is(Choice::AnalogSampling, "each-scan")) {
    const auto [sample, isFirst] = analog_.try_emplace(site.index, noNode);
    if (isFirst) sample->second = input(fmt::format("AIW{}", site.index), width);
    return {sample->second};
  }
  const Node node = input(siteName(site), width);
  if (site.kind == External::ClockByte) {
    const Graph::Bool legal = isa::clockShows(machine_, {node}, site.index);
    const Node shown = setsClock() ? graph.lor(legal, machine_.reads({Choice::ClockData, "any"})).node : legal.node;
    constraints_.push_back(shown);
    totalConstraints_.push_back(shown);
  }
  externals.push_back({site, node, width, machine_.guard.node});
  if (site.kind == External::LibraryOutput && contracts_.of(*machine_.current) == nullptr)
    approximate(machine_.current, "calls a block that no file has: what it may write is any value")
        .carriers.push_back(node);
  if (site.kind == External::AnalogInput) analog_[site.index] = node;
  return {node};
}

Node ScanEncoding::analogInput(std::uint32_t byte) {
  const auto [sample, isFirst] = analog_.try_emplace(byte, noNode);
  if (isFirst) sample->second = input(fmt::format("AIW{}", byte), 16);
  return sample->second;
}

bool ScanEncoding::isPossible(Graph::Bool condition) {
  if (const std::optional<bool> known = graph.truth(condition)) return *known;
  if (!knowledge_.followsPointers) return true;
  const auto answer = graph.listed([&]() -> std::optional<std::vector<std::uint64_t>> {
    const ValueSet values = ValueEvaluator(graph, known_).valuesOf(condition.node, machine_.guard.node, valueLimit);
    const bool isSo = values.contains(1);
    prunesLoops_ = prunesLoops_ || !isSo;
    return std::vector<std::uint64_t>{isSo ? 1ULL : 0ULL};
  });
  if (!answer || answer->empty()) return true;
  if (answer->front() == 0) tellList(graph.lnot(condition));
  return answer->front() != 0;
}

/// Where the machine is, what was said of values that were listed is so.
void ScanEncoding::tellList(Graph::Bool isIn) {
  if (graph.isAsWritten()) listFacts.push_back(graph.lor(graph.lnot(machine_.guard), isIn).node);
}

/// The stack and what the rounds write take any value where the loop goes on.
RoundsLeft ScanEncoding::beyondLimit(Graph::Bool condition, bool isFirst) {
  const LoopWidening::Branch branch{machine_.current->id, machine_.inInterrupt};
  if (isFirst) widening_.enter(branch);
  const RoundsLeft left = widening_.next(branch, machine_.scrActive.node);
  if (left != RoundsLeft::Follow) return left;
  const auto index = static_cast<std::size_t>(
      &approximate(machine_.current, "what later rounds of the loop write is taken as any value") -
      approximations.data());
  const Graph::Bool taken = graph.land(machine_.guard, condition);
  const auto any = [&](const std::string& name, int width) {
    approximations[index].carriers.push_back(input(name + " in later rounds", width));
    return approximations[index].carriers.back();
  };
  for (Graph::Bool& level : std::span(machine_.stack).first(machine_.stackLevels))
    level = graph.select(taken, {any("stack", 1)}, level);
  if (widening_.freesScr(branch)) machine_.scrActive = graph.select(taken, {any("SCR stack", 1)}, machine_.scrActive);
  if (plan_.form() == StatementForm::Accumulators)
    machine_.step7.each([&](Graph::Bool& bit) { bit = graph.select(taken, {any("status bit", 1)}, bit); },
                        [&](Graph::Bits& bits, int w) { bits = graph.select(taken, {any("register", w)}, bits, w); });
  for (const Place& place : widening_.freed(branch)) store_.replace(place, any(nameOf(place), place.width), taken);
  return RoundsLeft::Follow;
}

void ScanEncoding::report(Hazard hazard, Graph::Bool condition, const Instruction* place) {
  hazards.push_back({hazard, condition.node, place});
  if (hazard == Hazard::LoopBound) leaveOut(place, "loop that runs longer than it is followed", condition);
  if (hazard == Hazard::S7ErrorTwice)
    leaveOut(place, "synchronous error in the block that takes such errors", condition);
  // What ends the program keeps later interrupts from running.
  if (place != nullptr && hazardInfo(hazard).kind == HazardClass::Fatal)
    footprints_.record(place->id, routine_, {registerPlace(Reg::Running, 0), true});
}

/// Runs in which `condition` holds are not followed from there on.
void ScanEncoding::leaveOut(const Instruction* place, std::string_view reason, Graph::Bool condition) {
  Approximation& a = approximate(place, reason);
  a.leftOut = a.leftOut == noNode ? condition.node : graph.lor({a.leftOut}, condition).node;
}

Approximation& ScanEncoding::approximate(const Instruction* place, std::string_view reason) {
  for (Approximation& a : approximations) {
    if (a.place == place && a.reason == reason) return a;
  }
  return approximations.emplace_back(Approximation{place, std::string(reason)});
}

void ScanEncoding::havocBy(const Machine<Graph>& machine, const Approximation& cause) {
  const std::size_t index = static_cast<std::size_t>(&cause - approximations.data());
  hasHavoc_ = true;
  widening_.block();
  store_.havoc(machine.guard, [this, index](const Place& place) {
    const Node any = input("overwritten " + nameOf(place), place.width);
    approximations[index].carriers.push_back(any);
    return any;
  });
}

Node ScanEncoding::start(const Place& place) {
  store_.value(place);
  for (const Cell& cell : cells()) {
    if (cell.place == place) return cell.start;
  }
  // Part of a larger cell.
  for (const Cell& cell : cells()) {
    const Place& c = cell.place;
    if (c.isRegister || place.isRegister || c.area != place.area || c.at > place.at ||
        c.at + c.width < place.at + place.width)
      continue;
    return graph.make(Op::Extract, place.width, cell.start, noNode, noNode, c.at + c.width - place.at - place.width);
  }
  if (!place.isRegister && place.width > 1) return noNode;
  // The scan writes it before it reads it: nothing asked for its value until now.
  const bool wasClosed = std::exchange(isClosed_, false);
  store_.add(cellAt(place));
  isClosed_ = wasClosed;
  return cells().back().start;
}

TransitionSystem ScanEncoding::system() {
  TransitionSystem ts;
  ts.graph = &graph;
  ts.states = time.states();
  std::map<std::uint32_t, TimerHint> timers;
  ts.inputs = time.inputs();
  ts.steadySteps = time.steadySteps();
  ts.constraints = constraints_;
  for (std::size_t i = 0; i < cells().size(); ++i) {
    const Cell cell = cells()[i];
    if (cell.kind != CellKind::State) continue;
    ts.states.push_back({cell.start, init(cell.place), store_.value(cell.place)});
    if (cell.place == registerPlace(Reg::Running, 0)) ts.constraints.push_back(cell.start);
    if (!cell.place.isRegister) continue;
    if (cell.place.reg == Reg::TimerBit) timers[cell.place.at].bit = cell.start;
    if (cell.place.reg == Reg::TimerInput) timers[cell.place.at].input = cell.start;
    if (cell.place.reg == Reg::TimerRunning) timers[cell.place.at].running = cell.start;
    if (cell.place.reg == Reg::S5Rest) timers[cell.place.at].rest = cell.start;
    if (cell.place.reg == Reg::TimerCurrent) timers[cell.place.at].current = cell.start;
  }
  for (const auto& [number, timer] : timers) ts.timers.push_back(timer);
  ts.states.insert(ts.states.end(), eventStates_.all.begin(), eventStates_.all.end());
  ts.inputs.insert(ts.inputs.end(), inputs_.begin(), inputs_.end());
  ts.totalConstraints = totalConstraints_;
  return ts;
}

}  // namespace rungproof
