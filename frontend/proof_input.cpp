// Options and findings.
#include "frontend/proof_input.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/proof/proof_watch.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

ProverOptions proverOptionsOf(const Settings& settings) {
  ProverOptions options;
  options.choices = settings.choices();
  options.time.high = static_cast<std::uint32_t>(options.choices.watchdogMs());
  if (const auto range = settings.scanTime()) {
    options.time.low = static_cast<std::uint32_t>(std::max<std::int64_t>(range->low.count() / 1000, 1));
    options.time.high =
        static_cast<std::uint32_t>(std::max<std::int64_t>(range->high.count() / 1000, options.time.low));
  }
  if (const auto timeout = settings.timeout()) options.timeout = static_cast<double>(timeout->count()) / 1e6;
  options.memory = settings.memory().value_or(usualMemoryLimit());
  options.bound = static_cast<int>(settings.number(Opt::Bound, 0));
  options.jobs = static_cast<int>(settings.number(Opt::Jobs, 2));
  options.seed = static_cast<std::uint64_t>(settings.number(Opt::Seed, 1));
  return options;
}

namespace {

std::string helpOf(const BuiltinCheck& check, int scans) {
  switch (check.kind) {
    case BuiltinKind::TimerReachable:
    case BuiltinKind::TimerResettable: return "proved for every run; look at the input and the preset";
    case BuiltinKind::FlowOn:
    case BuiltinKind::FlowOff:
      return "proved for every run; a contact is missing, of the wrong kind, or at the wrong address";
    case BuiltinKind::LatchDrops:
      return "proved for every run; put the contact that ends it in series behind the holding contact, or mend the "
             "reset";
    case BuiltinKind::ContactMatters: return "proved for every run; remove it, or put it where it is needed";
    case BuiltinKind::StepEntered:
    case BuiltinKind::StepLeft: return "proved for every run; look at the conditions of the transitions";
    case BuiltinKind::CodeRuns:
      return "proved for every run; look at the conditions of the jumps, calls and loops before it";
    case BuiltinKind::CounterReset:
    case BuiltinKind::CountRises:
      return "proved for every run; the last load before the box is the reset or load input (001:3994-4004)";
    case BuiltinKind::TwoWaysOut:
    case BuiltinKind::StepsTogether:
      return fmt::format("seen in scan {} of a run that the engine repeats; make the conditions exclude each other",
                         scans);
    case BuiltinKind::PowerUp:
      return fmt::format("seen in scan {} of a run that the engine repeats; reset the bit that holds it with SM0.1",
                         scans);
    case BuiltinKind::Restart:
      return fmt::format("seen in scan {} of a run that the engine repeats; let the stop reset what starts the machine",
                         scans);
    default:
      return isRuleQuestion(check.kind) ? fmt::format("seen in scan {} of a run that the engine repeats", scans)
                                        : "'rungproof prove --builtin' shows the run";
  }
}

}  // namespace

std::optional<Finding> findingOf(const ProofResult& result) {
  if (!result.builtin) return std::nullopt;
  const bool bad =
      isWanted(result.builtin->kind) ? result.outcome == Outcome::Unreachable : result.outcome == Outcome::Violated;
  if (!bad) return std::nullopt;
  Finding finding;
  finding.rule = result.builtin->rule;
  const Rule* rule = ruleNamed(finding.rule);
  finding.severity = rule == nullptr ? Severity::Warning : rule->severity;
  finding.message = result.builtin->message;
  finding.address = result.builtin->address;
  finding.confirmation = Confirmation::Confirmed;
  if (result.builtin->place != nullptr) finding.span = result.builtin->place->span;
  if (result.builtin->other != nullptr) {
    finding.related.push_back({result.builtin->other->span, result.builtin->kind == BuiltinKind::StackLevels
                                                                ? "the level is used here"
                                                                : "the other half of the conflict"});
  }
  finding.help = helpOf(*result.builtin, result.depth);
  return finding;
}

}  // namespace rungproof
