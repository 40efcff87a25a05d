// Bit logic: scans, nesting, assignments, edges (002:2697-2714; first check and OR: 003:1213, 003:1292). The joining of
// AND groups is general knowledge: A v gives ((RLO or first) and v) or (OR and not first).
#pragma once

#include "ir/s7300/isa/step7_group.hpp"

namespace rungproof::isa::step7 {

/// The RLO and the OR bit that a scan of `value` leaves, by what it joins with.
template <class D>
void joinScan(Step7Args<D>& a, Joint joint, typename D::Bool value, typename D::Bool rlo, typename D::Bool orBit,
              typename D::Bool firstCheck) {
  D& d = a.d;
  const bool negates = joint == Joint::AndNot || joint == Joint::OrNot || joint == Joint::XorNot;
  const auto v = negates ? d.lnot(value) : value;
  const auto kept = d.land(orBit, firstCheck);
  switch (joint) {
    case Joint::And:
    case Joint::AndNot:
      a.setBit(a.s.rlo, d.lor(d.land(d.lor(rlo, d.lnot(firstCheck)), v), kept));
      a.setBit(a.s.orBit, kept);
      return;
    case Joint::Or:
    case Joint::OrNot: a.setBit(a.s.rlo, d.lor(d.land(rlo, firstCheck), v)); break;
    case Joint::Xor:
    case Joint::XorNot: a.setBit(a.s.rlo, d.lxor(d.land(rlo, firstCheck), v)); break;
  }
  a.setBit(a.s.orBit, a.no());
}

/// A, AN, O, ON, X, XN with an operand.
template <Joint joint, Name stlName, Name germanName, Name meaning>
struct BitScan {
  static constexpr bool negates = joint == Joint::AndNot || joint == Joint::OrNot || joint == Joint::XorNot;
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .german = germanName.view(),
                                             .meaning = meaning.view(),
                                             .group = "bit logic",
                                             .negated = negates,
                                             .execution = Execution::Always,
                                             .manual = "002:2697"},
                                            {in("bit", Type::Bool, form7::scanned)});
  template <class D>
  static void run(Step7Args<D>& a) {
    const Operand& o = a.operand();
    const auto value =
        o.kind == OperandKind::Constant ? statusScan(a, static_cast<StatusScan>(o.value)) : a.places.bitOf(o);
    joinScan(a, joint, value, a.s.rlo, a.s.orBit, a.s.firstCheck);
    a.setBit(a.s.sta, value);
    a.setBit(a.s.firstCheck, a.yes());
  }
};

/// O without operand: what stands before it is one AND group, what follows another.
struct OrOfAnds {
  static constexpr Desc desc = {.stl = "OR",
                                .meaning = "or of AND groups",
                                .group = "bit logic",
                                .drawn = "O",
                                .execution = Execution::Always,
                                .manual = "002:2699"};
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    a.setBit(a.s.orBit, d.land(d.lor(a.s.rlo, a.s.orBit), a.s.firstCheck));
    a.setBit(a.s.firstCheck, d.land(a.s.rlo, a.s.firstCheck));
    a.setBit(a.s.sta, a.yes());
  }
};

/// A( and its five relatives.
template <Joint joint, Name stlName, Name germanName>
struct Open {
  static constexpr Desc desc = {.stl = stlName.view(),
                                .german = germanName.view(),
                                .meaning = "open a nesting level",
                                .group = "bit logic",
                                .execution = Execution::Always,
                                .manual = "002:2707"};
  template <class D>
  static void run(Step7Args<D>& a) {
    auto& levels = a.s.nesting;
    for (std::size_t i = nestingLevels - 1; i > 0; --i) {
      a.m.put(levels[i].rlo, levels[i - 1].rlo);
      a.m.put(levels[i].orBit, levels[i - 1].orBit);
      a.m.put(levels[i].firstCheck, levels[i - 1].firstCheck);
      a.m.put(levels[i].joint, levels[i - 1].joint, 3);
    }
    a.m.put(levels[0].rlo, a.s.rlo);
    a.m.put(levels[0].orBit, a.s.orBit);
    a.m.put(levels[0].firstCheck, a.s.firstCheck);
    a.m.put(levels[0].joint, a.number(static_cast<std::uint64_t>(joint), 3), 3);
    a.endString(a.yes());
  }
};

struct Close {
  static constexpr Desc desc = {.stl = ")",
                                .meaning = "close a nesting level",
                                .group = "bit logic",
                                .execution = Execution::Always,
                                .manual = "002:2707"};
  template <class D>
  static void run(Step7Args<D>& a) {
    auto& levels = a.s.nesting;
    const auto top = levels[0];
    const auto inner = a.s.rlo;
    for (std::size_t i = 0; i + 1 < nestingLevels; ++i) {
      a.m.put(levels[i].rlo, levels[i + 1].rlo);
      a.m.put(levels[i].orBit, levels[i + 1].orBit);
      a.m.put(levels[i].firstCheck, levels[i + 1].firstCheck);
      a.m.put(levels[i].joint, levels[i + 1].joint, 3);
    }
    for (const Joint joint : {Joint::And, Joint::AndNot, Joint::Or, Joint::OrNot, Joint::Xor, Joint::XorNot}) {
      a.m.when(a.d.equal(top.joint, a.number(static_cast<std::uint64_t>(joint), 3), 3),
               [&] { joinScan(a, joint, inner, top.rlo, top.orBit, top.firstCheck); });
    }
    a.setBit(a.s.sta, a.yes());
    a.setBit(a.s.firstCheck, a.yes());
  }
};

