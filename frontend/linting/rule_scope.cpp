// Which rules look at a program.
#include "frontend/linting/rule_scope.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/lint/lint.hpp"
#include "analysis/rule.hpp"
#include "frontend/settings/code_list.hpp"

namespace rungproof {

namespace {

/// How far a code gets with a program; the furthest of its rules counts.
enum class RuleReach : std::uint8_t { NotMeant, Ignored, OtherDialect, NeedsProver, Looks };

/// Messages of the readers are spoken by whoever reads. A check of a rule that needs the prover finds only a part.
RuleReach ruleReach(const Code& code, const LintedProgram& program, const RuleSelection& selection, bool prove) {
  if (!selection.includes(code.id, code.onByDefault)) return RuleReach::Ignored;
  const Rule* const rule = code.isRule ? ruleNamed(code.id) : nullptr;
  if (rule == nullptr) return RuleReach::Looks;
  if (!knows(*rule, program.target)) return RuleReach::OtherDialect;
  return rule->needs == Needs::Solver && !prove ? RuleReach::NeedsProver : RuleReach::Looks;
}

/// `text`: a code of --select or the beginning of one.
RuleReach ruleReach(const std::string& text, const LintedProgram& program, bool prove) {
  const RuleSelection selection(program.settings->list(Opt::Select), program.settings->list(Opt::Ignore));
  RuleReach furthest = RuleReach::NotMeant;
  for (const Code& code : allCodes()) {
    if (text != "ALL" && !code.id.starts_with(text)) continue;
    furthest = std::max(furthest, ruleReach(code, program, selection, prove));
    if (furthest == RuleReach::Looks) break;
  }
  return furthest;
}

Failure whyIdle(const std::string& text, RuleReach reach, std::span<const LintedProgram> programs) {
  if (reach == RuleReach::NeedsProver)
    return {fmt::format("the rules that '{}' selects need the prover", text), text, "ask it with 'lint --prove'"};
  const std::string title(dialectOf(programs.front().target).title);
  const bool isOneFamily =
      std::ranges::all_of(programs, [&](const auto& each) { return dialectOf(each.target).title == title; });
  return {fmt::format("the rules that '{}' selects are for other programs than {}", text,
                      isOneFamily ? fmt::format("those of the {}", title) : "these"),
          text, "leave the code out, or name the family of the program with --dialect or --cpu"};
}

}  // namespace

std::vector<Failure> idleRules(std::span<const LintedProgram> programs, bool prove) {
  std::vector<Failure> failures;
  if (programs.empty()) return failures;
  std::vector<std::string> codes;
  for (const LintedProgram& program : programs) {
    for (const std::string& text : program.settings->list(Opt::Select)) {
      if (std::ranges::find(codes, text) == codes.end()) codes.push_back(text);
    }
  }
  const auto furthest = [&](const std::string& text) {
    RuleReach reach = RuleReach::NotMeant;
    for (const LintedProgram& program : programs) reach = std::max(reach, ruleReach(text, program, prove));
    return reach;
  };
  // A code that --ignore takes back on purpose is not missed, as long as another rule looks.
  for (const std::string& text : codes) {
    const RuleReach reach = furthest(text);
    if (reach == RuleReach::OtherDialect || reach == RuleReach::NeedsProver)
      failures.push_back(whyIdle(text, reach, programs));
  }
  if (failures.empty() && furthest("ALL") != RuleReach::Looks)
    failures.push_back(
        {"no rule is left to look at the program", {}, "--ignore takes back all that is selected: name fewer codes"});
  return failures;
}

}  // namespace rungproof
