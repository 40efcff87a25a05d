// LOG006: latch cannot drop out. A bit that holds itself, or is set and reset, and never goes off. Asked by
// analysis/proof/rung_checks.cpp; this file is its page. Tested by tests/prover/rule_questions_test.cpp, which runs the
// examples.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule log006_latch_cannot_drop_out = {
    .id = "LOG006",
    .title = "Latch cannot drop out",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "a coil that holds itself, or a bit with S and R, that no reachable state switches off again; one that none "
        "switches on is LOG001",
    .why = "the motor cannot be stopped from the program",
    .bad = "Network 1\nLD I0.0\nO Q0.0\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n",
    .falsePositives = "a fault memory that is meant to last until the next start",
    .questions = Questions::Rungs,
};

}  // namespace rungproof
