// What prove and lint --prove share: prover options from settings, and built-in results as findings.
// Covered by tests/prover/rule_questions_test.cpp and tests/cli/exit_test.cpp.
#pragma once

#include <vector>

#include "analysis/proof/prover.hpp"
#include "frontend/command/command.hpp"
#include "frontend/program_input.hpp"

namespace rungproof {

ProverOptions proverOptionsOf(const Settings& settings);
/// With the limits of lint --prove for all questions together: --budget, and 2 GB unless --memory is given.
ProverOptions lintProverOptionsOf(const Settings& settings);

/// Built-in checks with the unwanted answer as confirmed findings, in their order. Answers on bits of one range are one
/// finding that names the whole range; one answer for several networks is a finding in each.
std::vector<Finding> findingsOf(const std::vector<const ProofResult*>& results);
/// Whether a built-in check has the unwanted answer.
bool isRefuted(const ProofResult& result);

}  // namespace rungproof
