// JUnit XML: a test suite for each file (findings) and one for the properties, as CI servers read it.
#include <fmt/ranges.h>

#include <algorithm>
#include <ostream>
#include <pugixml.hpp>

#include "analysis/rule.hpp"
#include "frontend/report_basis.hpp"
#include "frontend/report_part.hpp"
#include "frontend/testing/test_output.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

pugi::xml_node addCase(pugi::xml_node suite, const std::string& className, const std::string& name, double seconds) {
  pugi::xml_node test = suite.append_child("testcase");
  test.append_attribute("classname") = lineText(className).c_str();
  test.append_attribute("name") = lineText(name).c_str();
  test.append_attribute("time") = fmt::format("{:.3f}", seconds).c_str();
  return test;
}

/// `text`: lines that are safe.
void addFailure(pugi::xml_node test, const std::string& type, const std::string& message, const std::string& text) {
  pugi::xml_node failure = test.append_child("failure");
  failure.append_attribute("type") = type.c_str();
  failure.append_attribute("message") = lineText(message).c_str();
  failure.text() = text.c_str();
}

void setCounts(pugi::xml_node node, std::size_t tests, std::size_t failures, std::size_t skipped) {
  node.append_attribute("tests") = static_cast<unsigned long long>(tests);
  node.append_attribute("failures") = static_cast<unsigned long long>(failures);
  node.append_attribute("errors") = 0;
  if (node.name() == std::string_view("testsuite"))
    node.append_attribute("skipped") = static_cast<unsigned long long>(skipped);
}

/// Remarks of a case or of a suite, a line each.
void addOutput(pugi::xml_node node, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::vector<std::string> safe;
  for (const std::string& line : lines) safe.push_back(lineText(line));
  node.append_child("system-out").text() = fmt::format("{}", fmt::join(safe, "\n")).c_str();
}

class JunitWriter {
 public:
  JunitWriter(const Report& report, pugi::xml_node root) : report_(report), root_(root) {}

  void write() {
    for (std::uint32_t file = 0; report_.sources != nullptr && file < report_.sources->size(); ++file) writeFile(file);
    writeProperties();
    writeComparison();
    if (report_.tests != nullptr) writeTests(*report_.tests);
    if (report_.properties.empty() && !report_.comparison) writeBasis();
    if (report_.part) writePart();
    setCounts(root_, tests_, failures_, 0);
  }

 private:
  void writePart() {
    pugi::xml_node mark = root_.child("testsuite").prepend_child("properties").append_child("property");
    mark.append_attribute("name") = "shard";
    mark.append_attribute("value") = partJson(report_).dump(-1, true).c_str();
  }

  /// A file without findings is one passed case, so that it does not vanish from the statistics; where tests are
  /// counted it is none.
  void writeFile(std::uint32_t file) {
    const std::string& name = report_.sources->file(file).name();
    const bool isClean = std::ranges::none_of(report_.findings, [&](const Finding& f) { return f.span.file == file; });
    if (isClean && report_.tests != nullptr && !report_.tests->tests.empty()) return;
    pugi::xml_node suite = root_.append_child("testsuite");
    suite.append_attribute("name") = lineText(name).c_str();
    std::size_t count = 0;
    for (const Finding& finding : report_.findings) {
      if (finding.span.file != file) continue;
      const Position place = report_.sources->position(finding.span);
      pugi::xml_node test =
          addCase(suite, name, fmt::format("{} line {} column {}", finding.rule, place.line, place.column), 0);
      std::string text = fmt::format("{}: {}", lineText(placeText(*report_.sources, finding.span)),
                                     lineText(withManualTitles(finding.message)));
      if (finding.confirmation == Confirmation::Unconfirmed) text += " (unconfirmed)";
      if (!finding.help.empty()) text += "\nhelp: " + lineText(withManualTitles(finding.help));
      const bool isOpen = finding.confirmation == Confirmation::Unconfirmed;
      addFailure(test, std::string(severityName(finding.severity)),
                 withManualTitles(finding.message) + (isOpen ? " (unconfirmed)" : ""), text);
      ++count;
    }
    if (count == 0) addCase(suite, name, report_.command, 0);
    setCounts(suite, std::max<std::size_t>(count, 1), count, 0);
    tests_ += std::max<std::size_t>(count, 1);
    failures_ += count;
  }

