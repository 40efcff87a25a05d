// The rules that only the prover can answer, for lint --prove: it asks the questions of the rules beside the declared
// properties and brings the findings of the flow analysis in line with the answers. A finding is confirmed by a run
// that the engine repeats or by a proof; a candidate that a proof refutes is dropped. Covered by
// tests/prover/rule_questions_test.cpp and tests/prover/corpus_rules_test.cpp.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/proof/prover.hpp"
#include "frontend/input/program_input.hpp"

namespace rungproof {

/// What the prover could not settle, and what was wrong with it.
struct OpenQuestions {
  std::vector<std::string> lines;  ///< "LOG001: 12 of 40 questions are open"
  std::size_t count = 0;
  std::vector<std::string> defects;      ///< internal disagreements
  std::vector<std::string> assumptions;  ///< what answers rest on: devices that have any value
  TechniqueUses techniques{};            ///< what each has done
};

/// Writes the run of an answer and gives the name of its file.
using RunWriter = std::function<std::string(const Program& program, const ProofResult& result)>;

/// `findings` holds those of the flow analysis; candidates among them of the same rule and place are confirmed or
/// dropped, and new findings of the rules that `isSelected` are added. ProverOptions::total limits all of it, and
/// ProverOptions::checks says whose questions are asked. `writeRun`: for the run of each confirmed finding, or empty.
OpenQuestions settleBySolver(const ProgramInput& input, const ProverOptions& options,
                             const std::function<bool(std::string_view)>& isSelected, std::vector<Finding>& findings,
                             const RunWriter& writeRun = {});

}  // namespace rungproof
