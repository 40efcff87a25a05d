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
  std::size_t same = 0;                  ///< outputs that are to be as before
  std::vector<std::string> notCompared;  ///< names of the others
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
        sight.notCompared.push_back(table.expects[i].name);
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

/// `isFirst`: behind power-on. Outputs that are not compared are not among those of which something is said; where no
/// remark names them, this does.
std::string sightText(const Sight& sight, bool isFirst, bool isRemarked) {
  std::string text = fmt::format("{}", fmt::join(sight.changed, "; "));
  const bool isAll = sight.notCompared.empty();
  if (sight.same > 0 && sight.changed.empty()) {
    text = isFirst ? (isAll ? "all outputs off" : "all other outputs off")
                   : (isAll ? "nothing changes" : "no other output changes");
  } else if (sight.same > 0) {
    text += isFirst ? (isAll ? "; all else off" : "; all other outputs off")
                    : (isAll ? "; all else as before" : "; all other outputs as before");
  }
  if (!isAll && !isRemarked && !text.empty())
    text += fmt::format("; not compared: {}", fmt::join(sight.notCompared, ", "));
  return text;
}

std::string seconds(double ms) { return fmt::format("{:g} s", ms / 1000); }

/// A wait at the machine, where nobody counts scans by hand. What comes with any number of scans from the wanted one on
/// gets the time in which the longest scans are so many; `countsScans`: with others it does not come.
std::string waitForPeople(const TestWait& wait, const TestSheet& sheet, bool countsScans) {
  if (wait.isTime()) return seconds(static_cast<double>(wait.timeUs) / 1000);
  if (!countsScans) return wait.scans == 1 ? "at once" : seconds(static_cast<double>(wait.scans) * sheet.highMs);
  const std::string scans = fmt::format("{} scan{}", wait.scans, wait.scans == 1 ? "" : "s");
  const double low = static_cast<double>(wait.scans) * sheet.lowMs,
               high = static_cast<double>(wait.scans) * sheet.highMs;
  return low == high ? fmt::format("{}: {}", scans, seconds(low))
                     : fmt::format("{}: {} to {}, by their length", scans, seconds(low), seconds(high));
}

struct SheetRow {
  std::string action, wait, seen, remark;
};

std::vector<SheetRow> sheetRowsOf(const TestSheet& sheet, std::size_t number) {
  std::vector<SheetRow> rows;
  const TestCase& test = sheet.table.tests[number];
  const std::vector<Sight> sights = sightsOf(sheet.table, test);
  for (std::size_t i = 0; i < test.rows.size(); ++i) {
    const TestRow& row = test.rows[i];
    const bool countsScans = number < sheet.countsScans.size() && sheet.countsScans[number][i];
    const bool isRemarked = row.note.find("not compared") != std::string::npos;
    rows.push_back(
        {row.step, waitForPeople(row.wait, sheet, countsScans), sightText(sights[i], i == 0, isRemarked), row.note});
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

constexpr std::string_view instruction =
    "Each test begins with power-on and all inputs off. Do the steps in their order. After each wait compare what is "
    "seen, tick the box, or write what was seen instead. A wait that names scans needs exactly so many: what must be "
    "seen then does not come with every other number of them.";

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
  text += fmt::format("<p>{}</p>\n", instruction);
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
    for (const SheetRow& row : sheetRowsOf(sheet, i))
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
  text += std::string(instruction) + "\n\n";
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
    for (const SheetRow& row : sheetRowsOf(sheet, i))
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
    for (const SheetRow& row : sheetRowsOf(sheet, i)) {
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
