// Tests and measures as text, JSON and HTML.
#include "frontend/testing/test_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "frontend/acceptance/page_style.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/picture/svg_picture.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostMissingInText = 40;

std::string_view stateName(MissingGoal::State state) {
  return state == MissingGoal::State::Unreachable ? "impossible"
         : state == MissingGoal::State::Open      ? "open"
                                                  : "missing";
}

std::string aroundText(const TestResult& test, const Paint& paint) {
  if (test.around.empty()) return "";
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < test.columns.size(); ++i) {
    std::size_t width = test.columns[i].size();
    for (const TestResult::Scan& scan : test.around) width = std::max(width, scan.values[i].size());
    widths.push_back(width);
  }
  const auto line = [&](const std::string& scan, const std::string& time, const std::vector<std::string>& cells) {
    std::string text = fmt::format("  {:>8}  {:>8}", scan, time);
    for (std::size_t i = 0; i < cells.size(); ++i) text += fmt::format("  {:>{}}", messageText(cells[i]), widths[i]);
    return text;
  };
  std::string text = line("scan", "ms", test.columns) + "\n";
  for (const TestResult::Scan& scan : test.around) {
    const bool isHere = scan.scan == test.scan;
    const std::string row =
        line(fmt::format("{}{}", isHere ? "> " : "", scan.scan), plainNumber(scan.timeMs), scan.values);
    text += (isHere ? paint.red(row) : row) + "\n";
  }
  return text;
}

/// That the step is one of those that other scans fail; empty for all others.
std::string timingText(const TestResult& test) {
  return test.timing.empty() ? "" : fmt::format("the step is marked '{}': with other scans it may pass", test.timing);
}

std::string killText(const std::vector<PlantedFault>& faults, const Paint& paint) {
  const FaultCounts count = countsOf(faults);
  const std::size_t matter = count.noticed + count.unnoticed;
  std::string text =
      fmt::format("\n{}: {} of {} planted faults that change what the program does are noticed by a test",
                  paint.bold("kill"), count.noticed, matter);
  if (matter > 0)
    text += fmt::format(" ({:.0f} %)", 100.0 * static_cast<double>(count.noticed) / static_cast<double>(matter));
  text += fmt::format("; {} change nothing, {} undecided\n", count.withoutEffect, count.undecided);
  for (const std::string_view fate : {"unnoticed", "undecided"}) {
    for (const PlantedFault& fault : faults) {
      if (fault.fate != fate) continue;
      text += fmt::format("  {}: {}:{} in {}, network {}: {}: {}{}\n",
                          fate == "unnoticed" ? paint.red(fate) : paint.yellow(fate), messageText(fault.file),
                          fault.line, messageText(fault.pou), fault.network, fault.kind, messageText(fault.text),
                          fault.differs.empty() ? "" : "; other value of " + fault.differs);
    }
  }
  return text;
}

std::string coverageText(const CoverageResult& coverage, const Paint& paint) {
  std::string text = fmt::format("\n{}\n", paint.bold("coverage"));
  for (const auto& [which, measure] : coverage.measures) {
    text += fmt::format("  {:<12} {:>5} of {}", measureText(which), measure.covered, measure.total);
    if (measure.unreachable > 0) text += fmt::format(", {} proved impossible", measure.unreachable);
    if (measure.open > 0) text += fmt::format(", {} not covered", measure.open);
    if (which == Measure::Mcdc && measure.covered > 0)
      text += fmt::format("; {} by unique cause, {} by masking", coverage.uniqueCause, coverage.masking);
    text += "\n";
  }
  for (const auto& [which, measure] : coverage.measures) {
    std::size_t shown = 0;
    for (const MissingGoal& goal : measure.missing) {
      if (++shown > mostMissingInText) {
        text += fmt::format("  ... {} more of {} in the JSON report\n", measure.missing.size() - mostMissingInText,
                            measureText(which));
        break;
      }
      const std::string_view state = stateName(goal.state);
      text += fmt::format("  {} {}: {}: {}\n",
                          goal.state == MissingGoal::State::Unreachable ? paint.cyan(state) : paint.yellow(state),
                          measureText(which), messageText(goal.text), messageText(goal.reason));
    }
  }
  return text;
}

}  // namespace

