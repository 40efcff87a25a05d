// What an encoding makes of the values that the analysis finds for a pointer: a list of places with the condition under
// which each is meant. Used by scans and by routines alone (routine_effects.hpp).
// Covered by tests/encoder/pointer_values_test.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "analysis/graph/graph.hpp"
#include "analysis/graph/value_set.hpp"
#include "ir/machine/machine.hpp"

namespace rungproof {

/// What the analysis knows of a node where a guard holds.
using ValuesWhere = std::function<ValueSet(Node node, Node guard)>;

/// The set, listed where that takes at most `limit` values: as it is, or after what the guard decides has been chosen.
ValueSet listedOrBounded(Graph& graph, Node pointer, Node guard, std::size_t limit, const ValuesWhere& valuesWhere);
/// That the pointer has one of these values.
Graph::Bool isAmong(Graph& graph, Node pointer, std::span<const std::uint64_t> values);
/// The places that values of a pointer of an S7-200 mean, for accesses of that width. Gives that it has none of the
/// values that mean no place; each place is handed to `tell`.
Graph::Bool leadTo(Graph& graph, const Machine<Graph>& machine, Graph::Bits pointer, Width width,
                   std::span<const std::uint64_t> values, Ref<Graph>& ref,
                   const std::function<void(std::uint32_t)>& tell);
/// The data block of an S7-300/400 in which all values of a place's number lie, by its first place.
std::optional<std::vector<std::uint64_t>> startOfBlock(const ValueSet& values);
/// All places of the block with that first place, for accesses of that width; nothing if they are more than `limit`.
/// `isInBlock`: that the place lies in it.
std::optional<std::vector<std::uint64_t>> placesInBlock(Graph& graph, const Plan& plan, Graph::Bits location,
                                                        std::uint64_t start, Width width, std::size_t limit,
                                                        Graph::Bool& isInBlock);

}  // namespace rungproof
