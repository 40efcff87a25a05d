// From valuations of variables to scans, and the verdict of engine and monitors on them.
#include "analysis/witness.hpp"

#include <algorithm>

#include "analysis/monitor.hpp"
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

std::vector<ReplayScan> scansOf(EncodedScan& encoding, const TransitionSystem& system, const WordTrace& trace, std::uint32_t longest) {
  std::vector<ReplayScan> scans;
  ScanRun run(encoding, system);
  run.start();
  for (const auto& [node, value] : trace.initial) run.set(node, value);
  for (const auto& inputs : trace.inputs) {
    for (const Node input : system.inputs) run.set(input, 0);
    for (const auto& [node, value] : inputs) run.set(node, value);
    run.evaluate();
    ReplayScan scan = run.script();
    const std::uint32_t length = std::max(scan.lengthMs, 1U);
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
    run.advance();
  }
  return scans;
}

std::optional<Concrete::Store> initialOf(EncodedScan& encoding, const Program&, const Choices&, const WordTrace& trace) {
  const std::vector<Cell>& cells = encoding.cells();
  const bool isGiven = std::any_of(trace.initial.begin(), trace.initial.end(), [&](const auto& given) {
    return std::any_of(cells.begin(), cells.end(), [&](const Cell& cell) { return cell.kind == CellKind::State && cell.start == given.first; });
  });
  if (!isGiven) return std::nullopt;
  const TransitionSystem system = encoding.system();
  ScanRun run(encoding, system);
  run.start();
  for (const auto& [node, value] : trace.initial) run.set(node, value);
  run.evaluate();
  return run.initialState();
}

}  // namespace rungproof
