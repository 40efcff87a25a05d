// The one place where all instruction meanings are compiled for graph nodes.
#include "analysis/encoding/symbolic_store.hpp"
#include "ir/dispatch.hpp"
#include "ir/isa_list.hpp"

namespace rungproof {

template <>
std::span<const Execute<Graph>> dispatchTable<Graph>() {
  static constexpr auto table = isa::makeDispatch<Graph>(isa::AllInstructions{});
  return table;
}

}  // namespace rungproof
