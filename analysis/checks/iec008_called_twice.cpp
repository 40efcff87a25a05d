// IEC008: a timer, counter or edge whose instance is called at two places of one body, or only in a branch. Tested by
// its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Where a statement stands: the branches around it, from the outermost on.
struct BranchStep {
  const iec::Statement* around;
  const void* list;
};
using BranchPath = std::vector<BranchStep>;

struct InstanceCall {
  const iec::Statement* statement;
  BranchPath path;
};

/// Whether one scan can run both: they do not stand in two branches of one IF or CASE.
bool canBothRun(const BranchPath& a, const BranchPath& b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i].around != b[i].around) return true;
    if (a[i].list != b[i].list) return false;
  }
  return true;
}

void collectCalls(const iec::Statements& list, const std::string& instance, BranchPath& path,
                  std::vector<InstanceCall>& calls) {
  for (const iec::Statement& one : list) {
    if (one.kind == iec::StatementKind::Call && one.target != nullptr && one.target->parts.size() == 1 &&
        iec::foldedName(one.target->parts[0].name) == instance)
      calls.push_back({&one, path});
    for (const iec::Branch& branch : one.branches) {
      path.push_back({&one, &branch});
      collectCalls(branch.body, instance, path, calls);
      path.pop_back();
    }
    path.push_back({&one, &one.otherwise});
    collectCalls(one.otherwise, instance, path, calls);
    path.pop_back();
  }
}

/// What the blocks of the standard are is told by their pins: those that see edges have CLK, CU or CD, timers have PT.
bool hasInput(const iec::BlockSyntax& block, std::initializer_list<std::string_view> names) {
  return std::ranges::any_of(block.variables, [&](const iec::VariableSyntax& variable) {
    return variable.section == iec::Section::Input &&
           std::ranges::find(names, iec::foldedName(variable.name)) != names.end();
  });
}

/// t(IN := FALSE): a timer that each scan calls is taken back on purpose, so that it begins anew in the next one.
bool isTakenBack(const InstanceCall& call) {
  const std::vector<iec::Argument>& given = call.statement->target->arguments;
  return std::ranges::any_of(given, [](const iec::Argument& one) {
    return iec::foldedName(one.name) == "IN" && one.value != nullptr && one.value->kind == iec::ExprKind::Literal &&
           iec::foldedName(one.value->text) == "FALSE";
  });
}

void checkIec008(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  for (const iec::DeclaredVariable& row : uses.all()) {
    const iec::BlockSyntax* of = uses.blockOf(*row.variable);
    if (row.block == nullptr || of == nullptr || !of->isLibrary) continue;
    const bool isEdge = hasInput(*of, {"CLK", "CU", "CD"});
    const bool isTimer = hasInput(*of, {"PT"});
    if (!isEdge && !isTimer) continue;
    std::vector<InstanceCall> calls;
    BranchPath path;
    iec::eachBody(*row.block, [&](const iec::Statements& body) {
      if (!iec::isList(body)) collectCalls(body, iec::foldedName(row.variable->name), path, calls);
    });
    for (std::size_t i = 1; i < calls.size(); ++i) {
      const auto before = std::find_if(calls.begin(), calls.begin() + static_cast<std::ptrdiff_t>(i),
                                       [&](const InstanceCall& call) { return canBothRun(call.path, calls[i].path); });
      if (before == calls.begin() + static_cast<std::ptrdiff_t>(i)) continue;
      if (isTimer && before->path.empty() && isTakenBack(calls[i])) continue;
      Finding& finding =
          iec::reportOn(sink, row, calls[i].statement->target->span,
                        fmt::format("{}, a {}, is called twice in one scan", row.variable->name, of->name));
      finding.related.push_back({before->statement->target->span, "the first call"});
      finding.help = "give each place an instance of its own";
    }
    if (calls.size() != 1 || calls[0].path.empty() || !isEdge) continue;
    Finding& finding = sink.report(
        calls[0].statement->target->span,
        fmt::format("{}, a {}, is called only in a branch: it misses the edges that come while the branch is not taken",
                    row.variable->name, of->name));
    finding.severity = Severity::Note;
    finding.address = row.variable->name;
    finding.help = "call it in front of the branch and ask its output there";
  }
}

}  // namespace

extern constexpr Rule iec008_called_twice = {
    .id = "IEC008",
    .title = "Timer, counter or edge called twice, or not in every scan",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "an instance of a standard timer, counter or edge that one scan can call at two places, other than with "
        "IN := FALSE to take a timer back; a note for an edge or a counter that is called in one branch only",
    .why =
        "the second call sees what the first one has left: edges disappear, and the last IN of a timer wins; a call "
        "that is left out does not see the edge at all",
    .bad =
        "PROGRAM Main\nVAR_INPUT a, b : BOOL; END_VAR\nVAR Edge : R_TRIG; END_VAR\nVAR_OUTPUT x, y : BOOL; "
        "END_VAR\nEdge(CLK := a);\nx := Edge.Q;\nEdge(CLK := b);\ny := Edge.Q;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT a, b : BOOL; END_VAR\nVAR Edge, Other : R_TRIG; END_VAR\nVAR_OUTPUT x, y : BOOL; "
        "END_VAR\nEdge(CLK := a);\nx := Edge.Q;\nOther(CLK := b);\ny := Other.Q;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .falsePositives = "a counter that should count in one state of a machine only: silence the line",
    .peers = "SA0105",
    .dialects = dialect::Iec,
    .check = checkIec008,
};

}  // namespace rungproof
