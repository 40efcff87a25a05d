// Interrupts at one place of a scan (001:5327-5547).
//
// Events that nothing limits (edges, counters, ports while they are at it) may come at any place, any number of times:
// whether each comes is an input. At a place all of them are let in one after the other, and that several times over
// (EncoderOptions::eventPasses), so that they come in any order; since a routine that changes nothing may as well not
// run, more runs matter only if the last pass has changed something. What more can do is estimated
// (routine_effects.hpp) from the state in front of the place. Scans that use the estimate are marked
// (Approximation::used). While interrupts are disabled, such events wait in the queue; to come when they are enabled
// again is the same to the program, so nothing is kept of them - except an entry whose event was detached meanwhile,
// and the overflow bits.
//
// Events that follow from the time are counted: 10 and 11, and cyclic interrupts of an S7-300/400, come as often as
// their period has passed, by the end of the scan at the latest and the one that is due for longer first; 21 and 22
// come when their timer reaches its preset. Those that meet disabled interrupts wait, as many as the queue holds, and
// run at the first place where they can. Events of a block that SFC 39 has locked pass at their places without a run.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "analysis/encoding/scan_encoding.hpp"
#include "analysis/encoding/scan_round.hpp"
#include "ir/families/run.hpp"
#include "ir/s7200/event_cause.hpp"
#include "ir/s7200/isa/comm.hpp"
#include "ir/s7300/interrupt_lock.hpp"

