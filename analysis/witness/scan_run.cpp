// Values of variables to scripts of the engine.
#include "analysis/witness/scan_run.hpp"

#include "ir/check.hpp"

namespace rungproof {

/// What a script depends on.
std::vector<Node> ScanRun::scriptNodes(const EncodedScan& scan) {
  std::vector<Node> nodes;
  for (const ScanInput& input : scanInputsOf(scan)) nodes.push_back(input.node);
  nodes.push_back(scan.time().dt());
  for (const ExternalInput& e : scan.externals()) {
    nodes.push_back(e.guard);
    if (e.node != noNode) nodes.push_back(e.node);
  }
  for (const DeviceWrite& write : scan.deviceWrites()) {
    nodes.push_back(write.guard);
    nodes.push_back(write.value);
  }
  for (const TickSite& t : scan.tickSites()) {
    nodes.push_back(t.where.guard);
    nodes.push_back(t.ticks);
  }
  for (const EventSite& e : scan.eventSites()) {
    nodes.push_back(e.where.guard);
    nodes.push_back(e.fires);
    nodes.push_back(e.waited);
  }
  for (const BoundarySite* site : scan.boundaries()) {
    for (const Node n : scan.visits(site->instruction)) nodes.push_back(n);
  }
  return nodes;
}

std::vector<Node> ScanRun::rootsOf(const EncodedScan& scan, const TransitionSystem& system,
                                   std::span<const Node> watched) {
  std::vector<Node> roots = scriptNodes(scan);
  roots.insert(roots.end(), watched.begin(), watched.end());
  for (const StateVariable& s : system.states) {
    roots.push_back(s.node);
    roots.push_back(s.next);
    if (s.init != noNode) roots.push_back(s.init);
  }
  roots.insert(roots.end(), system.inputs.begin(), system.inputs.end());
  roots.insert(roots.end(), system.constraints.begin(), system.constraints.end());
  for (const Node n : {scan.time().tensBefore(), scan.time().onesBefore()}) roots.push_back(n);
  return roots;
}

ScanRun::ScanRun(const EncodedScan& scan, const TransitionSystem& system, std::span<const Node> watched)
    : scan_(scan),
      system_(system),
      inputs_(scanInputsOf(scan)),
      values_(scan.graph(), rootsOf(scan, system, watched)) {}

void ScanRun::start() {
  values_.run();
  for (const StateVariable& s : system_.states) values_.set(s.node, s.init == noNode ? 0 : values_[s.init]);
}

bool ScanRun::evaluate() {
  values_.run();
  for (const Node constraint : system_.constraints) {
    if (!holds(constraint)) return false;
  }
  return true;
}

void ScanRun::advance() {
  std::vector<std::uint64_t> next;
  next.reserve(system_.states.size());
  for (const StateVariable& s : system_.states) next.push_back(values_[s.next]);
  for (std::size_t i = 0; i < next.size(); ++i) values_.set(system_.states[i].node, next[i]);
}

Concrete::Store ScanRun::initialState() const {
  Concrete::Store store = powerUpState(scan_.plan(), scan_.options().choices);
  for (const Cell& cell : scan_.cells()) {
    if (cell.kind != CellKind::State) continue;
    const Place& p = cell.place;
    const std::uint64_t value = values_[cell.start];
    if (p.isRegister) {
      store.set(p.reg, p.at, value, true);
    } else if (p.width == 1) {
      store.save(p.area, p.byte() * 8 + p.bit(), 1, value, true);
    } else {
      for (int i = 0; i < p.width; i += 8)
        store.save(p.area, p.at + static_cast<std::uint32_t>(i), 8, value >> (p.width - 8 - i) & 0xFF, true);
    }
  }
  setTickPhase(
      store, static_cast<std::uint32_t>(values_[scan_.time().tensBefore()] * 10 + values_[scan_.time().onesBefore()]));
  return store;
}

/// The engine counts the executions of an instruction that really happen.
ScanPlace ScanRun::placeOf(const BoundarySite& site) const {
  ScanPlace place{site.instruction, 0};
  if (site.instruction == ScanPlace::afterProgram) return place;
  const std::vector<Node>& visits = scan_.visits(site.instruction);
  for (std::uint32_t i = 0; i < site.visit; ++i) place.visit += holds(visits[i]) ? 1 : 0;
  return place;
}

ReplayScan ScanRun::script() const {
  ReplayScan result;
  for (const ScanInput& input : inputs_) result.inputs.push_back({input.operand, input.valueIn(values_[input.node])});
  result.lengthMs = static_cast<std::uint32_t>(values_[scan_.time().dt()]);
  for (const ExternalInput& e : scan_.externals()) {
    if (holds(e.guard)) result.externals.push_back({e.site, e.node == noNode ? 0 : values_[e.node]});
  }
  for (const DeviceWrite& write : scan_.deviceWrites()) {
    if (holds(write.guard))
      result.script.writes.push_back({{ScanPlace::startOfScan}, write.operand, values_[write.value]});
  }
  for (const TickSite& t : scan_.tickSites()) {
    const auto ticks = static_cast<std::uint32_t>(values_[t.ticks]);
    if (holds(t.where.guard) && ticks != 0) result.script.ticks1.push_back({placeOf(t.where), ticks});
  }
  for (const EventSite& e : scan_.eventSites()) {
    if (holds(e.where.guard) && holds(e.fires))
      result.script.events.push_back({placeOf(e.where), e.event, false, holds(e.waited)});
  }
  return result;
}

bool ScanRun::isScriptNew() {
  bool isNew = ofScript_.empty();
  if (isNew) {
    for (const Node n : scriptNodes(scan_)) ofScript_.emplace_back(n, 0);
  }
  for (auto& [node, value] : ofScript_) {
    isNew = isNew || values_[node] != value;
    value = values_[node];
  }
  return isNew;
}

}  // namespace rungproof
