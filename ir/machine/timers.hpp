// What a scan does for numbered timers, which run down in ms (Counting::Elements). The family that has them says how:
// ir/s7300/timer_pass.hpp. Of other families these do nothing.
#pragma once

#include "ir/machine/machine.hpp"

namespace rungproof {

/// At the start of a scan.
template <class D>
void beginScanOfTimers(Machine<D>& m);
/// Inside the scan: `ticks` ms (width 16) more have passed, Machine::passedMs in all. isAsked(number): whether it
/// matters now that this timer has come to its end.
template <class D, class IsAsked>
void passTimers(Machine<D>& m, typename D::Bits ticks, IsAsked&& isAsked);
/// At the end of a scan of `ms` (width restBits).
template <class D>
void endScanOfTimers(Machine<D>& m, typename D::Bits ms);

}  // namespace rungproof