/// = : where a master control relay is off it writes 0.
struct Step7Assign {
  static constexpr Desc desc = withOperands({.stl = "=",
                                             .meaning = "assign the RLO",
                                             .group = "bit logic",
                                             .role = Role::Assign,
                                             .drawn = " ",
                                             .execution = Execution::Always,
                                             .manual = "002:2708"},
                                            {out("bit", Type::Bool, form7::memory)});
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto value = a.d.land(a.s.rlo, a.d.lnot(a.isRelayOff()));
    a.places.saveBit(a.places.find(a.operand(), Width::Bit), value);
    a.endString(value);
  }
};

/// S and R: with RLO 1, and not where a master control relay is off. STA is the bit as it is afterwards.
template <bool value, Name stlName, Name meaning>
struct Step7Latch {
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .meaning = meaning.view(),
                                             .group = "bit logic",
                                             .role = value ? Role::Set : Role::Reset,
                                             .execution = Execution::Always,
                                             .manual = value ? "002:2710" : "002:2709"},
                                            {out("bit", Type::Bool, form7::memory)});
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto acts = a.d.land(a.s.rlo, a.d.lnot(a.isRelayOff()));
    const auto spot = a.places.find(a.operand(), Width::Bit);
    const auto old = a.places.loadBit(spot);
    a.m.when(acts, [&] { a.places.saveBit(spot, a.d.constant(value)); });
    a.endString(a.d.select(acts, a.d.constant(value), old));
  }
};

/// FP and FN: the edge of the RLO against the bit that remembers it.
template <bool rising, Name stlName, Name meaning>
struct RloEdge {
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .meaning = meaning.view(),
                                             .group = "bit logic",
                                             .execution = Execution::Always,
                                             .manual = rising ? "002:2706" : "002:2705"},
                                            {inout("edge memory", Type::Bool, form7::memory)});
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto spot = a.places.find(a.operand(), Width::Bit);
    const auto before = a.places.loadBit(spot), now = a.s.rlo;
    a.places.saveBit(spot, now);
    a.setBit(a.s.rlo, rising ? a.d.land(now, a.d.lnot(before)) : a.d.land(a.d.lnot(now), before));
    a.setBit(a.s.orBit, a.no());
    a.setBit(a.s.sta, now);
    a.setBit(a.s.firstCheck, a.yes());
  }
};

struct Step7Not {
  static constexpr Desc desc = {.stl = "NOT",
                                .meaning = "negate the RLO",
                                .group = "bit logic",
                                .role = Role::Not,
                                .execution = Execution::Always,
                                .manual = "002:2711"};
  template <class D>
  static void run(Step7Args<D>& a) {
    a.setBit(a.s.rlo, a.d.lnot(a.s.rlo));
    a.setBit(a.s.sta, a.yes());
  }
};

template <bool value, Name stlName, Name meaning>
struct FixRlo {
  static constexpr Desc desc = {.stl = stlName.view(),
                                .meaning = meaning.view(),
                                .group = "bit logic",
                                .execution = Execution::Always,
                                .manual = value ? "002:2712" : "002:2713"};
  template <class D>
  static void run(Step7Args<D>& a) {
    a.setBit(a.s.rlo, a.d.constant(value));
    a.endString(a.d.constant(value));
  }
};

struct Save {
  static constexpr Desc desc = {.stl = "SAVE",
                                .meaning = "save the RLO in BR",
                                .group = "bit logic",
                                .execution = Execution::Always,
                                .manual = "002:2714"};
  template <class D>
  static void run(Step7Args<D>& a) {
    a.setBit(a.s.br, a.s.rlo);
  }
};

using Step7BitLogicGroup =
    Group<BitScan<Joint::And, "A", "U", "and">, BitScan<Joint::AndNot, "AN", "UN", "and not">,
          BitScan<Joint::Or, "O", "O", "or">, BitScan<Joint::OrNot, "ON", "ON", "or not">,
          BitScan<Joint::Xor, "X", "X", "exclusive or">, BitScan<Joint::XorNot, "XN", "XN", "exclusive or not">,
          OrOfAnds, Open<Joint::And, "A(", "U(">, Open<Joint::AndNot, "AN(", "UN(">, Open<Joint::Or, "O(", "O(">,
          Open<Joint::OrNot, "ON(", "ON(">, Open<Joint::Xor, "X(", "X(">, Open<Joint::XorNot, "XN(", "XN(">, Close,
          Step7Assign, Step7Latch<false, "R", "reset">, Step7Latch<true, "S", "set">,
          RloEdge<false, "FN", "falling edge of the RLO">, RloEdge<true, "FP", "rising edge of the RLO">, Step7Not,
          FixRlo<true, "SET", "RLO to 1">, FixRlo<false, "CLR", "RLO to 0">, Save>;

}  // namespace rungproof::isa::step7
