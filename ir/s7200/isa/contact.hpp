// Contacts: LD A O with their negated and immediate forms, NOT (001:2719-2739).
// A contact of I or Q reads the process image; an immediate one the physical input at that moment (001:2731).
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

/// How a contact joins the stack is its role: pushed, ANDed with the top, ORed with it.
template <Role joint, class D>
void join(Machine<D>& m, typename D::Bool value) {
  static_assert(isContact(joint));
  if constexpr (joint == Role::Load) m.push(value);
  if constexpr (joint == Role::And) m.setTop(m.d.land(m.top(), value));
  if constexpr (joint == Role::Or) m.setTop(m.d.lor(m.top(), value));
}

constexpr StackEffect stackOf(Role joint) { return joint == Role::Load ? StackEffect{0, 0, 1} : StackEffect{1, 0, 0}; }

template <Role joint, bool negated, Name stlName, Name germanName, Name meaning, std::uint16_t time>
struct Contact {
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .german = germanName.view(),
                                             .meaning = meaning.view(),
                                             .group = "boolean",
                                             .role = joint,
                                             .negated = negated,
                                             .drawn = negated ? "/" : " ",
                                             .execution = Execution::Stack,
                                             .stack = stackOf(joint),
                                             .time = time,
                                             .manual = "001:2750"},
                                            {in("bit", Type::Bool, form::bitAny)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    join<joint>(m, negated ? m.d.lnot(a.bit(0)) : a.bit(0));
  }
};

template <Role joint, bool negated, Name stlName, Name germanName, Name meaning>
struct ImmediateContact {
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .german = germanName.view(),
                                             .meaning = meaning.view(),
                                             .group = "boolean",
                                             .role = joint,
                                             .negated = negated,
                                             .immediate = true,
                                             .drawn = negated ? "/I" : "I",
                                             .execution = Execution::Stack,
                                             .stack = stackOf(joint),
                                             .time = 1500,
                                             .manual = "001:2751"},
                                            {in("bit", Type::Bool, form::I)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const Operand& o = a.operand(0);
    const auto value = m.externalBit(External::ImmediateInput, o.offset * 8 + o.bit);
    join<joint>(m, negated ? m.d.lnot(value) : value);
  }
};

/// NOT inverts the top; the other levels stay (001:2735).
struct Not {
  static constexpr Desc desc{.stl = "NOT",
                             .meaning = "invert the top of stack",
                             .group = "boolean",
                             .role = Role::Not,
                             .execution = Execution::Stack,
                             .stack = {1, 0, 0},
                             .time = 22,
                             .manual = "001:2735"};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    m.setTop(m.d.lnot(m.top()));
  }
};

using Ld = Contact<Role::Load, false, "LD", "LD", "load bit", 22>;
using Ldn = Contact<Role::Load, true, "LDN", "LDN", "load inverted bit", 30>;
using And = Contact<Role::And, false, "A", "U", "AND bit", 22>;
using Andn = Contact<Role::And, true, "AN", "UN", "AND inverted bit", 22>;
using Or = Contact<Role::Or, false, "O", "O", "OR bit", 22>;
using Orn = Contact<Role::Or, true, "ON", "ON", "OR inverted bit", 22>;
using Ldi = ImmediateContact<Role::Load, false, "LDI", "LDI", "load bit immediate">;
using Ldni = ImmediateContact<Role::Load, true, "LDNI", "LDNI", "load inverted bit immediate">;
using Ai = ImmediateContact<Role::And, false, "AI", "UI", "AND bit immediate">;
using Ani = ImmediateContact<Role::And, true, "ANI", "UNI", "AND inverted bit immediate">;
using Oi = ImmediateContact<Role::Or, false, "OI", "OI", "OR bit immediate">;
using Oni = ImmediateContact<Role::Or, true, "ONI", "ONI", "OR inverted bit immediate">;

using ContactGroup = Group<Ld, Ldn, And, Andn, Or, Orn, Ldi, Ldni, Ai, Ani, Oi, Oni, Not>;

}  // namespace rungproof::isa
