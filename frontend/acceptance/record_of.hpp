// Fills the record of a page from a program, its settings and its proofs.
#pragma once

#include "analysis/proof/prover.hpp"
#include "engine/trace.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/report.hpp"

namespace rungproof {

/// The program's record without drawings and names: what its verdicts depend on. `propertyFiles`: as given.
ProgramRecord basisRecord(const Settings& settings, const ProgramInput& input, const std::vector<std::string>& files,
                          const std::vector<std::string>& propertyFiles);

/// Adds the record of the program to the report, and what lint finds in it. `propertyFiles`: as given.
void addRecord(Report& report, const Settings& settings, const ProgramInput& input,
               const std::vector<std::string>& files, const std::vector<std::string>& propertyFiles);

/// `shown`: the witness with the signals that matter, for the eye.
void addEvidence(PropertyResult& row, const Program& program, const Choices& choices, const ProofResult& result,
                 const Trace* shown);

/// The comment that states what a statement is for: the lines `# ...` (in a program `// ...`) right above it, or above
/// the group of statements that it stands in, and one behind it on its own line. Empty if there is none.
std::string requirementAbove(const SourceFile& file, std::uint32_t line);

}  // namespace rungproof
