// FlowWalk: the walk of a machine over the steps of a block. What a step does, the family's scan says.
//
// Branches are guards: branch(condition, target) sends the part of the current guard where `condition` holds to
// `target` and keeps the rest here. Concrete follows the one part that exists. Graph walks on in program order,
// collecting what was sent forward until its target is reached, and repeats a loop body for what was sent back
// until nothing can be sent any more, `loopLimit` rounds were made or `stepLimit` instructions were walked. From there
// on a hook beyondLimit(condition, isFirst), if there is one, says what becomes of the rounds that are left; without it
// they are not followed (Hazard::LoopBound).
//
// Hooks: before(scan, step) is called in front of every instruction; interrupts and time within a scan live there.
#pragma once

#include <concepts>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "ir/family.hpp"
#include "ir/flow.hpp"
#include "ir/hazard.hpp"

namespace rungproof {

/// What becomes of the rounds of a loop that are too many to be followed one by one.
enum class RoundsLeft : std::uint8_t {
  Follow,   ///< one more round, from a state that the hook has made stand for several
  Endless,  ///< all rounds in which the loop can end have been followed: what is left runs into the watchdog
  LeftOut,  ///< they are not followed
};

/// `Derived` runs one step in execute(walk, at); `Machine` is a GuardedRun.
template <class Derived, class Machine, class Hooks>
class FlowWalk {
 protected:
  using Bool = typename Machine::Bool;
  static constexpr bool isConcrete = std::same_as<Bool, bool>;

  FlowWalk(Machine& machine, Hooks& hooks, int loopLimit, std::size_t stepLimit)
      : m_(machine), hooks_(hooks), loopLimit_(loopLimit), stepLimit_(stepLimit) {}

  Machine& m_;
  Hooks& hooks_;

  /// State of the walk over one block.
  struct Walk {
    const Flow& flow;
    std::uint32_t next = 0;
    std::map<std::uint32_t, Bool> sent{};   ///< guards on their way to a later instruction
    std::map<std::uint32_t, int> rounds{};  ///< rounds made by each backward branch
    std::set<std::uint32_t> beyond{};       ///< backward branches that have had all their rounds
    std::optional<Bool> whole{};            ///< the guard before it was split into parts, of which none is lost
  };

  void walk(const Flow& flow) {
    const Bool entry = m_.guard;
    const bool isEvery = m_.isEveryRun();
    const std::optional<Bool> outer = m_.everyRun;
    Walk w{flow};
    Derived& derived = static_cast<Derived&>(*this);
    const auto end = static_cast<std::uint32_t>(flow.steps.size());
    while (w.next < end) {
      const std::uint32_t at = w.next++;
      if constexpr (isConcrete) {
        if (!m_.guard) break;
      } else {
        arrive(w, at);
        if (const auto known = m_.d.truth(m_.guard); known && !*known) continue;
      }
      const FlowStep& step = flow.steps[at];
      m_.current = step.instruction;
      ++steps_;
      hooks_.before(derived, step);
      if constexpr (isConcrete) {
        if (!m_.guard) break;  // an interrupt routine in front of the instruction has ended the program
      } else {
        m_.everyRun = isEvery && onTheirWay_ == 0 ? std::optional(m_.guard) : std::nullopt;
      }
      derived.execute(w, at);
    }
    m_.guard = m_.d.land(entry, m_.d.lnot(m_.halted));
    onTheirWay_ -= w.sent.size();
    m_.everyRun = isEvery ? std::optional(m_.guard) : outer;
  }

  /// Runs body, which walks blocks with registers of their own.
  template <class Body>
  void withOwnRegisters(Body&& body) {
    const std::size_t outer = std::exchange(onTheirWay_, 0);
    const std::optional<Bool> every = std::exchange(m_.everyRun, m_.guard);
    body();
    onTheirWay_ = outer;
    m_.everyRun = every;
  }

  /// Runs body, which walks another block, where `condition` holds.
  template <class Body>
  void inside(Bool condition, Body&& body) {
    m_.when(condition, body);
  }

  /// Continues at `target` where `condition` holds. The end of the block is target steps.size().
  void branch(Walk& w, Bool condition, std::uint32_t target) {
    if constexpr (isConcrete) {
      if (condition) w.next = target;
    } else {
      const std::uint32_t from = w.next;
      if (w.sent.empty()) w.whole = m_.guard;
      const Bool taken = m_.d.land(m_.guard, condition);
      const Bool stays = m_.d.land(m_.guard, m_.d.lnot(condition));
      if (const auto known = m_.d.truth(taken); known && !*known) return;
      if (target >= from) {
        send(w, target, taken);
        m_.guard = stays;
        return;
      }
      w.rounds.erase(w.rounds.lower_bound(target), w.rounds.lower_bound(from));  // loops inside start anew
      w.beyond.erase(w.beyond.lower_bound(target), w.beyond.lower_bound(from));
      if constexpr (requires { hooks_.isPossible(condition); }) {
        if (!hooks_.isPossible(condition)) return;
      }
      if ((++w.rounds[from] > loopLimit_ || steps_ > stepLimit_) && !goesOn(condition, w.beyond.insert(from).second)) {
        m_.guard = stays;
        w.whole.reset();
        return;
      }
      send(w, from, stays);
      m_.guard = taken;
      w.next = target;
    }
  }

 private:
  void arrive(Walk& w, std::uint32_t at) {
    const auto found = w.sent.find(at);
    if (found == w.sent.end()) return;
    m_.guard = m_.d.lor(m_.guard, found->second);
    w.sent.erase(found);
    --onTheirWay_;
    if (w.sent.empty() && w.whole && joinsWhole()) m_.guard = m_.d.land(*w.whole, m_.d.lnot(m_.halted));
  }
  void send(Walk& w, std::uint32_t target, Bool guard) {
    const auto [place, isNew] = w.sent.emplace(target, guard);
    if (!isNew) place->second = m_.d.lor(place->second, guard);
    if (isNew) ++onTheirWay_;
  }

  /// Whether all parts of a guard together are the guard again, without what has ended the program: shorter than the
  /// parts, and the same. A subroutine of the other families may end its caller as well.
  bool joinsWhole() const { return m_.plan.form() == StatementForm::Accumulators; }

  /// Whether a loop that has had its rounds goes into another one; `isFirst`: the first one beyond them.
  bool goesOn(Bool condition, bool isFirst) {
    RoundsLeft left = RoundsLeft::LeftOut;
    if constexpr (requires { hooks_.beyondLimit(condition, isFirst); }) left = hooks_.beyondLimit(condition, isFirst);
    if (left == RoundsLeft::Follow) return true;
    m_.hazard(left == RoundsLeft::Endless ? m_.plan.dialect().run.endlessScan : Hazard::LoopBound, condition);
    return false;
  }

  int loopLimit_;
  std::size_t stepLimit_;
  std::size_t steps_ = 0;       ///< instructions walked so far
  std::size_t onTheirWay_ = 0;  ///< guards in Walk::sent of this block and of those that have called it
};

}  // namespace rungproof
