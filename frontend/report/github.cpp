// Workflow commands that GitHub Actions shows as annotations on the changed lines.
#include <fmt/ranges.h>

#include <ostream>

#include "frontend/report_basis.hpp"
#include "frontend/text/safe_text.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

std::string_view githubLevel(Severity severity) {
  return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "notice";
}

void writeGithubReport(const Report& report, const ReportStyle&, std::ostream& out) {
  for (const Finding& finding : report.findings) {
    const SourceFile& file = report.sources->file(finding.span.file);
    const Position begin = file.position(finding.span.offset);
    const Position end = file.position(finding.span.offset + finding.span.length);
    out << fmt::format("::{} file={},line={},endLine={},col={},title={}::{}{}\n", githubLevel(finding.severity),
                       workflowText(file.name(), true), begin.line, end.line, begin.column,
                       workflowText(finding.rule, true), workflowText(withManualTitles(finding.message), false),
                       finding.confirmation == Confirmation::Unconfirmed ? " (unconfirmed)" : "");
  }
  for (const PropertyResult& property : report.properties) {
    const bool good = property.verdict == Outcome::Proved || property.verdict == Outcome::Reachable;
    const std::vector<std::string> remarks = remarksBesideRun(property);
    const bool isPlain = property.notes.empty() && property.assumptions.empty();
    if (good && isPlain) continue;
    std::string place;
    if (property.span) {
      const SourceFile& file = report.sources->file(property.span->file);
      place =
          fmt::format("file={},line={},", workflowText(file.name(), true), file.position(property.span->offset).line);
    }
    const bool isOpen = property.verdict == Outcome::Unknown || property.verdict == Outcome::HoldsToBound ||
                        property.verdict == Outcome::NotCovered;
    std::string text = property.title();
    if (!property.statement.empty()) text += ": " + property.statement;
    for (const std::string& line : property.run) text += '\n' + line;
    for (const std::string& line : remarks) text += '\n' + line;
    out << fmt::format("::{} {}title={}::{}\n",
                       good     ? "notice"
                       : isOpen ? "warning"
                                : "error",
                       place, workflowText(verdictText(property.verdict, property.depth), true),
                       workflowText(text, false));
  }
  if (report.comparison && !report.comparison->equal) {
    const std::string& verdict = report.comparison->verdict;
    out << fmt::format("::error title={}::{}\n", verdict.empty() ? "traces differ" : verdict,
                       workflowText(differenceText(*report.comparison), false));
  }
  if (const std::vector<std::string> basis = basisOf(report); !basis.empty())
    out << fmt::format("::notice title=what this rests on::{}\n",
                       workflowText(fmt::format("{}", fmt::join(basis, "\n")), false));
}

}  // namespace

extern constexpr Reporter githubReport = {
    .name = "github", .summary = "annotations of GitHub Actions", .write = writeGithubReport};

}  // namespace rungproof
