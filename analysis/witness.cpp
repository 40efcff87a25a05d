// From valuations of variables to scans, and the verdict of engine and monitors on them.
#include "analysis/witness.hpp"

#include <algorithm>
#include <map>

#include "analysis/follower.hpp"
#include "analysis/scan_run.hpp"
#include "engine/start_up.hpp"

namespace rungproof {

std::uint64_t valueIn(const Concrete::Store& state, const Operand& o) {
  switch (o.area) {
    case Area::T: return state.get(o.width == Width::Bit ? Reg::TimerBit : Reg::TimerCurrent, o.offset);
    case Area::C: return state.get(o.width == Width::Bit ? Reg::CounterBit : Reg::CounterCurrent, o.offset);
    case Area::AC: return state.get(Reg::Accumulator, o.offset);
    case Area::HC: return state.get(Reg::HscCurrent, o.offset);
    default: return state.load(o.area, o.offset * 8 + (o.width == Width::Bit ? o.bit : 0), bits(o.width));
  }
}

namespace {

struct NoOutside final : Outside {
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};

}  // namespace

Judge::Judge(const Program& program, const Choices& choices, const std::vector<Property>& assumptions, const Property& goal)
    : program_(program), choices_(choices), assumptions_(assumptions), goal_(goal) {}

Judge::Outcome Judge::run(const std::vector<ReplayScan>& scans, const Concrete::Store* initial) const {
  NoOutside outside;
  Concrete domain(outside);
  Follower goal(goal_);
  std::vector<Follower> assumptions;
  for (const Property& assumption : assumptions_) assumptions.emplace_back(assumption);
  Outcome outcome;
  std::size_t step = ~std::size_t{0};
  replay(program_, choices_, scans, initial, [&](const Concrete::Store& state, std::size_t at) {
    outcome.round = at == step ? outcome.round + 1 : 0;
    outcome.step = step = at;
    const bool isFirst = outcome.scan++ == 0;
    outcome.milliseconds += scans[at].lengthMs;
    for (Follower& assumption : assumptions) {
      if (!assumption.evaluate(domain, state, scans[at], isFirst)) outcome.assumptionBroken = true;
    }
    outcome.shown = !outcome.assumptionBroken && goal.evaluate(domain, state, scans[at], isFirst);
    return !outcome.shown && !outcome.assumptionBroken;
  });
  return outcome;
}

std::optional<Witness> Judge::witness(std::vector<ReplayScan> scans, std::optional<Concrete::Store> initial) const {
  const Outcome outcome = run(scans, initial ? &*initial : nullptr);
  if (!outcome.shown) return std::nullopt;
  scans.resize(outcome.step + 1);
  scans.back().repeats = outcome.round + 1;
  return Witness{std::move(scans), {}, std::move(initial), outcome.scan, outcome.milliseconds};
}

namespace {

void setInitial(ScanRun& run, const TransitionSystem& system, const WordTrace& trace) {
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    if (system.states[i].init == noNode) run.set(system.states[i].node, trace.initial[i]);
  }
}

/// Real scans that last `length` ms together: how many of which length, nearly equal ones, the longer first.
struct Stretch {
  std::uint32_t length;
  std::uint32_t count;
};
std::vector<Stretch> stretchOf(std::uint32_t length, const TimeRange& range) {
  length = std::max(length, range.low);
  const std::uint32_t scans = (length + range.high - 1) / range.high;
  if (range.low == range.high || scans == 1) return {{std::min(length, range.high), scans}};
  const std::uint32_t longer = length % scans;
  std::vector<Stretch> parts;
  if (longer > 0) parts.push_back({length / scans + 1, longer});
  parts.push_back({length / scans, scans - longer});
  return parts;
}

}  // namespace

std::vector<ReplayScan> scansOf(EncodedScan& encoding, const TransitionSystem& system, const WordTrace& trace, const TimeRange& range) {
  std::vector<ReplayScan> scans;
  ScanRun run(encoding, system);
  run.start();
  setInitial(run, system, trace);
  for (const std::vector<std::uint64_t>& inputs : trace.inputs) {
    for (std::size_t i = 0; i < system.inputs.size(); ++i) run.set(system.inputs[i], inputs[i]);
    run.evaluate();
    ReplayScan scan = run.script();
    scan.script.ticks10.reset();  // the engine counts its own: stretches have become several scans
    scan.script.ticks100.reset();
    for (const Stretch& part : stretchOf(scan.lengthMs, range)) {
      // Ticks and events inside the scan belong to its first part.
      scan.lengthMs = part.length;
      scan.repeats = 1;
      scans.push_back(scan);
      scan.script = {};
      scan.repeats = part.count - 1;
      if (scan.repeats > 0) scans.push_back(scan);
    }
    run.advance();
  }
  return scans;
}

std::optional<Concrete::Store> initialOf(EncodedScan& encoding, const TransitionSystem& system, const WordTrace& trace) {
  const auto isFree = [](const StateVariable& state) { return state.init == noNode; };
  if (std::none_of(system.states.begin(), system.states.end(), isFree)) return std::nullopt;
  ScanRun run(encoding, system);
  run.start();
  setInitial(run, system, trace);
  run.evaluate();
  return run.initialState();
}

