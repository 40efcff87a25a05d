// Every timer of one family with every one of the other, and every bit that only the S7-300/400 names with every bit of
// the S7-200, whichever of them is OLD.
#include "analysis/equivalence/memory_relations.hpp"

#include <fmt/format.h>

#include <bit>
#include <optional>

namespace rungproof {

namespace {

constexpr std::size_t mostTimerPairs = 64, mostBitPairs = 400;
constexpr int wide = 24;  ///< bits that hold the ms of a timer of either family

/// The preset of all boxes of a timer; nothing where it is not one constant.
std::optional<std::uint64_t> presetOf(const Plan& plan, std::uint32_t number) {
  std::optional<std::uint64_t> preset;
  for (const Flow& flow : plan.flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& box = *step.instruction;
      const bool isTimer = box.desc->operandCount > 1 && box.desc->operands[0].type == Type::Timer;
      if (!isTimer || box.operands.size() < 2 || box.operands[0].offset != number) continue;
      if (box.operands[1].kind != OperandKind::Constant || box.operands[1].value < 0) return std::nullopt;
      const auto value = static_cast<std::uint64_t>(box.operands[1].value);
      if (preset && *preset != value) return std::nullopt;
      preset = value;
    }
  }
  return preset;
}

bool isBitState(const Cell& cell) {
  const bool isBit = !cell.place.isRegister || cell.place.reg == Reg::EdgeMemory || cell.place.reg == Reg::TimerBit ||
                     cell.place.reg == Reg::CounterBit;
  return cell.kind == CellKind::State && cell.place.width == 1 && isBit;
}

}  // namespace

RelationCandidates::RelationCandidates(EncodedScan& before, EncodedScan& after)
    : time_(before.time()), graph_(before.graph()) {
  const bool isStep7New = after.plan().isStep7();
  if (before.plan().isStep7() == isStep7New) return;
  EncodedScan& step7 = isStep7New ? after : before;
  EncodedScan& s7200 = isStep7New ? before : after;
  addSeenEdges(before, false);
  addSeenEdges(after, true);
  addBits(s7200, step7, isStep7New);
  addTimers(s7200, step7, isStep7New);
  if (!step7.plan().timers.empty()) addWholeTicks();
}

RelationCandidates::Value RelationCandidates::valueOf(EncodedScan& scan, const Place& place, bool isNew) {
  return {scan.atStart(place), scan.atEnd(place), isNew};
}

void RelationCandidates::addTimers(EncodedScan& s7200, EncodedScan& step7, bool isStep7New) {
  if (s7200.plan().timers.size() * step7.plan().timers.size() > mostTimerPairs) return;
  for (const TimerUse& use : s7200.plan().timers) {
    const std::optional<std::uint64_t> preset = presetOf(s7200.plan(), use.number);
    if (!preset || *preset == 0 || (use.kind != TimerKind::OnDelay && use.kind != TimerKind::OffDelay)) continue;
    const auto of = [&](Reg reg) { return valueOf(s7200, registerPlace(reg, use.number), !isStep7New); };
    TimerPair pair{.in = of(Reg::TimerInput),
                   .bit = of(Reg::TimerBit),
                   .running = of(Reg::TimerRunning),
                   .current = of(Reg::TimerCurrent),
                   .preset = of(Reg::TimerPreset),
                   .coming = use.resolution == 10    ? ticks10()
                             : use.resolution == 100 ? ticks100()
                                                     : Value{},
                   .length = *preset,
                   .unit = static_cast<std::uint64_t>(use.resolution),
                   .isOffDelay = use.kind == TimerKind::OffDelay};
    for (const TimerUse& s5 : step7.plan().timers) {
      const auto there = [&](Reg reg) { return valueOf(step7, registerPlace(reg, s5.number), isStep7New); };
      pair.s5In = there(Reg::TimerInput);
      pair.s5Bit = there(Reg::TimerBit);
      pair.s5Running = there(Reg::TimerRunning);
      pair.s5Rest = there(Reg::S5Rest);
      pair.s5AtEnd = there(Reg::S5AtEnd);
      add(fmt::format("T{} and T{}", use.number, s5.number), pair);
    }
  }
}

