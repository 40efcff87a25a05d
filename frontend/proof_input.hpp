// What prove and lint --prove share: prover options from settings, and built-in results as findings.
// Covered by tests/prover/rule_questions_test.cpp and tests/cli/exit_test.cpp.
#pragma once

#include <optional>

#include "analysis/proof/prover.hpp"
#include "frontend/command/command.hpp"
#include "frontend/program_input.hpp"

namespace rungproof {

ProverOptions proverOptionsOf(const Settings& settings);

/// A built-in check with the unwanted answer as a confirmed finding, else nothing.
std::optional<Finding> findingOf(const ProofResult& result);

}  // namespace rungproof
