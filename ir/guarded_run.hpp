// GuardedRun<D>: an instruction running over a domain D of values, on any machine of this kind.
//
// Guards replace branches: `guard` is the condition under which the current instruction runs. Every write
// takes effect only under it. For Concrete the guard is always true where code runs at all; for Graph a write
// becomes "if guard then new else old". Meanings use when() instead of `if` on values. The machine of a family
// (ir/machine/machine.hpp) adds its state.
#pragma once

#include <optional>

#include "ir/domain.hpp"
#include "ir/external.hpp"
#include "ir/hazard.hpp"
#include "ir/program.hpp"

namespace rungproof {

template <class D>
class GuardedRun {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  explicit GuardedRun(D& domain)
      : d(domain), guard(domain.constant(true)), halted(domain.constant(false)), faulted(domain.constant(false)) {}

  D& d;
  Bool guard;    ///< the current instruction runs under this condition
  Bool halted;   ///< STOP or a fatal error has ended the program
  Bool faulted;  ///< a fatal error has: the scan has no end (001:13906-13910)
  const Instruction* current = nullptr;
  /// The guard of all that has not ended, where nothing is on its way to a later instruction: what registers hold
  /// outside it nobody asks.
  std::optional<Bool> everyRun{};

  /// Whether the current guard is that one.
  bool isEveryRun() const {
    if constexpr (requires { d.isSame(guard, guard); }) return everyRun && d.isSame(*everyRun, guard);
    return false;
  }
  /// Runs body under `condition`. Concrete skips it when false.
  template <class Body>
  void when(Bool condition, Body&& body) {
    if (const std::optional<bool> known = d.truth(condition); known && !*known) return;
    const Bool saved = guard;
    const bool isEvery = isEveryRun();
    guard = d.land(saved, condition);
    if (const std::optional<bool> known = d.truth(guard); !known || *known) body();
    guard = d.land(saved, d.lnot(halted));
    if (isEvery) everyRun = guard;
  }
  /// Runs body(k) for k = 0 .. count-1; `count` has width w and at most `limit` rounds are followed.
  template <class Body>
  void repeat(Bits count, int w, int limit, Body&& body) {
    for (int k = 0; k < limit; ++k) {
      const Bool more = d.ult(d.literal(static_cast<std::uint64_t>(k), w), count, w);
      if (const std::optional<bool> known = d.truth(more); known && !*known) return;
      when(more, [&] { body(k); });
    }
  }
  Bits number(std::uint64_t value, int w) { return d.literal(value, w); }

  Bits external(External kind, std::uint32_t index, int width) {
    return d.external(ExternalSite{kind, index, current == nullptr ? 0 : current->id}, width);
  }
  Bool externalBit(External kind, std::uint32_t index = 0) { return d.bit(external(kind, index, 1), 0); }

  /// Tells the outside, where the domain has one, that the current instruction does this.
  void signal(Signal which, std::uint32_t index = 0) {
    if constexpr (requires { d.signal(which, index, guard); }) d.signal(which, index, guard);
  }

  /// Ends the program under `condition` (STOP in the main program, fatal errors).
  void halt(Bool condition) {
    const bool isEvery = isEveryRun();
    halted = d.lor(halted, d.land(guard, condition));
    guard = d.land(guard, d.lnot(condition));
    if (isEvery) everyRun = guard;
  }

 protected:
  /// Reports that `condition` means that error here, does `then` about it, and ends the program if it is fatal.
  template <class Then>
  void meet(Hazard which, Bool condition, Then&& then) {
    if (const std::optional<bool> known = d.truth(condition); known && !*known) return;
    const Bool happens = d.land(guard, condition);
    if (const std::optional<bool> known = d.truth(happens); known && !*known) return;
    if constexpr (requires { d.leavesAt(which); }) {
      if (d.leavesAt(which)) return d.leave(happens);
    }
    d.report(which, happens, current);
    const Bool saved = guard;
    guard = happens;
    then();
    guard = saved;
    if (hazardInfo(which).kind == HazardClass::Fatal) {
      faulted = d.lor(faulted, d.land(guard, condition));
      halt(condition);
    }
  }
};

}  // namespace rungproof
