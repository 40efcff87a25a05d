// Logic stack: ALD OLD LPS LRD LPP LDS AENO, and NOP (001:2825-2872). The stack has nine levels, that
// of the S7-200 SMART 32; a push loses the lowest one, a pop fills it with an unknown value (001:2868-2870). LRD
// replaces the top without a push. Tests: tests/manual/stack_test.cpp.
#pragma once

#include <algorithm>

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

/// ALD and OLD: the two upper levels become one (001:2829-2833).
template <bool conjunction, Name stlName, Name germanName, Name meaning>
struct CombineLevels {
  static constexpr Desc desc{.stl = stlName.view(),
                             .german = germanName.view(),
                             .meaning = meaning.view(),
                             .group = "boolean / stack",
                             .role = conjunction ? Role::Ald : Role::Old,
                             .execution = Execution::Stack,
                             .stack = {2, 1, 0},
                             .time = 22,
                             .manual = conjunction ? "001:2829" : "001:2833"};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    const auto result = conjunction ? m.d.land(m.level(0), m.level(1)) : m.d.lor(m.level(0), m.level(1));
    m.pop();
    m.setTop(result);
  }
};

/// LPS: pushes a copy of the top (001:2839).
struct PushTop {
  static constexpr Desc desc{.stl = "LPS",
                             .meaning = "duplicate the top of stack (push)",
                             .group = "boolean / stack",
                             .role = Role::Lps,
                             .execution = Execution::Stack,
                             .stack = {1, 0, 1},
                             .time = 24,
                             .manual = "001:2839"};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    m.push(m.top());
  }
};

/// LRD: level 1 overwrites the top; nothing moves (001:2843).
struct ReadSecond {
  static constexpr Desc desc{.stl = "LRD",
                             .meaning = "copy stack level 2 to the top",
                             .group = "boolean / stack",
                             .role = Role::Lrd,
                             .execution = Execution::Stack,
                             .stack = {2, 0, 0},
                             .time = 22,
                             .manual = "001:2843"};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    m.setTop(m.level(1));
  }
};

/// LPP: pops (001:2847).
struct PopTop {
  static constexpr Desc desc{.stl = "LPP",
                             .meaning = "pop the stack",
                             .group = "boolean / stack",
                             .role = Role::Lpp,
                             .execution = Execution::Stack,
                             .stack = {2, 1, 0},
                             .time = 22,
                             .manual = "001:2847"};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    m.pop();
  }
};

/// LDS N: pushes a copy of level N, 0 to 8 (S7-200 SMART: 31); LDS 0 is LPS (001:2857-2862). It needs N + 1 filled
/// levels.
struct LoadLevel {
  static constexpr Desc desc =
      withOperands({.stl = "LDS",
                    .meaning = "duplicate stack bit N on the top",
                    .group = "boolean / stack",
                    .role = Role::Lds,
                    .execution = Execution::Stack,
                    .stack = {1, 0, 1},
                    .time = 22,
                    .manual = "001:2857"},
                   {in("N", Type::Byte, form::Const).within({{0, 8, s7200Cpus}, {0, 31, smartCpus}})});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    m.push(m.level(std::min<std::size_t>(a.number(0), m.stackLevels - 1)));
  }
};

/// AENO: the top AND the ENO bit; without power flow 0 whatever ENO holds (001:2851-2853).
struct AndEno {
  static constexpr Desc desc{.stl = "AENO",
                             .german = "UENO",
                             .meaning = "AND the ENO bit with the top of stack",
                             .group = "boolean / stack",
                             .role = Role::Aeno,
                             .execution = Execution::Stack,
                             .stack = {1, 0, 0},
                             .time = 40,
                             .manual = "001:2851"};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    m.setTop(m.d.land(m.top(), m.getBit(Reg::Eno)));
  }
};

/// NOP N: no effect. The manual only gives its time (001:14609); the operand is general knowledge.
struct NoOperation {
  static constexpr Desc desc = withOperands({.stl = "NOP",
                                             .meaning = "no operation",
                                             .group = "only in Appendix F or C",
                                             .role = Role::Nop,
                                             .execution = Execution::Stack,
                                             .time = 22,
                                             .manual = "001:14609"},
                                            {optional(in("N", Type::Byte, form::Const).within({{0, 255, everyCpu}}))});
  template <class D>
  static void run(Machine<D>&, Args<D>&) {}
};

using AndLevels = CombineLevels<true, "ALD", "ULD", "AND of stack levels 1 and 2">;
using OrLevels = CombineLevels<false, "OLD", "OLD", "OR of stack levels 1 and 2">;

using StackGroup = Group<AndLevels, OrLevels, PushTop, ReadSecond, PopTop, LoadLevel, AndEno, NoOperation>;

}  // namespace rungproof::isa
