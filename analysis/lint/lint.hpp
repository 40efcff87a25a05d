// Running rules over a program: which of them, in which order, and what they found. Reports and suppression come
// after. Tested by tests/cli/rule_table_test.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

/// Which rules run. The longer prefix decides between --select and --ignore, as in other linters; at equal length
/// --ignore wins. "ALL" is the shortest prefix. Without --select, rules run that are on by default.
class RuleSelection {
 public:
  RuleSelection() = default;
  RuleSelection(std::vector<std::string> select, std::vector<std::string> ignore)
      : select_(std::move(select)), ignore_(std::move(ignore)) {}

  bool includes(std::string_view id, bool onByDefault) const;
  bool includes(const Rule& rule) const { return includes(rule.id, rule.enabledByDefault); }

 private:
  std::vector<std::string> select_;
  std::vector<std::string> ignore_;
};

/// Findings of all selected rules that have a check and know the program's dialect. Where a heading or declaration
/// could not be read only rules speak that stand alone.
std::vector<Finding> runRules(const Facts& facts, const RuleSelection& selection, const RuleSettings& settings,
                              std::span<const Rule* const> rules = allRules());
/// The same for who wants nothing but the findings: the facts, made here, are gone before those are put in one row.
std::vector<Finding> runRules(const Program& program, std::span<const ExternalRange> externals,
                              const Surroundings& around, const RuleSelection& selection, const RuleSettings& settings);

}  // namespace rungproof
