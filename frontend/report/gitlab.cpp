// GitLab's code quality report: an array of issues that a merge request shows beside the changed lines. GitLab drops an
// issue whose fingerprint repeats, so that equal findings are told apart by their order.
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <ostream>

#include "frontend/files/json.hpp"
#include "frontend/linting/fingerprint.hpp"
#include "frontend/report_basis.hpp"
#include "frontend/test_results.hpp"
#include "frontend/testing/test_output.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

std::string_view gitlabSeverity(Severity severity) {
  return severity == Severity::Error ? "critical" : severity == Severity::Warning ? "major" : "info";
}

class IssueList {
 public:
  explicit IssueList(const Report& report) : report_(report) {}

  Json issues() {
    for (const Finding& finding : report_.findings) addFinding(finding);
    for (const PropertyResult& property : report_.properties) addProperty(property);
    if (report_.tests != nullptr) addTests(*report_.tests);
    if (report_.comparison && !report_.comparison->equal)
      add({.check = "comparison", .text = differenceText(*report_.comparison), .severity = "critical"},
          fingerprintOf({"comparison", report_.comparison->signal}));
    return std::move(issues_);
  }

 private:
  struct Issue {
    std::string check, text;
    std::string_view severity;
    std::string path = {};
    std::uint32_t line = 1;
    std::vector<std::string> remarks = {};
  };

  void addFinding(const Finding& finding) {
    const bool isOpen = finding.confirmation == Confirmation::Unconfirmed;
    Issue issue{std::string(finding.rule), withManualTitles(finding.message) + (isOpen ? " (unconfirmed)" : ""),
                isOpen ? "info" : gitlabSeverity(finding.severity)};
    setPlace(issue, finding.span);
    add(std::move(issue), fingerprintOf(finding, *report_.sources));
  }

  void addProperty(const PropertyResult& property) {
    const bool isGood = property.verdict == Outcome::Proved || property.verdict == Outcome::Reachable;
    if (isGood) return;
    const bool isBad = property.verdict == Outcome::Violated || property.verdict == Outcome::Unreachable ||
                       property.verdict == Outcome::Vacuous;
    Issue issue{"property",
                fmt::format("{}: {}{}{}", verdictText(property.verdict, property.depth), property.title(),
                            property.statement.empty() ? "" : ": ", property.statement),
                isBad ? "blocker" : "minor"};
    issue.remarks = remarksBesideRun(property);
    if (property.span) setPlace(issue, *property.span);
    add(std::move(issue), fingerprintOf({"property", property.program, property.name, property.statement}));
  }

  void addTests(const TestReport& tests) {
    for (const TestResult& test : tests.tests) {
      if (test.passed) continue;
      add({"test", fmt::format("{}: {}", test.name, testFailureText(test)), "critical", test.table,
           std::max(test.line, 1U)},
          fingerprintOf({"test", test.table, test.name}));
    }
  }

  void setPlace(Issue& issue, Span span) const {
    const SourceFile& file = report_.sources->file(span.file);
    issue.path = file.name();
    issue.line = file.position(span.offset).line;
  }

  /// What has no place of its own stands at the first line of the first file.
  void add(Issue issue, std::string fingerprint) {
    if (issue.path.empty() && report_.sources != nullptr && report_.sources->size() > 0)
      issue.path = report_.sources->file(0).name();
    const std::size_t before = seen_[fingerprint]++;
    if (before > 0) fingerprint = fingerprintOf({fingerprint, std::to_string(before)});
    if (issue.path.starts_with("./")) issue.path.erase(0, 2);
    Json json = {{"description", std::move(issue.text)},
                 {"check_name", std::move(issue.check)},
                 {"fingerprint", std::move(fingerprint)},
                 {"severity", issue.severity},
                 {"location", {{"path", std::move(issue.path)}, {"lines", {{"begin", issue.line}}}}}};
    if (!issue.remarks.empty()) json["content"] = {{"body", fmt::format("{}", fmt::join(issue.remarks, "\n"))}};
    issues_.push_back(std::move(json));
  }

  const Report& report_;
  Json issues_ = Json::array();
  std::map<std::string, std::size_t> seen_;
};

void writeGitlabReport(const Report& report, const ReportStyle&, std::ostream& out) {
  out << IssueList(report).issues().dump(2) << '\n';
}

}  // namespace

extern constexpr Reporter gitlabReport = {
    .name = "gitlab", .summary = "code quality report of GitLab merge requests", .write = writeGitlabReport};

}  // namespace rungproof
