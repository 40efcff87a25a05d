// What prove and lint --prove share: prover options from settings. Covered by tests/cli/exit_test.cpp.
#pragma once

#include <initializer_list>

#include "analysis/proof/prover.hpp"
#include "frontend/command.hpp"
#include "frontend/input/program_input.hpp"

namespace rungproof {

/// For a proof over these programs: a scan is as long as one of them allows at most, unless --scan-time says it.
ProverOptions proverOptionsOf(const Settings& settings, std::initializer_list<const Program*> programs);
/// With the limits of lint --prove for all questions together: --budget, and 2 GB unless --memory is given.
ProverOptions lintProverOptionsOf(const Settings& settings, const Program& program);

}  // namespace rungproof
