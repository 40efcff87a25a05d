// Options, findings, confirmation.
#include "frontend/proof_input.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/proof_watch.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

ProverOptions proverOptionsOf(const Settings& settings) {
  ProverOptions options;
  options.choices = settings.choices();
  options.time.high = static_cast<std::uint32_t>(options.choices.watchdogMs());
  if (const auto range = settings.scanTime()) {
    options.time.low = static_cast<std::uint32_t>(std::max<std::int64_t>(range->low.count() / 1000, 1));
    options.time.high = static_cast<std::uint32_t>(std::max<std::int64_t>(range->high.count() / 1000, options.time.low));
  }
  if (const auto timeout = settings.timeout()) options.timeout = static_cast<double>(timeout->count()) / 1e6;
  options.memory = settings.memory().value_or(usualMemoryLimit());
  options.bound = static_cast<int>(settings.number(Opt::Bound, 0));
  options.jobs = static_cast<int>(settings.number(Opt::Jobs, 2));
  options.seed = static_cast<std::uint64_t>(settings.number(Opt::Seed, 1));
  return options;
}

std::optional<Finding> findingOf(const ProofResult& result) {
  if (!result.builtin) return std::nullopt;
  const bool bad = isWanted(result.builtin->kind) ? result.outcome == Outcome::Unreachable : result.outcome == Outcome::Violated;
  if (!bad) return std::nullopt;
  Finding finding;
  finding.rule = result.builtin->rule;
  const Rule* rule = ruleNamed(finding.rule);
  finding.severity = rule == nullptr ? Severity::Warning : rule->severity;
  finding.message = result.builtin->message;
  finding.address = result.builtin->address;
  finding.confirmation = Confirmation::Confirmed;
  if (result.builtin->place != nullptr) finding.span = result.builtin->place->span;
  if (result.builtin->other != nullptr) finding.related.push_back({result.builtin->other->span, "the other half of the conflict"});
  return finding;
}

namespace {

bool isAbout(const Finding& finding, const ProofResult& result) {
  return result.builtin && finding.rule == result.builtin->rule && result.builtin->place != nullptr && finding.span.file == result.builtin->place->span.file &&
         finding.span.offset >= result.builtin->place->span.offset && finding.span.offset < result.builtin->place->span.offset + result.builtin->place->span.length;
}

/// A declared property that fails, as a finding at its statement.
std::optional<Finding> brokenProperty(const ProofResult& result) {
  if (result.builtin || (result.outcome != Outcome::Violated && result.outcome != Outcome::Vacuous)) return std::nullopt;
  Finding finding;
  finding.rule = result.outcome == Outcome::Violated ? "SAF001" : "SAF002";
  finding.severity = Severity::Error;
  finding.message = result.outcome == Outcome::Violated ? fmt::format("the property '{}' is violated after {} scans", result.property.name, result.depth)
                                                        : fmt::format("the property '{}' holds vacuously", result.property.name);
  finding.span = result.property.span;
  finding.help = "'rungproof prove' shows the run";
  finding.confirmation = Confirmation::Confirmed;
  return finding;
}

}  // namespace

void confirmBySolver(const Settings& settings, const ProgramInput& input, Report& report) {
  ProverOptions options = proverOptionsOf(settings);
  options.builtin = true;
  const ProofRun run = prove(input.program, input.properties, options);
  for (const ProofResult& result : run.results) {
    const std::optional<Finding> finding = result.builtin ? findingOf(result) : brokenProperty(result);
    const bool dismissed = result.builtin && (isWanted(result.builtin->kind) ? result.outcome == Outcome::Reachable : result.outcome == Outcome::Proved);
    bool isKnown = false;
    for (Finding& known : report.findings) {
      if (!isAbout(known, result) || known.confirmation == Confirmation::NotNeeded) continue;
      isKnown = true;
      if (finding) known.confirmation = Confirmation::Confirmed;
    }
    if (dismissed) std::erase_if(report.findings, [&](const Finding& known) { return isAbout(known, result) && known.confirmation == Confirmation::Unconfirmed; });
    if (finding && !isKnown) report.findings.push_back(*finding);
  }
}

}  // namespace rungproof
