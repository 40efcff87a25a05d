// SAF006: restarts by itself. An output that returns when a declared stop is released. Asked by
// analysis/proof/safety_checks.cpp; this file is its page. Tested by tests/prover/rule_questions_test.cpp, which runs
// the examples.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule saf006_restarts_by_itself = {
    .id = "SAF006",
    .title = "Restarts by itself",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "an output that a declared stop (`not INPUT implies not OUTPUT`) holds off, and that comes on in the scan in "
        "which the stop is released and no other input changes, though with the same inputs it would stay off if the "
        "program remembered nothing",
    .why = "an unexpected restart: after a stop or a fault the machine must wait for a new start command",
    .bad =
        "//@ prove stop: not I0.1 implies not Q0.0\nNetwork 1\nLD I0.0\nS M0.0, 1\nNetwork 2\nLD I0.2\n"
        "R M0.0, 1\nNetwork 3\nLD M0.0\nA I0.1\n= Q0.0\n",
    .good =
        "//@ prove stop: not I0.1 implies not Q0.0\nNetwork 1\nLD I0.0\nS M0.0, 1\nNetwork 2\nLD I0.2\n"
        "ON I0.1\nR M0.0, 1\nNetwork 3\nLD M0.0\nA I0.1\n= Q0.0\n",
    .falsePositives = "a pause after which the machine is meant to go on",
    .questions = Questions::Rungs,
};

}  // namespace rungproof
