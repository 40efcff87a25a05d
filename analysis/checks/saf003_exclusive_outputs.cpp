// SAF003: exclusive outputs on together. Declared in a property, broken by a run. Tested by
// tests/prover/rule_questions_test.cpp, which runs the examples.
#include "analysis/asking/safety_shape.hpp"
#include "analysis/proof/rule_answers.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

std::optional<std::string> tellSaf003(const ProofResult& result) {
  if (result.outcome != Outcome::Violated || !excludesOutputs(result.property)) return std::nullopt;
  return violationText(result);
}

}  // namespace

extern constexpr Rule saf003_exclusive_outputs = {
    .id = "SAF003",
    .title = "Exclusive outputs on together",
    .severity = Severity::Error,
    .needs = Needs::Solver,
    .detects =
        "a declared property `never A and B` over outputs that some run breaks; the run has been repeated by the "
        "reference engine",
    .why = "forward and reverse contactor, or star and delta, closed together",
    .bad = "//@ prove directions: never Q0.0 and Q0.1\nNetwork 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n",
    .good =
        "//@ prove directions: never Q0.0 and Q0.1\nNetwork 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\nAN Q0.0\n"
        "= Q0.1\n",
    .peers = "ESBMC mutual_exclusion; PLCverif invariant",
    .tell = {.property = tellSaf003},
};

}  // namespace rungproof