namespace rungproof {

namespace {

std::string nameOfEdge(int input) {
  const std::uint32_t bit = edgeInputs[static_cast<std::size_t>(input)].bit;
  return fmt::format("edge of I{}.{}", bit / 8, bit % 8);
}

/// Events at places of one scan; more would repeat the routines' text too often.
constexpr std::size_t eventSiteLimit = 400;

constexpr std::uint32_t overflowByte = 4;  // SM4.0 to SM4.2, by group (001:5491)

bool isLimited(int event) { return isTimedEvent(event) || isTimerEvent(event); }

/// Events that tell of the end of a request.
bool isOfRequest(int event) {
  const auto port = portEvent(event);
  return isPulseEvent(event) || (port && port->kind != PortEvent::Character);
}

}  // namespace

Node ScanEncoding::state(std::string name, int width) {
  const Node node = graph.variable(std::move(name), width, true);
  eventStates_.all.push_back({node, graph.constantNode(0, width), noNode});
  return node;
}

/// A block of higher priority interrupts one of lower priority as well (002:817). Where both touch the same memory,
/// what that leaves is not followed; otherwise it is as if one ran before the other.
void ScanEncoding::leaveOutNesting() {
  const auto& footprints = knowledge_.footprints.ofRoutine;
  for (const int low : events_) {
    for (const int high : events_) {
      if (!isBlockEvent(low) || !isBlockEvent(high) || priorityOf(low) >= priorityOf(high)) continue;
      const auto its = footprints.find(blockOfEvent(low)), other = footprints.find(blockOfEvent(high));
      if (its == footprints.end() || other == footprints.end() || !its->second.conflictsWith(other->second)) continue;
      approximate(nullptr, fmt::format("OB{} inside OB{}, which use the same memory, is not followed",
                                       blockOfEvent(high), blockOfEvent(low)))
          .leftOut = graph.constant(true).node;
    }
  }
}

void ScanEncoding::beginEvents() {
  if (attachments_.empty()) return;
  for (const Flow& flow : plan_.flows) {
    for (const FlowStep& step : flow.steps) {
      hasPointers_ = hasPointers_ || std::ranges::any_of(step.instruction->operands, [](const Operand& o) {
                       return o.kind == OperandKind::Indirect;
                     });
    }
  }
  leaveOutNesting();
  std::set<int> detached;
  for (const Flow& flow : plan_.flows) {
    for (const FlowStep& step : flow.steps) {
      if (roleOf(*step.instruction) == Role::Dtch && !step.instruction->operands.empty())
        detached.insert(static_cast<int>(step.instruction->operands[0].value));
    }
  }
  EventStates& s = eventStates_;
  int periodWidth = regInfo(Reg::TimedPeriod).width;
  for (const std::uint32_t timer : plan_.timedEvents)
    periodWidth = std::max(periodWidth, static_cast<int>(regInfo(timedRegisters(timer).period).width));
  const int w = std::max(time.width(), periodWidth) + 2;
  s.passed = graph.constantNode(0, w);
  const Node dt = graph.make(Op::Zext, w, time.dt());
  for (const int event : events_) {
    if (isTimedEvent(event)) {
      const auto timer = static_cast<std::uint32_t>(timerOfEvent(event));
      const TimedRegisters registers = timedRegisters(timer);
      const Node elapsed = graph.make(Op::Zext, w, machine_.get(registers.elapsed, registers.at).node);
      s.sinceLast[timer] = graph.make(Op::Add, w, elapsed, dt);
    }
    if (isLimited(event) || isOfRequest(event))
      s.waiting[event] = state(fmt::format("event {} waiting", event), queueBits);
    if (const Node end = devices_.ends(event); isOfRequest(event) && end != noNode) queueOne(event, {end});
    if (detached.contains(event) && options_.choices.is(Choice::DetachedEvents, "kept"))
      s.left[event] = state(fmt::format("event {} left", event), 8);
    if (!isRisingEdge(event) || !attachments_.contains(event + 1)) continue;
    const Node last = s.lastEdge[edgeInputOf(event)] = state(nameOfEdge(edgeInputOf(event)), 2);
    // Every edge was followed, so the input is as the last one left it.
    const Graph::Bool isOn = machine_.loadBit(Area::I, 0, edgeInputFor(event).bit);
    const auto was = [&](std::uint64_t which) { return graph.equal({last}, graph.literal(which, 2), 2); };
    const Node agrees =
        graph.land(graph.lor(graph.lnot(was(1)), isOn), graph.lor(graph.lnot(was(2)), graph.lnot(isOn))).node;
    constraints_.push_back(agrees);
    totalConstraints_.push_back(agrees);
  }
  for (int bit = 0; bit < eventGroupCount; ++bit) {
    Footprint seen;
    addKeys(memoryPlace(Area::SM, overflowByte, Width::Bit, static_cast<std::uint32_t>(bit)), seen.writes);
    const bool isRead = std::ranges::any_of(knowledge_.footprints.ofInstruction,
                                            [&](const auto& entry) { return entry.second.conflictsWith(seen); });
    const bool isObserved = std::ranges::any_of(options_.observed, [&](const Operand& o) {
      return o.area == Area::SM && o.offset <= overflowByte &&
             o.offset + static_cast<std::uint32_t>(bytes(o.width)) > overflowByte;
    });
    if (isRead || isObserved) s.overflowBits.insert(bit);
  }
}

/// What lives on to the next scan.
void ScanEncoding::endEvents() {
  EventStates& s = eventStates_;
  if (attachments_.empty()) return;
  machine_.guard = graph.constant(true);
  for (const auto& [timer, since] : s.sinceLast) {
    const TimedRegisters registers = timedRegisters(timer);
    const int width = regInfo(registers.period).width;
    const Graph::Bool isPeriodic =
        graph.lnot(graph.equal(machine_.get(registers.period, registers.at), graph.literal(0, width), width));
    const Graph::Bool goesOn = graph.land(machine_.getBit(Reg::Running), graph.lnot(machine_.halted));
    const Graph::Bool counts = graph.land(goesOn, graph.land(isPeriodic, hasRoutine(eventOfTimed(timer))));
    machine_.when(counts,
                  [&] { machine_.set(registers.elapsed, registers.at, {graph.make(Op::Extract, width, since)}); });
  }
  for (StateVariable& variable : s.all) variable.next = variable.node;
  const auto setNext = [&](Node now, const std::string& name) {
    for (StateVariable& variable : s.all) {
      if (graph.variables()[graph[variable.node].value].name == name) variable.next = now;
    }
  };
  for (const auto& [event, now] : s.waiting) setNext(now, fmt::format("event {} waiting", event));
  for (const auto& [event, now] : s.left) setNext(now, fmt::format("event {} left", event));
  for (const auto& [input, now] : s.lastEdge) setNext(now, nameOfEdge(input));
}

// ---- Conditions --------------------------------------------------------------------------------------------

Graph::Bool ScanEncoding::isAttached(int event, int routine) {
  Graph::Bits now = machine_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event));
  if (isBlockEvent(event)) now = graph.band(now, graph.literal(lockBit - 1, 8), 8);
  return graph.equal(now, graph.literal(static_cast<std::uint64_t>(routine) + 1, 8), 8);
}

