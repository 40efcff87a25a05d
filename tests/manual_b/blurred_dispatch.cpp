// All instruction meanings compiled for the blurred domain, for this program of tests.
#include "ir/dispatch.hpp"
#include "ir/isa_list.hpp"
#include "tests/manual_a/blurred.hpp"

namespace rungproof {

template <>
std::span<const Execute<manual::Blurred>> dispatchTable<manual::Blurred>() {
  static constexpr auto table = isa::makeDispatch<manual::Blurred>(isa::AllInstructions{});
  return table;
}

}  // namespace rungproof
