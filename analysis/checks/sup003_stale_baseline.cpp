// SUP003: an entry of the baseline file that no finding matches any more. Spoken by frontend/linting/baseline.cpp;
// tested by tests/cli/baseline_test.cpp.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule sup003_stale_baseline = {
    .id = "SUP003",
    .title = "Baseline entry is stale",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects =
        "an entry of the baseline file that matches no finding of this run, where all of the program could be read",
    .why = "a baseline only ever shrinks; an entry that is left over would hide a new finding of the same kind",
    .peers = "eslint --prune-suppressions",
};

}  // namespace rungproof