Graph::Bool ScanEncoding::hasRoutine(int event) {
  Graph::Bool result = graph.constant(false);
  for (const int routine : attachments_.at(event)) result = graph.lor(result, isAttached(event, routine));
  return result;
}

/// SFC 39 lets the event be lost when it comes.
Graph::Bool ScanEncoding::isLockedOut(int event) {
  if (!isBlockEvent(event)) return graph.constant(false);
  return graph.bit(machine_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event)), 7);
}

Graph::Bool ScanEncoding::interruptsEnabled() {
  return graph.land(machine_.getBit(Reg::InterruptsEnabled), machine_.getBit(Reg::Running));
}

/// The event's routine would run if the event came.
Graph::Bool ScanEncoding::isReady(int event) { return graph.land(interruptsEnabled(), hasRoutine(event)); }

Graph::Bits ScanEncoding::periodOf(std::uint32_t timer) {
  const int w = graph[eventStates_.passed].width;
  const TimedRegisters registers = timedRegisters(timer);
  return {graph.make(Op::Zext, w, machine_.get(registers.period, registers.at).node)};
}

/// Whether a timed event is due by the end of the scan.
Graph::Bool ScanEncoding::isDue(std::uint32_t timer) {
  const int event = eventOfTimed(timer);
  if (!eventStates_.sinceLast.contains(timer)) return graph.constant(false);
  const int w = graph[eventStates_.passed].width;
  const Graph::Bits period = periodOf(timer);
  return graph.land(hasRoutine(event), graph.land(graph.lnot(graph.equal(period, graph.literal(0, w), w)),
                                                  graph.ule(period, {eventStates_.sinceLast[timer]}, w)));
}

/// Due, and not after another one.
Graph::Bool ScanEncoding::isNextDue(std::uint32_t timer) {
  Graph::Bool isNext = isDue(timer);
  const int w = graph[eventStates_.passed].width;
  for (const auto& [other, since] : eventStates_.sinceLast) {
    if (other == timer) continue;
    const Graph::Bits mine = graph.sub({eventStates_.sinceLast.at(timer)}, periodOf(timer), w);
    const Graph::Bits its = graph.sub({since}, periodOf(other), w);
    const bool hasRank = eventInfo(eventOfTimed(timer)).rank < eventInfo(eventOfTimed(other)).rank;
    const Graph::Bool first = hasRank ? graph.ule(its, mine, w) : graph.ult(its, mine, w);
    isNext = graph.land(isNext, graph.lor(graph.lnot(isDue(other)), first));
  }
  return isNext;
}

/// Whether the event comes at this point, nothing waiting.
Graph::Bool ScanEncoding::occurs(Round& round, int event) {
  const auto input = [&] { return Graph::Bool{siteInput(event, round.where.instruction, 1)}; };
  if (isTimerEvent(event)) return graph.constant(false);
  if (isTimedEvent(event)) {
    const auto timer = static_cast<std::uint32_t>(timerOfEvent(event));
    const Graph::Bool next = isNextDue(timer);
    if (!effects_->isOnePassEnough())
      return round.isEnd || graph.truth(next) == false ? next : graph.land(next, input());
    // One run of each stands for all: those that are due for longer come at the end in any case; at another place they
    // may have come before in any number, which no run can name.
    const Graph::Bool due = isDue(timer);
    if (round.isEnd || graph.truth(due) == false) return due;
    const Graph::Bool comes = graph.land(due, input()), early = graph.land(comes, graph.lnot(next));
    if (graph.truth(here(early)) != false) {
      anyOf("a timed event before its turn", 1);
      useEstimate(early);
    }
    return comes;
  }
  Graph::Bool possible = graph.land(hasRoutine(event), eventHasCause(machine_, event));
  possible = graph.land(possible, graph.lnot(isLockedOut(event)));
  if (const auto last = eventStates_.lastEdge.find(edgeInputOf(event)); last != eventStates_.lastEdge.end()) {
    const auto same = static_cast<std::uint64_t>(edgeKind(event));
    possible = graph.land(possible, graph.lnot(graph.equal({last->second}, graph.literal(same, 2), 2)));
  }
  return graph.truth(possible) == false ? possible : graph.land(possible, input());
}

// ---- Inputs that stand for what is not followed ------------------------------------------------------------

