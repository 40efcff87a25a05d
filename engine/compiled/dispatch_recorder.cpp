// The one place where all instruction meanings are compiled for recorded code.
#include "engine/compiled/recorder.hpp"
#include "ir/s7200/dispatch.hpp"
#include "ir/s7200/isa_list.hpp"

namespace rungproof {

template <>
std::span<const Execute<compiled::Recorder>> dispatchTable<compiled::Recorder>() {
  static constexpr auto table = isa::makeDispatch<compiled::Recorder>(isa::AllInstructions{});
  return table;
}

/// Programs for the S7-300/400 are not compiled.
template <>
std::span<const Execute<compiled::Recorder>> step7DispatchTable<compiled::Recorder>() {
  return {};
}
template <>
void runSystemBlock<compiled::Recorder>(Machine<compiled::Recorder>&, const std::function<void()>&) {}

}  // namespace rungproof
