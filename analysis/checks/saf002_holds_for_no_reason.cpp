// SAF002: property holds for no good reason. Tested by tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include "analysis/proof/rule_answers.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

std::optional<std::string> tellSaf002(const ProofResult& result) {
  if (result.outcome != Outcome::Vacuous) return std::nullopt;
  return fmt::format("the property '{}' holds vacuously", result.property.name);
}

}  // namespace

extern constexpr Rule saf002_holds_for_no_reason = {
    .id = "SAF002",
    .title = "Property holds for no good reason",
    .severity = Severity::Error,
    .needs = Needs::Solver,
    .detects = "a property whose premise can never be met, or assumptions that contradict each other",
    .why = "a vacuous pass is worse than a fail: it is believed",
    .bad = "//@ prove lamp: Q0.0 and Q0.1 implies M0.0\nNetwork 1\nLD I0.0\n= Q0.0\nNetwork 2\nLDN I0.0\n= Q0.1\n",
    .good = "//@ prove lamp: Q0.0 or Q0.1 implies SM0.0\nNetwork 1\nLD I0.0\n= Q0.0\nNetwork 2\nLDN I0.0\n= Q0.1\n",
    .tell = {.property = tellSaf002},
};

}  // namespace rungproof
