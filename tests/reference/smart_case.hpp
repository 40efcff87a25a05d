// One instruction with random operands on a CPU ST60, engine and naive interpreter side by side from the same random
// memory: operands are single values, direct, from the borders of their types.
#pragma once

#include <cstdint>
#include <string>

namespace rungproof::reference {

/// Fails the running test where the two differ. The mnemonic takes single values only (bwdrBWDR of naive.hpp).
void compareOnSmart(const std::string& mnemonic, std::uint64_t seed);

/// RUNGPROOF_SEED, or 1; RUNGPROOF_CASES, or `usual`.
std::uint64_t smartSeed();
std::uint64_t smartCases(std::uint64_t usual);

}  // namespace rungproof::reference
