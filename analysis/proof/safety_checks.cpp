// Outputs that old memory switches on, for lint --prove: in the first scan after power-up (SAF005), and in the scan in
// which a declared stop is released and no other input changes (SAF006). Memory is the cause if the same scan, with the
// same inputs but with memory at its values of power-up, leaves the output off; a start button that is held down is
// therefore no cause.
// Covered by tests/prover/rule_questions_test.cpp.
#include <fmt/format.h>

#include <map>
#include <set>
#include <unordered_map>

#include "analysis/graph/substitution.hpp"
#include "analysis/proof/builtin_checks.hpp"
#include "analysis/proof/safety_shape.hpp"
#include "analysis/proof/scan_run.hpp"

namespace rungproof {

namespace {

/// What the program remembers. Edges keep their memory: whether a button was pressed just now is no old state.
bool isMemory(const Place& place) {
  if (!place.isRegister) return place.area != Area::SM;
  switch (place.reg) {
    case Reg::Accumulator:
    case Reg::TimerCurrent:
    case Reg::TimerBit:
    case Reg::TimerRunning:
    case Reg::CounterCurrent:
    case Reg::CounterBit: return true;
    default: return false;
  }
}

/// Values of the end of a scan as they would be with the program's memory at rest, as power-up leaves it, at its start.
Substitution restedScan(EncodedScan& encoding) {
  const Concrete::Store rest = powerUpState(encoding.plan(), encoding.options().choices);
  std::unordered_map<std::uint32_t, Node> atRest;
  for (const Cell& cell : encoding.cells()) {
    if (cell.kind == CellKind::State && isMemory(cell.place))
      atRest[indexOf(cell.start)] = encoding.graph().constantNode(valueAt(cell.place, rest), cell.place.width);
  }
  return Substitution(encoding.graph(), std::move(atRest));
}

/// Output bits with the first instruction that drives them.
std::map<Place, const Instruction*> outputsOf(const EncodedScan& encoding) {
  std::map<Place, const Instruction*> outputs;
  for (const BitWrite& write : encoding.bitWrites()) {
    if (!write.place.isRegister && write.place.area == Area::Q && write.instruction != nullptr)
      outputs.emplace(write.place, write.instruction);
  }
  return outputs;
}

}  // namespace

void addPowerUpChecks(const Program&, Obligations& obligations, std::vector<BuiltinCheck>& checks) {
  EncodedScan& encoding = obligations.encoding();
  Graph& graph = encoding.graph();
  const auto outputs = outputsOf(encoding);
  for (const auto& [place, driver] : outputs) encoding.atEnd(place);
  const Graph::Bool first{encoding.firstScan()};
  Substitution rested = restedScan(encoding);
  for (const auto& [place, driver] : outputs) {
    const Node on = encoding.atEnd(place);
    const Graph::Bool switchedOn = graph.land(first, graph.land({on}, graph.lnot({rested(on)})));
    const Graph::Bool bad{obligations.atScanEnd(switchedOn.node)};
    if (const auto known = graph.truth(bad); known && !*known) continue;
    const std::string name = nameOf(place);
    const BitRow row{place.area, {bitPosition(place.area, place.byte(), place.bit())}};
    checks.push_back({BuiltinKind::PowerUp, fmt::format("{} is on after power-up", name), "SAF005", powerUpMessage(row),
                      name, driver, nullptr, bad.node, row});
  }
}

void addRestartChecks(const PropertySet& set, Obligations& obligations, std::vector<BuiltinCheck>& checks) {
  EncodedScan& encoding = obligations.encoding();
  Graph& graph = encoding.graph();
  const auto drivers = outputsOf(encoding);
  std::set<std::pair<std::string, std::string>> asked;
  std::vector<std::tuple<StopInput, Place>> pairs;
  for (const Property& property : set.properties) {
    const auto shape = property.isGoal() ? stopShapeOf(property) : std::nullopt;
    if (!shape) continue;
    for (const StopInput& stop : shape->stops) {
      for (const Operand& output : shape->outputs) {
        const Place place = memoryPlace(output.area, output.offset, Width::Bit, output.bit);
        if (!asked.emplace(toString(stop.input), toString(output)).second || !drivers.contains(place)) continue;
        encoding.atEnd(place);
        encoding.atStart(place);
        pairs.emplace_back(stop, place);
      }
    }
  }
  if (pairs.empty()) return;
  Substitution rested = restedScan(encoding);
  std::map<Place, Graph::Bool> unchanged;  // by input
  for (const Cell& cell : encoding.cells()) {
    if (cell.kind != CellKind::Input || cell.place.isRegister || cell.place.area != Area::I) continue;
    const Node before = obligations.before("earlier " + nameOf(cell.place), cell.start);
    unchanged[cell.place] = graph.equal({before}, {cell.start}, cell.place.width);
  }
  for (const auto& [stop, place] : pairs) {
    const Graph::Bool input{encoding.atEnd(stop.input, 1)};
    const Graph::Bool released = stop.activeWhenOff ? input : graph.lnot(input);
    const std::string name = nameOf(place), button = toString(stop.input);
    const Graph::Bool stopped{obligations.before(fmt::format("{} stops {}", button, name), graph.lnot(released).node)};
    const Node on = encoding.atEnd(place);
    Graph::Bool bad =
        graph.land(graph.land(stopped, released), graph.land({on}, graph.lnot({encoding.atStart(place)})));
    bad = graph.land(bad, graph.lnot({rested(on)}));
    for (const auto& [other, same] : unchanged) {
      if (other != memoryPlace(stop.input.area, stop.input.offset, Width::Bit, stop.input.bit))
        bad = graph.land(bad, same);
    }
    const Instruction* driver = drivers.at(place);
    checks.push_back(
        {BuiltinKind::Restart, fmt::format("{} comes back with {}", name, button), "SAF006",
         fmt::format("{} comes on by itself when the stop {} is released: memory from before the stop switches it on",
                     name, button),
         name, driver, nullptr, obligations.atScanEnd(bad.node)});
  }
}

}  // namespace rungproof
