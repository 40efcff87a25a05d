// Test support: proves with the solver that instructions do what a drawing says. The drawing is executed naively,
// element by element, on the meanings of the instruction table; both sides start in the same unknown state, get the
// same external values, and everything they leave behind is compared: memory, timers, counters, edges, stops, and the
// power flow at each control instruction.
#pragma once

#include <string>
#include <vector>

#include "ir/drawing.hpp"
#include "ir/program.hpp"

namespace rungproof::testing {

/// "" if equal for every state; otherwise what differs, or why nothing can be said.
std::string difference(const Drawing& drawing, const std::vector<Instruction>& instructions,
                       const std::vector<std::uint32_t>& instructionOf, const Target& target = {});
/// The same for two lists of instructions. Edges are matched by their order.
std::string difference(const std::vector<Instruction>& a, const std::vector<Instruction>& b, const Target& target = {});

}  // namespace rungproof::testing