namespace {

std::string nameIn(const TransitionSystem& system, Node variable) { return system.graph->variables()[(*system.graph)[variable].value].name; }

/// Digits of time that the exact model chooses in a scan that lasts `length` ms and begins `now` ms after power-up.
std::optional<std::uint64_t> digitOf(const std::string& name, std::uint64_t now, std::uint64_t length) {
  const std::uint64_t then = now + length;
  if (name == "time.hundreds") return then / 100 - now / 100;
  if (name == "time.tens") return then / 10 % 10;
  if (name == "time.ones") return then % 10;
  return std::nullopt;
}

/// The value that a cell has in a state of the engine.
std::uint64_t valueOf(const Cell& cell, const Concrete::Store& state) {
  const Place& p = cell.place;
  if (p.isRegister) return state.get(p.reg, p.at);
  std::uint64_t value = 0;
  for (std::uint32_t i = 0; i < p.width; ++i) value = value << 1 | state.load(p.area, (p.at + i) / 8 * 8 + 7 - (p.at + i) % 8, 1);
  return value;
}

/// ms of each scan of a found run, from its time digits.
std::vector<std::uint32_t> lengthsOf(const TransitionSystem& found, const WordTrace& trace) {
  std::vector<std::uint32_t> lengths;
  std::uint64_t tens = 0, ones = 0;
  for (const std::vector<std::uint64_t>& inputs : trace.inputs) {
    std::uint64_t hundreds = 0, nextTens = tens, nextOnes = ones;
    for (std::size_t i = 0; i < found.inputs.size(); ++i) {
      const std::string name = nameIn(found, found.inputs[i]);
      if (name == "time.hundreds") hundreds = inputs[i];
      if (name == "time.tens") nextTens = inputs[i];
      if (name == "time.ones") nextOnes = inputs[i];
    }
    lengths.push_back(static_cast<std::uint32_t>(100 * hundreds + 10 * nextTens + nextOnes - 10 * tens - ones));
    tens = nextTens;
    ones = nextOnes;
  }
  return lengths;
}

}  // namespace

std::optional<Witness> agreedRun(const Program& program, const Choices& choices, EncodedScan& exact, const TransitionSystem& exactSystem, Node bad,
                                 const TransitionSystem& found, const WordTrace& trace, const TimeRange& range) {
  std::map<std::string, std::size_t> inputNamed;
  for (std::size_t i = 0; i < found.inputs.size(); ++i) inputNamed[nameIn(found, found.inputs[i])] = i;
  std::map<std::string, std::size_t> stateNamed;
  for (std::size_t i = 0; i < found.states.size(); ++i) stateNamed[nameIn(found, found.states[i].node)] = i;
  const std::vector<Node> watched{bad};
  ScanRun run(exact, exactSystem, watched);
  run.start();
  for (const StateVariable& state : exactSystem.states) {
    const auto given = stateNamed.find(nameIn(exactSystem, state.node));
    if (state.init == noNode && given != stateNamed.end()) run.set(state.node, trace.initial[given->second]);
  }
  run.evaluate();
  Witness witness;
  const bool isFreeStart = std::any_of(exactSystem.states.begin(), exactSystem.states.end(), [](const StateVariable& s) { return s.init == noNode; });
  if (isFreeStart) witness.initial = run.initialState();

  const std::vector<std::uint32_t> lengths = lengthsOf(found, trace);
  std::vector<std::vector<std::uint64_t>> predicted;
  bool isShown = false;
  for (std::size_t i = 0; i < trace.inputs.size() && !isShown; ++i) {
    for (const Stretch& part : stretchOf(lengths[i], range)) {
      for (std::uint32_t k = 0; k < part.count && !isShown; ++k) {
        for (const Node input : exactSystem.inputs) {
          const std::string name = nameIn(exactSystem, input);
          const auto given = inputNamed.find(name);
          const auto digit = digitOf(name, witness.milliseconds, part.length);
          run.set(input, digit ? *digit : given == inputNamed.end() ? 0 : trace.inputs[i][given->second]);
        }
        if (!run.evaluate()) return std::nullopt;
        isShown = run[bad] != 0;
        witness.scans.push_back(run.script());
        witness.scans.back().lengthMs = part.length;
        std::vector<std::uint64_t> after;
        for (const StateVariable& state : exactSystem.states) after.push_back(run[state.next]);
        predicted.push_back(std::move(after));
        run.advance();
        witness.milliseconds += part.length;
        ++witness.scanCount;
      }
    }
  }
  if (!isShown) return std::nullopt;
  std::map<Node, std::size_t> stateOf;
  for (std::size_t i = 0; i < exactSystem.states.size(); ++i) stateOf[exactSystem.states[i].node] = i;
  bool agrees = true;
  replay(program, choices, witness.scans, witness.initial ? &*witness.initial : nullptr, [&](const Concrete::Store& state, std::size_t at) {
    for (const Cell& cell : exact.cells()) {
      const auto place = stateOf.find(cell.start);
      // The time model counts ticks by digits of its own; the phases that the engine counts them by mean nothing there.
      const bool isPhase = cell.place.isRegister && (cell.place.reg == Reg::PhaseTen || cell.place.reg == Reg::PhaseHundred);
      if (cell.kind != CellKind::State || place == stateOf.end() || isPhase) continue;
      agrees = agrees && valueOf(cell, state) == predicted[at][place->second];
    }
    return agrees;
  });
  if (!agrees) return std::nullopt;
  return witness;
}

}  // namespace rungproof
