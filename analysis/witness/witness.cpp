// From valuations of variables to scans, and the verdict of engine and monitors on them.
#include "analysis/witness/witness.hpp"

#include <algorithm>
#include <map>

#include "analysis/witness/follower.hpp"
#include "analysis/witness/scan_run.hpp"
#include "engine/cell_value.hpp"
#include "engine/start_up.hpp"

namespace rungproof {

std::uint64_t valueIn(const Concrete::Store& state, const Operand& o) {
  switch (o.area) {
    case Area::T:
    case Area::C:
    case Area::PI: return cellValue(state, o);
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

std::vector<StartCell> startCells(const Program& program, const Choices& choices, const Concrete::Store& initial) {
  const Concrete::Store powerUp = powerUpState(Plan(program), choices);
  std::vector<StartCell> cells;
  for (const AreaInfo& info : areaTable) {
    if (!info.mayRetain || info.addressing != Addressing::Bytes) continue;
    const Area area = info.area;
    for (std::uint32_t i = 0; i < initial.area(area).size(); ++i) {
      if (initial.area(area)[i] != powerUp.area(area)[i]) cells.push_back({area, i});
    }
  }
  for (const Area area : {Area::T, Area::C}) {
    const auto registers = retainedRegisters(area, dialectOf(program.target).run.counting);
    for (std::uint32_t i = 0; i < initial.count(registers[0]); ++i) {
      const auto isOther = [&](Reg reg) { return initial.get(reg, i) != powerUp.get(reg, i); };
      if (std::ranges::any_of(registers, isOther)) cells.push_back({area, i});
    }
  }
  return cells;
}

namespace {

/// Follows a property of every instruction inside the scans of a run.
class InsideScan final : public InstructionObserver {
 public:
  InsideScan(const Property& property, Concrete& domain) : follower_(property), domain_(domain) {}

  void enter(const ReplayScan& scan, bool isFirst) {
    scan_ = &scan;
    isFirst_ = isFirst;
    place_ = nullptr;
  }
  void before(const Machine<Concrete>& machine, const Instruction& instruction) override {
    if (place_ == nullptr && follower_.evaluate(domain_, machine.store, *scan_, isFirst_)) place_ = &instruction;
  }
  void external(const ExternalSite&, std::uint64_t) override {}
  void programEnded(const Machine<Concrete>&) override {}
  /// The first instruction of the scan in front of which the monitor answered true; nullptr: none.
  const Instruction* place() const { return place_; }

 private:
  Follower follower_;
  Concrete& domain_;
  const ReplayScan* scan_ = nullptr;
  bool isFirst_ = true;
  const Instruction* place_ = nullptr;
};

}  // namespace

Judge::Judge(const Program& program, const Choices& choices, const std::vector<Property>& assumptions,
             const Property& goal)
    : program_(program), choices_(choices), assumptions_(assumptions), goal_(goal) {}

Judge::Outcome Judge::run(const std::vector<ReplayScan>& scans, const Concrete::Store* initial) const {
  NoOutside outside;
  Concrete domain(outside);
  Follower goal(goal_);
  std::vector<Follower> assumptions;
  for (const Property& assumption : assumptions_) assumptions.emplace_back(assumption);
  Outcome outcome;
  std::size_t step = ~std::size_t{0};
  InsideScan inside(goal_, domain);
  if (!scans.empty()) inside.enter(scans.front(), true);
  replay(
      program_, choices_, scans, initial,
      [&](const Concrete::Store& state, std::size_t at) {
        outcome.round = at == step ? outcome.round + 1 : 0;
        outcome.step = step = at;
        const bool isFirst = outcome.scan++ == 0;
        outcome.milliseconds += scans[at].lengthMs;
        const bool isWhole = hasScanEnd(state);
        for (Follower& assumption : assumptions) {
          if (isWhole && !assumption.evaluate(domain, state, scans[at], isFirst)) outcome.assumptionBroken = true;
        }
        if (goal_.atEveryInstruction) {
          outcome.place = inside.place();
          const bool staysHere = outcome.round + 1 < scans[at].repeats || at + 1 == scans.size();
          inside.enter(scans[staysHere ? at : at + 1], false);
        }
        const bool isShownNow =
            outcome.place != nullptr || (isWhole && goal.evaluate(domain, state, scans[at], isFirst));
        outcome.shown = !outcome.assumptionBroken && isShownNow;
        return !outcome.shown && !outcome.assumptionBroken;
      },
      goal_.atEveryInstruction ? &inside : nullptr);
  return outcome;
}

std::optional<Witness> Judge::witness(std::vector<ReplayScan> scans, std::optional<Concrete::Store> initial) const {
  const Outcome outcome = run(scans, initial ? &*initial : nullptr);
  if (!outcome.shown) return std::nullopt;
  scans.resize(outcome.step + 1);
  scans.back().repeats = outcome.round + 1;
  return Witness{std::move(scans), {}, std::move(initial), outcome.scan, outcome.milliseconds, outcome.place};
}

std::vector<std::optional<Witness>> witnessesOf(const Program& program, const Choices& choices,
                                                const std::vector<Property>& assumptions,
                                                const std::vector<const Property*>& goals,
                                                const std::vector<ReplayScan>& scans,
                                                const std::optional<Concrete::Store>& initial) {
  std::vector<std::optional<Witness>> found(goals.size());
  NoOutside outside;
  Concrete domain(outside);
  std::vector<Follower> followers, assumed;
  std::vector<std::size_t> open;
  for (std::size_t g = 0; g < goals.size(); ++g) {
    followers.emplace_back(*goals[g]);
    if (goals[g]->atEveryInstruction)
      found[g] = Judge(program, choices, assumptions, *goals[g]).witness(scans, initial);
    else
      open.push_back(g);
  }
  for (const Property& assumption : assumptions) assumed.emplace_back(assumption);
  std::size_t step = ~std::size_t{0};
  std::uint32_t round = 0;
  std::uint64_t scan = 0, milliseconds = 0;
  if (open.empty()) return found;
  replay(program, choices, scans, initial ? &*initial : nullptr, [&](const Concrete::Store& state, std::size_t at) {
    round = at == step ? round + 1 : 0;
    step = at;
    const bool isFirst = scan++ == 0;
    milliseconds += scans[at].lengthMs;
    if (!hasScanEnd(state)) return true;
    for (Follower& assumption : assumed) {
      if (!assumption.evaluate(domain, state, scans[at], isFirst)) return false;
    }
    std::erase_if(open, [&](std::size_t g) {
      if (!followers[g].evaluate(domain, state, scans[at], isFirst)) return false;
      std::vector<ReplayScan> shown(scans.begin(), scans.begin() + static_cast<std::ptrdiff_t>(at) + 1);
      shown.back().repeats = round + 1;
      found[g] = Witness{std::move(shown), {}, initial, scan, milliseconds, nullptr};
      return true;
    });
    return !open.empty();
  });
  return found;
}

namespace {

void setInitial(ScanRun& run, const TransitionSystem& system, const WordTrace& trace) {
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    if (system.states[i].init == noNode) run.set(system.states[i].node, trace.initial[i]);
  }
}

}  // namespace

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

std::vector<ReplayScan> scansOf(EncodedScan& encoding, const TransitionSystem& system, const WordTrace& trace,
                                const TimeRange& range) {
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

void fillOtherInputs(const TransitionSystem& system, const std::unordered_set<std::uint32_t>& fixed,
                     std::mt19937_64& random, WordTrace& trace) {
  for (std::vector<std::uint64_t>& scan : trace.inputs) {
    for (std::size_t i = 0; i < scan.size(); ++i) {
      if (!fixed.contains(indexOf(system.inputs[i])))
        scan[i] = random() & Graph::maskOf((*system.graph)[system.inputs[i]].width);
    }
  }
}

std::optional<Concrete::Store> initialOf(EncodedScan& encoding, const TransitionSystem& system,
                                         const WordTrace& trace) {
  const auto isFree = [](const StateVariable& state) { return state.init == noNode; };
  if (std::none_of(system.states.begin(), system.states.end(), isFree)) return std::nullopt;
  ScanRun run(encoding, system);
  run.start();
  setInitial(run, system, trace);
  run.evaluate();
  return run.initialState();
}

}  // namespace rungproof