/// An input that only estimates may use: it is 0 in runs that are exact.
Graph::Bool ScanEncoding::freely(std::string name, Graph::Bool use) {
  if (graph.truth(use) == false) return use;
  const Graph::Bool result = graph.land(use, {anyOf(std::move(name), 1)});
  useEstimate(result);
  return result;
}

Node ScanEncoding::anyOf(std::string name, int width) {
  const Node any = input(std::move(name), width);
  estimate().carriers.push_back(any);
  return any;
}

Approximation& ScanEncoding::estimate() {
  return approximate(nullptr,
                     fmt::format("interrupts that come more than {} times at one place, or are lost: what their "
                                 "routines leave is estimated",
                                 options_.eventPasses));
}

void ScanEncoding::useEstimate(Graph::Bool used) {
  Approximation& a = estimate();
  a.used = a.used == noNode ? here(used).node : graph.lor({a.used}, here(used)).node;
}

// ---- One place ---------------------------------------------------------------------------------------------

void ScanEncoding::interrupts(Runner& runner, std::uint32_t instruction) {
  Round round{{instruction, visitOf(instruction), machine_.guard.node}};
  round.isEnd = instruction == ScanPlace::afterProgram;
  round.hasChanged = round.mustGoOn = round.mayGoOn = graph.constant(false);
  for (const int event : events_) {
    if (mayInterrupt(event, instruction)) round.events.push_back(event);
  }
  for (const int event : round.events) followEdges(event);
  Graph::Bool any = graph.constant(false);
  for (const int event : round.events) any = graph.lor(any, graph.lor(isReady(event), hasRoutine(event)));
  for (const auto& [event, left] : eventStates_.left)
    any = graph.lor(any, graph.lnot(graph.equal({left}, graph.literal(0, 8), 8)));
  if (graph.truth(here(any)) == false) return;
  if (eventSites.size() >= eventSiteLimit * static_cast<std::size_t>(options_.eventPasses)) {
    approximate(nullptr,
                "interrupts are followed at the first " + std::to_string(eventSiteLimit) + " places of a scan only")
        .leftOut = graph.constant(true).node;
    return;
  }
  noteEntry(round, any);
  if (!effects_->isOnePassEnough()) {
    for (const int event : round.events) {
      for (const int routine : attachments_.at(event)) {
        for (const Place& place : effects_->places(routine)) round.before[place] = store_.value(place);
      }
    }
  }
  for (const int event : round.events) serveLeft(runner, round, event);
  const int passes = effects_->isOnePassEnough() ? 1 : options_.eventPasses;
  for (int pass = 1; pass <= passes; ++pass) {
    round.isLastPass = pass == passes;
    followOverflow(round);
    for (const int event : round.events) runEvent(runner, round, event);
  }
  passTime(round);
  if (!effects_->isOnePassEnough() || !eventStates_.overflowBits.empty()) moreRuns(runner, round);
  endOverflow(round);
}

/// An event at its turn: what waits runs first, then what comes now.
void ScanEncoding::runEvent(Runner& runner, Round& round, int event) {
  EventStates& s = eventStates_;
  followEdges(event);
  const Graph::Bool isLost = isLockedOut(event);
  const Graph::Bool ready = isReady(event);
  const Graph::Bool mayCome = graph.lor(ready, graph.land(isLost, machine_.getBit(Reg::Running)));
  if (graph.truth(here(mayCome)) == false) return;
  const auto waits = s.waiting.find(event);
  Graph::Bool waited = graph.constant(false);
  if (waits != s.waiting.end()) {
    waited = graph.land(ready, graph.lnot(graph.equal({waits->second}, graph.literal(0, queueBits), queueBits)));
    // A timer's event that has just come may let others pass.
    if (isTimerEvent(event) && !round.isLastPass && graph.truth(here(waited)) != false) {
      waited = graph.land(waited, {siteInput(event, round.where.instruction, 1)});
    }
  }
  Graph::Bool comes = graph.land(graph.lnot(waited), graph.land(mayCome, occurs(round, event)));
  if (round.cameBefore) comes = graph.land(comes, *round.cameBefore);
  const Graph::Bool isNoticed = graph.lor(waited, comes);
  if (round.events.size() == 1) round.cameBefore = isNoticed;
  if (graph.truth(here(isNoticed)) == false) return;
  eventSites.push_back({round.where, event, here(isNoticed).node, here(waited).node});
  if (waits != s.waiting.end())
    become(waits->second, here(waited),
           graph.make(Op::Sub, queueBits, waits->second, graph.constantNode(1, queueBits)));
  if (isTimedEvent(event)) {
    const auto timer = static_cast<std::uint32_t>(timerOfEvent(event));
    const int w = graph[s.passed].width;
    const Node since = graph.sub({s.sinceLast[timer]}, periodOf(timer), w).node;
    become(s.sinceLast[timer], here(comes), since);
    const Node dt = graph.make(Op::Zext, w, time.dt());
    const Graph::Bool isInScan = graph.ule({since}, {dt}, w);
    const Node due = graph.make(Op::Ite, w, isInScan.node, graph.sub({dt}, {since}, w).node, graph.constantNode(0, w));
    become(s.passed, here(graph.land(comes, graph.ult({s.passed}, {due}, w))), due);
    if (isDelayEvent(event))
      machine_.when(comes, [&] { machine_.set(Reg::DelayPeriod, timedRegisters(timer).at, graph.literal(0, 16)); });
  }
  if (const auto last = s.lastEdge.find(edgeInputOf(event)); last != s.lastEdge.end())
    become(last->second, here(comes), graph.constantNode(static_cast<std::uint64_t>(edgeKind(event)), 2));
  machine_.when(comes, [&] { deviceEvent(machine_, event); });
  runRoutines(runner, round, event, graph.lor(waited, graph.land(comes, graph.lnot(isLost))));
}

