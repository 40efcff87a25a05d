// Bistables SR (set dominant) and RS (reset dominant) (001:2876-2908). They exist in LAD and FBD
// only; the IR writes `SR bit` and `RS bit` with the set input on level 1 and the reset input on top, as after
// `LD set / LD reset`. The reset level is popped and OUT, which mirrors the bit, becomes the new top, so that a coil
// may follow. Evaluated in every pass. Tests: tests/manual/coil_test.cpp.
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

template <bool setDominant, Name stlName, Name meaning>
struct Bistable {
  static constexpr Desc desc =
      withOperands({.stl = stlName.view(),
                    .meaning = meaning.view(),
                    .group = "boolean",
                    .role = setDominant ? Role::Sr : Role::Rs,
                    .flowPins = setDominant ? FlowPins{"S1", "R"} : FlowPins{"S", "R1"},
                    .execution = Execution::Sampled,
                    .stack = {2, 1, 0},
                    .drawingOnly = true,
                    .manual = "001:2892"},
                   {inout("bit", Type::Bool, form::I | form::Q | form::V | form::M | form::S)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto set = m.powerFlow(1), reset = m.powerFlow(0), before = a.bit(0);
    const auto after =
        setDominant ? d.lor(set, d.land(d.lnot(reset), before)) : d.land(d.lnot(reset), d.lor(set, before));
    a.storeBit(0, after);
    m.pop();
    m.setTop(after);
  }
};

using SetDominant = Bistable<true, "SR", "bistable, set dominant">;
using ResetDominant = Bistable<false, "RS", "bistable, reset dominant">;

using BistableGroup = Group<SetDominant, ResetDominant>;

}  // namespace rungproof::isa
