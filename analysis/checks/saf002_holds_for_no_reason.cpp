// SAF002: property holds for no good reason. Spoken by the prover (analysis/builtin_checks, analysis/prover); this file is its page.
// Tested by tests/prover and tests/corpus.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule saf002_holds_for_no_reason = {
    .id = "SAF002",
    .title = "Property holds for no good reason",
    .severity = Severity::Error,
    .needs = Needs::Solver,
    .detects = "a property whose premise can never be met, or assumptions that contradict each other",
    .why = "a vacuous pass is worse than a fail: it is believed",
    .manual = "",
    .falsePositives = "",
    .peers = "",
};

}  // namespace rungproof
