// All instruction meanings compiled for the mutated domain, and the changes to an instruction as a whole.
#include "ir/machine/dispatch.hpp"
#include "ir/s7200/isa/list.hpp"
#include "tests/mutation/every_entry.hpp"

namespace rungproof {

namespace {

using mutation::Mutated;

void executeChanged(Machine<Mutated>& m, const Instruction& instruction) {
  static constexpr auto table = isa::makeDispatch<Mutated>(isa::AllInstructions{});
  const int change = mutation::Mutation::instance().changeOfWhole(mutation::Op::Whole, *instruction.desc);
  if (change != 1) table[instruction.desc->opcode](m, instruction);
  if (change > 1) m.stack[static_cast<std::size_t>(change - 2)] = !m.stack[static_cast<std::size_t>(change - 2)];
}

}  // namespace

template <>
std::span<const Execute<Mutated>> dispatchTable<Mutated>() {
  static constexpr auto table =
      mutation::everyEntry<&executeChanged>(std::make_index_sequence<isa::instructionTable.size()>{});
  return table;
}

/// Programs of the S7-300/400 are not mutated here.
template <>
std::span<const Execute<Mutated>> step7DispatchTable<Mutated>() {
  return {};
}
template <>
std::span<const Execute<Mutated>> iecDispatchTable<Mutated>() {
  return {};
}
template <>
void runSystemBlock<Mutated>(Machine<Mutated>&, const std::function<void()>&) {}
template <>
void actOnCpu<Mutated>(Machine<Mutated>&, const Instruction&) {}

}  // namespace rungproof
