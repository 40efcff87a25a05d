// The one place where all instruction meanings are compiled for graph nodes.
#include "analysis/encoding/symbolic_store.hpp"
#include "ir/families/instructions.hpp"
#include "ir/machine/dispatch.hpp"

namespace rungproof {

template <>
std::span<const Execute<Graph>> dispatchTable<Graph>() {
  static constexpr auto table = isa::makeDispatch<Graph>(isa::AllInstructions{});
  return table;
}

template <>
std::span<const Execute<Graph>> step7DispatchTable<Graph>() {
  static constexpr auto table = isa::step7::makeDispatch<Graph>(isa::step7::AllInstructions{});
  return table;
}

template <>
std::span<const Execute<Graph>> iecDispatchTable<Graph>() {
  static constexpr auto table = isa::iec::makeDispatch<Graph>(isa::iec::AllInstructions{});
  return table;
}

template <>
void runSystemBlock<Graph>(Machine<Graph>& machine, const std::function<void()>& between) {
  runSystemBlockOn(machine, between);
}
template <>
void actOnCpu<Graph>(Machine<Graph>& machine, const Instruction& call) {
  actOnCpuOf(machine, call);
}

}  // namespace rungproof
