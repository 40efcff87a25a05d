// SAF005: energised in the first scan. An output that old memory switches on at power-up: the same scan, with the same
// inputs but with empty memory, leaves it off. Tested by tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include "analysis/asking/asking.hpp"
#include "analysis/rule.hpp"
#include "analysis/witness/rested_scan.hpp"

namespace rungproof {

namespace {

std::string powerUpMessage(const BitRow& row, std::string_view) {
  return fmt::format("{} can be on at the end of the first scan because of what retentive memory holds", row.text());
}

void askSaf005(Asking& asking) {
  EncodedScan& encoding = asking.encoding();
  Graph& graph = asking.graph();
  const auto outputs = outputsOf(encoding);
  for (const auto& [place, driver] : outputs) encoding.atEnd(place);
  const Graph::Bool first{encoding.firstScan()};
  Substitution rested = restedScan(encoding);
  for (const auto& [place, driver] : outputs) {
    const Node on = encoding.atEnd(place);
    const Graph::Bool switchedOn = graph.land(first, graph.land({on}, graph.lnot({rested(on)})));
    const Graph::Bool bad{asking.askedProperties().atScanEnd(switchedOn.node)};
    if (const auto known = graph.truth(bad); known && !*known) continue;
    const std::string name = nameOf(place);
    const BitRow row{place.area, {bitPosition(place.area, place.byte(), place.bit())}};
    asking.ask({.name = fmt::format("{} is on after power-up", name),
                .message = powerUpMessage(row, {}),
                .address = name,
                .place = driver,
                .bad = bad.node,
                .row = row});
  }
}

}  // namespace

extern constexpr Rule saf005_energised_in_first_scan = {
    .id = "SAF005",
    .title = "Energised in the first scan",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "an output that is on at the end of the first scan for some content of retentive memory and some inputs, and "
        "off with the same inputs when memory is empty",
    .why =
        "retentive V, M, T and C values survive the loss of power, and the machine starts by itself when power returns",
    .manual = "001:1619",
    .bad = "Network 1\nLD I0.0\nS V0.0, 1\nNetwork 2\nLDN I0.1\nR V0.0, 1\nNetwork 3\nLD V0.0\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nS V0.0, 1\nNetwork 2\nLDN I0.1\nO SM0.1\nR V0.0, 1\nNetwork 3\nLD V0.0\n= Q0.0\n",
    .falsePositives = "lamps and other outputs that are meant to show what was",
    .ask = {.in = asked::PowerUp, .cost = 2, .program = askSaf005},
    .tell = {.advice = "reset the bit that holds it in the first scan (SM0.1), on an S7-300/400 in OB100",
             .bits = powerUpMessage},
};

}  // namespace rungproof