/// The routine that the event has now.
void ScanEncoding::runRoutines(Runner& runner, Round& round, int event, Graph::Bool fires) {
  for (const int number : attachments_.at(event)) {
    const Graph::Bool runs = graph.land(fires, isAttached(event, number));
    if (graph.truth(here(runs)) == false) continue;
    std::vector<std::pair<Place, Node>> old;
    if (round.isLastPass && !effects_->isOnePassEnough()) {
      for (const Place& place : effects_->places(number)) old.emplace_back(place, store_.value(place));
    }
    round.ran.insert(number);
    routine_ = number;
    isRecording_ = true;
    runner.interrupt(number, runs);
    isRecording_ = false;
    routine_ = -1;
    tellKept(round);
    for (const auto& [place, value] : old) {
      const Graph::Bool same = graph.equal({store_.value(place)}, {value}, place.width);
      round.hasChanged = graph.lor(round.hasChanged, graph.lnot(same));
    }
    if (round.isLastPass && !effects_->isComplete()) round.hasChanged = graph.lor(round.hasChanged, here(runs));
  }
}

/// An entry whose event was detached while it waited: its routine runs all the same, once for all such entries.
void ScanEncoding::serveLeft(Runner& runner, Round& round, int event) {
  const auto left = eventStates_.left.find(event);
  if (left == eventStates_.left.end()) return;
  const Graph::Bool enabled = interruptsEnabled();
  const Node entry = left->second;
  for (const int number : attachments_.at(event)) {
    const Graph::Bool is = graph.equal({entry}, graph.literal(static_cast<std::uint64_t>(number) + 1, 8), 8);
    const Graph::Bool runs = graph.land(enabled, graph.land(is, graph.lnot(hasRoutine(event))));
    if (graph.truth(here(runs)) == false) continue;
    round.mayGoOn = graph.lor(round.mayGoOn, runs);
    eventSites.push_back({round.where, event, here(runs).node, here(runs).node});
    routine_ = number;
    isRecording_ = true;
    runner.interrupt(number, runs);
    isRecording_ = false;
    routine_ = -1;
  }
  become(left->second, here(enabled), graph.constantNode(0, 8));
}

