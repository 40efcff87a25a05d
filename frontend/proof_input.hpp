// What prove and lint --prove share: prover options from settings, and built-in results as findings.
#pragma once

#include <optional>

#include "analysis/prover.hpp"
#include "frontend/command/command.hpp"
#include "frontend/program_input.hpp"

namespace rungproof {

ProverOptions proverOptionsOf(const Settings& settings);

/// A built-in check with the unwanted answer as a confirmed finding, else nothing.
std::optional<Finding> findingOf(const ProofResult& result);

/// Runs the built-in checks and declared properties and brings the report in line with them: candidates of the same
/// rule and place are confirmed or, where a proof says so, dropped; new findings are added.
void confirmBySolver(const Settings& settings, const ProgramInput& input, Report& report);

}  // namespace rungproof
