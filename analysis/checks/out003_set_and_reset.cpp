// OUT003: set and reset true together. Spoken by the prover (analysis/proof/builtin_checks, analysis/proof/prover);
// this file is its page. Tested by tests/prover/rule_questions_test.cpp, which runs the examples.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule out003_set_and_reset = {
    .id = "OUT003",
    .title = "Set and reset true together",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "S and R, S or R against =, or both inputs of SR or RS, that act on one bit in one scan with opposite values",
    .why = "the order of the networks decides which one wins, and for SR and RS the type of the box does",
    .manual = "001:2821, 001:2897",
    .bad = "Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD I0.1\nR Q0.0, 1\n",
    .good = "Network 1\nLD I0.0\nAN I0.1\nS Q0.0, 1\nNetwork 2\nLD I0.1\nR Q0.0, 1\n",
    .falsePositives = "a stop that is written last on purpose",
};

}  // namespace rungproof
