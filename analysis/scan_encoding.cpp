// Encoding of one scan: inputs and time, the program, the end of the scan.
#include "analysis/scan_encoding.hpp"

#include <fmt/format.h>

#include "analysis/device_memory.hpp"
#include "ir/check.hpp"
#include "ir/timer_refresh.hpp"

namespace rungproof {

namespace {

std::string siteName(const ExternalSite& site) {
  switch (site.kind) {
    case External::ImmediateInput: return fmt::format("I{}.{} immediate, instruction {}", site.index / 8, site.index % 8, site.instruction);
    case External::AnalogInput: return fmt::format("AIW{}, instruction {}", site.index, site.instruction);
    case External::StackBottom: return fmt::format("stack bottom, instruction {}", site.instruction);
    case External::LocalMemory: return fmt::format("LB{}, instruction {}", site.index, site.instruction);
    default: return fmt::format("external {} {}, instruction {}", static_cast<int>(site.kind), site.index, site.instruction);
  }
}

}  // namespace

ScanEncoding::ScanEncoding(const Program& program, const EncoderOptions& options, const Plan& plan, const MemoryLayout& layout,
                           const Knowledge& knowledge)
    : time(graph, options.time), program_(program), options_(options), plan_(plan), knowledge_(knowledge),
      initial_(powerUpState(plan, options.choices)), store_(graph, layout, *this, plan.edgeCount), machine_(graph, store_, plan, options.choices) {
  graph.listen(this);
  store_.follow(&machine_);
  if (time.constraint() != noNode) {
    constraints_.push_back(time.constraint());
    totalConstraints_.push_back(time.constraint());
  }
  run();
}

void ScanEncoding::run() {
  machine_.ticks100 = {time.ticks100()};
  refreshTimers(machine_, 10, {time.ticks10()});
  Runner runner(machine_, *this, options_.loopLimit);
  runner.program();
  machine_.current = nullptr;
  endOfScan();
}

void ScanEncoding::endOfScan() {
  Machine<Graph>& m = machine_;
  m.guard = graph.lnot(m.halted);
  refreshTimers(m, 1, {time.dt16()});
  m.guard = m.halted;
  m.setBit(Reg::Running, 0, graph.constant(false));
  m.guard = graph.constant(true);
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
  if (options_.atInstruction) options_.atInstruction(runner.machine(), *step.instruction);
}

void ScanEncoding::callWithoutBody(Runner& runner, const Instruction& instruction) {
  Machine<Graph>& m = runner.machine();
  approximate(&instruction, "calls a block without visible text, which may change any memory");
  havoc(m);
}

void ScanEncoding::freshLocal(Runner& runner, unsigned frame, std::uint32_t byte) {
  const Machine<Graph>& m = runner.machine();
  if (byte == 0) localEntries_.emplace_back();
  const ExternalSite site{External::LocalMemory, byte, m.current == nullptr ? 0 : m.current->id};
  localEntries_.back().push_back(externals.size());
  externals.push_back({site, noNode, 8, m.guard.node});
  store_.forgetLocal(frame, byte, static_cast<std::uint32_t>(localEntries_.size() - 1));
}

Node ScanEncoding::input(std::string name, int width) {
  inputs_.push_back(graph.variable(std::move(name), width, false));
  return inputs_.back();
}

Node ScanEncoding::localByte(std::uint32_t entry, std::uint32_t byte) {
  ExternalInput& e = externals[localEntries_[entry][byte]];
  if (e.node == noNode) e.node = input(siteName(e.site), e.width);
  return e.node;
}

bool ScanEncoding::isInput(const Place& place) const {
  if (place.isRegister) return place.reg == Reg::PhysicalInput || place.reg == Reg::HscCurrent;
  if (place.area == Area::I) return true;
  const std::uint32_t byte = place.byte();
  if (place.area == Area::SM && isDeviceByte(byte)) return true;
  for (const ExternalBytes& e : options_.externals) {
    if (e.area == place.area && e.first <= byte && byte <= e.last) return true;
  }
  return false;
}

Node ScanEncoding::init(const Place& place) const {
  Graph& g = const_cast<Graph&>(graph);
  if (place.isRegister) {
    const bool isTimer = place.reg == Reg::TimerCurrent, isCounter = place.reg == Reg::CounterCurrent;
    if (options_.initialRetentive && (isTimer || isCounter) && isRetentive(options_.retentive, isTimer ? Area::T : Area::C, place.at)) return noNode;
    return g.constantNode(initial_.get(place.reg, place.at), place.width);
  }
  if (options_.initialRetentive && isRetentive(options_.retentive, place.area, place.byte())) return noNode;
  if (place.width == 1) return g.constantNode(initial_.load(place.area, place.byte() * 8 + place.bit(), 1), 1);
  std::uint64_t value = 0;
  for (std::uint32_t i = 0; i < place.width / 8U; ++i) value = value << 8 | initial_.load(place.area, (place.byte() + i) * 8, 8);
  return g.constantNode(value, place.width);
}

Cell ScanEncoding::cellAt(const Place& place) {
  if (isInput(place)) return {place, CellKind::Input, input(nameOf(place), place.width)};
  if (const auto known = knowledge_.constants.find(place); known != knowledge_.constants.end()) {
    return {place, CellKind::Constant, graph.constantNode(known->second, place.width)};
  }
  return {place, CellKind::State, graph.variable(nameOf(place), place.width, true)};
}

Graph::Bits ScanEncoding::external(const ExternalSite& site, int width) {
  const Node node = input(siteName(site), width);
  externals.push_back({site, node, width, machine_.guard.node});
  if (site.kind == External::AnalogInput) analog_[{Area::AI, site.index}] = node;
  return {node};
}

Node ScanEncoding::analogInput(std::uint32_t byte) const {
  const auto found = analog_.find({Area::AI, byte});
  return found == analog_.end() ? noNode : found->second;
}

void ScanEncoding::report(Hazard hazard, Graph::Bool condition, const Instruction* place) { hazards.push_back({hazard, condition.node, place}); }

Approximation& ScanEncoding::approximate(const Instruction* place, std::string_view reason) {
  for (Approximation& a : approximations) {
    if (a.place == place && a.reason == reason) return a;
  }
  return approximations.emplace_back(Approximation{place, std::string(reason), {}});
}

Graph::Bool ScanEncoding::targets(Machine<Graph>& machine, Graph::Bits, Width, Ref<Graph>& ref) {
  ref.isUnresolved = true;
  Approximation& a = approximate(machine.current, "pointer whose targets could not be found");
  a.carriers.push_back(input("pointer is legal", 1));
  return {a.carriers.back()};
}

Graph::Bits ScanEncoding::unresolved(Machine<Graph>& machine, int width) {
  Approximation& a = approximate(machine.current, "pointer whose targets could not be found");
  a.carriers.push_back(input("value behind a pointer", width));
  return {a.carriers.back()};
}

void ScanEncoding::havoc(Machine<Graph>& machine) {
  const std::size_t index = static_cast<std::size_t>(&approximate(machine.current, "pointer whose targets could not be found") - approximations.data());
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
    if (c.isRegister || place.isRegister || c.area != place.area || c.at > place.at || c.at + c.width < place.at + place.width) continue;
    return graph.make(Op::Extract, place.width, cell.start, noNode, noNode, c.at + c.width - place.at - place.width);
  }
  return noNode;
}

TransitionSystem ScanEncoding::system() {
  TransitionSystem ts;
  ts.graph = &graph;
  ts.states = time.states();
  ts.inputs = time.inputs();
  ts.constraints = constraints_;
  for (std::size_t i = 0; i < cells().size(); ++i) {
    const Cell cell = cells()[i];
    if (cell.kind != CellKind::State) continue;
    ts.states.push_back({cell.start, init(cell.place), store_.value(cell.place)});
    if (cell.place == registerPlace(Reg::Running, 0)) ts.constraints.push_back(cell.start);
  }
  ts.inputs.insert(ts.inputs.end(), inputs_.begin(), inputs_.end());
  ts.totalConstraints = totalConstraints_;
  return ts;
}

}  // namespace rungproof
