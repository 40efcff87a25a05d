// PTR003: a pointer to words that moves by an odd number of bytes, to double words by a number that four does not
// divide. Steps of one network count together: INCD twice is a step of 2. Tested by its examples and
// tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/dataflow_pointers.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkPtr003(const Facts& facts, FindingSink& sink) {
  const PointerTable& pointers = facts.pointers();
  for (const PointerStride& stride : pointers.strides()) {
    if (stride.narrowest < 2 || stride.total % stride.narrowest == 0) continue;
    Finding& finding = sink.report(
        stride.last->span,
        fmt::format("{} moves the pointer by {}, but it is used for {} of {} bytes", Facts::text(*stride.last),
                    stride.total == 1 ? std::string("1 byte") : fmt::format("{} bytes", stride.total),
                    stride.narrowest == 2 ? "words" : "double words", stride.narrowest));
    finding.related.push_back({facts.instruction(stride.use->instruction).span, "the pointer is used here"});
    finding.address = accessName(*stride.use);
    finding.help = "add 2 for words and current values of T and C, 4 for double words (001:1478)";
  }
}

}  // namespace

extern constexpr Rule ptr003_step_does_not_fit = {
    .id = "PTR003",
    .title = "Step does not fit the width",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a pointer to words advanced by 1, to double words by 2",
    .why = "addresses count bytes: the next word is two bytes further, and a step of 1 mixes the halves of two words",
    .manual = "001:1470, 001:1478",
    .bad =
        "Network 1\nLD SM0.1\nMOVD &VB100, VD0\nNetwork 2\nLD I0.0\nEU\nMOVW *VD0, VW10\nINCD VD0\nNetwork 3\nLDD> "
        "VD0, 200\nMOVD &VB100, VD0\n",
    .good =
        "Network 1\nLD SM0.1\nMOVD &VB100, VD0\nNetwork 2\nLD I0.0\nEU\nMOVW *VD0, VW10\n+D +2, VD0\nNetwork 3\nLDD> "
        "VD0, 200\nMOVD &VB100, VD0\n",
    .falsePositives = "a byte-wise walk over overlapping words, such as for a checksum",
    .peers = "SA0065; E2",
    .dialects = dialect::S7200,
    .check = checkPtr003,
};

}  // namespace rungproof
