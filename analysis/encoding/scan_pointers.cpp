// Where pointers of a scan can lead, by the value analysis, and what becomes of accesses whose targets are not known.
#include <algorithm>
#include <utility>

#include "analysis/encoding/pointer_targets.hpp"
#include "analysis/encoding/scan_encoding.hpp"
#include "ir/s7200/isa/comm.hpp"
#include "ir/s7300/place.hpp"

namespace rungproof {

namespace {

constexpr std::string_view unresolvedReason = "pointer whose targets could not be found";

/// Whether a pointer of the instruction, wherever it leads, may lead into one of those areas.
bool mayReach(const Instruction* instruction, std::initializer_list<Area> areas) {
  bool isElsewhere = false;
  for (const Operand& o : instruction == nullptr ? Operands() : instruction->operands) {
    if (o.kind != OperandKind::Indirect || o.reach == nullptr) continue;
    const bool isWithin = o.reach->way == Way::Pointer || o.reach->way == Way::Register;
    if (!isWithin || std::ranges::find(areas, o.area) != areas.end()) return true;
    isElsewhere = true;
  }
  return !isElsewhere;
}

}  // namespace

/// In the first scan, what cells start with; in all others, what they have become.
ValueSet ScanEncoding::pointerValues(Node pointer, Node guard, Evaluation evaluation) {
  const auto valuesWith = [&](const VariableValues& known) {
    return (ValueEvaluator(graph, known).*evaluation)(pointer, guard, pointerValueLimit);
  };
  if (later_.empty()) return valuesWith(known_);
  VariableValues known = known_;
  const auto setFirst = [&](std::uint64_t value) {
    for (const Cell& cell : cells()) {
      const std::vector<Place>& firsts = knowledge_.firstScans;
      if (std::find(firsts.begin(), firsts.end(), cell.place) != firsts.end()) known[cell.start] = ValueSet::of(value);
    }
  };
  setFirst(1);
  ValueSet values = valuesWith(known);
  for (const auto& [cell, after] : later_) known[cell] = after;
  setFirst(0);
  values.join(valuesWith(known), pointerValueLimit);
  return values;
}

ValueSet ScanEncoding::whereItLeads(Node pointer, Node guard) {
  return listedOrBounded(graph, pointer, guard, pointerValueLimit, [this](Node node, Node condition) {
    return pointerValues(node, condition, &ValueEvaluator::valuesByCase);
  });
}

/// All values that the pointer can have here; nothing if they are too many.
std::optional<std::vector<std::uint64_t>> ScanEncoding::targetsOf(Node pointer, Node guard) {
  const auto values = graph.listed([&]() -> std::optional<std::vector<std::uint64_t>> {
    for (const Node n : partsOf(graph, pointer)) {
      if (graph.variables()[graph[n].value].isState) pointerCells_.insert(n);
    }
    if (!knowledge_.followsPointers) return std::nullopt;
    const ValueSet values = whereItLeads(pointer, guard);
    if (!values.isListed()) return std::nullopt;
    return values.values();
  });
  if (!values || !graph.isAsWritten()) return values;
  tellList(isAmong(graph, pointer, *values));
  return values;
}

/// The values that the pointer can have here decide between a few places; a legal one is always among them.
Graph::Bool ScanEncoding::targets(Machine<Graph>& machine, Graph::Bits pointer, Width width, Ref<Graph>& ref) {
  const bool isOfDevice = machine.current != nullptr && machine.current->desc->group == "communication";
  // What no operand names is the own data of GET.
  auto& told = ref.operand != nullptr ? tableTargets_.tables : tableTargets_.buffers;
  const auto tell = [&](std::uint32_t address) {
    if (isOfDevice) told[machine.current->id].insert(address);
  };
  const std::optional<std::vector<std::uint64_t>> values = targetsOf(pointer.node, machine.guard.node);
  if (!values) {
    ref.isUnresolved = true;
    tell(isa::unknownAddress);
    Approximation& a = approximate(machine.current, unresolvedReason);
    a.carriers.push_back(input("pointer is legal", 1));
    return {a.carriers.back()};
  }
  return leadTo(graph, machine, pointer, width, *values, ref, tell);
}

std::optional<std::vector<std::uint64_t>> ScanEncoding::locations(Machine<Graph>& machine, Graph::Bits location) {
  return targetsOf(location.node, machine.guard.node);
}

std::optional<std::vector<std::uint64_t>> ScanEncoding::locationsInBlock(Machine<Graph>& machine, Graph::Bits location,
                                                                         Width width) {
  const auto start = graph.listed([&]() -> std::optional<std::vector<std::uint64_t>> {
    if (!knowledge_.followsPointers) return std::nullopt;
    return startOfBlock(whereItLeads(location.node, machine.guard.node));
  });
  if (!start || start->empty()) return std::nullopt;
  Graph::Bool isInBlock{};
  auto places = placesInBlock(graph, plan_, location, start->front(), width, pointerValueLimit, isInBlock);
  tellList(isInBlock);
  return places;
}

/// A module may be asked that does not answer, which calls OB122; a block may be written that is protected.
void ScanEncoding::meetUnknownErrors(Machine<Graph>& machine, bool isWrite) {
  if (!plan_.dialect().memory.pointersMayMiss) return;
  const auto any = [&](const char* name) {
    const Node node = input(name, 1);
    approximate(machine.current, unresolvedReason).carriers.push_back(node);
    return Graph::Bool{node};
  };
  if (plan_.block(accessErrorBlock) != nullptr && mayReach(machine.current, {Area::PI, Area::PQ}))
    machine.accessError(any("module behind a pointer fails"));
  if (!isWrite || !mayReach(machine.current, {Area::DB})) return;
  for (std::uint32_t block = 0; block <= lastDataBlock; ++block) {
    if (plan_.blocks->isReadOnly(block)) return machine.error(Hazard::S7WriteProtected, any("block is protected"));
  }
}

Graph::Bits ScanEncoding::unresolved(Machine<Graph>& machine, int width) {
  meetUnknownErrors(machine, false);
  Approximation& a = approximate(machine.current, unresolvedReason);
  a.carriers.push_back(input("value behind a pointer", width));
  return {a.carriers.back()};
}

void ScanEncoding::havoc(Machine<Graph>& machine) {
  meetUnknownErrors(machine, true);
  havocBy(machine, approximate(machine.current, unresolvedReason));
}

}  // namespace rungproof