  void writeProperties() {
    if (report_.properties.empty()) return;
    pugi::xml_node suite = root_.append_child("testsuite");
    suite.append_attribute("name") = "properties";
    std::size_t failed = 0;
    std::size_t skipped = 0;
    for (const PropertyResult& property : report_.properties) {
      pugi::xml_node test =
          addCase(suite, property.program.empty() ? "properties" : property.program, property.name, property.seconds);
      const std::string verdict = verdictText(property.verdict, property.depth);
      std::vector<std::string> lines;
      for (const std::string& line : property.run) lines.push_back(lineText(line));
      switch (property.verdict) {
        case Outcome::Proved:
        case Outcome::Reachable: break;
        case Outcome::Violated:
        case Outcome::Unreachable:
        case Outcome::Vacuous:
          addFailure(
              test, verdict, property.statement.empty() ? property.name : property.statement,
              fmt::format("{}{}{}", fmt::join(lines, "\n"), lines.empty() ? "" : "\n", lineText(property.trace)));
          ++failed;
          break;
        default: test.append_child("skipped").append_attribute("message") = verdict.c_str(); ++skipped;
      }
      addOutput(test, remarksBesideRun(property));
    }
    addOutput(suite, basisOf(report_));
    setCounts(suite, report_.properties.size(), failed, skipped);
    tests_ += report_.properties.size();
    failures_ += failed;
  }

  /// What the answers of lint --prove rest on.
  void writeBasis() {
    const std::vector<std::string> lines = basisOf(report_);
    if (lines.empty()) return;
    pugi::xml_node suite = root_.append_child("testsuite");
    suite.append_attribute("name") = "basis";
    addCase(suite, "basis", report_.command, 0);
    addOutput(suite, lines);
    setCounts(suite, 1, 0, 0);
    ++tests_;
  }

  void writeComparison() {
    if (!report_.comparison) return;
    const Comparison& c = *report_.comparison;
    pugi::xml_node suite = root_.append_child("testsuite");
    suite.append_attribute("name") = "comparison";
    pugi::xml_node test = addCase(suite, "comparison", report_.command, 0);
    const bool isFailed = !c.equal && !c.isUndecided();
    if (c.isUndecided()) test.append_child("skipped").append_attribute("message") = lineText(differenceText(c)).c_str();
    if (isFailed) addFailure(test, "difference", differenceText(c), "");
    addOutput(test, c.notes);
    if (c.isOfPrograms()) addOutput(suite, basisOf(report_));
    failures_ += isFailed ? 1 : 0;
    setCounts(suite, 1, isFailed ? 1 : 0, c.isUndecided() ? 1 : 0);
    ++tests_;
  }

  /// A suite for each table.
  void writeTests(const TestReport& report) {
    for (std::size_t begin = 0; begin < report.tests.size();) {
      const std::string& table = report.tests[begin].table;
      pugi::xml_node suite = root_.append_child("testsuite");
      suite.append_attribute("name") = lineText(table).c_str();
      std::size_t count = 0, failed = 0, skipped = 0;
      for (; begin < report.tests.size() && report.tests[begin].table == table; ++begin, ++count) {
        const TestResult& result = report.tests[begin];
        pugi::xml_node test = addCase(suite, table, result.name, 0);
        if (!result.passed) {
          addFailure(test, "expectation", testFailureText(result),
                     fmt::format("scan {}, {} ms", result.scan, plainNumber(result.timeMs)));
          ++failed;
        } else if (!result.isDecided) {
          test.append_child("skipped").append_attribute("message") = "nothing is expected";
          ++skipped;
        }
      }
      setCounts(suite, count, failed, skipped);
      tests_ += count;
      failures_ += failed;
    }
  }

  const Report& report_;
  pugi::xml_node root_;
  std::size_t tests_ = 0;
  std::size_t failures_ = 0;
};

void writeJunitReport(const Report& report, const ReportStyle&, std::ostream& out) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("testsuites");
  root.append_attribute("name") = "rungproof";
  JunitWriter(report, root).write();
  document.save(out, "  ");
}

}  // namespace

extern constexpr Reporter junitReport = {
    .name = "junit", .summary = "JUnit XML for CI servers", .write = writeJunitReport};

}  // namespace rungproof
