// One description of each row; two ways to write it down.
#include "frontend/testing/test_sheet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "frontend/cli/cli.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

std::string seenValue(const TraceSignal& signal, const TestRange& range) {
  if (signal.type != SignalType::Bool) return rangeText(range, signal.type);
  return range.low == 0 ? "off" : "on";
}

/// What must be seen after a row: what has changed, and that the rest has not.
struct Sight {
  std::vector<std::string> changed;
  std::size_t same = 0;  ///< outputs that are to be as before
};

std::vector<Sight> sightsOf(const TestTable& table, const TestCase& test) {
  std::vector<Sight> sights;
  std::vector<std::optional<TestRange>> before(table.expects.size(), TestRange{0, 0});
  for (const TestRow& row : test.rows) {
    Sight& sight = sights.emplace_back();
    for (std::size_t i = 0; i < table.expects.size(); ++i) {
      const std::optional<TestRange>& now = row.expects[i];
      if (!now) {
        before[i].reset();  // not known: seen again where it is expected next
        continue;
      }
      const bool isSame = before[i] && before[i]->low == now->low && before[i]->high == now->high;
      if (isSame)
        ++sight.same;
      else
        sight.changed.push_back(fmt::format("{} {}", signalText(table.expects[i]), seenValue(table.expects[i], *now)));
      before[i] = now;
    }
  }
  return sights;
}

std::string sightText(const Sight& sight, bool isFirst) {
  if (sight.changed.empty()) return sight.same == 0 ? "" : isFirst ? "all outputs off" : "nothing changes";
  return fmt::format("{}{}", fmt::join(sight.changed, "; "),
                     sight.same == 0 ? ""
                     : isFirst       ? "; all else off"
                                     : "; all else as before");
}

/// A wait at the machine: scans are too short to be counted by hand, and none is longer than 100 ms.
std::string waitForPeople(const TestWait& wait) {
  if (wait.isTime()) return fmt::format("{:g} s", static_cast<double>(wait.timeUs) / 1e6);
  return wait.scans == 1   ? "at once"
         : wait.scans <= 8 ? "0.5 s"
                           : fmt::format("{:g} s", static_cast<double>(wait.scans) / 10);
}

struct SheetRow {
  std::string action, wait, seen, remark;
};

std::vector<SheetRow> sheetRowsOf(const TestTable& table, const TestCase& test) {
  std::vector<SheetRow> rows;
  const std::vector<Sight> sights = sightsOf(table, test);
  for (std::size_t i = 0; i < test.rows.size(); ++i) {
    const TestRow& row = test.rows[i];
    rows.push_back({row.step, waitForPeople(row.wait), sightText(sights[i], i == 0), row.note});
  }
  return rows;
}

