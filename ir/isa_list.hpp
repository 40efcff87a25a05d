// All instructions: the groups of ir/isa joined in the manual's order. Only ir/isa.cpp and the one source per
// domain that instantiates its dispatch table include this file.
#pragma once

#include "ir/isa/ascii.hpp"
#include "ir/isa/bistable.hpp"
#include "ir/isa/call.hpp"
#include "ir/isa/clock.hpp"
#include "ir/isa/coil.hpp"
#include "ir/isa/comm.hpp"
#include "ir/isa/compare.hpp"
#include "ir/isa/contact.hpp"
#include "ir/isa/control.hpp"
#include "ir/isa/convert.hpp"
#include "ir/isa/counter.hpp"
#include "ir/isa/edge.hpp"
#include "ir/isa/ethernet.hpp"
#include "ir/isa/hsc.hpp"
#include "ir/isa/increment.hpp"
#include "ir/isa/integer.hpp"
#include "ir/isa/interrupt.hpp"
#include "ir/isa/logic.hpp"
#include "ir/isa/move.hpp"
#include "ir/isa/pid.hpp"
#include "ir/isa/pulse.hpp"
#include "ir/isa/real.hpp"
#include "ir/isa/scr.hpp"
#include "ir/isa/shift.hpp"
#include "ir/isa/smart_math.hpp"
#include "ir/isa/stack.hpp"
#include "ir/isa/string.hpp"
#include "ir/isa/string_edit.hpp"
#include "ir/isa/table.hpp"
#include "ir/isa/timer.hpp"

namespace rungproof::isa {

using AllInstructions =
    Join<ContactGroup, CoilGroup, StackGroup, EdgeGroup, BistableGroup, ClockGroup, CommGroup, CompareGroup,
         ConvertGroup, AsciiGroup, StringGroup, StringEditGroup, CounterGroup, HscGroup, PulseGroup, IntegerGroup,
         RealGroup, IncrementGroup, PidGroup, InterruptGroup, LogicGroup, MoveGroup, ControlGroup, CallGroup, ScrGroup,
         ShiftGroup, TableGroup, TimerGroup, SmartMathGroup, EthernetGroup>::type;

template <class... Ops>
constexpr std::array<Desc, sizeof...(Ops)> makeTable(Group<Ops...>) {
  std::array<Desc, sizeof...(Ops)> table = {Ops::desc...};
  for (std::size_t i = 0; i < table.size(); ++i) table[i].opcode = static_cast<std::uint16_t>(i);
  return table;
}

/// Every descriptor, opcode = index.
inline constexpr auto instructionTable = makeTable(AllInstructions{});

constexpr bool mnemonicsAreUnique() {
  for (std::size_t i = 0; i < instructionTable.size(); ++i) {
    for (std::size_t k = i + 1; k < instructionTable.size(); ++k) {
      if (instructionTable[i].stl == instructionTable[k].stl) return false;
    }
  }
  return true;
}
static_assert(mnemonicsAreUnique(), "two instructions share a mnemonic");

/// What a domain does with an instruction: one function per opcode.
template <class D>
using Execute = void (*)(Machine<D>&, const Instruction&);

template <class D, class... Ops>
constexpr std::array<Execute<D>, sizeof...(Ops)> makeDispatch(Group<Ops...>) {
  return {&execute<Ops, D>...};
}

}  // namespace rungproof::isa
