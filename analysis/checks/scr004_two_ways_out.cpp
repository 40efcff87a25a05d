// SCR004: two ways out at once. Transitions of one step that do not exclude each other. Asked by
// analysis/proof/sequence_checks.cpp; this file is its page. Tested by tests/prover/rule_questions_test.cpp, which runs
// the examples.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule scr004_two_ways_out = {
    .id = "SCR004",
    .title = "Two ways out at once",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "two transitions of one step, behind rungs of their own, that can be taken in the same scan; in a chain "
        "without a divergence, two steps that are active at the end of a scan",
    .why = "the steps behind both are then active together: two branches run where one was meant",
    .manual = "001:5834, 001:5850-5872",
    .bad =
        "Network 1\nLD SM0.1\nS S0.1, 1\nNetwork 2\nLSCR S0.1\nNetwork 3\nLD I0.0\nSCRT S0.2\nNetwork 4\n"
        "LD I0.1\nSCRT S0.3\nNetwork 5\nSCRE\nNetwork 6\nLSCR S0.2\nNetwork 7\nLD I0.2\nSCRT S0.1\n"
        "Network 8\nSCRE\nNetwork 9\nLSCR S0.3\nNetwork 10\nLD I0.2\nSCRT S0.1\nNetwork 11\nSCRE\n",
    .good =
        "Network 1\nLD SM0.1\nS S0.1, 1\nNetwork 2\nLSCR S0.1\nNetwork 3\nLD I0.0\nSCRT S0.2\nNetwork 4\n"
        "LDN I0.0\nA I0.1\nSCRT S0.3\nNetwork 5\nSCRE\nNetwork 6\nLSCR S0.2\nNetwork 7\nLD I0.2\nSCRT S0.1\n"
        "Network 8\nSCRE\nNetwork 9\nLSCR S0.3\nNetwork 10\nLD I0.2\nSCRT S0.1\nNetwork 11\nSCRE\n",
    .falsePositives = "a divergence that is meant to be parallel: drive both SCRT from one rung",
    .peers = "L7 (nearest)",
    .questions = Questions::Rungs,
};

}  // namespace rungproof