/// Names of the requirements that the test exercises.
std::string requirementsOf(const TestSheet& sheet, const std::string& test) {
  std::vector<std::string> names;
  for (const SheetRequirement& requirement : sheet.requirements) {
    if (std::ranges::find(requirement.tests, test) != requirement.tests.end()) names.push_back(requirement.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

constexpr std::string_view sheetStyle = R"(
@page { size: A4; margin: 14mm 12mm; }
body { font: 10.5pt/1.35 "DejaVu Sans", Arial, sans-serif; color: #111; max-width: 186mm; margin: 1em auto; }
h1 { font-size: 17pt; margin: 0 0 .2em; } h2 { font-size: 12.5pt; margin: 1.2em 0 .2em; break-after: avoid; }
p { margin: .25em 0; } .small { font-size: 8.5pt; color: #444; overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; margin: .4em 0; } th, td { border: 1px solid #777; padding: 2px 5px; text-align: left; vertical-align: top; }
th { background: #eceff3; font-weight: 600; } tr { break-inside: avoid; } thead { display: table-header-group; }
td.n, td.w { white-space: nowrap; text-align: right; } td.box { width: 9mm; text-align: center; font-size: 14pt; line-height: 1; } td.remark { width: 30mm; font-size: 8.5pt; }
.signature { display: flex; gap: 8mm; margin: .5em 0 1em; break-inside: avoid; } .signature span { flex: 1; border-bottom: 1px solid #333; padding-top: 6mm; font-size: 8.5pt; color: #444; }
.missing { color: #a00; } a { color: inherit; }
)";

std::string figuresText(Measure which, const MeasureResult& measure) {
  std::string text = fmt::format("{} of {} {}", measure.covered, measure.total, measureText(which));
  if (measure.unreachable > 0) text += fmt::format(" ({} proved impossible)", measure.unreachable);
  if (measure.open > 0) text += fmt::format(" ({} open)", measure.open);
  return text;
}

}  // namespace

namespace {

std::string linkedNetworks(const TestSheet& sheet, const std::vector<std::string>& names) {
  std::vector<std::string> shown;
  for (const std::string& name : names) {
    const auto link = sheet.links.find(name);
    shown.push_back(link == sheet.links.end()
                        ? xmlText(name)
                        : fmt::format("<a href=\"{}\">{}</a>", xmlText(link->second), xmlText(name)));
  }
  return fmt::format("{}", fmt::join(shown, ", "));
}

}  // namespace

std::string sheetHtml(const TestSheet& sheet) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Acceptance test {0}</title>\n"
      "<style>{1}</style></head><body>\n<h1>Acceptance test: {0}</h1>\n",
      xmlText(sheet.title), sheetStyle);
  text += fmt::format("<p class=\"small\">Program SHA-256 {}<br>rungproof {}</p>\n", xmlText(sheet.hash),
                      xmlText(programVersion()));
  for (const std::string& line : sheet.basis) text += fmt::format("<p class=\"small\">{}</p>\n", xmlText(line));
  text +=
      "<p>Each test begins with power-on and all inputs off. Do the steps in their order. After each wait compare "
      "what is seen, tick the box, or write what was seen instead.</p>\n";
  text += "<table><thead><tr><th>Signal</th><th>Terminal</th><th>What it is</th></tr></thead><tbody>\n";
  for (const SheetSignal& signal : sheet.signals)
    text += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", xmlText(signal.symbol), xmlText(signal.address),
                        xmlText(signal.comment));
  text += "</tbody></table>\n";
  for (std::size_t i = 0; i < sheet.table.tests.size(); ++i) {
    const TestCase& test = sheet.table.tests[i];
    text +=
        fmt::format("<h2 id=\"{0}\">{0}</h2>\n<p>Purpose: {1}.</p>\n", xmlText(test.name), xmlText(sheet.purposes[i]));
    if (const std::string required = requirementsOf(sheet, test.name); !required.empty())
      text += fmt::format("<p class=\"small\">Requirements: {}</p>\n", xmlText(required));
    if (!sheet.networks[i].empty())
      text += fmt::format("<p class=\"small\">Networks: {}</p>\n", linkedNetworks(sheet, sheet.networks[i]));
    text +=
        "<table><thead><tr><th>Step</th><th>Action</th><th>Wait</th><th>Must be seen</th><th>OK</th><th>Remark</th>"
        "</tr></thead><tbody>\n";
    std::size_t number = 0;
    for (const SheetRow& row : sheetRowsOf(sheet.table, test))
      text += fmt::format(
          "<tr><td class=\"n\">{}</td><td>{}</td><td class=\"w\">{}</td><td>{}</td><td class=\"box\">"
          "&#9744;</td><td class=\"remark\">{}</td></tr>\n",
          ++number, xmlText(row.action), row.wait, xmlText(row.seen), xmlText(row.remark));
    text +=
        "</tbody></table>\n<div class=\"signature\"><span>Date</span><span>Name</span><span>Signature</span></div>\n";
  }
  if (!sheet.requirements.empty()) {
    text +=
        "<h2>Requirements</h2>\n<table><thead><tr><th>Requirement</th><th>Statement</th><th>Tests</th></tr></"
        "thead><tbody>\n";
    for (const SheetRequirement& requirement : sheet.requirements)
      text += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", xmlText(requirement.name),
                          xmlText(requirement.text),
                          requirement.tests.empty() ? "<span class=\"missing\">no test exercises it</span>"
                                                    : xmlText(fmt::format("{}", fmt::join(requirement.tests, ", "))));
    text += "</tbody></table>\n";
  }
  text += "<h2>Coverage</h2>\n<ul>\n";
  for (const auto& [which, measure] : sheet.coverage.measures)
    text += fmt::format("<li>{}</li>\n", figuresText(which, measure));
  text += "</ul>\n";
  for (const auto& [which, measure] : sheet.coverage.measures) {
    for (const MissingGoal& goal : measure.missing)
      text += fmt::format("<p class=\"small\">Not covered, {}: {}: {}</p>\n", measureText(which), xmlText(goal.text),
                          xmlText(goal.reason));
  }
  return text + "</body></html>\n";
}

namespace {

/// A cell of a Markdown table.
std::string markdownCell(std::string_view text) {
  std::string result;
  for (const char c : lineText(text)) {
    if (c == '|' || c == '<' || c == '*' || c == '_' || c == '`' || c == '[') result += '\\';
    result += c;
  }
  return result;
}

}  // namespace

std::string sheetMarkdown(const TestSheet& sheet) {
  std::string text = fmt::format("# Acceptance test: {}\n\nProgram SHA-256 `{}`, rungproof {}\n\n",
                                 markdownCell(sheet.title), sheet.hash, programVersion());
  for (const std::string& line : sheet.basis) text += markdownCell(line) + "\n\n";
  text += "| Signal | Terminal | What it is |\n|---|---|---|\n";
  for (const SheetSignal& signal : sheet.signals)
    text += fmt::format("| {} | {} | {} |\n", markdownCell(signal.symbol), markdownCell(signal.address),
                        markdownCell(signal.comment));
  text += "\n";
  for (std::size_t i = 0; i < sheet.table.tests.size(); ++i) {
    const TestCase& test = sheet.table.tests[i];
    text += fmt::format("## {}\n\nPurpose: {}.\n\n", markdownCell(test.name), markdownCell(sheet.purposes[i]));
    if (const std::string required = requirementsOf(sheet, test.name); !required.empty())
      text += fmt::format("Requirements: {}\n\n", markdownCell(required));
    if (!sheet.networks[i].empty())
      text += fmt::format("Networks: {}\n\n", markdownCell(fmt::format("{}", fmt::join(sheet.networks[i], ", "))));
    text += "| Step | Action | Wait | Must be seen | OK | Remark |\n|---:|---|---:|---|:---:|---|\n";
    std::size_t number = 0;
    for (const SheetRow& row : sheetRowsOf(sheet.table, test))
      text += fmt::format("| {} | {} | {} | {} | ☐ | {} |\n", ++number, markdownCell(row.action), row.wait,
                          markdownCell(row.seen), markdownCell(row.remark));
    text += "\nDate: ____________ Name: ____________ Signature: ____________\n\n";
  }
  if (!sheet.requirements.empty()) {
    text += "## Requirements\n\n| Requirement | Statement | Tests |\n|---|---|---|\n";
    for (const SheetRequirement& requirement : sheet.requirements)
      text +=
          fmt::format("| {} | {} | {} |\n", markdownCell(requirement.name), markdownCell(requirement.text),
                      requirement.tests.empty() ? "no test exercises it"
                                                : markdownCell(fmt::format("{}", fmt::join(requirement.tests, ", "))));
    text += "\n";
  }
  text += "## Coverage\n\n";
  for (const auto& [which, measure] : sheet.coverage.measures)
    text += fmt::format("- {}\n", figuresText(which, measure));
  for (const auto& [which, measure] : sheet.coverage.measures) {
    for (const MissingGoal& goal : measure.missing)
      text += fmt::format("- not covered, {}: {}: {}\n", measureText(which), markdownCell(goal.text),
                          markdownCell(goal.reason));
  }
  return text;
}

std::string sheetCsv(const TestSheet& sheet) {
  std::string text = "test,purpose,requirements,networks,step,action,wait,must be seen,ok,remark\n";
  for (std::size_t i = 0; i < sheet.table.tests.size(); ++i) {
    const TestCase& test = sheet.table.tests[i];
    std::size_t number = 0;
    for (const SheetRow& row : sheetRowsOf(sheet.table, test)) {
      const std::string step = std::to_string(++number);
      const std::string networks = fmt::format("{}", fmt::join(sheet.networks[i], " "));
      std::string line;
      for (const std::string& cell : {test.name, sheet.purposes[i], requirementsOf(sheet, test.name), networks, step,
                                      row.action, row.wait, row.seen, std::string(), row.remark})
        line += (line.empty() ? "" : ",") + csvCell(cell);
      text += line + "\n";
    }
  }
  return text;
}

}  // namespace rungproof
