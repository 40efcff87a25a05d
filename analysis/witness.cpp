// From valuations of variables to scans, and the verdict of engine and monitors on them.
#include "analysis/witness.hpp"

#include <algorithm>
#include <unordered_map>

#include "analysis/evaluate.hpp"
#include "analysis/monitor.hpp"
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

/// One property followed along a run of the engine.
class Follower {
 public:
  explicit Follower(const Property& property) : property_(property), cells_(property.cells.size(), 0) {}

  bool evaluate(Concrete& domain, const Concrete::Store& state, const ReplayScan& scan, bool isFirst) {
    const auto leaf = [&](const Operand& o, int width) -> std::uint64_t {
      if (o.area == Area::AI) return analog(scan, o.offset);
      Operand address = o;
      if (o.area == Area::T || o.area == Area::C) address.width = width == 1 ? Width::Bit : Width::Word;
      return valueIn(state, address);
    };
    std::vector<std::uint64_t> after = cells_;
    const Moment<Concrete> moment{isFirst, scan.lengthMs, 32};
    const bool answer = Monitor<Concrete, decltype(leaf)>(domain, property_, leaf, moment, cells_, after).evaluate();
    cells_ = std::move(after);
    return answer;
  }

 private:
  /// The last value that the scan read from that analog input.
  static std::uint64_t analog(const ReplayScan& scan, std::uint32_t address) {
    std::uint64_t value = 0;
    for (const ExternalValue& external : scan.externals) {
      if (external.site.kind == External::AnalogInput && external.site.index == address) value = external.value;
    }
    return value;
  }

  const Property& property_;
  std::vector<std::uint64_t> cells_;
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
  return Witness{std::move(scans), std::move(initial), outcome.scan, outcome.milliseconds};
}

namespace {

/// The valuation of one scan over all nodes of interest.
class Valuation {
 public:
  Valuation(Encoding& encoding, const TransitionSystem& system, const WordTrace& trace) : system_(system), trace_(trace), evaluator_(encoding.graph(), roots(encoding, system)) {
    for (const StateVariable& state : system.states) {
      Evaluator init(encoding.graph(), std::span(&state.init, state.init == noNode ? 0 : 1));
      if (state.init != noNode) {
        init.run();
        before_[state.node] = init[state.init];
      }
    }
    for (const auto& [node, value] : trace.initial) before_[node] = value;
  }

  void load(std::size_t scan) {
    for (const Node input : system_.inputs) evaluator_.set(input, 0);
    for (const auto& [node, value] : before_) evaluator_.set(node, value);
    for (const auto& [node, value] : trace_.inputs[scan]) evaluator_.set(node, value);
    evaluator_.run();
  }
  void advance() {
    std::unordered_map<Node, std::uint64_t> after;
    for (const StateVariable& state : system_.states) after[state.node] = evaluator_[state.next];
    before_ = std::move(after);
  }
  std::uint64_t operator[](Node n) const { return n == noNode ? 0 : evaluator_[n]; }

 private:
  static std::vector<Node> roots(Encoding& encoding, const TransitionSystem& system) {
    std::vector<Node> nodes{encoding.time().dt(), encoding.lastTicks()};
    const auto add = [&](Node n) {
      if (n != noNode) nodes.push_back(n);
    };
    for (const StateVariable& state : system.states) add(state.next);
    for (const Node input : system.inputs) add(input);
    for (const ExternalInput& external : encoding.externals()) {
      add(external.node);
      add(external.guard);
    }
    const auto addSite = [&](const BoundarySite& where) {
      add(where.guard);
      for (const Node earlier : where.earlier) add(earlier);
    };
    for (const TickSite& site : encoding.tickSites()) {
      addSite(site.where);
      add(site.ticks);
    }
    for (const EventSite& site : encoding.eventSites()) {
      addSite(site.where);
      add(site.fires);
    }
    for (const Cell& cell : encoding.cells()) add(cell.start);
    nodes.erase(std::remove(nodes.begin(), nodes.end(), noNode), nodes.end());
    return nodes;
  }

