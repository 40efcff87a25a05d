// Entries of the event queue (001:5480-5491): what puts them there beside the places of a scan - timers that reach
// their preset, requests that end, a reception that RCV ends itself - and what ATCH, DTCH and CEVNT do to those that
// wait.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "analysis/encoding/scan_encoding.hpp"
#include "ir/s7200/event_cause.hpp"
#include "ir/s7200/isa/comm.hpp"

namespace rungproof {

void ScanEncoding::timerReached(const TimerUse& use, Graph::Bool reached) {
  if (eventStates_.waiting.contains(eventOfTimer(use.number))) queueOne(eventOfTimer(use.number), reached);
}

/// The event comes where `condition` holds, and waits for its turn.
void ScanEncoding::queueOne(int event, Graph::Bool condition) {
  const auto waits = eventStates_.waiting.find(event);
  const std::uint64_t depth = queueDepth(machine_.target, eventInfo(event).group);
  const Graph::Bool comes = graph.land(condition, graph.land(hasRoutine(event), machine_.getBit(Reg::Running)));
  const Graph::Bool fits = graph.ult({waits->second}, graph.literal(depth, queueBits), queueBits);
  become(waits->second, here(graph.land(comes, fits)),
         graph.make(Op::Add, queueBits, waits->second, graph.constantNode(1, queueBits)));
}

/// In front of RCV: with the enable bit off it ends a running reception, which is an event (001:3217).
void ScanEncoding::noteEndOfReception(const Instruction& instruction) {
  if (instruction.operands.size() != 2 || instruction.operands[1].kind != OperandKind::Constant) return;
  const auto port = static_cast<std::uint32_t>(instruction.operands[1].value);
  if (port > 1 || !eventStates_.waiting.contains(eventOfEnd(PortUse::Reception, port))) return;
  const bool wasRecording = std::exchange(isRecording_, false);
  const Graph::Bits busy = machine_.get(Reg::PortBusy, port);
  const Graph::Bool isUsable =
      graph.land(isa::portIs(machine_, port, isa::freeport), graph.lnot(graph.bit(busy, isa::sending)));
  const Graph::Bool ends =
      graph.land(graph.bit(busy, isa::receiving), graph.lnot(machine_.sm(receiveStatus(port) + 1, 7)));
  queueOne(eventOfEnd(PortUse::Reception, port), graph.land(machine_.powerFlow(), graph.land(isUsable, ends)));
  isRecording_ = wasRecording;
}

/// The time of an event begins anew, at any time of the scan that is not over yet; the engine asks for it likewise.
void ScanEncoding::restartTimed(int event, const Instruction& instruction, Graph::Bool runs) {
  EventStates& s = eventStates_;
  const int w = graph[s.passed].width;
  const Graph::Bits dt{graph.make(Op::Zext, w, time.dt())}, before{s.passed};
  const ExternalSite site{External::AsyncTicks, static_cast<std::uint32_t>(event), instruction.id};
  const Graph::Bits any{siteInput(SiteInput::ticks, instruction.id, w)};
  externals.push_back({site, any.node, w, here(runs).node});
  const Graph::Bool fits = graph.land(graph.ule(before, any, w), graph.ule(any, dt, w));
  const Graph::Bits now = graph.select(fits, any, before, w);
  become(s.sinceLast.at(static_cast<std::uint32_t>(timerOfEvent(event))), here(runs), graph.sub(dt, now, w).node);
  become(s.passed, here(runs), now.node);
}

/// SFC 32 starts a delay anew, or SFC 33 ends it. Whether that is in time for an interrupt that is due and held back,
/// by SFC 41 or because another block runs, is not stated.
void ScanEncoding::signalled(Signal which, std::uint32_t index, Graph::Bool) {
  const int event = static_cast<int>(index);
  if (which == Signal::EventDetached) return noteLock(event);
  const bool starts = which == Signal::EventAttached;
  if ((!starts && which != Signal::EventsCleared) || !isDelayEvent(event) || !attachments_.contains(event)) return;
  const Graph::Bool isHeldBack = graph.lor(graph.constant(machine_.inInterrupt),
                                           graph.lnot(graph.equal(machine_.step7.delays, graph.literal(0, 8), 8)));
  const Graph::Bool isOpen = here(graph.land(isHeldBack, isDue(static_cast<std::uint32_t>(timerOfEvent(event)))));
  if (graph.truth(isOpen) != false)
    leaveOut(machine_.current, "a delay interrupt may be due while it is held back", isOpen);
  if (starts) restartTimed(event, *machine_.current, graph.constant(true));
}

/// SFC 39 locks the event. One that waits, because of SFC 41 or of a block of the same or a higher priority, would
/// still run afterwards: which those are is not kept.
void ScanEncoding::noteLock(int event) {
  if (!isBlockEvent(event) || !attachments_.contains(event) || machine_.isStartUp) return;
  const int running = eventOfBlock(routine_);
  const bool isBelow = machine_.inInterrupt && (running < 0 || priorityOf(event) <= priorityOf(running));
  const Graph::Bool isHeldBack =
      graph.lor(graph.constant(isBelow), graph.lnot(graph.equal(machine_.step7.delays, graph.literal(0, 8), 8)));
  const Graph::Bool isOpen = here(graph.land(isHeldBack, graph.lnot(isLockedOut(event))));
  if (graph.truth(isOpen) != false) leaveOut(machine_.current, "an interrupt may wait while it is locked", isOpen);
}

/// In front of ATCH, DTCH and CEVNT.
void ScanEncoding::noteAttachment(const Instruction& instruction) {
  const Role role = roleOf(instruction);
  if (role == Role::Eni) {
    isAfterEnable_ = !eventStates_.waiting.empty() || !eventStates_.left.empty() || !eventStates_.overflowBits.empty();
  }
  if (role == Role::Rcv) noteEndOfReception(instruction);
  if (role != Role::Atch && role != Role::Dtch && role != Role::Cevnt) return;
  const std::size_t at = role == Role::Atch ? 1 : 0;
  if (instruction.operands.size() <= at) return;
  const int event = static_cast<int>(instruction.operands[at].value);
  if (!attachments_.contains(event)) return;
  const bool wasRecording = std::exchange(isRecording_, false);
  EventStates& s = eventStates_;
  const Graph::Bool runs = machine_.powerFlow();
  const auto waits = s.waiting.find(event);
  const auto left = s.left.find(event);
  const Graph::Bits none = graph.literal(0, queueBits);
  if (role == Role::Atch && isTimedEvent(event)) restartTimed(event, instruction, runs);
  if (role == Role::Dtch && left != s.left.end()) {
    // Entries are in the queue only while interrupts are disabled, or while a routine runs.
    const Graph::Bool maySit =
        graph.land(machine_.inInterrupt ? graph.constant(true) : graph.lnot(machine_.getBit(Reg::InterruptsEnabled)),
                   graph.land(runs, hasRoutine(event)));
    const Graph::Bool caused = waits != s.waiting.end() ? graph.lnot(graph.equal({waits->second}, none, queueBits))
                                                        : eventHasCause(machine_, event);
    const Graph::Bool sits = graph.land(maySit, caused);
    if (graph.truth(here(sits)) != false) {
      const bool isExact = !machine_.inInterrupt && waits == s.waiting.end();
      const std::string name = fmt::format("event {} waits at instruction {}", event, instruction.id);
      const Graph::Bool any{isExact ? input(name, 1) : anyOf(name, 1)};
      const Graph::Bool stays = graph.land(sits, any);
      // An entry that is there stays in the queue of the engine, and all that are there.
      if (waits != s.waiting.end()) {
        const Graph::Bool single = graph.equal({waits->second}, graph.literal(1, queueBits), queueBits);
        useEstimate(graph.land(sits, graph.lnot(graph.land(any, single))));
      } else if (!isExact) {
        useEstimate(stays);
      }
      become(left->second, here(stays), machine_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event)).node);
      if (isExact) {
        eventSites.push_back({{instruction.id, visitOf(instruction.id), machine_.guard.node},
                              event,
                              here(stays).node,
                              graph.constant(false).node});
        machine_.when(stays, [&] { deviceEvent(machine_, event); });
      }
    }
  }
  if (waits != s.waiting.end() && role != Role::Atch) become(waits->second, here(runs), none.node);
  if (left != s.left.end() && role == Role::Atch) {
    const Graph::Bool isLeft = graph.land(runs, graph.lnot(graph.equal({left->second}, graph.literal(0, 8), 8)));
    if (graph.truth(here(isLeft)) != false) {  // it runs the new routine, as an event that comes then would
      anyOf("an entry finds another routine", 1);
      useEstimate(isLeft);
    }
  }
  if (left != s.left.end() && role != Role::Dtch) become(left->second, here(runs), graph.constantNode(0, 8));
  isRecording_ = wasRecording;
}

}  // namespace rungproof