std::size_t TestReport::failed() const {
  return static_cast<std::size_t>(std::ranges::count(tests, false, &TestResult::passed));
}

std::size_t TestReport::openGoals() const {
  if (!coverage) return 0;
  std::size_t open = 0;
  for (const auto& [which, measure] : coverage->measures) {
    if (asked.contains(which)) open += measure.open;
  }
  return open;
}

std::string testFailureText(const TestResult& test) {
  std::string text = fmt::format("step {}", test.step.value_or(0));
  if (!test.stepText.empty()) text += fmt::format(" '{}'", test.stepText);
  if (test.line != 0) text += fmt::format(" (line {})", test.line);
  if (!test.reason.empty())
    text += ": " + test.reason;
  else
    text += fmt::format(": {} expected {}, actual {}", test.signal, test.expected, test.actual);
  return test.timing.empty() ? text : text + "; " + timingText(test);
}

std::string testText(const TestReport& report, const Paint& paint, bool isQuiet) {
  std::string text;
  std::size_t width = 4;
  for (const TestResult& test : report.tests)
    width = std::max<std::size_t>(width, static_cast<std::size_t>(displayWidth(test.name)));
  std::string table;
  for (const TestResult& test : report.tests) {
    if (test.table != table) text += fmt::format("{}\n", paint.bold(messageText(table = test.table)));
    const std::string padding(width - static_cast<std::size_t>(displayWidth(test.name)), ' ');
    const std::string verdict = !test.passed      ? paint.red("FAILED")
                                : !test.isDecided ? paint.yellow("open  ")
                                                  : paint.green("passed");
    text += fmt::format("  {}  {}{}  {} step{}{}\n", verdict, messageText(test.name), padding, test.steps,
                        test.steps == 1 ? "" : "s", test.isDecided || !test.passed ? "" : "; nothing is expected");
    if (test.passed) continue;
    text += fmt::format("  {} {}; scan {}, {} ms\n", paint.blue("="), messageText(testFailureText(test)), test.scan,
                        plainNumber(test.timeMs));
    text += aroundText(test, paint);
    for (const ShownScan& scan : test.shown) {
      for (const ShownNetwork& network : scan.networks) {
        if (network.text.empty()) continue;
        text += fmt::format("\n  {}\n", messageText(network.heading));
        for (const std::string& line : network.text) text += fmt::format("  {}\n", line);
      }
    }
  }
  if (report.coverage) text += coverageText(*report.coverage, paint);
  if (report.kills) text += killText(*report.kills, paint);
  if (!report.written.empty()) {
    text += "\n";
    for (const std::string& file : report.written) text += fmt::format("written: {}\n", messageText(file));
  }
  if (isQuiet || report.tests.empty()) return text;
  const std::size_t failed = report.failed();
  text += fmt::format("\n{} test{}, {} failed\n", report.tests.size(), report.tests.size() == 1 ? "" : "s", failed);
  return text;
}