  const TransitionSystem& system_;
  const WordTrace& trace_;
  Evaluator evaluator_;
  std::unordered_map<Node, std::uint64_t> before_;
};

ScanPlace placeOf(const BoundarySite& where, const Valuation& value) {
  const auto visits = std::count_if(where.earlier.begin(), where.earlier.end(), [&](Node n) { return value[n] != 0; });
  return {where.instruction, static_cast<std::uint32_t>(visits)};
}

void addPresets(const Cell& cell, std::uint64_t value, std::vector<PresetValue>& presets) {
  if (cell.place.isRegister) return;
  for (std::uint32_t i = 0; i < cell.place.width; ++i) {
    const std::uint32_t at = cell.place.at + i;
    presets.push_back({direct(cell.place.area, Width::Bit, at / 8, 7 - at % 8), value >> (cell.place.width - 1U - i) & 1U});
  }
}

ReplayScan scanAt(Encoding& encoding, const Valuation& value) {
  ReplayScan scan;
  for (const Cell& cell : encoding.cells()) {
    if (cell.kind == CellKind::Input) addPresets(cell, value[cell.start], scan.inputs);
  }
  for (const ExternalInput& external : encoding.externals()) {
    if (value[external.guard] != 0) scan.externals.push_back({external.site, value[external.node]});
  }
  for (const TickSite& site : encoding.tickSites()) {
    if (value[site.where.guard] != 0 && value[site.ticks] != 0) scan.script.ticks1.push_back({placeOf(site.where, value), static_cast<std::uint32_t>(value[site.ticks])});
  }
  for (const EventSite& site : encoding.eventSites()) {
    if (value[site.where.guard] != 0 && value[site.fires] != 0) scan.script.events.push_back({placeOf(site.where, value), site.event});
  }
  return scan;
}

}  // namespace

std::vector<ReplayScan> scansOf(Encoding& encoding, const TransitionSystem& system, const WordTrace& trace, std::uint32_t longest) {
  std::vector<ReplayScan> scans;
  Valuation value(encoding, system, trace);
  for (std::size_t i = 0; i < trace.inputs.size(); ++i) {
    value.load(i);
    ReplayScan scan = scanAt(encoding, value);
    const auto length = static_cast<std::uint32_t>(std::max<std::uint64_t>(value[encoding.time().dt()], 1));
    scan.lengthMs = std::min(length, longest);
    if (length > longest) {
      // Ticks and events of the scan belong to its first part; the stretch repeats the same inputs.
      scans.push_back(scan);
      scan.script = {};
      scan.repeats = length / longest - 1;
      if (scan.repeats > 0) scans.push_back(scan);
      scan.repeats = 1;
      scan.lengthMs = length % longest;
      if (scan.lengthMs > 0) scans.push_back(scan);
    } else {
      scans.push_back(std::move(scan));
    }
    value.advance();
  }
  return scans;
}

std::optional<Concrete::Store> initialOf(Encoding& encoding, const Program&, const Choices& choices, const WordTrace& trace) {
  std::unordered_map<Node, std::uint64_t> values(trace.initial.begin(), trace.initial.end());
  std::optional<Concrete::Store> state;
  for (const Cell& cell : encoding.cells()) {
    const auto found = values.find(cell.start);
    if (found == values.end() || cell.kind != CellKind::State) continue;
    if (!state) state = powerUpState(encoding.plan(), choices);
    if (cell.place.isRegister) {
      state->set(cell.place.reg, cell.place.at, found->second, true);
      continue;
    }
    std::vector<PresetValue> presets;
    addPresets(cell, found->second, presets);
    for (const PresetValue& preset : presets) state->save(preset.operand.area, preset.operand.offset * 8 + preset.operand.bit, 1, preset.value, true);
  }
  return state;
}

}  // namespace rungproof
