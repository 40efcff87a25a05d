// From answers of the prover to findings: an answer that a rule does not want is a finding in the rule's own words; a
// candidate of the flow analysis is confirmed or dropped; what another answer explains is not reported a second time.
// Which rule says what, and what explains what, stands in the rules (Rule::tell, Rule::explainedBy).
// Covered by tests/prover/rule_questions_test.cpp and tests/prover/own_rule_test.cpp.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/proof/prover.hpp"

namespace rungproof {

/// Whether a rule's question has the unwanted answer.
bool isRefuted(const ProofResult& result);

/// What stands beside the findings: the run of each answer, or the findings alone.
enum class Shown : std::uint8_t { Finding, Run };

/// Questions with the unwanted answer as confirmed findings, in their order. Answers on bits of one range are one
/// finding that names the whole range; one answer for several networks is a finding in each.
std::vector<Finding> findingsOf(const std::vector<const ProofResult*>& results, Shown shown);

/// The rule whose finding a declared property with that result is, or nullptr: it holds, or it is open.
const Rule* ruleOf(const ProofResult& result, std::span<const Rule* const> rules = allRules());
/// "the property 'stop' is violated after 3 scans".
std::string violationText(const ProofResult& result);

/// Brings `findings` of the flow analysis in line with the answers: candidates of the same rule and place are confirmed
/// or dropped, and new findings of the rules that `isSelected` are added.
void settle(const Program& program, const std::vector<ProofResult>& results, std::span<const Rule* const> rules,
            const std::function<bool(std::string_view)>& isSelected, std::vector<Finding>& findings);

}  // namespace rungproof
