// SAF001: declared property violated. What more particular rules tell (SAF003, SAF004) is left to them. Tested by
// tests/prover/rule_questions_test.cpp, which runs the examples.
#include "analysis/proof/rule_answers.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

std::optional<std::string> tellSaf001(const ProofResult& result) {
  if (result.outcome != Outcome::Violated) return std::nullopt;
  return violationText(result);
}

constexpr Explanation saf001Explained[] = {{"SAF003", Where::SameProperty}, {"SAF004", Where::SameProperty}};

}  // namespace

extern constexpr Rule saf001_property_violated = {
    .id = "SAF001",
    .title = "Declared property violated",
    .severity = Severity::Error,
    .needs = Needs::Solver,
    .detects =
        "a declared property that some run of the program breaks; the run has been repeated by the reference engine",
    .why = "the interlock that was meant is not the one that was written",
    .bad = "//@ prove follows: Q0.0 implies I0.0\nNetwork 1\nLD I0.0\nO I0.1\n= Q0.0\n",
    .good = "//@ prove follows: Q0.0 implies I0.0\nNetwork 1\nLD I0.0\nA I0.1\n= Q0.0\n",
    .peers = "PLCverif all patterns; ESBMC SAFE-LD",
    .tell = {.property = tellSaf001},
    .explainedBy = saf001Explained,
};

}  // namespace rungproof
