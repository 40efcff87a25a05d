// Definite assignment of local memory: which of the 64 bytes of a block have been written on every path to a place.
// Local memory is not initialised (001:1373); IN and IN_OUT parameters are written by the call (001:6815). A box with
// an enable counts as a write: whether it had power flow is another question. One pass in program order, joined at
// labels. Tested by tests/rules/control_rules_test.cpp.
#pragma once

#include <bitset>
#include <cstdint>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

inline constexpr std::uint32_t localBits = 64 * 8;
using LocalBits = std::bitset<localBits>;

/// A read of local memory of which some bit is not written on every path.
struct LocalRead {
  const Access* access;
};
/// An end of a block that an OUT parameter may reach unwritten.
struct LocalExit {
  const LocalVariable* parameter;
  const Instruction* exit;  ///< CRET or the like; nullptr: the end of the block
  bool isNeverWritten;      ///< no instruction of the block writes it
};

struct LocalFlow {
  std::vector<LocalRead> unwritten;
  std::vector<LocalExit> exits;
};

/// Bits that an access of local memory covers.
LocalBits localBitsOf(const Access& access);
LocalBits localBitsOf(const LocalVariable& local);
LocalFlow localFlow(const Facts& facts, std::uint32_t block);

}  // namespace rungproof
