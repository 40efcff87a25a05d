// All meanings of the S7-300/400 compiled for the mutated domain, and the changes to an instruction as a whole.
#include <cstdlib>

#include "ir/families/instructions.hpp"
#include "ir/machine/dispatch.hpp"
#include "tests/mutation/every_entry.hpp"

namespace rungproof {

namespace {

using mutation::Mutated;

void executeChanged(Machine<Mutated>& m, const Instruction& instruction) {
  static constexpr auto table = isa::step7::makeDispatch<Mutated>(isa::step7::AllInstructions{});
  const int change = mutation::Mutation::instance().changeOfWhole(mutation::Op::Whole, *instruction.desc);
  if (change != 1) table[instruction.desc->opcode](m, instruction);
  if (change == 2) m.step7.rlo = !m.step7.rlo;
}

}  // namespace

/// Programs of the S7-200 are not mutated here.
template <>
std::span<const Execute<Mutated>> dispatchTable<Mutated>() {
  return {};
}

template <>
std::span<const Execute<Mutated>> step7DispatchTable<Mutated>() {
  static constexpr auto table =
      mutation::everyEntry<&executeChanged>(std::make_index_sequence<isa::step7::instructionTable.size()>{});
  return table;
}
template <>
std::span<const Execute<Mutated>> iecDispatchTable<Mutated>() {
  return {};
}

/// The stated cases call no block of the system: its bodies have tests of their own (tests/step7).
template <>
void runSystemBlock<Mutated>(Machine<Mutated>&, const std::function<void()>&) {
  std::abort();
}
template <>
void actOnCpu<Mutated>(Machine<Mutated>&, const Instruction&) {
  std::abort();
}

}  // namespace rungproof
