// The one place where all instruction meanings are compiled for recorded code.
#include "engine/compiled/recorder.hpp"
#include "ir/families/instructions.hpp"
#include "ir/machine/dispatch.hpp"

namespace rungproof {

template <>
std::span<const Execute<compiled::Recorder>> dispatchTable<compiled::Recorder>() {
  static constexpr auto table = isa::makeDispatch<compiled::Recorder>(isa::AllInstructions{});
  return table;
}

template <>
std::span<const Execute<compiled::Recorder>> step7DispatchTable<compiled::Recorder>() {
  static constexpr auto table = isa::step7::makeDispatch<compiled::Recorder>(isa::step7::AllInstructions{});
  return table;
}

template <>
std::span<const Execute<compiled::Recorder>> iecDispatchTable<compiled::Recorder>() {
  static constexpr auto table = isa::iec::makeDispatch<compiled::Recorder>(isa::iec::AllInstructions{});
  return table;
}

/// Blocks that would take too many steps, or that others may interrupt, are left to the reference engine.
template <>
void runSystemBlock<compiled::Recorder>(Machine<compiled::Recorder>& m, const std::function<void()>& between) {
  constexpr std::size_t mostSteps = 20'000;
  compiled::Recorder& d = m.d;
  if (between) return d.leave(m.guard);
  const std::size_t first = d.code.steps.size(), sites = d.code.sites.size();
  const auto registers = m.step7;
  runSystemBlockOn(m, between);
  if (d.code.steps.size() - first <= mostSteps) return;
  d.takeBack(first, sites);
  m.step7 = registers;
  d.leave(m.guard);
}
template <>
void actOnCpu<compiled::Recorder>(Machine<compiled::Recorder>& m, const Instruction& call) {
  actOnCpuOf(m, call);
}

}  // namespace rungproof