/// Timed events that are due and have not run: they wait, or more of them come than are followed.
void ScanEncoding::passTime(Round& round) {
  EventStates& s = eventStates_;
  const int w = s.passed == noNode ? 0 : graph[s.passed].width;
  const Graph::Bool enabled = interruptsEnabled();
  const auto queued = [&] {
    Node sum = graph.constantNode(0, queueBits + 2);
    for (const auto& [event, count] : s.waiting) {
      if (!isLimited(event)) continue;
      sum = graph.make(Op::Add, queueBits + 2, sum, graph.make(Op::Zext, queueBits + 2, count));
    }
    return sum;
  };
  for (const int event : round.events) {
    if (isTimedEvent(event) && round.isEnd) {
      const auto timer = static_cast<std::uint32_t>(timerOfEvent(event));
      const Graph::Bool due = isDue(timer);
      if (graph.truth(here(due)) == false) continue;
      const Graph::Bool runs = graph.land(due, graph.lnot(isLockedOut(event)));
      round.mustGoOn = graph.lor(round.mustGoOn, graph.land(enabled, runs));
      const Graph::Bool waits = graph.land(runs, graph.lnot(enabled));
      if (graph.truth(here(waits)) != false) {
        const std::size_t depth = queueDepth(machine_.target, EventGroup::Timed);
        const Graph::Bits many = graph.udiv({s.sinceLast[timer]}, periodOf(timer), w);
        const Node room = graph.make(Op::Sub, queueBits + 2, graph.constantNode(depth, queueBits + 2), queued());
        const Graph::Bits wide{graph.make(Op::Zext, w, room)};
        const Graph::Bool overflows = graph.ult(wide, many, w);
        const Node more = graph.make(Op::Extract, queueBits, graph.select(overflows, wide, many, w).node);
        become(s.waiting.at(event), here(waits), graph.make(Op::Add, queueBits, s.waiting.at(event), more));
        machine_.when(graph.land(waits, overflows), [&] { machine_.setSm(overflowByte, 2, graph.constant(true)); });
      }
      become(s.sinceLast[timer], here(due), graph.urem({s.sinceLast[timer]}, periodOf(timer), w).node);
    }
    const auto waits = s.waiting.find(event);
    if (waits == s.waiting.end()) continue;
    // What still waits where it could run: more than is followed.
    const Graph::Bool open =
        graph.land(isReady(event), graph.lnot(graph.equal({waits->second}, graph.literal(0, queueBits), queueBits)));
    round.mustGoOn = graph.lor(round.mustGoOn, open);
    become(waits->second, here(open), graph.constantNode(0, queueBits));
  }
}

/// More runs than the passes: what the routines write becomes what any number of them could leave. One more pass shows
/// what can go wrong in a run that begins there.
void ScanEncoding::moreRuns(Runner& runner, Round& round) {
  if (round.ran.empty()) return;
  Graph::Bool comesStill = graph.constant(false);
  for (const int event : round.events) {
    if (isTimerEvent(event)) continue;
    const Graph::Bool may =
        isTimedEvent(event) ? isDue(static_cast<std::uint32_t>(timerOfEvent(event))) : eventHasCause(machine_, event);
    const Graph::Bool runs = graph.land(isReady(event), graph.lnot(isLockedOut(event)));
    comesStill = graph.lor(comesStill, graph.land(may, runs));
  }
  const Graph::Bool optional =
      graph.land(graph.lor(graph.land(round.hasChanged, comesStill), round.mayGoOn), graph.lnot(round.mustGoOn));
  Graph::Bool more = graph.constant(false);
  if (graph.truth(here(optional)) != false)
    more = freely(fmt::format("more interrupts before instruction {}", round.where.instruction), optional);
  if (graph.truth(here(round.mustGoOn)) != false) {
    useEstimate(round.mustGoOn);
    more = graph.lor(more, round.mustGoOn);
  }
  if (graph.truth(here(more)) == false) return;
  std::map<Place, Node> places = round.before;
  if (!effects_->isComplete()) {
    if (hasHavoc_) {
      store_.havoc(here(more),
                   [this](const Place& place) { return anyOf("after more " + nameOf(place), place.width); });
    }
    for (const auto& [routine, footprint] : knowledge_.footprints.ofRoutine) {
      for (const Place& place : placesOf(footprint.writes)) places.try_emplace(place, store_.value(place));
    }
  }
  // What devices change beside the routines.
  std::set<Place> ofDevices;
  for (const int event : round.events) {
    Footprint cause;
    addCauseKeys(event, cause);
    for (const Place& place : placesOf(cause.writes)) {
      places.try_emplace(place, store_.value(place));
      ofDevices.insert(place);
    }
  }
  std::erase_if(places, [](const auto& entry) {
    const Place& place = entry.first;
    return place.isRegister && (place.reg == Reg::InterruptsEnabled || place.reg == Reg::Eno);
  });
  std::map<Place, RunBounds::Ends> ends;
  for (const auto& [place, before] : places) {
    const auto entry = effects_->entry().find(place);
    const int width = entry == effects_->entry().end() ? place.width : bitsFor(entry->second, place.width);
    const Node after = graph.make(Op::Zext, place.width, anyOf("after more " + nameOf(place), width));
    ends.emplace(place, RunBounds::Ends{before, after});
  }
  std::vector<Graph::Bool> changing;
  RunBounds::Change change{[&](const Place& other) {
    const auto found = ends.find(other);
    const Node stays = found == ends.end() ? store_.value(other) : noNode;
    return found == ends.end() ? RunBounds::Ends{stays, stays} : found->second;
  }};
  if (hasPointers_) change.isPossible = [&](Graph::Bool condition) { return isPossible(here(condition)); };
  for (const auto& [place, before] : places) {
    const Graph::Bool isWithin = effects_->bounds().mayChange(graph, place, change);
    changing.push_back(ofDevices.contains(place) ? more : graph.land(more, isWithin));
  }
  auto changes = changing.begin();
  for (const auto& [place, before] : places) {
    const Node fresh = ends.at(place).after;
    machine_.when(*changes++, [&] {
      if (place.isRegister)
        machine_.set(place.reg, place.at, {fresh});
      else if (place.width == 1)
        machine_.saveBit(place.area, place.byte(), place.bit(), {fresh});
      else
        store_.save(place.area, place.at, place.width, {fresh}, machine_.guard);
    });
  }
  tellKept(round);
  for (auto& [input, last] : eventStates_.lastEdge) become(last, here(more), graph.constantNode(0, 2));
  for (auto& [timer, since] : eventStates_.sinceLast) {
    const int event = eventOfTimed(timer);
    if (isDelayEvent(event))  // their routines may have started it anew
      become(since, here(more), anyOf(fmt::format("after more event {}", event), graph[since].width));
  }
  const bool mayHalt =
      !effects_->isComplete() || std::ranges::any_of(round.ran, [&](int r) { return effects_->mayHalt(r); });
  if (mayHalt) machine_.halt(graph.land(more, {anyOf("more interrupts end the program", 1)}));
  for (const int event : round.events) {
    for (const int number : attachments_.at(event)) {
      const Graph::Bool again = graph.land(more, graph.land(isReady(event), isAttached(event, number)));
      if (graph.truth(here(again)) == false) continue;
      routine_ = number;
      isRecording_ = true;
      runner.interrupt(number, graph.land(again, {anyOf("one more interrupt", 1)}));
      isRecording_ = false;
      routine_ = -1;
      tellKept(round);
    }
  }
}

