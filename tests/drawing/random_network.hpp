// Test support: random networks as Micro/WIN writes them, from a grammar of rungs that knows nothing of lowering, and
// random drawings that need not be series and parallel circuits at all.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "ir/drawing.hpp"
#include "ir/program.hpp"

namespace rungproof::testing {

/// Seed from RUNGPROOF_SEED, or a fixed one.
std::uint64_t drawingSeed();

/// Statements of one rung, separated by "; ". Fbd allows edges and coils inside groups.
std::string randomRung(std::mt19937_64& random, Form form);

/// Elements with inputs from any earlier ones, operands that meet each other, up to `size` elements.
Drawing randomDrawing(std::mt19937_64& random, std::size_t size);

}  // namespace rungproof::testing
