// SAF005: energised in the first scan. An output that old memory switches on at power-up. Asked by
// analysis/proof/safety_checks.cpp; this file is its page. Tested by tests/prover/rule_questions_test.cpp, which runs
// the examples.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule saf005_energised_in_first_scan = {
    .id = "SAF005",
    .title = "Energised in the first scan",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "an output that is on at the end of the first scan for some content of retentive memory and some inputs, and "
        "off with the same inputs when memory is empty",
    .why =
        "retentive V, M, T and C values survive the loss of power, and the machine starts by itself when power returns",
    .manual = "001:1619",
    .bad = "Network 1\nLD I0.0\nS V0.0, 1\nNetwork 2\nLDN I0.1\nR V0.0, 1\nNetwork 3\nLD V0.0\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nS V0.0, 1\nNetwork 2\nLDN I0.1\nO SM0.1\nR V0.0, 1\nNetwork 3\nLD V0.0\n= Q0.0\n",
    .falsePositives = "lamps and other outputs that are meant to show what was",
    .questions = Questions::PowerUp,
};

}  // namespace rungproof
