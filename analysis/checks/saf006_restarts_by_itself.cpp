// SAF006: restarts by itself. An output that returns when a declared stop is released and nothing else changes: the
// same scan with empty memory leaves it off. Tested by tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include <map>
#include <set>

#include "analysis/asking/asking.hpp"
#include "analysis/asking/safety_shape.hpp"
#include "analysis/rule.hpp"
#include "analysis/witness/rested_scan.hpp"

namespace rungproof {

namespace {

/// Stops with the outputs that they are declared to hold off, each pair once.
std::vector<std::pair<StopInput, Place>> declaredStops(Asking& asking,
                                                       const std::map<Place, const Instruction*>& drivers) {
  std::set<std::pair<std::string, std::string>> known;
  std::vector<std::pair<StopInput, Place>> pairs;
  for (const Property& property : asking.properties().properties) {
    const auto shape = property.isGoal() ? stopShapeOf(property) : std::nullopt;
    if (!shape) continue;
    for (const StopInput& stop : shape->stops) {
      for (const Operand& output : shape->outputs) {
        const Place place = memoryPlace(output.area, output.offset, Width::Bit, output.bit);
        if (!known.emplace(toString(stop.input), toString(output)).second || !drivers.contains(place)) continue;
        asking.encoding().atEnd(place);
        asking.encoding().atStart(place);
        pairs.emplace_back(stop, place);
      }
    }
  }
  return pairs;
}

/// By input: that it is what it was in the scan before.
std::map<Place, Graph::Bool> unchangedInputs(Asking& asking) {
  std::map<Place, Graph::Bool> unchanged;
  for (const Cell& cell : asking.encoding().cells()) {
    if (cell.kind != CellKind::Input || cell.place.isRegister || cell.place.area != Area::I) continue;
    const Node before = asking.askedProperties().before("earlier " + nameOf(cell.place), cell.start);
    unchanged[cell.place] = asking.graph().equal({before}, {cell.start}, cell.place.width);
  }
  return unchanged;
}

void askSaf006(Asking& asking) {
  EncodedScan& encoding = asking.encoding();
  Graph& graph = asking.graph();
  const auto drivers = outputsOf(encoding);
  const auto pairs = declaredStops(asking, drivers);
  if (pairs.empty()) return;
  Substitution rested = restedScan(encoding);
  const std::map<Place, Graph::Bool> unchanged = unchangedInputs(asking);
  for (const auto& [stop, place] : pairs) {
    const Graph::Bool input{encoding.atEnd(stop.input, 1)};
    const Graph::Bool released = stop.activeWhenOff ? input : graph.lnot(input);
    const std::string name = nameOf(place), button = toString(stop.input);
    const Graph::Bool stopped{
        asking.askedProperties().before(fmt::format("{} stops {}", button, name), graph.lnot(released).node)};
    const Node on = encoding.atEnd(place);
    Graph::Bool bad =
        graph.land(graph.land(stopped, released), graph.land({on}, graph.lnot({encoding.atStart(place)})));
    bad = graph.land(bad, graph.lnot({rested(on)}));
    for (const auto& [other, same] : unchanged) {
      if (other != memoryPlace(stop.input.area, stop.input.offset, Width::Bit, stop.input.bit))
        bad = graph.land(bad, same);
    }
    asking.ask({.name = fmt::format("{} comes back with {}", name, button),
                .message = fmt::format(
                    "{} comes on by itself when the stop {} is released: memory from before the stop switches it on",
                    name, button),
                .address = name,
                .place = drivers.at(place),
                .bad = asking.askedProperties().atScanEnd(bad.node)});
  }
}

}  // namespace

extern constexpr Rule saf006_restarts_by_itself = {
    .id = "SAF006",
    .title = "Restarts by itself",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "an output that a declared stop (`not INPUT implies not OUTPUT`) holds off, and that comes on in the scan in "
        "which the stop is released and no other input changes, though with the same inputs it would stay off if the "
        "program remembered nothing",
    .why = "an unexpected restart: after a stop or a fault the machine must wait for a new start command",
    .bad =
        "//@ prove stop: not I0.1 implies not Q0.0\nNetwork 1\nLD I0.0\nS M0.0, 1\nNetwork 2\nLD I0.2\n"
        "R M0.0, 1\nNetwork 3\nLD M0.0\nA I0.1\n= Q0.0\n",
    .good =
        "//@ prove stop: not I0.1 implies not Q0.0\nNetwork 1\nLD I0.0\nS M0.0, 1\nNetwork 2\nLD I0.2\n"
        "ON I0.1\nR M0.0, 1\nNetwork 3\nLD M0.0\nA I0.1\n= Q0.0\n",
    .falsePositives = "a pause after which the machine is meant to go on",
    .ask = {.in = asked::Lint, .turn = 90, .cost = 2, .program = askSaf006},
    .tell = {.advice = "let the stop reset what starts the machine"},
};

}  // namespace rungproof