Json testsJson(const TestReport& report) {
  const auto textOrNone = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  Json rows = Json::array();
  for (const TestResult& test : report.tests) {
    Json row = {{"name", test.name},
                {"table", test.table},
                {"steps", test.steps},
                {"passed", test.passed},
                {"step", test.step ? Json(*test.step) : Json(nullptr)},
                {"signal", textOrNone(test.signal)},
                {"expected", textOrNone(test.expected)},
                {"actual", textOrNone(test.actual)}};
    if (!test.passed) {
      row["line"] = test.line;
      row["scan"] = test.scan;
      row["reason"] = textOrNone(!test.reason.empty() ? test.reason : timingText(test));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

void addMeasures(Json& json, const CoverageResult& coverage) {
  for (const auto& [which, measure] : coverage.measures) {
    Json names = Json::array(), goals = Json::array();
    for (const MissingGoal& goal : measure.missing) {
      if (goal.state != MissingGoal::State::Unreachable) names.push_back(goal.text);
      Json one = {{"goal", goal.text}, {"state", stateName(goal.state)}, {"reason", goal.reason}};
      if (!goal.certificate.empty()) one["certificate"] = goal.certificate;
      goals.push_back(std::move(one));
    }
    json[std::string(measureWord(which))] = {{"covered", measure.covered},         {"total", measure.total},
                                             {"unreachable", measure.unreachable}, {"open", measure.open},
                                             {"missing", std::move(names)},        {"goals", std::move(goals)}};
  }
  json["mcdc"]["unique_cause"] = coverage.uniqueCause;
  json["mcdc"]["masking"] = coverage.masking;
}

namespace {

std::string pageHead(std::string_view title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>{0}</title>\n<style>{1}{2}</style></head><body>\n<h1>{0}</h1>\n",
      xmlText(title), pageStyle(), svgStyle());
}

std::string coverageSection(const CoverageResult& coverage, const std::string& drawings) {
  std::string text =
      "<h2>Coverage</h2>\n<table><thead><tr><th>Measure</th><th>Covered</th><th>Of</th><th>Impossible</th>"
      "<th>Open</th></tr></thead><tbody>\n";
  for (const auto& [which, measure] : coverage.measures)
    text += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", measureText(which),
                        measure.covered, measure.total, measure.unreachable, measure.open);
  text += "</tbody></table>\n";
  for (const auto& [which, measure] : coverage.measures) {
    if (measure.missing.empty()) continue;
    text += fmt::format("<h3>Not covered: {}</h3>\n<ul>\n", measureText(which));
    for (const MissingGoal& goal : measure.missing) {
      const std::string proof =
          goal.certificate.empty() ? "" : fmt::format(" <a href=\"{0}\">{0}</a>", xmlText(goal.certificate));
      text += fmt::format("<li><b>{}</b> {}: {}{}</li>\n", stateName(goal.state), xmlText(goal.text),
                          xmlText(goal.reason), proof);
    }
    text += "</ul>\n";
  }
  return text + drawings;
}

}  // namespace

std::string coveragePage(const CoverageResult& coverage, const std::string& drawings, std::string_view title) {
  return pageHead(fmt::format("Coverage of the tests: {}", title)) + coverageSection(coverage, drawings) +
         "</body></html>\n";
}

void writeTestPage(const Report& report, const TestReport& tests, std::ostream& out) {
  out << pageHead("Tests");
  out << fmt::format("<p>{} tests, <b class=\"{}\">{} failed</b>. rungproof {}.</p>\n", tests.tests.size(),
                     tests.failed() > 0 ? "bad" : "good", tests.failed(), xmlText(programVersion()));
  out << "<table><thead><tr><th>Test</th><th>Table</th><th>Steps</th><th>Result</th></tr></thead><tbody>\n";
  for (const TestResult& test : tests.tests)
    out << fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"{}\">{}</td></tr>\n", xmlText(test.name),
                       xmlText(test.table), test.steps, test.passed ? "good" : "bad",
                       !test.passed     ? xmlText(testFailureText(test))
                       : test.isDecided ? "passed"
                                        : "nothing is expected");
  out << "</tbody></table>\n";
  for (const TestResult& test : tests.tests) {
    if (test.passed) continue;
    out << fmt::format(
        "<h2>{}</h2>\n<p class=\"bad\">{}; scan {}, {} ms</p>\n<table><thead><tr><th>scan</th><th>ms</th>",
        xmlText(test.name), xmlText(testFailureText(test)), test.scan, plainNumber(test.timeMs));
    for (const std::string& column : test.columns) out << fmt::format("<th>{}</th>", xmlText(column));
    out << "</tr></thead><tbody>\n";
    for (const TestResult::Scan& scan : test.around) {
      out << fmt::format("<tr{}><td>{}</td><td>{}</td>", scan.scan == test.scan ? " class=\"bad\"" : "", scan.scan,
                         plainNumber(scan.timeMs));
      for (const std::string& value : scan.values) out << fmt::format("<td>{}</td>", xmlText(value));
      out << "</tr>\n";
    }
    out << "</tbody></table>\n";
    for (const ShownScan& scan : test.shown) {
      for (const ShownNetwork& network : scan.networks)
        out << fmt::format("<div class=\"drawn\"><h3>{}</h3>{}</div>\n", xmlText(network.heading), network.svg);
    }
  }
  if (tests.coverage) out << coverageSection(*tests.coverage, tests.drawings);
  for (const std::string& line : report.assumptions) out << fmt::format("<p>{}</p>\n", xmlText(line));
  out << "</body></html>\n";
}

}  // namespace rungproof
