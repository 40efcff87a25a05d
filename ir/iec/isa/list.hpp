// All instructions of the IEC 61131-3 machine: the groups of ir/iec/isa joined. Only ir/iec/isa/table.cpp and the one
// source per domain that instantiates the dispatch table include it.
#pragma once

#include "ir/iec/isa/access.hpp"
#include "ir/iec/isa/arithmetic.hpp"
#include "ir/iec/isa/control.hpp"
#include "ir/iec/isa/convert.hpp"
#include "ir/iec/isa/logic.hpp"
#include "ir/iec/isa/long_real.hpp"
#include "ir/iec/isa/real.hpp"
#include "ir/iec/isa/text.hpp"

namespace rungproof::isa::iec {

using AllInstructions = Join<AccessGroup, LogicGroup, ArithmeticGroup, RealGroup, LongRealGroup, ConvertGroup,
                             TextGroup, ControlGroup>::type;

/// Every descriptor, opcode = index.
inline constexpr auto instructionTable = makeTable(AllInstructions{});

template <class D, class... Ops>
constexpr std::array<Execute<D>, sizeof...(Ops)> makeDispatch(Group<Ops...>) {
  return {&executeIec<Ops, D>...};
}

}  // namespace rungproof::isa::iec
