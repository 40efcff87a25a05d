// LOG002: contact without effect. A contact that changes nothing in any reachable state. Asked by
// analysis/proof/rung_checks.cpp; this file is its page. Tested by tests/prover/rule_questions_test.cpp, which runs the
// examples.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule log002_contact_without_effect = {
    .id = "LOG002",
    .title = "Contact without effect",
    .severity = Severity::Note,
    .needs = Needs::Solver,
    .detects =
        "a contact without which - bridged in a series, cut out of a parallel circuit - the network does the same in "
        "every reachable state; contacts of special memory and normally closed contacts of outputs, which are doubled "
        "on purpose, are excepted",
    .why = "leftovers of copying, or a contact at the wrong place: what it was to prevent is not prevented by it",
    .bad = "Network 1\nLD I0.0\nA I0.1\nA I0.0\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nA I0.1\nA I0.2\n= Q0.0\n",
    .falsePositives = "an interlock that other networks happen to guarantee, and that is kept in case they change",
    .peers = "Rockwell \"shorted branch\"",
    .questions = Questions::Rungs,
};

}  // namespace rungproof
