// Time acceleration: the search for witnesses must not walk through every scan in which nothing but time passes. In
// the relaxed encoding a scan may last very long; here that is restricted to what stands for a stretch of real scans:
// the long scan changes nothing but time, and the scan after it has the same inputs. A witness found so is expanded
// into real scans and replayed by the engine; that replay alone decides. Proofs never use this system.
// Covered by tests/prover/time_test.cpp.
#pragma once

#include <functional>

#include "analysis/encoding/time_model.hpp"
#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// Adds to a relaxed system the rule for long scans, each as long as some number of ordinary ones can be. `dt` and
/// `width`: length of the scan in ms; `ordinary`: of an ordinary scan; isTime: state variables that only measure time.
void accelerate(TransitionSystem& system, Node dt, int width, const TimeRange& ordinary,
                const std::function<bool(Node)>& isTime);

}  // namespace rungproof
