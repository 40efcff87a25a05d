// Edges: EU and ED (001:2741-2745, 001:2763). Each occurrence owns one memory bit, the top of the
// stack at its previous execution. The first scan only stores: no edge can be seen there. What an occurrence compares
// with that is first executed later is Choice::FirstEdge. An occurrence that is not executed keeps its memory.
// Tests: tests/manual/edge_test.cpp.
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

template <bool rising, Name stlName, Name meaning>
struct Edge {
  static constexpr Desc desc{.stl = stlName.view(),
                             .meaning = meaning.view(),
                             .group = "boolean",
                             .role = rising ? Role::Eu : Role::Ed,
                             .drawn = rising ? "P" : "N",
                             .execution = Execution::Stack,
                             .stack = {1, 0, 0},
                             .time = 800,
                             .manual = "001:2743"};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    const std::uint32_t memory = m.plan.edge[m.current->id];
    const auto now = m.top();
    const auto before = m.getBit(Reg::EdgeMemory, memory);
    const auto edge = rising ? m.d.land(now, m.d.lnot(before)) : m.d.land(before, m.d.lnot(now));
    const auto isNew =
        m.d.land(m.reads({Choice::FirstEdge, "first-execution"}), m.d.lnot(m.getBit(Reg::EdgeSeen, memory)));
    const auto onlyStores = m.d.lor(m.getBit(Reg::FirstScan), isNew);
    m.setBit(Reg::EdgeSeen, memory, m.d.constant(true));
    m.setBit(Reg::EdgeMemory, memory, now);
    m.setTop(m.d.land(edge, m.d.lnot(onlyStores)));
  }
};

using RisingEdge = Edge<true, "EU", "detect rising edge">;
using FallingEdge = Edge<false, "ED", "detect falling edge">;

using EdgeGroup = Group<RisingEdge, FallingEdge>;

}  // namespace rungproof::isa
