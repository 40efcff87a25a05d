// Every timer of one family with every one of the other, and every bit that only one program names with every bit of
// the other one, whichever of them is OLD.
#include "analysis/equivalence/memory_relations.hpp"

#include <fmt/format.h>

#include <bit>
#include <optional>
#include <set>

#include "ir/iec/expression_role.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostTimerPairs = 64, mostBitPairs = 400;
constexpr int wide = 24;                          ///< bits that hold the ms of a timer of either family
constexpr int clockBits = 32, restWidth = 24;     ///< of a clock of IEC 61131-3, of what is left of an S5 timer
constexpr std::int64_t longestTimer = 9'990'000;  ///< ms: of an S5 timer; one of an S7-200 is shorter
constexpr std::uint32_t instanceBytes = 24;       ///< between the parts of a timer of IEC 61131-3

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
  const auto isOfVariables = [](EncodedScan& scan) { return scan.plan().dialect().memory.isOfVariables; };
  const auto hasElements = [](EncodedScan& scan) { return scan.plan().counting() == Counting::Elements; };
  if (isOfVariables(before) != isOfVariables(after)) {
    const bool isNew = isOfVariables(after);
    addSeenEdges(before, false);
    addSeenEdges(after, true);
    addBits(isNew ? before : after, isNew ? after : before, isNew);
    addClocks(isNew ? after : before, isNew ? before : after, isNew);
    return;
  }
  const bool isNew = hasElements(after);
  if (hasElements(before) == isNew) return;
  EncodedScan& elements = isNew ? after : before;
  EncodedScan& boxes = isNew ? before : after;
  addSeenEdges(before, false);
  addSeenEdges(after, true);
  addBits(boxes, elements, isNew);
  addTimers(boxes, elements, isNew);
  if (!elements.plan().timers.empty()) addWholeTicks();
}

RelationCandidates::Value RelationCandidates::valueOf(EncodedScan& scan, const Place& place, bool isNew) {
  return {scan.atStart(place), scan.atEnd(place), isNew};
}

std::vector<RelationCandidates::CountingTimer> RelationCandidates::countingTimers(EncodedScan& other, bool isNew) {
  std::vector<CountingTimer> timers;
  for (const TimerUse& use : other.plan().timers) {
    const auto of = [&](Reg reg) { return valueOf(other, registerPlace(reg, use.number), isNew); };
    CountingTimer timer{.name = fmt::format("T{}", use.number),
                        .running = of(Reg::TimerRunning),
                        .bit = of(Reg::TimerBit),
                        .input = of(Reg::TimerInput)};
    if (other.plan().counting() == Counting::Elements) {
      timer.count = of(Reg::S5Rest);
      timer.atEnd = of(Reg::S5AtEnd);
      timer.isRest = true;
    } else {
      const std::optional<std::uint64_t> preset = presetOf(other.plan(), use.number);
      if (!preset || *preset == 0 || (use.kind != TimerKind::OnDelay && use.kind != TimerKind::OffDelay)) continue;
      timer.unit = static_cast<std::uint64_t>(use.resolution);
      timer.length = *preset * timer.unit;
      timer.isOffDelay = use.kind == TimerKind::OffDelay;
      timer.count = of(Reg::TimerCurrent);
      if (use.resolution > 1) timer.coming = use.resolution == 10 ? ticks10() : ticks100();
    }
    timers.push_back(std::move(timer));
  }
  return timers;
}

