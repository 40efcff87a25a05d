// One run of the prover for everything but power-up, which starts from other memory. What one answer explains is not
// reported a second time under another rule.
#include "frontend/solver_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "analysis/proof/safety_shape.hpp"
#include "analysis/rule.hpp"
#include "frontend/proof_input.hpp"

namespace rungproof {

namespace {

bool isWithin(const Span& inner, const Span& outer) {
  return inner.file == outer.file && inner.offset >= outer.offset && inner.offset < outer.offset + outer.length;
}

bool isAbout(const Finding& finding, const ProofResult& result) {
  if (!result.builtin || finding.rule != result.builtin->rule || result.builtin->place == nullptr) return false;
  const bool isSameAddress = finding.confirmation == Confirmation::NotNeeded && !finding.address.empty() &&
                             finding.address == result.builtin->address;
  return isSameAddress || isWithin(finding.span, result.builtin->place->span);
}

/// A declared property that fails, as a finding at its statement.
std::optional<Finding> brokenProperty(const ProofResult& result) {
  if (result.builtin || (result.outcome != Outcome::Violated && result.outcome != Outcome::Vacuous))
    return std::nullopt;
  const bool isViolated = result.outcome == Outcome::Violated;
  Finding finding;
  finding.rule = isViolated ? ruleOfViolation(result.property) : "SAF002";
  finding.severity = Severity::Error;
  finding.message =
      isViolated ? fmt::format("the property '{}' is violated after {} scans", result.property.name, result.depth)
                 : fmt::format("the property '{}' holds vacuously", result.property.name);
  if (finding.rule == "SAF004") finding.message += "; besides, a stop must work without the controller (001:2016-2021)";
  finding.span = result.property.span;
  finding.help = "'rungproof prove' shows the run";
  finding.confirmation = Confirmation::Confirmed;
  return finding;
}

/// Leaves out answers that follow from others: a rung that never runs, a latch of which no run was seen that has it on
/// at the end of a scan, contacts of a rung that is constant anyway, all but the last of several contacts that stand
/// for each other, all but the first of dead networks in a row.
class Explained {
 public:
  Explained(const Program& program, const std::vector<ProofResult>& results) : places_(program), results_(results) {
    for (const ProofResult& result : results) {
      if (result.builtin && result.builtin->kind == BuiltinKind::LatchOn && result.outcome == Outcome::Reachable)
        liveLatches_.insert(result.builtin->address);
      if (!isRefuted(result)) continue;
      const BuiltinCheck& check = *result.builtin;
      const Network* network = check.place == nullptr ? nullptr : places_.at(check.place->span).network;
      switch (check.kind) {
        case BuiltinKind::FlowOn:
          neverOn_.insert(check.place);
          for (const AlikePlace& alike : check.alike) neverOn_.insert(alike.place);
          addConstant(check);
          break;
        case BuiltinKind::FlowOff:
          alwaysOn_.insert(check.place);
          addConstant(check);
          for (const AlikePlace& alike : check.alike) alwaysOn_.insert(alike.place);
          break;
        case BuiltinKind::CodeRuns:
          constant_.insert(network);
          if (check.rule == "CTL005") dead_.insert(network);
          break;
        case BuiltinKind::StepEntered: deadSteps_.insert(check.address); break;
        case BuiltinKind::ContactMatters: {
          const BuiltinCheck*& last = lastIdle_[{network, check.address}];
          if (last == nullptr || last->place->id < check.place->id) last = &check;
          break;
        }
        default: break;
      }
    }
  }

  /// Code that a jump or a return leaves out, where that jump or return never comes to pass.
  bool restsOnDeadCode(const Finding& finding) const {
    if (finding.rule != "TIM004" && finding.rule != "TIM014" && finding.rule != "OUT007") return false;
    return finding.related.size() == 1 && std::ranges::any_of(neverOn_, [&](const Instruction* instruction) {
             return instruction->span == finding.related.front().span;
           });
  }

  bool operator()(const ProofResult& result) const {
    const BuiltinCheck& check = *result.builtin;
    const Network* network = check.place == nullptr ? nullptr : places_.at(check.place->span).network;
    switch (check.kind) {
      case BuiltinKind::FlowOn: return alwaysOn_.contains(check.place);
      case BuiltinKind::FlowOff: return neverOn_.contains(check.place);
      case BuiltinKind::CodeRuns:
        return check.rule == "CTL005" && network != &places_.at(check.place->span).pou->networks.front() &&
               dead_.contains(network - 1);
      case BuiltinKind::LatchOn: return true;
      case BuiltinKind::LatchDrops: return !liveLatches_.contains(check.address) || alwaysOn_.contains(check.place);
      case BuiltinKind::StepLeft: return deadSteps_.contains(check.address);
      case BuiltinKind::ContactMatters:
        return constant_.contains(network) || lastIdle_.at({network, check.address})->place != check.place;
      default: return false;
    }
  }