/// What a TON and an SD, or a TOF and an SF, of the same length have in common while they are given the same input.
void RelationCandidates::add(const std::string& name, const TimerPair& p) {
  using Bool = Graph::Bool;
  const auto truth = [](const Read& read, const Value& value) { return Bool{read(value).node}; };
  const auto implies = [](Graph& g, Bool a, Bool b) { return g.lor(g.lnot(a), b); };
  const auto same = [](Graph& g, Bool a, Bool b) { return g.lnot(g.lxor(a, b)); };
  const auto counts = [=](Graph& g, const Read& read) {
    const Bool running = truth(read, p.running);
    return p.isOffDelay ? running : g.land(running, g.lnot(truth(read, p.bit)));
  };
  const auto candidate = [&](std::string_view what, auto holds) {
    candidates_.push_back({fmt::format("{}: {}", name, what), holds});
  };
  candidate("inputs", [=](Graph& g, const Read& r) { return same(g, truth(r, p.in), truth(r, p.s5In)); });
  candidate("bits", [=](Graph& g, const Read& r) { return same(g, truth(r, p.bit), truth(r, p.s5Bit)); });
  candidate("both count", [=](Graph& g, const Read& r) { return same(g, counts(g, r), truth(r, p.s5Running)); });
  candidate("time that is left", [=](Graph& g, const Read& r) {
    const int w = std::bit_width(p.length);  // "below the preset" says that no more are needed
    const Graph::Bits passed = g.mul(g.zext(g.extract(r(p.current), w - 1, 0), w, wide), g.literal(p.unit, wide), wide);
    Graph::Bits left = g.sub(g.literal(p.length * p.unit, wide), passed, wide);
    if (p.coming.start != noNode) {  // an S5 timer has counted them
      const Graph::Bits coming = g.mul(g.zext(r(p.coming), 16, wide), g.literal(p.unit, wide), wide);
      left = g.select(g.ult(coming, left, wide), g.sub(left, coming, wide), g.literal(0, wide), wide);
    }
    return implies(g, truth(r, p.s5Running), g.equal(left, r(p.s5Rest), wide));
  });
  candidate("bit at the end", [=](Graph& g, const Read& r) {
    const Bool atEnd = truth(r, p.s5AtEnd);
    return implies(g, truth(r, p.s5Running), p.isOffDelay ? g.lnot(atEnd) : atEnd);
  });
  candidate("preset", [=](Graph& g, const Read& r) {
    return implies(g, counts(g, r), g.equal(r(p.preset), g.literal(p.length, 16), 16));
  });
  if (p.isOffDelay) {
    candidate("signal while it counts", [=](Graph& g, const Read& r) {
      return implies(g, g.lor(counts(g, r), truth(r, p.in)), truth(r, p.bit));
    });
    candidate("counts without input",
              [=](Graph& g, const Read& r) { return implies(g, counts(g, r), g.lnot(truth(r, p.in))); });
  } else {
    candidate("enabled", [=](Graph& g, const Read& r) { return same(g, truth(r, p.running), truth(r, p.in)); });
    candidate("off", [=](Graph& g, const Read& r) {
      const Bool isReset = g.land(g.equal(r(p.current), g.literal(0, 16), 16), g.lnot(truth(r, p.bit)));
      return g.lor(truth(r, p.in), isReset);
    });
  }
  candidate("not negative", [=](Graph& g, const Read& r) { return g.sle(g.literal(0, 16), r(p.current), 16); });
  candidate("below the preset", [=](Graph& g, const Read& r) {
    return implies(g, counts(g, r), g.slt(r(p.current), g.literal(p.length, 16), 16));
  });
}

/// Where scans last whole ticks of 100 ms.
void RelationCandidates::addWholeTicks() {
  const Value ticks = ticks10(), hundreds = ticks100();
  candidates_.push_back({"whole ticks of 100 ms", [=](Graph& g, const Read& r) {
                           return g.equal(r(ticks), g.mul(r(hundreds), g.literal(10, 16), 16), 16);
                         }});
}

void RelationCandidates::addBits(EncodedScan& s7200, EncodedScan& step7, bool isStep7New) {
  std::vector<Place> all, own;
  for (const Cell& cell : s7200.cells()) {
    if (isBitState(cell)) all.push_back(cell.place);
  }
  for (const Cell& cell : step7.cells()) {
    const bool isShared = std::ranges::any_of(s7200.cells(), [&](const Cell& c) { return c.place == cell.place; });
    const bool isTimer = cell.place.isRegister && cell.place.reg == Reg::TimerBit;
    if (isBitState(cell) && !isShared && !isTimer) own.push_back(cell.place);
  }
  if (all.size() * own.size() > mostBitPairs) return;
  for (const Place& there : own) {
    const Value theirs = valueOf(step7, there, isStep7New);
    for (const Place& here : all) {
      const Value mine = valueOf(s7200, here, !isStep7New);
      candidates_.push_back({fmt::format("{} and {}", nameOf(here), nameOf(there)),
                             [=](Graph& g, const Read& r) { return g.equal(r(mine), r(theirs), 1); }});
    }
  }
}

/// An edge instruction that has not run since the first scan (001:2763).
void RelationCandidates::addSeenEdges(EncodedScan& scan, bool isNew) {
  std::vector<Place> places;
  for (const Cell& cell : scan.cells()) {
    if (cell.kind == CellKind::State && cell.place.isRegister && cell.place.reg == Reg::EdgeSeen)
      places.push_back(cell.place);
  }
  const Value first = valueOf(scan, registerPlace(Reg::FirstScan, 0), isNew);
  for (const Place& place : places) {
    const Value seen = valueOf(scan, place, isNew);
    candidates_.push_back({fmt::format("{} after the first scan", nameOf(place)), [=](Graph& g, const Read& r) {
                             return g.lor(Graph::Bool{r(first).node}, Graph::Bool{r(seen).node});
                           }});
  }
}

std::vector<std::string> RelationCandidates::names() const {
  std::vector<std::string> names;
  for (const Candidate& candidate : candidates_) names.push_back(candidate.name);
  return names;
}

std::vector<MemoryRelation> RelationCandidates::relations(const NewView& view) const {
  std::vector<MemoryRelation> relations;
  const Read start = [&](const Value& v) { return Graph::Bits{v.isNew ? view.inScan(v.start) : v.start}; };
  const Read end = [&](const Value& v) { return Graph::Bits{v.isNew ? view.inScan(v.end) : v.end}; };
  const Read first = [&](const Value& v) { return Graph::Bits{v.isNew ? view.first(v.start) : v.start}; };
  for (const Candidate& c : candidates_)
    relations.push_back({c.name, c.holds(graph_, start).node, c.holds(graph_, end).node, c.holds(graph_, first).node});
  return relations;
}

}  // namespace rungproof
