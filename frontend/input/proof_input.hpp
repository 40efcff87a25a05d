// What prove and lint --prove share: prover options from settings. Covered by tests/cli/exit_test.cpp.
#pragma once

#include "analysis/proof/prover.hpp"
#include "frontend/command.hpp"
#include "frontend/input/program_input.hpp"

namespace rungproof {

ProverOptions proverOptionsOf(const Settings& settings);
/// With the limits of lint --prove for all questions together: --budget, and 2 GB unless --memory is given.
ProverOptions lintProverOptionsOf(const Settings& settings);

}  // namespace rungproof