 private:
  void addConstant(const BuiltinCheck& check) {
    constant_.insert(places_.at(check.place->span).network);
    for (const AlikePlace& alike : check.alike) constant_.insert(places_.at(alike.place->span).network);
  }

  const PlaceIndex places_;
  const std::vector<ProofResult>& results_;
  std::set<const Instruction*> neverOn_, alwaysOn_;
  std::set<std::string> deadSteps_, liveLatches_;
  std::set<const Network*> constant_, dead_;
  std::map<std::pair<const Network*, std::string>, const BuiltinCheck*> lastIdle_;
};

void settle(const Program& program, const std::vector<ProofResult>& results,
            const std::function<bool(std::string_view)>& isSelected, std::vector<Finding>& findings) {
  const Explained isExplained(program, results);
  std::erase_if(findings, [&](const Finding& finding) { return isExplained.restsOnDeadCode(finding); });
  std::vector<const ProofResult*> news;
  for (const ProofResult& result : results) {
    if (!result.builtin) {
      std::optional<Finding> finding = brokenProperty(result);
      if (finding && isSelected(finding->rule)) findings.push_back(std::move(*finding));
      continue;
    }
    const bool isBad = isRefuted(result);
    bool isKnown = false;
    for (Finding& known : findings) {
      if (!isAbout(known, result)) continue;
      isKnown = true;
      if (isBad && known.confirmation == Confirmation::Unconfirmed) known.confirmation = Confirmation::Confirmed;
    }
    const bool isDismissed =
        isWanted(result.builtin->kind) ? result.outcome == Outcome::Reachable : result.outcome == Outcome::Proved;
    if (isDismissed) {
      std::erase_if(findings, [&](const Finding& known) {
        return isAbout(known, result) && known.confirmation == Confirmation::Unconfirmed;
      });
    }
    const bool isNew = isBad && !isKnown && isSelected(result.builtin->rule);
    if (isNew && !needsCandidate(result.builtin->kind) && !isExplained(result)) news.push_back(&result);
  }
  // Of several answers of one rule at one place the first speaks.
  std::set<std::tuple<std::string, std::uint32_t, std::uint32_t>> said;
  for (Finding& finding : findingsOf(news)) {
    if (said.emplace(finding.rule, finding.span.file, finding.span.offset).second)
      findings.push_back(std::move(finding));
  }
}

constexpr double shareOfRules = 0.75;  ///< of the time, for all but power-up

/// Counts by rule what stays open.
class OpenCount {
 public:
  explicit OpenCount(const std::function<bool(std::string_view)>& isSelected) : isSelected_(isSelected) {}

  void add(const ProofRun& run) {
    for (const ProofResult& result : run.results) {
      const std::string rule = result.builtin ? result.builtin->rule : result.property.name;
      if (result.builtin && !isSelected_(rule)) continue;
      Row& row = rows_[rule];
      ++row.asked;
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
      open_.lines.push_back(fmt::format("{}: {} of {} questions to the prover are open{}", rule, row.open, row.asked,
                                        row.reason.empty() ? "" : ": " + row.reason));
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

}  // namespace

OpenQuestions settleBySolver(const ProgramInput& input, const ProverOptions& options,
                             const std::function<bool(std::string_view)>& isSelected, std::vector<Finding>& findings) {
  const auto start = std::chrono::steady_clock::now();
  ProverOptions questions = options;
  const auto areAsked = [&](Questions group) {
    return std::ranges::any_of(allRules(),
                               [&](const Rule* rule) { return rule->questions == group && isSelected(rule->id); });
  };
  const bool asksPowerUp = areAsked(Questions::PowerUp);
  questions.checks = {.builtin = true, .rungs = areAsked(Questions::Rungs)};
  if (asksPowerUp) questions.total *= shareOfRules;
  OpenCount open(isSelected);
  const ProofRun rules = prove(input.program, input.properties, questions);
  open.add(rules);
  settle(input.program, rules.results, isSelected, findings);
  if (!asksPowerUp) return open.take();
  PropertySet atPowerUp = input.properties;
  std::erase_if(atPowerUp.properties, [](const Property& property) { return property.isGoal(); });
  atPowerUp.initialRetentive = true;
  questions.checks = {.powerUp = true};
  const std::chrono::duration<double> used = std::chrono::steady_clock::now() - start;
  if (options.total > 0) questions.total = std::max(options.total - used.count(), 0.001);
  const ProofRun powerUp = prove(input.program, atPowerUp, questions);
  open.add(powerUp);
  settle(input.program, powerUp.results, isSelected, findings);
  return open.take();
}

}  // namespace rungproof