/// What the clock of a timer of IEC 61131-3 has in common with a timer of the same length, and with the bits of its own
/// block. STATE is 0 before it runs, 1 while it runs, 2 behind that.
void RelationCandidates::addClocks(EncodedScan& variables, EncodedScan& other, bool isVariablesNew) {
  struct Clock {
    Place state, elapsed;
  };
  std::vector<Clock> clocks;
  std::set<std::uint64_t> lengths;
  for (const Flow& flow : variables.plan().flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& i = *step.instruction;
      const ExpressionRole role = expressionRole(i);
      if (role == ExpressionRole::PassTime)
        clocks.push_back({memoryPlace(Area::V, i.operands[0].offset, Width::Byte),
                          memoryPlace(Area::V, i.operands[1].offset, Width::DWord)});
      if (role == ExpressionRole::Constant && i.operands[1].value == 32 && i.operands[0].value > 0 &&
          i.operands[0].value <= longestTimer)
        lengths.insert(static_cast<std::uint64_t>(i.operands[0].value));
    }
  }
  std::vector<CountingTimer> timers = countingTimers(other, !isVariablesNew);
  if (clocks.size() * timers.size() * std::max<std::size_t>(lengths.size(), 1) > mostTimerPairs) timers.clear();
  const Value last = valueOf(variables, registerPlace(Reg::LastScan, 0), isVariablesNew);
  const Value first = valueOf(variables, registerPlace(Reg::FirstScan, 0), isVariablesNew);
  std::vector<Place> bits;
  for (const Cell& cell : variables.cells()) {
    if (isBitState(cell)) bits.push_back(cell.place);
  }
  const auto truth = [](const Read& read, const Value& value) { return Graph::Bool{read(value).node}; };
  const auto implies = [](Graph& g, Graph::Bool a, Graph::Bool b) { return g.lor(g.lnot(a), b); };
  for (const Clock& clock : clocks) {
    const Value state = valueOf(variables, clock.state, isVariablesNew),
                elapsed = valueOf(variables, clock.elapsed, isVariablesNew);
    const std::string own = nameOf(clock.state);
    const auto isIn = [=](Graph& g, const Read& r, std::uint64_t number) {
      return g.equal(r(state), g.literal(number, 8), 8);
    };
    const auto candidate = [&](const std::string& what, auto holds) {
      candidates_.push_back({fmt::format("{}: {}", own, what), holds});
    };
    candidate("idle before the first scan",
              [=](Graph& g, const Read& r) { return implies(g, truth(r, first), isIn(g, r, 0)); });
    candidate("a state", [=](Graph& g, const Read& r) { return g.ule(r(state), g.literal(2, 8), 8); });
    std::vector<Place> nearby;
    for (const Place& place : bits) {
      const bool isNear = !place.isRegister && place.byte() + instanceBytes >= clock.state.byte() &&
                          place.byte() <= clock.state.byte() + instanceBytes;
      if (isNear) nearby.push_back(place);
    }
    for (const Place& place : nearby) {
      const Value bit = valueOf(variables, place, isVariablesNew);
      for (const std::uint64_t number : {0U, 1U, 2U}) {
        candidate(fmt::format("{} is in {}", nameOf(place), number),
                  [=](Graph& g, const Read& r) { return g.lnot(g.lxor(truth(r, bit), isIn(g, r, number))); });
        candidate(fmt::format("{} is not in {}", nameOf(place), number),
                  [=](Graph& g, const Read& r) { return g.lxor(truth(r, bit), isIn(g, r, number)); });
      }
    }
    for (const CountingTimer& timer : timers) {
      const auto counts = [=](Graph& g, const Read& r) {
        const Graph::Bool running = truth(r, timer.running);
        return timer.isRest || timer.isOffDelay ? running : g.land(running, g.lnot(truth(r, timer.bit)));
      };
      candidate(timer.name + " counts too",
                [=](Graph& g, const Read& r) { return g.lnot(g.lxor(isIn(g, r, 1), counts(g, r))); });
      for (const Place& place : nearby) {
        const Value bit = valueOf(variables, place, isVariablesNew);
        candidate(fmt::format("{} is given {}", timer.name, nameOf(place)),
                  [=](Graph& g, const Read& r) { return g.equal(r(timer.input), r(bit), 1); });
      }
      for (const bool atEnd : {true, false}) {
        if (!timer.isRest) continue;
        candidate(fmt::format("{} ends with {}", timer.name, atEnd ? 1 : 0), [=](Graph& g, const Read& r) {
          const Graph::Bool bit = truth(r, timer.atEnd);
          return implies(g, truth(r, timer.running), atEnd ? bit : g.lnot(bit));
        });
      }
      for (const std::uint64_t length : lengths) {
        if (timer.length != 0 && timer.length != length) continue;
        candidate(fmt::format("{} has {} ms as long to go", timer.name, length), [=](Graph& g, const Read& r) {
          const auto number = [&](std::uint64_t value) { return g.literal(value, clockBits); };
          const auto leftOf = [&](Graph::Bits passed) {
            return g.select(g.ult(passed, number(length), clockBits), g.sub(number(length), passed, clockBits),
                            number(0), clockBits);
          };
          const Graph::Bits left = leftOf(g.add(r(elapsed), g.zext(r(last), 16, clockBits), clockBits));
          Graph::Bits theirs = g.zext(r(timer.count), timer.isRest ? restWidth : 16, clockBits);
          if (!timer.isRest) {
            if (timer.coming.start != noNode) theirs = g.add(theirs, g.zext(r(timer.coming), 16, clockBits), clockBits);
            theirs = leftOf(g.mul(theirs, number(timer.unit), clockBits));
          }
          return implies(g, isIn(g, r, 1), g.equal(left, theirs, clockBits));
        });
      }
    }
  }
  for (const CountingTimer& timer : timers) {
    if (timer.isRest) continue;
    const Value running = timer.running, bit = timer.bit, count = timer.count;
    candidates_.push_back({timer.name + " counts below its preset", [=](Graph& g, const Read& r) {
                             const std::uint64_t steps = timer.length / timer.unit;
                             const Graph::Bool counts = g.land(truth(r, running), g.lnot(truth(r, bit)));
                             return implies(g, counts, g.slt(r(count), g.literal(steps, 16), 16));
                           }});
    candidates_.push_back({timer.name + " counts from 0",
                           [=](Graph& g, const Read& r) { return g.sle(g.literal(0, 16), r(count), 16); }});
    if (timer.coming.start == noNode) continue;
    const Value coming = timer.coming;
    candidates_.push_back({fmt::format("whole steps of {} ms", timer.unit), [=](Graph& g, const Read& r) {
                             const Graph::Bits passed =
                                 g.mul(g.zext(r(coming), 16, clockBits), g.literal(timer.unit, clockBits), clockBits);
                             return g.lor(truth(r, first), g.equal(g.zext(r(last), 16, clockBits), passed, clockBits));
                           }});
  }
}

