// All instructions of the S7-300/400: the groups of ir/s7300/isa joined in the order of the manual's appendix
// (002:2697-2910). Only ir/s7300/isa/table.cpp and the one source per domain that instantiates the dispatch table
// include it.
#pragma once

#include "ir/s7300/isa/arithmetic.hpp"
#include "ir/s7300/isa/bit_logic.hpp"
#include "ir/s7300/isa/compare.hpp"
#include "ir/s7300/isa/control.hpp"
#include "ir/s7300/isa/convert.hpp"
#include "ir/s7300/isa/counter.hpp"
#include "ir/s7300/isa/load.hpp"
#include "ir/s7300/isa/real.hpp"
#include "ir/s7300/isa/shift.hpp"
#include "ir/s7300/isa/timer.hpp"

namespace rungproof::isa::step7 {

using AllInstructions =
    Join<Step7BitLogicGroup, Step7ConvertGroup, Step7CompareGroup, Step7ArithmeticGroup, Step7RealGroup,
         Step7ShiftGroup, Step7ControlGroup, Step7LoadGroup, Step7TimerGroup, Step7CounterGroup>::type;

/// Every descriptor, opcode = index.
inline constexpr auto instructionTable = makeTable(AllInstructions{});

template <class D, class... Ops>
constexpr std::array<Execute<D>, sizeof...(Ops)> makeDispatch(Group<Ops...>) {
  return {&executeStep7<Ops, D>...};
}

}  // namespace rungproof::isa::step7
