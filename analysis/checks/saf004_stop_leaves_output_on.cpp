// SAF004: emergency stop leaves an output on. Declared in a property, broken by a run. Tested by
// tests/prover/rule_questions_test.cpp, which runs the examples.
#include "analysis/asking/safety_shape.hpp"
#include "analysis/proof/rule_answers.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

std::optional<std::string> tellSaf004(const ProofResult& result) {
  if (result.outcome != Outcome::Violated || !stopShapeOf(result.property)) return std::nullopt;
  return violationText(result) + "; besides, a stop must work without the controller (001:2016-2021)";
}

}  // namespace

extern constexpr Rule saf004_stop_leaves_output_on = {
    .id = "SAF004",
    .title = "Emergency stop leaves an output on",
    .severity = Severity::Error,
    .needs = Needs::Solver,
    .detects =
        "a declared property `not INPUT implies not OUTPUT` (INPUT for a stop that closes; several inputs with or, "
        "several outputs) that some run breaks",
    .why =
        "with the stop active the output can be on at the end of that scan; besides, the manual demands a stop that "
        "works without the controller",
    .manual = "001:1087, 001:2016-2021",
    .bad = "//@ prove stop: not I0.1 implies not Q0.0\nNetwork 1\nLD I0.0\nO Q0.0\n= Q0.0\n",
    .good = "//@ prove stop: not I0.1 implies not Q0.0\nNetwork 1\nLD I0.0\nO Q0.0\nA I0.1\n= Q0.0\n",
    .peers = "PLCverif implication",
    .tell = {.property = tellSaf004},
};

}  // namespace rungproof
