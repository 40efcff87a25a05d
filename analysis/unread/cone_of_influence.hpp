// Cone of influence: the networks that can have any effect on some places, so that the encoding of a question holds
// only what it needs. A network stays in if it writes a place of the cone, moves the flow of the program, acts on a
// device, or can end the program; what it reads belongs to the cone then. Syntactic, and therefore generous.
// Tested by tests/prover/cone_test.cpp.
#pragma once

#include <vector>

#include "analysis/unread/influence.hpp"

namespace rungproof {

/// By Instruction::id: whether it lies in a network that has no effect on any of the places in any run. Empty if the
/// whole program may have one.
std::vector<bool> outsideCone(const Facts& facts, std::span<const PlaceRow> places);

}  // namespace rungproof
