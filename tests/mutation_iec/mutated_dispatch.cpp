// All meanings of IEC 61131-3 compiled for the mutated domain, and an instruction left out as a whole.
#include <cstdlib>

#include "ir/families/instructions.hpp"
#include "ir/iec/expression_role.hpp"
#include "ir/machine/dispatch.hpp"
#include "tests/mutation/every_entry.hpp"

namespace rungproof {

namespace {

using mutation::Mutated;

/// Left out, it takes its values off the stack and leaves zeros.
void executeChanged(Machine<Mutated>& m, const Instruction& instruction) {
  static constexpr auto table = isa::iec::makeDispatch<Mutated>(isa::iec::AllInstructions{});
  if (mutation::Mutation::instance().changeOfWhole(mutation::Op::Whole, *instruction.desc) == 0)
    return table[instruction.desc->opcode](m, instruction);
  const StackUse use = stackUse(instruction);
  m.evaluation.resize(m.evaluation.size() - use.pops + use.pushes);
}

}  // namespace

/// Programs of other families are not mutated here.
template <>
std::span<const Execute<Mutated>> dispatchTable<Mutated>() {
  return {};
}
template <>
std::span<const Execute<Mutated>> step7DispatchTable<Mutated>() {
  return {};
}
template <>
std::span<const Execute<Mutated>> iecDispatchTable<Mutated>() {
  static constexpr auto table =
      mutation::everyEntry<&executeChanged>(std::make_index_sequence<isa::iec::instructionTable.size()>{});
  return table;
}
template <>
void runSystemBlock<Mutated>(Machine<Mutated>&, const std::function<void()>&) {
  std::abort();
}
template <>
void actOnCpu<Mutated>(Machine<Mutated>&, const Instruction&) {
  std::abort();
}

}  // namespace rungproof
