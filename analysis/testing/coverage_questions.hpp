// Goals of coverage as questions to the prover: whether some run covers them. An answer is a run of the engine, or a
// proof that there is none. Covered by tests/tables/generate_command_test.cpp.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/proof/prover.hpp"
#include "engine/coverage/coverage_goals.hpp"

namespace rungproof {

struct GoalAnswer {
  Outcome outcome = Outcome::Unknown;
  std::string method{};
  std::string certificate{};
  std::string restriction{};  ///< of a proof: "as long as one input changes a scan"
  std::optional<Witness> witness{};
};

/// An assumption: in each scan at most one of the bits changes, from all 0 before the first.
Property oneChangeAScan(const Operands& bits);

/// Asks the prover; goals that it cannot be asked are left out of the answers. `options`: limits, choices, times.
std::map<CoverageGoal, GoalAnswer> askGoals(const CoverageMap& map, const PropertySet& set,
                                            const std::vector<CoverageGoal>& goals, ProverOptions options);

}  // namespace rungproof
