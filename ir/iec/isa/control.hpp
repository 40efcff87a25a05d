// What moves the flow of a program has its meaning in ir/iec/control.hpp; here are the descriptors. Beside them the
// passing of time: the clock of a timer goes on by itself while it runs, whether its block is called or not.
#pragma once

#include "ir/iec/isa/iec_group.hpp"

namespace rungproof::isa::iec {

/// Base of instructions whose meaning is in ir/iec/control.hpp.
struct InIecScan {
  template <class D>
  static void run(IecArgs<D>&) {}
};

constexpr Desc controlling(std::string_view mnemonic, std::string_view meaning, Control control,
                           StackEffect stack = {}) {
  Desc desc = described(mnemonic, meaning);
  desc.control = control;
  desc.stack = stack;
  return desc;
}
constexpr OperandDesc label() { return in("LABEL", Type::Label, form::Const); }

struct Jump : InIecScan {
  static constexpr Desc desc = withOperands(controlling("JMP", "jump", Control::Jump), {label()});
};
struct JumpIfFalse : InIecScan {
  static constexpr Desc desc =
      withOperands(controlling("JMPCN", "pop, and jump if it is FALSE", Control::Jump, {1, 1, 0}), {label()});
};
struct Label : InIecScan {
  static constexpr Desc desc = withOperands(controlling("LBL", "label", Control::LabelMark), {label()});
};
struct Call : InIecScan {
  static constexpr Desc desc = withOperands(controlling("CAL", "run the body of an instance", Control::Call),
                                            {in("POU", Type::Subroutine, form::Const)});
};
struct Return : InIecScan {
  static constexpr Desc desc = controlling("RET", "leave the body", Control::Return);
};

/// Where STATE is 1 the ms from the start of the scan before to the start of this one are added to ELAPSED, which stays
/// at LIMIT.
struct PassTime {
  static constexpr Desc desc =
      withOperands(described("PASS", "time passes for a timer that runs"),
                   {in("STATE", Type::Byte, variable), inout("ELAPSED", Type::DInt, variable), part("LIMIT")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto isRunning = a.d.equal(a.load(0), a.literal(1, 8), 8);
    a.m.when(isRunning, [&] {
      const auto passed = a.d.add(a.load(1), a.d.zext(a.m.get(Reg::LastScan), 16, 32), 32);
      const auto limit = a.literal(static_cast<std::uint64_t>(a.number(2)), 32);
      a.save(1, a.d.select(a.d.ult(passed, limit, 32), passed, limit, 32));
    });
  }
};

using ControlGroup = Group<Jump, JumpIfFalse, Label, Call, Return, PassTime>;

}  // namespace rungproof::isa::iec
