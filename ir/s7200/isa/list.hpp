// All instructions: the groups of ir/s7200/isa joined in the manual's order. Only ir/s7200/isa/table.cpp and the one
// source per domain that instantiates its dispatch table include this file.
#pragma once

#include "ir/s7200/isa/ascii.hpp"
#include "ir/s7200/isa/bistable.hpp"
#include "ir/s7200/isa/call.hpp"
#include "ir/s7200/isa/clock.hpp"
#include "ir/s7200/isa/coil.hpp"
#include "ir/s7200/isa/comm.hpp"
#include "ir/s7200/isa/compare.hpp"
#include "ir/s7200/isa/contact.hpp"
#include "ir/s7200/isa/control.hpp"
#include "ir/s7200/isa/convert.hpp"
#include "ir/s7200/isa/counter.hpp"
#include "ir/s7200/isa/edge.hpp"
#include "ir/s7200/isa/ethernet.hpp"
#include "ir/s7200/isa/hsc.hpp"
#include "ir/s7200/isa/increment.hpp"
#include "ir/s7200/isa/integer.hpp"
#include "ir/s7200/isa/interrupt.hpp"
#include "ir/s7200/isa/logic.hpp"
#include "ir/s7200/isa/move.hpp"
#include "ir/s7200/isa/pid.hpp"
#include "ir/s7200/isa/pulse.hpp"
#include "ir/s7200/isa/real.hpp"
#include "ir/s7200/isa/scr.hpp"
#include "ir/s7200/isa/shift.hpp"
#include "ir/s7200/isa/smart_math.hpp"
#include "ir/s7200/isa/stack.hpp"
#include "ir/s7200/isa/string.hpp"
#include "ir/s7200/isa/string_edit.hpp"
#include "ir/s7200/isa/table.hpp"
#include "ir/s7200/isa/timer.hpp"

namespace rungproof::isa {

using AllInstructions =
    Join<ContactGroup, CoilGroup, StackGroup, EdgeGroup, BistableGroup, ClockGroup, CommGroup, CompareGroup,
         ConvertGroup, AsciiGroup, StringGroup, StringEditGroup, CounterGroup, HscGroup, PulseGroup, IntegerGroup,
         RealGroup, IncrementGroup, PidGroup, InterruptGroup, LogicGroup, MoveGroup, ControlGroup, CallGroup, ScrGroup,
         ShiftGroup, TableGroup, TimerGroup, SmartMathGroup, EthernetGroup>::type;

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

template <class D, class... Ops>
constexpr std::array<Execute<D>, sizeof...(Ops)> makeDispatch(Group<Ops...>) {
  return {&execute<Ops, D>...};
}

}  // namespace rungproof::isa
