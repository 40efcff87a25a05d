// One run of the prover for everything but power-up, which starts from other memory.
#include "frontend/linting/solver_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "analysis/proof/rule_answers.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

/// Counts by rule what stays open.
class OpenCount {
 public:
  explicit OpenCount(const std::function<bool(std::string_view)>& isSelected) : isSelected_(isSelected) {}

  void add(const ProofRun& run) {
    rungproof::add(open_.techniques, run.techniques);
    for (const ProofResult& result : run.results) {
      const std::string rule = result.builtin ? std::string(result.builtin->rule->id) : result.property.name;
      if (result.builtin && !isSelected_(rule)) continue;
      Row& row = rows_[rule];
      ++row.asked;
      for (const std::string& text : result.assumptions) {
        if (std::ranges::find(open_.assumptions, text) == open_.assumptions.end()) open_.assumptions.push_back(text);
      }
      if (result.outcome != Outcome::Unknown) continue;
      ++row.open;
      if (result.method.empty() && !result.notes.empty()) row.reason = result.notes.back();
    }
    for (const Disagreement& disagreement : run.disagreements)
      open_.defects.push_back(
          fmt::format("internal disagreement on '{}': {}", disagreement.name, disagreement.explanation));
  }
  OpenQuestions take() {
    for (const auto& [rule, row] : rows_) {
      if (row.open == 0) continue;
      open_.count += row.open;
      open_.lines.push_back(
          fmt::format("{}: {} of {} questions to the prover are open{}; --budget and --timeout give more time", rule,
                      row.open, row.asked, row.reason.empty() ? "" : ": " + row.reason));
    }
    return std::move(open_);
  }

 private:
  struct Row {
    std::size_t asked = 0, open = 0;
    std::string reason{};
  };
  const std::function<bool(std::string_view)>& isSelected_;
  std::map<std::string, Row> rows_;
  OpenQuestions open_;
};

/// Gives each finding that a run has confirmed the file of that run.
void writeRuns(const Program& program, const std::vector<ProofResult>& results, const RunWriter& writeRun,
               std::vector<Finding>& findings) {
  if (!writeRun) return;
  for (const ProofResult& result : results) {
    if (!result.witness || result.witness->scans.empty() || (result.builtin && !isRefuted(result))) continue;
    const Rule* rule = result.builtin ? result.builtin->rule : ruleOf(result);
    if (rule == nullptr) continue;
    const Span place = !result.builtin                    ? result.property.span
                       : result.builtin->place != nullptr ? result.builtin->place->span
                                                          : Span{};
    const std::string address = result.builtin ? result.builtin->address : std::string();
    const auto isShown = [&](const Finding& finding) {
      const bool isHere = finding.span == place || (!address.empty() && finding.address == address);
      return finding.rule == rule->id && finding.confirmation == Confirmation::Confirmed && finding.trace.empty() &&
             isHere;
    };
    const auto first = std::ranges::find_if(findings, isShown);
    if (first == findings.end()) continue;
    const std::string name = writeRun(program, result);
    for (auto finding = first; finding != findings.end(); ++finding) {
      if (isShown(*finding)) finding->trace = name;
    }
  }
}

}  // namespace

OpenQuestions settleBySolver(const ProgramInput& input, const ProverOptions& options,
                             const std::function<bool(std::string_view)>& isSelected, std::vector<Finding>& findings,
                             const RunWriter& writeRun) {
  const auto start = std::chrono::steady_clock::now();
  ProverOptions questions = options;
  const std::span<const Rule* const> known = options.checks.rules;
  const auto areAsked = [&](AskedIn run) {
    return std::ranges::any_of(known,
                               [&](const Rule* rule) { return (rule->ask.in & run) != 0 && isSelected(rule->id); });
  };
  const bool asksPowerUp = areAsked(asked::PowerUp);
  questions.checks = {.builtin = true, .lint = areAsked(asked::Lint), .rules = known};
  if (asksPowerUp) questions.total *= schedule::rulesShare;
  OpenCount open(isSelected);
  const ProofRun rules = prove(input.program, input.properties, questions);
  open.add(rules);
  settle(input.program, rules.results, known, isSelected, findings);
  writeRuns(input.program, rules.results, writeRun, findings);
  if (!asksPowerUp) return open.take();
  PropertySet atPowerUp = input.properties;
  std::erase_if(atPowerUp.properties, [](const Property& property) { return property.isGoal(); });
  atPowerUp.initialRetentive = true;
  questions.checks = {.powerUp = true, .rules = known};
  const std::chrono::duration<double> used = std::chrono::steady_clock::now() - start;
  if (options.total > 0) questions.total = std::max(options.total - used.count(), 0.001);
  const ProofRun powerUp = prove(input.program, atPowerUp, questions);
  open.add(powerUp);
  settle(input.program, powerUp.results, known, isSelected, findings);
  writeRuns(input.program, powerUp.results, writeRun, findings);
  return open.take();
}

}  // namespace rungproof
