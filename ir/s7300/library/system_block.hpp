// What blocks of the CPU and of the libraries do whose meaning is no list of statements. A block of
// which nothing but the contract is known gives every output any value. Each domain compiles this in one source file
// (ir/machine/dispatch.hpp). Tested by tests/prover/pointer_parameter_test.cpp and the tests of the files below.
#pragma once

#include "ir/s7300/block.hpp"
#include "ir/s7300/library/cpu_call.hpp"
#include "ir/s7300/library/list.hpp"
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

template <class D, class Block>
constexpr void (*meaningOf())(SystemArgs<D>&) {
  if constexpr (requires(SystemArgs<D> & a) { Block::run(a); }) {
    return [](SystemArgs<D>& a) { Block::run(a); };
  } else {
    return &anyOutputs<D>;
  }
}

template <class D, class... Blocks>
void runBlockAmong(isa::Group<Blocks...>, SystemArgs<D>& a, int number) {
  const auto isIt = [&](const s7300::LibraryBlock& block) {
    return block.isBuiltIn && block.type == a.pou.type && block.number == number;
  };
  const bool isKnown = ((isIt(Blocks::block) && (meaningOf<D, Blocks>()(a), true)) || ...);
  if (!isKnown) anyOutputs(a);
}

template <class Block, class D>
void actAs(CpuCall<D>& call, BlockType type, int number) {
  if constexpr (requires { Block::act(call); }) {
    if (Block::block.type == type && Block::block.number == number) Block::act(call);
  }
}

template <class D, class... Blocks>
void actAmong(isa::Group<Blocks...>, CpuCall<D>& call, BlockType type, int number) {
  (actAs<Blocks>(call, type, number), ...);
}

/// What the call does to the CPU itself, before the block is entered; nothing, if the block is not one of those.
template <class D>
void actOnCpuOf(Machine<D>& m, const Instruction& instruction) {
  CpuCall<D> call(m, instruction);
  const auto block = static_cast<int>(instruction.operands[0].value);
  actAmong(s7300::library::AllBlocks{}, call, blockTypeOf(block), numberOfBlock(block));
}

/// The block that the machine has just entered. `between`: an interrupt may come here.
template <class D>
void runSystemBlockOn(Machine<D>& m, const std::function<void()>& between) {
  SystemArgs<D> a(m);
  a.between = between;
  runBlockAmong(s7300::library::AllBlocks{}, a, numberOfBlock(a.pou.number));
}

}  // namespace rungproof
