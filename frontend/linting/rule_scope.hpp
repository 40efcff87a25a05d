// Whether the rules that a run selects can look at its programs at all: a run in which no rule looked, or not one of
// those that --select names, is no clean run. Tested by tests/cli/rule_scope_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "frontend/files/failure.hpp"
#include "frontend/settings/options.hpp"
#include "ir/target.hpp"

namespace rungproof {

/// A program of the run, and the settings that count for it.
struct LintedProgram {
  const Settings* settings = nullptr;
  Target target{};
};

/// What was not checked: each code of --select of which no rule looks at any of the programs, or that no rule is left.
/// `place` names the code, empty for all. `prove`: the prover is asked too.
std::vector<Failure> idleRules(std::span<const LintedProgram> programs, bool prove);

}  // namespace rungproof
