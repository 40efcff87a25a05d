// One line for each result, "file:line:col: error[ADR001] message", for editors, grep and problem matchers.
#include <fmt/ranges.h>

#include <ostream>

#include "analysis/rule.hpp"
#include "frontend/report.hpp"
#include "frontend/testing/test_output.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

void writeConciseReport(const Report& report, const ReportStyle& style, std::ostream& out) {
  const Paint paint{style.color};
  for (const Finding& finding : report.findings) {
    const std::string head = fmt::format("{}[{}]", severityName(finding.severity), finding.rule);
    out << fmt::format("{}: {} {}{}{}\n", messageText(placeText(*report.sources, finding.span)),
                       finding.severity == Severity::Error ? paint.red(head) : paint.yellow(head),
                       messageText(withManualTitles(finding.message)),
                       finding.confirmation == Confirmation::Unconfirmed ? " (unconfirmed)" : "",
                       finding.trace.empty() ? std::string() : fmt::format(" ({})", messageText(finding.trace)));
  }
  for (const PropertyResult& property : report.properties) {
    const std::string place = property.span ? placeText(*report.sources, *property.span) + ": " : std::string();
    const std::string assumed =
        property.assumptions.empty() ? "" : fmt::format(" (assumes: {})", fmt::join(property.assumptions, "; "));
    out << fmt::format("{}{} {}{}{}\n", messageText(place), verdictText(property.verdict, property.depth),
                       messageText(property.title()),
                       property.trace.empty() ? "" : " (" + messageText(property.trace) + ")", messageText(assumed));
  }
  if (report.tests != nullptr) {
    for (const TestResult& test : report.tests->tests)
      out << fmt::format("{}{}: {} {}{}\n", messageText(test.table),
                         test.line != 0 ? fmt::format(":{}", test.line) : "", test.passed ? "passed" : "failed",
                         messageText(test.name), test.passed ? "" : ": " + messageText(testFailureText(test)));
  }
  for (const std::string& line : report.coverage.leftOut) out << fmt::format("left out: {}\n", messageText(line));
  if (report.comparison && report.comparison->isOfPrograms())
    out << report.comparison->verdict << (report.comparison->equal ? "\n" : " ");
  if (report.comparison && !report.comparison->equal) out << messageText(differenceText(*report.comparison)) << '\n';
}

}  // namespace

extern constexpr Reporter conciseReport = {
    .name = "concise", .summary = "one line for each result", .write = writeConciseReport};

}  // namespace rungproof
