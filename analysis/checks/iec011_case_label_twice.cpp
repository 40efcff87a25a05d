// IEC011: a label of a CASE that stands in it twice. Tested by its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <optional>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Whether the first label takes what the second one names.
bool takes(const iec::CaseLabel& first, const iec::CaseLabel& second) {
  if (first.low == nullptr || second.low == nullptr) return false;
  if (first.high == nullptr && second.high == nullptr && iec::isSame(*first.low, *second.low)) return true;
  const auto low = iec::plainNumber(*first.low), high = first.high != nullptr ? iec::plainNumber(*first.high) : low;
  const auto from = iec::plainNumber(*second.low), to = second.high != nullptr ? iec::plainNumber(*second.high) : from;
  return low && high && from && to && *low <= *to && *from <= *high;
}

void checkIec011(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  iec::eachOwnStatement(
      uses.project(), [&](const iec::BlockSyntax&, const iec::Statement& one, const iec::Statements&, std::size_t) {
        if (one.kind != iec::StatementKind::Case) return;
        std::vector<const iec::CaseLabel*> before;
        for (const iec::Branch& branch : one.branches) {
          for (const iec::CaseLabel& label : branch.labels) {
            for (const iec::CaseLabel* other : before) {
              if (!takes(*other, label)) continue;
              Finding& finding = sink.report(label.low->span, "a label before this one has the value already");
              finding.related.push_back({other->low->span, "the first label"});
              finding.help = "the first label wins: remove one of them";
              break;
            }
            before.push_back(&label);
          }
        }
      });
}

}  // namespace

extern constexpr Rule iec011_case_label_twice = {
    .id = "IEC011",
    .title = "Label of a CASE twice",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "a label of a CASE whose value a label before it has already, by itself or in a range",
    .why = "the first label wins, so that the statements of the second one do not run for that value",
    .bad =
        "PROGRAM Main\nVAR_INPUT n : INT; END_VAR\nVAR_OUTPUT q : INT; END_VAR\nCASE n OF\n  1..5: q := 1;\n  5: q := "
        "2;\nELSE\n  q := 0;\nEND_CASE;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT n : INT; END_VAR\nVAR_OUTPUT q : INT; END_VAR\nCASE n OF\n  1..4: q := 1;\n  5: q := "
        "2;\nELSE\n  q := 0;\nEND_CASE;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .dialects = dialect::Iec,
    .check = checkIec011,
};

}  // namespace rungproof
