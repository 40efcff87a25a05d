// What blocks of the CPU and of the libraries do whose meaning is no list of statements, by their numbers. A block of
// which nothing but the contract is known gives every output any value. Each domain compiles this in one source file
// (ir/machine/dispatch.hpp). Tested by tests/prover/pointer_parameter_test.cpp and the tests of the files below.
#pragma once

#include "ir/s7300/block.hpp"
#include "ir/s7300/block_transfer.hpp"
#include "ir/s7300/date_functions.hpp"
#include "ir/s7300/selection.hpp"
#include "ir/s7300/string_functions.hpp"

namespace rungproof {

/// Every output, BR and the registers: any value. What a POINTER or an ANY leads to counts as output where the block
/// may write it. BR is 1, no error, where nothing else is given (002:2387).
template <class D>
void anyOutputs(SystemArgs<D>& a) {
  for (std::uint32_t i = 0; i < a.pou.locals.size(); ++i) {
    const LocalVariable& local = a.pou.locals[i];
    if (local.section == VarSection::Input || !a.isGiven(i)) continue;
    if (local.type == DataType::String) {
      StringFunctions<D>(a).spoil(i);
    } else if (local.type == DataType::Any) {
      const auto targets = a.targets(i);
      if (!targets) a.d.havoc(a.m);
      for (const AnyTarget<D>& t : targets ? *targets : std::vector<AnyTarget<D>>())
        a.m.when(t.condition, [&] { a.spoil(t); });
    } else if (isComplexType(local.type)) {
      for (std::uint32_t byte = 0; byte < local.size; ++byte) a.setByte(i, byte, a.any(8));
    } else {
      a.set(i, a.any(local.size == 0 ? 1 : static_cast<int>(local.size) * 8));
    }
  }
  a.finish(a.d.lnot(a.anyBit()));
}

template <class D>
void runFunction(SystemArgs<D>& a, int number) {
  DateFunctions<D> dates(a);
  StringFunctions<D> strings(a);
  Selection<D> selection(a);
  switch (number) {
    case 1: return dates.addTime(false);
    case 2: return strings.concatenate();
    case 3: return dates.fromDateAndTime();
    case 4: return strings.cut();
    case 6: return dates.date();
    case 7: return dates.weekday();
    case 8: return dates.timeOfDay();
    case 9: return dates.compare(true, false, false);
    case 10: return strings.compare(true, false, false);
    case 11: return strings.find();
    case 12: return dates.compare(true, false, true);
    case 13: return strings.compare(true, false, true);
    case 14: return dates.compare(false, false, true);
    case 15: return strings.compare(false, false, true);
    case 17: return strings.insert();
    case 18: return dates.compare(true, true, false);
    case 19: return strings.compare(true, true, false);
    case 20: return strings.left();
    case 21: return strings.length();
    case 22: return selection.limit();
    case 23: return dates.compare(false, true, false);
    case 24: return strings.compare(false, true, false);
    case 25: return selection.extreme(false);
    case 26: return strings.middle();
    case 27: return selection.extreme(true);
    case 28: return dates.compare(false, true, true);
    case 29: return strings.compare(false, true, true);
    case 31: return strings.replace();
    case 32: return strings.right();
    case 33: return dates.timeOfS5Time();
    case 34: return dates.difference();
    case 35: return dates.addTime(true);
    case 36: return selection.select();
    case 40: return dates.s5TimeOfTime();
    default: return anyOutputs(a);
  }
}

/// The block that the machine has just entered. `between`: an interrupt may come here.
template <class D>
void runSystemBlockOn(Machine<D>& m, const std::function<void()>& between) {
  SystemArgs<D> a(m);
  a.between = between;
  const int number = numberOfBlock(a.pou.number);
  if (a.pou.type == BlockType::Fc) return runFunction(a, number);
  if (a.pou.type != BlockType::Sfc) return anyOutputs(a);
  switch (number) {
    case 0: return DateFunctions<D>(a).setClock();
    case 1: return DateFunctions<D>(a).readClock();
    case 20: return BlockTransfer<D>(a).run(0, 1, 2, false);
    case 21: return BlockTransfer<D>(a).run(0, 1, 2, true);
    case 64: return DateFunctions<D>(a).systemTime();
    default: return anyOutputs(a);
  }
}

}  // namespace rungproof
