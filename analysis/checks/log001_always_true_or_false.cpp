// LOG001: always true or always false. A rung with one power flow in every reachable state. Asked by
// analysis/proof/rung_checks.cpp; this file is its page. Tested by tests/prover/rule_questions_test.cpp, which runs the
// examples.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule log001_always_true_or_false = {
    .id = "LOG001",
    .title = "Always true or always false",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "an output, box or jump whose rung has power in every reachable state, or in none; rungs of special memory "
        "alone (SM0.0) are excepted",
    .why =
        "a dead rung, or an interlock that is none; bytes compare unsigned and words signed, which makes some "
        "comparisons constant",
    .manual = "001:3384",
    .bad = "Network 1\nLD I0.0\nLPS\nA I0.1\n= M0.0\nLPP\nAN I0.1\n= M0.1\nNetwork 2\nLD M0.0\nA M0.1\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nLPS\nA I0.1\n= M0.0\nLPP\nAN I0.1\n= M0.1\nNetwork 2\nLD M0.0\nO M0.1\n= Q0.0\n",
    .falsePositives = "a rung that waits for memory which a panel or the network writes: declare it with //@ external",
    .peers = "SA0059; SA0062; Frama-PLC E4.1",
    .questions = Questions::Rungs,
};

}  // namespace rungproof
