// Runs the transition system, and then the engine along its script.
#include "tests/differential/scan_agreement.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "analysis/witness/scan_run.hpp"
#include "tests/differential/random_source.hpp"

namespace rungproof {

namespace {

std::uint64_t valueIn(const Concrete::Store& store, const Place& place) {
  if (place.isRegister) return store.get(place.reg, place.at);
  std::uint64_t value = 0;
  for (std::uint32_t i = 0; i < place.width; ++i) {
    const std::uint32_t at = place.at + i;
    value = value << 1 | store.load(place.area, at / 8 * 8 + 7 - at % 8, 1);
  }
  return value;
}

/// What both sides must agree on. The phases of the tick clocks are kept as digits in the transition system.
bool isCompared(const Place& place) {
  return !place.isRegister ||
         (place.reg != Reg::PhaseTen && place.reg != Reg::PhaseHundred && place.reg != Reg::PhysicalOutput);
}

}  // namespace

AgreementOutcome compareScans(const Program& program, std::uint64_t seed, int scanCount,
                              const AgreementQuestion& question) {
  const auto& [options, asked, usesAllExternals, seen] = question;
  AgreementOutcome outcome;
  EncodedScan scan(program, options);
  for (const Place& place : asked) scan.atEnd(place);
  const TransitionSystem system = scan.system();
  // What is estimated in some scans, or left out from some place on, only says in which; its inputs stay 0 here, and
  // such a scan is not compared.
  std::vector<Node> estimates;
  std::set<Node> kept;
  for (const Approximation& approximation : scan.approximations()) {
    outcome.approximation += approximation.reason + "\n";
    const Node mark = approximation.used != noNode ? approximation.used : approximation.leftOut;
    if (mark == noNode) {
      outcome.isExact = false;
      return outcome;
    }
    estimates.push_back(mark);
    kept.insert(approximation.carriers.begin(), approximation.carriers.end());
  }
  std::vector<Place> places;
  std::vector<Node> ends;
  for (const Place& place : !asked.empty() ? asked : scan.places()) {
    if (!isCompared(place)) continue;
    places.push_back(place);
    ends.push_back(scan.atEnd(place));
  }
  std::vector<Node> watched = ends;
  watched.insert(watched.end(), estimates.begin(), estimates.end());
  ScanRun run(scan, system, watched);
  RandomSource inputs(seed);
  run.start();
  for (const StateVariable& s : system.states) {
    if (s.init == noNode) run.set(s.node, inputs.value(scan.graph()[s.node].width));
  }
  std::optional<Concrete::Store> initial;
  std::vector<ReplayScan> script;
  std::vector<std::vector<std::uint64_t>> expected;
  for (int k = 0; k < scanCount; ++k) {
    bool isScan = false;
    for (int tries = 0; tries < 200 && !isScan; ++tries) {
      for (const Node input : system.inputs) {
        if (kept.contains(input)) continue;
        if (tries == 0 && k > 0 && inputs.chance(60)) continue;  // most inputs keep their values for a while
        const int width = scan.graph()[input].width;
        run.set(input, tries > 20 && inputs.chance(50) ? inputs.below(10) : inputs.value(width));
      }
      isScan = run.evaluate();
    }
    if (!isScan) break;  // the program has stopped
    if (std::ranges::any_of(estimates, [&](Node used) { return run[used] != 0; })) {
      outcome.isExact = k > 0;
      break;
    }
    if (k == 0) initial = run.initialState();
    script.push_back(run.script());
    expected.emplace_back();
    for (const Node end : ends) expected.back().push_back(run[end]);
    for (std::size_t i = 0; k == 0 && seen && i < places.size(); ++i) seen(places[i], expected[0][i]);
    run.advance();
  }
  const ReplayResult result = replay(program, options.choices, script, initial ? &*initial : nullptr);
  outcome.scans = static_cast<int>(result.states.size());
  if (result.states.size() != script.size())
    outcome.difference =
        "engine made " + std::to_string(result.states.size()) + " of " + std::to_string(script.size()) + " scans";
  for (std::size_t k = 0; k < result.states.size() && outcome.difference.empty(); ++k) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::uint64_t actual = valueIn(result.states[k], places[i]);
      if (actual == expected[k][i]) continue;
      outcome.difference += "scan " + std::to_string(k + 1) + ", " + nameOf(places[i]) + ": engine " +
                            std::to_string(actual) + ", transition system " + std::to_string(expected[k][i]) + "\n";
    }
  }
  if (outcome.difference.empty() && asked.empty() && usesAllExternals && result.unusedExternals != 0)
    outcome.difference = std::to_string(result.unusedExternals) + " external values unused";
  return outcome;
}

}  // namespace rungproof
