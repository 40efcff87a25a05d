// Where pointers of a scan can lead, by the value analysis, and what becomes of accesses whose targets are not known.
#include <algorithm>
#include <utility>

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
ValueSet ScanEncoding::pointerValues(Node pointer, Node guard) {
  if (later_.empty()) return ValueEvaluator(graph, known_).valuesOf(pointer, guard, pointerValueLimit);
  VariableValues known = known_;
  const auto setFirst = [&](std::uint64_t value) {
    for (const Cell& cell : cells()) {
      const std::vector<Place>& firsts = knowledge_.firstScans;
      if (std::find(firsts.begin(), firsts.end(), cell.place) != firsts.end()) known[cell.start] = ValueSet::of(value);
    }
  };
  setFirst(1);
  ValueSet values = ValueEvaluator(graph, known).valuesOf(pointer, guard, pointerValueLimit);
  for (const auto& [cell, after] : later_) known[cell] = after;
  setFirst(0);
  values.join(ValueEvaluator(graph, known).valuesOf(pointer, guard, pointerValueLimit), pointerValueLimit);
  return values;
}

/// The same after what the guard decides has been chosen, where that is needed to list them.
ValueSet ScanEncoding::listedOrBounded(Node pointer, Node guard) {
  const auto valuesOf = [&](Node node, Node condition) {
    return pointerValues(node, condition).listedIfFew(pointerValueLimit);
  };
  const ValueSet values = valuesOf(pointer, guard);
  if (values.isListed()) return values;
  const Assumed here = assuming(graph, pointer, guard);
  return valuesOf(here.node, here.guard);
}

/// All values that the pointer can have here; nothing if they are too many.
std::optional<std::vector<std::uint64_t>> ScanEncoding::targetsOf(Node pointer, Node guard) {
  const auto values = graph.listed([&]() -> std::optional<std::vector<std::uint64_t>> {
    for (const Node n : variablesOf(graph, pointer)) {
      if (graph.variables()[graph[n].value].isState) pointerCells_.insert(n);
    }
    if (!knowledge_.followsPointers) return std::nullopt;
    const ValueSet values = listedOrBounded(pointer, guard);
    if (!values.isListed()) return std::nullopt;
    return values.values();
  });
  if (!values || !graph.isAsWritten()) return values;
  Graph::Bool isIn = graph.constant(false);
  const int width = graph[pointer].width;
  for (const std::uint64_t value : *values)
    isIn = graph.lor(isIn, graph.equal({pointer}, graph.literal(value, width), width));
  tellList(isIn);
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
  Graph::Bool legal = graph.constant(true);
  for (const std::uint64_t value : *values) {
    const Graph::Bool isValue = graph.equal(pointer, graph.literal(value, 32), 32);
    const auto address = static_cast<std::uint32_t>(value);
    const bool isPlace = pointer::isLegal(machine.target, address, width);
    if (isPlace) tell(address);
    if (isPlace)
      ref.targets.push_back({isValue, *pointer::areaOf(address), pointer::offsetOf(address)});
    else
      legal = graph.land(legal, graph.lnot(isValue));
  }
  if (ref.targets.empty()) return graph.constant(false);
  if (values->size() == 1) {
    ref.isPlace = true;
    ref.area = ref.targets[0].area;
    ref.offset = ref.targets[0].offset;
    ref.targets.clear();
  }
  return legal;
}

std::optional<std::vector<std::uint64_t>> ScanEncoding::locations(Machine<Graph>& machine, Graph::Bits location) {
  return targetsOf(location.node, machine.guard.node);
}

std::optional<std::vector<std::uint64_t>> ScanEncoding::locationsInBlock(Machine<Graph>& machine, Graph::Bits location,
                                                                         Width width) {
  const auto start = graph.listed([&]() -> std::optional<std::vector<std::uint64_t>> {
    if (!knowledge_.followsPointers) return std::nullopt;
    const Graph::Facts facts = listedOrBounded(location.node, machine.guard.node).facts();
    const std::optional<std::uint32_t> block = blockOfLocation(facts.ones, facts.zeros | facts.ones);
    return block ? std::optional(std::vector{locationInBlock(*block, 0)}) : std::nullopt;
  });
  if (!start || start->empty()) return std::nullopt;
  constexpr int addressBits = 24;
  const auto block = static_cast<std::uint32_t>(start->front() >> addressBits & 0xFFFF);
  const int w = graph[location.node].width, above = w - addressBits;
  tellList(graph.equal(graph.extract(location, w - 1, addressBits), graph.literal(start->front() >> addressBits, above),
                       above));
  const std::uint32_t length = plan_.blocks->length(block), own = static_cast<std::uint32_t>(bytes(width));
  const std::uint32_t step = width == Width::Bit ? 1 : 8, count = length < own ? 0 : (length - own + 1) * 8 / step;
  if (count > pointerValueLimit) return std::nullopt;
  std::vector<std::uint64_t> places;
  for (std::uint32_t i = 0; i < count; ++i) places.push_back(locationInBlock(block, i * step));
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
