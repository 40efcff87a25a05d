// The part of a BitSystem that one question depends on, with known equalities of latches substituted.
// Tested by tests/solver/bit_cone_test.cpp.
#pragma once

#include <vector>

#include "analysis/bits/engine_contract.hpp"

namespace rungproof {

struct BitCone {
  BitSystem system;                    ///< bad literals in the order asked for
  std::vector<bool> isTotal;           ///< by constraint of the cone
  std::vector<std::uint32_t> latches;  ///< by latch of the cone: latch index in the whole system
  std::vector<std::uint32_t> inputs;   ///< by input of the cone: input index in the whole system
  std::vector<Lit> toCone;             ///< by variable of the whole system: literal in the cone, or outside
  static constexpr Lit outside = 0xFFFFFFFF;

  Lit translated(Lit l) const { return toCone[variableOf(l)] == outside ? outside : toCone[variableOf(l)] ^ (l & 1U); }
  /// Clauses of the whole system that speak about the cone only and are not trivially true there.
  std::vector<std::vector<Lit>> translated(const std::vector<std::vector<Lit>>& clauses) const;
};

/// By variable of the system: the literal that equals it in all reachable states (itself if nothing is
/// known; only latches are substituted). Empty: none.
using EqualLiterals = std::vector<Lit>;

/// `isTotal`, by constraint: left out unless it shares variables with the rest of the cone. Gates under `wanted` are
/// kept where the variables they depend on belong to the cone.
BitCone makeCone(const BitSystem& system, const std::vector<Lit>& bads, const std::vector<bool>& isTotal,
                 const EqualLiterals& equal = {}, const std::vector<Lit>& wanted = {});

/// A run of the cone as a run of the whole system. What the cone lacks is simulated; inputs outside are chosen such
/// that total constraints hold. Empty if the constraints outside cannot be met, which isTotal promises never happens.
std::optional<BitTrace> completeTrace(const BitSystem& system, const BitCone& cone, const BitTrace& trace);

/// By variable: do the constraints depend on it within one scan?
std::vector<bool> constrainedVariables(const BitSystem& system);

}  // namespace rungproof
