// All instruction meanings compiled for the blurred domain of the bench.
#include "blurred.hpp"
#include "ir/machine/dispatch.hpp"
#include "ir/s7200/isa/list.hpp"

namespace rungproof {

template <>
std::span<const Execute<manual::Blurred>> dispatchTable<manual::Blurred>() {
  static constexpr auto table = isa::makeDispatch<manual::Blurred>(isa::AllInstructions{});
  return table;
}

/// Programs of the S7-300/400 do not run on it.
template <>
std::span<const Execute<manual::Blurred>> step7DispatchTable<manual::Blurred>() {
  return {};
}
template <>
std::span<const Execute<manual::Blurred>> iecDispatchTable<manual::Blurred>() {
  return {};
}
template <>
void runSystemBlock<manual::Blurred>(Machine<manual::Blurred>&, const std::function<void()>&) {}
template <>
void actOnCpu<manual::Blurred>(Machine<manual::Blurred>&, const Instruction&) {}

}  // namespace rungproof
