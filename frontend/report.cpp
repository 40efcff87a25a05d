// Counting and ordering of results. Tested by tests/cli/report_test.cpp.
#include "frontend/report.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <tuple>

#include "analysis/read_errors.hpp"
#include "analysis/rule.hpp"
#include "frontend/test_results.hpp"

namespace rungproof {

std::string verdictText(Outcome verdict, int depth) {
  switch (verdict) {
    case Outcome::Proved: return "PROVED";
    case Outcome::Violated: return "VIOLATED";
    case Outcome::Reachable: return "REACHABLE";
    case Outcome::Unreachable: return "UNREACHABLE";
    case Outcome::HoldsToBound: return fmt::format("HOLDS TO BOUND {}", depth);
    case Outcome::Vacuous: return "VACUOUS";
    case Outcome::NotCovered: return "NOT COVERED";
    default: return "UNKNOWN";
  }
}

std::string_view resultKindName(ResultKind kind) {
  return kind == ResultKind::Prove ? "prove" : kind == ResultKind::Reach ? "reach" : "builtin";
}

std::string plainNumber(TraceNumber value) {
  const bool isWhole = std::trunc(value) == value && std::abs(value) < 0x1p64L;
  return isWhole ? fmt::format("{:.0f}", value) : fmt::format("{:g}", static_cast<double>(value));
}

std::string differenceText(const Comparison& comparison) {
  if (comparison.isUndecided())
    return fmt::format("undecided{}{}", comparison.notes.empty() ? "" : ": ", fmt::join(comparison.notes, "; "));
  if (comparison.isOfPrograms())
    return fmt::format("scan {}, {} ms, {}: OLD {}, NEW {}", comparison.scan, plainNumber(comparison.timeMs),
                       comparison.signal, plainNumber(comparison.expected), plainNumber(comparison.actual));
  return fmt::format("scan {}, {} ms, {}: expected {}, {}", comparison.scan, plainNumber(comparison.timeMs),
                     comparison.signal, plainNumber(comparison.expected),
                     comparison.hasEnded ? "but the trace ends before that scan"
                                         : fmt::format("actual {}", plainNumber(comparison.actual)));
}

FaultCounts countsOf(const std::vector<PlantedFault>& faults) {
  FaultCounts count;
  for (const PlantedFault& fault : faults) {
    ++(fault.fate == "noticed"     ? count.noticed
       : fault.fate == "unnoticed" ? count.unnoticed
       : fault.fate == "undecided" ? count.undecided
                                   : count.withoutEffect);
  }
  return count;
}

Summary summaryOf(const Report& report) {
  Summary summary;
  for (const Finding& finding : report.findings) {
    if (finding.severity == Severity::Error) ++summary.errors;
    if (finding.severity == Severity::Warning) ++summary.warnings;
    if (finding.severity == Severity::Note) ++summary.notes;
  }
  for (const PropertyResult& property : report.properties) {
    switch (property.verdict) {
      case Outcome::Proved:
      case Outcome::Reachable: ++summary.proved; break;
      case Outcome::Violated:
      case Outcome::Unreachable:
      case Outcome::Vacuous: ++summary.violated; break;
      default: ++summary.undecided; break;
    }
  }
  summary.undecided += report.coverage.open;
  if (report.tests != nullptr) summary.undecided += report.tests->openGoals();
  return summary;
}

namespace {

/// Failed tests, and tests that expect nothing.
void addTestReasons(const Report& report, const std::function<void(bool, Exit, std::string)>& add) {
  if (report.tests == nullptr) return;
  const std::vector<TestResult>& tests = report.tests->tests;
  add(report.tests->failed() > 0, Exit::Found, "a test fails");
  const bool isDecided = tests.empty() || std::ranges::any_of(tests, &TestResult::isDecided);
  add(!isDecided, Exit::Undecided, "no test expects anything");
}

}  // namespace

ExitReason exitReasonOf(const Report& report) {
  const Severity failLevel = report.failLevel.value_or(Severity::Warning);
  const auto fails = [&](const Finding& finding) { return finding.severity >= failLevel; };
  const Summary summary = summaryOf(report);
  const bool isUndecided = report.comparison && report.comparison->isUndecided();
  const bool differs = report.comparison && !report.comparison->equal && !isUndecided;
  ExitReason worst;
  const auto add = [&](bool applies, Exit exit, std::string text) {
    if (applies && (worst.text.empty() || (exit != worst.exit && worse(exit, worst.exit) == exit)))
      worst = {exit, std::move(text)};
  };
  add(std::ranges::any_of(report.findings, isReadError), Exit::Failed, "not everything could be read");
  add(!report.defects.empty(), Exit::Failed, "rungproof disagrees with itself");
  for (const ExitReason& reason : report.reasons) add(true, reason.exit, reason.text);
  const auto all = [&](Outcome verdict) {
    return static_cast<std::size_t>(std::ranges::count(report.properties, verdict, &PropertyResult::verdict));
  };
  const std::size_t vacuous = all(Outcome::Vacuous);
  add(summary.violated > vacuous, Exit::Found, "a property does not hold");
  add(vacuous > 0, Exit::Found, "the condition of a property never occurs");
  addTestReasons(report, add);
  add(differs, Exit::Found,
      report.comparison && report.comparison->isOfPrograms() ? "outputs differ" : "traces differ");
  add(std::ranges::any_of(report.findings, fails), Exit::Found,
      failLevel == Severity::Note ? "findings" : fmt::format("findings at or above '{}'", severityName(failLevel)));
  add(summary.undecided > 0 || isUndecided, Exit::Undecided, "something is undecided");
  add(!report.findings.empty(), Exit::Clean, fmt::format("findings below '{}' do not fail", severityName(failLevel)));
  if (report.exitsZero && worst.exit != Exit::Failed && worst.exit != Exit::Clean) return {Exit::Clean, "--exit-zero"};
  return worst;
}

void sortFindings(Report& report) {
  const auto key = [](const Finding& f) {
    return std::tuple(f.span.file, f.span.offset, -static_cast<int>(f.severity), std::string_view(f.rule),
                      std::string_view(f.message));
  };
  const auto isAscending = [&](const Finding& a, const Finding& b) { return !(key(a) < key(b)); };
  if (std::ranges::adjacent_find(report.findings, isAscending) == report.findings.end()) return;  // none twice, too
  // A finding is large: each is moved once.
  std::vector<std::uint32_t> order(report.findings.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return key(report.findings[i]); });
  std::vector<Finding> sorted;
  sorted.reserve(order.size());
  for (const std::uint32_t i : order) {
    if (sorted.empty() || key(sorted.back()) != key(report.findings[i]))
      sorted.push_back(std::move(report.findings[i]));
  }
  report.findings = std::move(sorted);
}

const Reporter* reporterNamed(std::string_view name) {
  for (const Reporter* reporter : allReporters()) {
    if (reporter->name == name) return reporter;
  }
  return nullptr;
}

}  // namespace rungproof