void RelationCandidates::addTimers(EncodedScan& boxes, EncodedScan& elements, bool isElementsNew) {
  if (boxes.plan().timers.size() * elements.plan().timers.size() > mostTimerPairs) return;
  for (const TimerUse& use : boxes.plan().timers) {
    const std::optional<std::uint64_t> preset = presetOf(boxes.plan(), use.number);
    if (!preset || *preset == 0 || (use.kind != TimerKind::OnDelay && use.kind != TimerKind::OffDelay)) continue;
    const auto of = [&](Reg reg) { return valueOf(boxes, registerPlace(reg, use.number), !isElementsNew); };
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
    for (const TimerUse& s5 : elements.plan().timers) {
      const auto there = [&](Reg reg) { return valueOf(elements, registerPlace(reg, s5.number), isElementsNew); };
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

void RelationCandidates::addBits(EncodedScan& all, EncodedScan& own, bool isOwnNew) {
  const bool haveOneMemory = !all.plan().dialect().memory.isOfVariables && !own.plan().dialect().memory.isOfVariables;
  std::vector<Place> here, there;
  for (const Cell& cell : all.cells()) {
    if (isBitState(cell)) here.push_back(cell.place);
  }
  for (const Cell& cell : own.cells()) {
    const bool isShared =
        haveOneMemory && std::ranges::any_of(all.cells(), [&](const Cell& c) { return c.place == cell.place; });
    const bool isTimer = cell.place.isRegister && cell.place.reg == Reg::TimerBit;
    if (isBitState(cell) && !isShared && !isTimer) there.push_back(cell.place);
  }
  if (here.size() * there.size() > mostBitPairs) return;
  for (const Place& one : there) {
    const Value theirs = valueOf(own, one, isOwnNew);
    for (const Place& other : here) {
      const Value mine = valueOf(all, other, !isOwnNew);
      candidates_.push_back({fmt::format("{} and {}", nameOf(other), nameOf(one)),
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
