// One lint run: reading, rules, suppression, baseline. The commands lint, baseline and lsp share it.
#pragma once

#include <string>
#include <vector>

#include "frontend/command.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/linting/solver_rules.hpp"

namespace rungproof {

/// Whether --select and --ignore let the code be reported.
bool isSelected(const Settings& settings, std::string_view id);

/// Findings of the readers and of all selected rules, allow-comments applied unless --no-suppress. `prove`: candidates
/// are confirmed or dropped by the prover, and its own findings added; `writeRun` gets the runs that confirm.
Report lintProgram(const Settings& settings, const ProgramInput& given, const std::vector<std::string>& files,
                   bool prove = false, const RunWriter& writeRun = {});

/// The same for the files of a command line, which may hold several programs. `traces`: folder for the runs that
/// confirm findings, or empty.
Report lintFiles(const Context& context, const std::vector<std::string>& files, bool prove = false,
                 const std::string& traces = {});

/// Drops what the baseline of the settings lists, if they name one, or says why it cannot be read.
std::optional<Failure> subtractBaseline(const Settings& settings, Report& report);

}  // namespace rungproof
