// One run of the prover for everything but power-up, which starts from other memory. What one answer explains is not
// reported a second time under another rule.
#include "frontend/solver_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
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

}  // namespace

void settleBySolver(const ProgramInput& input, const ProverOptions& options,
                    const std::function<bool(std::string_view)>& isSelected, std::vector<Finding>& findings) {
  ProverOptions questions = options;
  const auto areAsked = [&](Questions group) {
    return std::ranges::any_of(allRules(),
                               [&](const Rule* rule) { return rule->questions == group && isSelected(rule->id); });
  };
  questions.checks = {.builtin = true, .rungs = areAsked(Questions::Rungs)};
  settle(input.program, prove(input.program, input.properties, questions).results, isSelected, findings);
  if (!areAsked(Questions::PowerUp)) return;
  PropertySet atPowerUp = input.properties;
  std::erase_if(atPowerUp.properties, [](const Property& property) { return property.isGoal(); });
  atPowerUp.initialRetentive = true;
  questions.checks = {.powerUp = true};
  settle(input.program, prove(input.program, atPowerUp, questions).results, isSelected, findings);
}

}  // namespace rungproof
