// SAF001: declared property violated. Spoken by the prover (analysis/builtin_checks, analysis/prover); this file is its page.
// Tested by tests/prover and tests/corpus.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule saf001_property_violated = {
    .id = "SAF001",
    .title = "Declared property violated",
    .severity = Severity::Error,
    .needs = Needs::Solver,
    .detects = "a declared property that some run of the program breaks; the run has been repeated by the reference engine",
    .why = "the interlock that was meant is not the one that was written",
    .manual = "",
    .falsePositives = "",
    .peers = "PLCverif all patterns; ESBMC SAFE-LD",
};

}  // namespace rungproof