// ---- Edges and lost events ---------------------------------------------------------------------------------

/// Edges of an input are in turn only while both are followed.
void ScanEncoding::followEdges(int event) {
  const auto last = eventStates_.lastEdge.find(edgeInputOf(event));
  if (last == eventStates_.lastEdge.end()) return;
  const int rising = edgeInputFor(event).rising;
  const Graph::Bool areFollowed =
      graph.land(machine_.getBit(Reg::InterruptsEnabled), graph.land(hasRoutine(rising), hasRoutine(rising + 1)));
  become(last->second, here(graph.lnot(areFollowed)), graph.constantNode(0, 2));
}

/// A queue may overflow while routines run or interrupts are disabled. That it is full means that many routines will
/// run.
void ScanEncoding::followOverflow(Round& round) {
  for (const int bit : eventStates_.overflowBits) {
    Graph::Bool attached = graph.constant(false);
    for (const int event : round.events) {
      if (static_cast<int>(eventInfo(event).group) == bit) attached = graph.lor(attached, hasRoutine(event));
    }
    if (graph.truth(here(attached)) == false) continue;
    const Graph::Bool full = freely(fmt::format("queue {} overflows", bit), attached);
    machine_.when(full, [&] { machine_.setSm(overflowByte, static_cast<std::uint32_t>(bit), graph.constant(true)); });
    const Graph::Bool wasFull = machine_.sm(overflowByte, static_cast<std::uint32_t>(bit));
    round.mayGoOn = graph.lor(round.mayGoOn, graph.land(interruptsEnabled(), wasFull));
  }
}

void ScanEncoding::endOverflow(const Round&) {
  const Graph::Bool enabled = interruptsEnabled();
  machine_.when(enabled, [&] {
    for (const int bit : eventStates_.overflowBits)
      machine_.setSm(overflowByte, static_cast<std::uint32_t>(bit), graph.constant(false));
  });
}

}  // namespace rungproof
