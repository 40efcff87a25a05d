// IEC011: a label of a CASE that stands in it twice. Tested by its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

using Labels = std::map<std::int64_t, std::pair<std::int64_t, const iec::CaseLabel*>>;

/// By its first value: the last one, and the label that names them. Ranges that meet stand there once.
const iec::CaseLabel* takenBy(const Labels& labels, std::int64_t low, std::int64_t high) {
  auto next = labels.upper_bound(high);
  if (next == labels.begin()) return nullptr;
  --next;
  return next->second.first >= low ? next->second.second : nullptr;
}

/// What of low..high no label has yet.
void add(Labels& labels, std::int64_t low, std::int64_t high, const iec::CaseLabel& label) {
  std::vector<std::pair<std::int64_t, std::int64_t>> free;
  auto next = labels.upper_bound(low);
  if (next != labels.begin()) {
    const std::int64_t last = std::prev(next)->second.first;
    if (last >= high) return;
    low = std::max(low, last + 1);
  }
  for (; next != labels.end() && next->first <= high; ++next) {
    if (low < next->first) free.emplace_back(low, next->first - 1);
    low = next->second.first;
    if (low >= high) break;
    ++low;
  }
  if (low <= high && takenBy(labels, low, high) == nullptr) free.emplace_back(low, high);
  for (const auto& [from, to] : free) labels.emplace(from, std::pair(to, &label));
}

void checkIec011(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  iec::eachOwnStatement(
      uses.project(), [&](const iec::BlockSyntax&, const iec::Statement& one, const iec::Statements&, std::size_t) {
        if (one.kind != iec::StatementKind::Case) return;
        Labels numbers;                            // do not meet each other
        std::vector<const iec::CaseLabel*> names;  // of enumerations and constants
        for (const iec::Branch& branch : one.branches) {
          for (const iec::CaseLabel& label : branch.labels) {
            if (label.low == nullptr) continue;
            const auto low = iec::plainNumber(*label.low);
            const auto high = label.high != nullptr ? iec::plainNumber(*label.high) : low;
            const iec::CaseLabel* first = nullptr;
            if (low && high) {
              if (*low > *high) continue;
              first = takenBy(numbers, *low, *high);
              add(numbers, *low, *high, label);
            } else if (label.high == nullptr) {
              const auto same = std::ranges::find_if(
                  names, [&](const iec::CaseLabel* other) { return iec::isSame(*other->low, *label.low); });
              if (same != names.end())
                first = *same;
              else
                names.push_back(&label);
            }
            if (first == nullptr) continue;
            Finding& finding = sink.report(label.low->span, "a label before this one has the value already");
            finding.related.push_back({first->low->span, "the first label"});
            finding.help = "the first label wins: remove one of them";
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
    .detects = "a label of a CASE with a value that an earlier label already has, by itself or in a range",
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
