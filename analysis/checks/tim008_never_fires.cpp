// TIM008: timer or counter can never fire. Spoken by the prover (analysis/proof/builtin_checks, analysis/proof/prover);
// this file is its page. Tested by tests/prover/rule_questions_test.cpp, which runs the examples.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule tim008_never_fires = {
    .id = "TIM008",
    .title = "Timer or counter can never fire",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects = "a timer or counter whose bit can never become 1, or once 1 never returns to 0",
    .why = "a dead alarm or a dead step looks like a live one in the listing",
    .manual = "001:6569",
    .bad = "Network 1\nLD I0.0\nEU\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .falsePositives = "a timer that is only used through its current value",
};

}  // namespace rungproof
