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

bool isRefuted(const ProofResult& result) {
  return result.builtin && (isWanted(result.builtin->kind) ? result.outcome == Outcome::Unreachable
                                                           : result.outcome == Outcome::Violated);
}

/// Leaves out answers that follow from others: a rung that never runs, a latch that is never set, contacts of a rung
/// that is constant anyway, all but the last of several contacts that stand for each other, all but the first of dead
/// networks in a row.
class Explained {
 public:
  Explained(const Program& program, const std::vector<ProofResult>& results) : places_(program), results_(results) {
    for (const ProofResult& result : results) {
      if (!isRefuted(result)) continue;
      const BuiltinCheck& check = *result.builtin;
      const Network* network = check.place == nullptr ? nullptr : places_.at(check.place->span).network;
      switch (check.kind) {
        case BuiltinKind::FlowOn:
          neverOn_.insert(check.place);
          if (!isReset(kindOf(*check.place))) deadBits_.insert(check.address);
          constant_.insert(network);
          break;
        case BuiltinKind::FlowOff:
          alwaysOn_.insert(check.place);
          constant_.insert(network);
          break;
        case BuiltinKind::CodeRuns:
          constant_.insert(network);
          if (check.rule == "CTL005") dead_.insert(network);
          break;
        case BuiltinKind::StepEntered: deadBits_.insert(check.address); break;
        case BuiltinKind::ContactMatters: {
          const BuiltinCheck*& last = lastIdle_[{network, check.address}];
          if (last == nullptr || last->place->id < check.place->id) last = &check;
          break;
        }
        default: break;
      }
    }
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
      case BuiltinKind::LatchDrops: return deadBits_.contains(check.address) || alwaysOn_.contains(check.place);
      case BuiltinKind::StepLeft: return deadBits_.contains(check.address);
      case BuiltinKind::ContactMatters:
        return constant_.contains(network) || lastIdle_.at({network, check.address})->place != check.place;
      default: return false;
    }
  }

 private:
  const PlaceIndex places_;
  const std::vector<ProofResult>& results_;
  std::set<const Instruction*> neverOn_, alwaysOn_;
  std::set<std::string> deadBits_;
  std::set<const Network*> constant_, dead_;
  std::map<std::pair<const Network*, std::string>, const BuiltinCheck*> lastIdle_;
};

void settle(const Program& program, const std::vector<ProofResult>& results,
            const std::function<bool(std::string_view)>& isSelected, std::vector<Finding>& findings) {
  const Explained isExplained(program, results);
  for (const ProofResult& result : results) {
    const std::optional<Finding> finding = result.builtin ? findingOf(result) : brokenProperty(result);
    const bool isDismissed = result.builtin && (isWanted(result.builtin->kind) ? result.outcome == Outcome::Reachable
                                                                               : result.outcome == Outcome::Proved);
    bool isKnown = false;
    for (Finding& known : findings) {
      if (!isAbout(known, result)) continue;
      isKnown = true;
      if (finding && known.confirmation == Confirmation::Unconfirmed) known.confirmation = Confirmation::Confirmed;
    }
    if (isDismissed)
      std::erase_if(findings, [&](const Finding& known) {
        return isAbout(known, result) && known.confirmation == Confirmation::Unconfirmed;
      });
    if (!finding || isKnown || !isSelected(finding->rule)) continue;
    if (result.builtin && (needsCandidate(result.builtin->kind) || isExplained(result))) continue;
    findings.push_back(*finding);
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
