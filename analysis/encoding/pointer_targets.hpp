// Places behind a pointer of which all values are known. Covered by tests/encoder and tests/environment.
#pragma once

#include <functional>
#include <vector>

#include "analysis/graph/graph.hpp"
#include "ir/s7200/machine.hpp"

namespace rungproof {

/// The values decide between a few places, which become the targets of `ref`; a legal one is always among them. Gives
/// whether the pointer is legal. `tell`: is told of each place.
Graph::Bool placesBehind(Graph& graph, const Target& target, Graph::Bits pointer, Width width,
                         const std::vector<std::uint64_t>& values, Ref<Graph>& ref,
                         const std::function<void(std::uint32_t)>& tell = {});

}  // namespace rungproof
