// One HTML file without outside references: findings with excerpts, verdicts, comparison, what the results rest on.
#include <fmt/core.h>

#include <ostream>

#include "analysis/rule.hpp"
#include "frontend/cli.hpp"
#include "frontend/drawing/svg_picture.hpp"
#include "frontend/page/excerpt.hpp"
#include "frontend/report/report.hpp"
#include "frontend/run/timing_diagram.hpp"

namespace rungproof {

namespace {

constexpr std::string_view pageStyle =
    "body{font:15px/1.5 system-ui,sans-serif;max-width:70em;margin:2em auto;padding:0 "
    "1em;color:#1a1f26;background:#fff}"
    "h1{font-size:1.4em}h2{font-size:1.15em;margin-top:2em;border-bottom:1px solid #d8dee4}"
    "table{border-collapse:collapse}td,th{padding:.25em .8em;border:1px solid "
    "#d8dee4;text-align:left;vertical-align:top}"
    "td.n{text-align:right}pre{background:#f6f8fa;padding:.6em;overflow-x:auto;margin:.4em 0}"
    "article{margin:1.2em 0;padding-left:.8em;border-left:4px solid #8b949e}.error{border-color:#c62828}"
    ".warning{border-color:#b26a00}.note{border-color:#1565c0}.good{color:#1b7f37}.bad{color:#c62828}.open{color:#"
    "b26a00}"
    "mark{background:#ffd6d6;color:inherit}.place{color:#57606a}"
    "@media(prefers-color-scheme:dark){body{color:#e6edf3;background:#0d1117}pre{background:#161b22}"
    "td,th,h2{border-color:#30363d}mark{background:#6e2b2b}.place{color:#9198a1}.good{color:#4ac26b}.bad{color:#ff7b72}"
    ".open{color:#d29922}}";

/// Ladder stays dark on white, as on paper.
constexpr std::string_view runStyle =
    ".run{border:1px solid #d8dee4;margin:1em 0;padding:.6em .8em;background:#fff;color:#1a1f26}.run h3{margin:.1em 0 "
    ".4em;font-size:1em}"
    ".run:focus{outline:2px solid #0b62d6}.run figure{margin:.4em 0;overflow-x:auto}.run "
    "figcaption{font-weight:bold;font-size:.92em}"
    ".steps button{font:inherit;padding:.1em .6em}.scan h4{margin:.5em 0 .2em}";

/// Steps through the scans of each run: buttons, and arrow keys for the run that has the focus. Without scripts all
/// scans stand below each other.
constexpr std::string_view runScript = R"(
(() => {
"use strict";
for (const run of document.querySelectorAll(".run")) {
  const scans = [...run.querySelectorAll(".scan")], where = run.querySelector(".where");
  let at = scans.length - 1;
  const show = to => {
    at = Math.max(0, Math.min(scans.length - 1, to));
    scans.forEach((scan, i) => { scan.hidden = i !== at; });
    where.textContent = `${at + 1} of ${scans.length}`;
  };
  const steps = {first: () => 0, back: () => at - 1, forward: () => at + 1, last: () => scans.length - 1};
  for (const name in steps) run.querySelector("." + name).onclick = () => show(steps[name]());
  const keys = {ArrowLeft: "back", ArrowRight: "forward", Home: "first", End: "last"};
  run.onkeydown = e => { if (keys[e.key]) { show(steps[keys[e.key]]()); e.preventDefault(); } };
  run.querySelector(".steps").hidden = false;
  show(at);
}
})();
)";

class HtmlWriter {
 public:
  HtmlWriter(const Report& report, std::ostream& out) : report_(report), out_(out) {}

  void write() {
    const Summary summary = summaryOf(report_);
    out_ << fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\">"
        "<title>rungproof {}</title><style>{}</style></head><body>\n<h1>rungproof {}</h1>\n",
        report_.command, pageStyle, report_.command);
    out_ << "<table><tr><th>errors</th><th>warnings</th><th>notes</th><th>proved or "
            "reached</th><th>violated</th><th>undecided</th></tr>";
    out_ << fmt::format(
        "<tr><td class=n>{}</td><td class=n>{}</td><td class=n>{}</td><td class=n>{}</td><td class=n>{}</td><td "
        "class=n>{}</td></tr></table>\n",
        summary.errors, summary.warnings, summary.notes, summary.proved, summary.violated, summary.undecided);
    writeProperties();
    writeRuns();
    if (report_.selfCheck) writeSelfCheck(*report_.selfCheck);
    if (report_.comparison) writeComparison(*report_.comparison);
    writeFindings();
    writeBasis();
    out_ << fmt::format("<p class=place>rungproof {}</p>\n</body></html>\n", programVersion());
  }

 private:
  void writeFindings() {
    if (report_.findings.empty()) return;
    out_ << "<h2>Findings</h2>\n";
    for (const Finding& finding : report_.findings) {
      out_ << fmt::format("<article class={}><b>{}[{}]</b>: {}{}<br>\n", severityName(finding.severity),
                          severityName(finding.severity), finding.rule, xmlText(finding.message),
                          finding.confirmation == Confirmation::Unconfirmed ? " (unconfirmed)" : "");
      writePlace(finding.span, finding.pou.empty()    ? ""
                               : finding.network == 0 ? finding.pou
                                                      : fmt::format("{}, network {}", finding.pou, finding.network));
      for (const RelatedPlace& related : finding.related) {
        out_ << fmt::format("note: {}<br>\n", xmlText(related.message));
        writePlace(related.span, "");
      }
      if (!finding.help.empty()) out_ << fmt::format("<i>help:</i> {}\n", xmlText(finding.help));
      out_ << "</article>\n";
    }
  }

  void writePlace(Span span, const std::string& context) {
    const SourceFile& file = report_.sources->file(span.file);
    const std::uint32_t number = file.position(span.offset).line;
    const std::string_view line = file.line(number);
    const std::size_t begin = std::min<std::size_t>(span.offset - file.lineStart(number), line.size());
    const std::size_t end = std::min<std::size_t>(begin + span.length, line.size());
    out_ << fmt::format("<span class=place>{}{}{}</span><pre>{} | {}<mark>{}</mark>{}</pre>\n",
                        xmlText(placeText(*report_.sources, span)), context.empty() ? "" : " in ", xmlText(context),
                        number, xmlText(line.substr(0, begin)), xmlText(line.substr(begin, end - begin)),
                        xmlText(line.substr(end)));
  }

  void writeProperties() {
    if (report_.properties.empty()) return;
    out_ << "<h2>Properties</h2>\n<table><tr><th>Verdict</th><th>Property</th><th>Method</th><th>Scans</"
            "th><th>Seconds</th><th>Trace</th></tr>\n";
    for (const PropertyResult& property : report_.properties) {
      const bool good = property.verdict == Outcome::Proved || property.verdict == Outcome::Reachable;
      const bool bad = property.verdict == Outcome::Violated || property.verdict == Outcome::Unreachable ||
                       property.verdict == Outcome::Vacuous;
      std::string text = fmt::format("<b>{}</b>", xmlText(property.title()));
      if (!property.statement.empty()) text += fmt::format("<br><code>{}</code>", xmlText(property.statement));
      writeNotes(property.notes, text);
      if (!property.networks.empty())
        text += fmt::format("<br><span class=place>rests on networks: {}</span>", xmlText(property.networks));
      for (const std::string& assumption : property.assumptions)
        text += fmt::format("<br>assumes: {}", xmlText(assumption));
      const std::string trace =
          property.trace.empty() ? "" : fmt::format("<a href=\"{0}\">{0}</a>", xmlText(property.trace));
      out_ << fmt::format(
          "<tr><td class={}>{}</td><td>{}</td><td>{}</td><td class=n>{}</td><td class=n>{:.2f}</td><td>{}</td></tr>\n",
          good  ? "good"
          : bad ? "bad"
                : "open",
          verdictText(property.verdict, property.depth), text, xmlText(property.method), property.depth,
          property.seconds, trace);
    }
    out_ << "</table>\n";
  }

  /// Lines with columns keep them.
  static void writeNotes(const std::vector<std::string>& notes, std::string& text) {
    bool isTable = false;
    for (const std::string& note : notes) {
      const bool hasColumns = note.find("  ") != std::string::npos;
      if (hasColumns != isTable) text += hasColumns ? "<pre>" : "</pre>";
      text += hasColumns ? xmlText(note) + "\n" : (isTable ? "" : "<br>") + xmlText(note);
      isTable = hasColumns;
    }
    if (isTable) text += "</pre>";
  }

  /// The last scans of each witness, as ladder with power flow.
  void writeRuns() {
    bool isFirst = true;
    for (const PropertyResult& property : report_.properties) {
      if (property.scans.empty() || property.scans.front().networks.empty() ||
          property.scans.front().networks.front().svg.empty())
        continue;
      if (isFirst) out_ << fmt::format("<h2>Runs</h2>\n<style>{}{}</style>\n", runStyle, svgStyle());
      isFirst = false;
      out_ << fmt::format(
          "<section class=run tabindex=0><h3>{}: {}</h3>\n<p class=steps hidden><button class=first>first</button> "
          "<button class=back>scan back</button> "
          "<button class=forward>scan forward</button> <button class=last>last</button> <span "
          "class=where></span></p>\n",
          verdictText(property.verdict, property.depth), xmlText(property.title()));
      for (const ShownScan& scan : property.scans) writeScan(scan);
      out_ << "</section>\n";
    }
    if (!isFirst) out_ << fmt::format("<script>{}</script>\n", runScript);
  }

  void writeScan(const ShownScan& scan) {
    out_ << fmt::format("<div class=scan><h4>scan {}, {} ms</h4>\n", scan.scan, plainNumber(scan.timeMs));
    for (const ShownNetwork& network : scan.networks)
      out_ << fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", xmlText(network.heading), network.svg);
    out_ << "</div>\n";
  }

  /// How many planted faults the properties notice, and each that they do not.
  void writeSelfCheck(const std::vector<PlantedFault>& faults) {
    const FaultCounts count = countsOf(faults);
    out_ << fmt::format(
        "<h2>Self-check</h2>\n<p class={}>{} of {} planted faults that change the outputs are noticed by a property; "
        "{} change nothing, {} undecided</p>\n",
        count.unnoticed == 0 && count.undecided == 0 ? "good" : "open", count.noticed, count.noticed + count.unnoticed,
        count.withoutEffect, count.undecided);
    if (count.unnoticed + count.undecided == 0) return;
    out_ << "<table><tr><th>Fate</th><th>Place</th><th>Kind</th><th>Fault</th><th>Other value</th></tr>\n";
    for (const PlantedFault& fault : faults) {
      if (fault.fate != "unnoticed" && fault.fate != "undecided") continue;
      out_ << fmt::format(
          "<tr><td class={}>{}</td><td>{}:{} in {}, network "
          "{}</td><td>{}</td><td><code>{}</code></td><td>{}</td></tr>\n",
          fault.fate == "unnoticed" ? "bad" : "open", fault.fate, xmlText(fault.file), fault.line, xmlText(fault.pou),
          fault.network, xmlText(fault.kind), xmlText(fault.text), xmlText(fault.differs));
    }
    out_ << "</table>\n";
  }

  /// The run with both programs' networks, or why nothing is decided.
  void writeProgramComparison(const Comparison& comparison) {
    const bool isDifferent = !comparison.equal && !comparison.isUndecided();
    out_ << fmt::format("<p class={}><b>{}</b> by {}{}</p>\n",
                        comparison.equal ? "good"
                        : isDifferent    ? "bad"
                                         : "open",
                        comparison.verdict, xmlText(comparison.method),
                        isDifferent ? ": " + xmlText(differenceText(comparison)) : "");
    if (!comparison.notes.empty()) {
      out_ << "<pre>";
      for (const std::string& note : comparison.notes) out_ << xmlText(note) << '\n';
      out_ << "</pre>\n";
    }
    if (comparison.scans.empty()) return;
    out_ << fmt::format("<style>{}{}</style>\n", runStyle, svgStyle());
    for (const ShownScan& scan : comparison.scans) writeScan(scan);
  }

  void writeComparison(const Comparison& comparison) {
    out_ << "<h2>Comparison</h2>\n";
    if (comparison.isOfPrograms()) return writeProgramComparison(comparison);
    if (comparison.equal) {
      out_ << "<p class=good>The traces agree.</p>\n";
      return;
    }
    out_ << fmt::format("<p class=bad>First difference: {}</p>\n", xmlText(differenceText(comparison)));
    if (comparison.around.empty()) return;
    out_ << "<table><tr><th>scan</th><th>ms</th>";
    for (const std::string& signal : comparison.signals) out_ << fmt::format("<th>{}</th>", xmlText(signal));
    out_ << "</tr>\n";
    for (const ComparedScan& scan : comparison.around) {
      out_ << fmt::format("<tr><td class=n>{}</td><td class=n>{}</td>", scan.scan, plainNumber(scan.timeMs));
      for (std::size_t i = 0; i < comparison.signals.size(); ++i) {
        const bool differs = !scan.expected[i].empty() && scan.expected[i] != scan.actual[i];
        out_ << (differs ? fmt::format("<td class=\"n bad\">{} (expected {})</td>", xmlText(scan.actual[i]),
                                       xmlText(scan.expected[i]))
                         : fmt::format("<td class=n>{}</td>", xmlText(scan.actual[i])));
      }
      out_ << "</tr>\n";
    }
    out_ << "</table>\n";
  }

  void writeBasis() {
    out_ << "<h2>Basis</h2>\n<ul>\n";
    for (const std::string& file : report_.files) out_ << fmt::format("<li>file {}</li>\n", xmlText(file));
    out_ << fmt::format("<li>{} of {} instructions understood</li>\n", report_.coverage.understood,
                        report_.coverage.instructions);
    for (const std::string& place : report_.coverage.approximated)
      out_ << fmt::format("<li>approximated: {}</li>\n", xmlText(place));
    for (const std::string& line : report_.coverage.leftOut)
      out_ << fmt::format("<li>left out: {}</li>\n", xmlText(line));
    for (const std::string& assumption : report_.assumptions)
      out_ << fmt::format("<li>assumes: {}</li>\n", xmlText(assumption));
    out_ << "</ul>\n";
  }

  const Report& report_;
  std::ostream& out_;
};

void write(const Report& report, const ReportStyle&, std::ostream& out) { HtmlWriter(report, out).write(); }

}  // namespace

extern constexpr Reporter htmlReport = {.name = "html", .summary = "one page for the browser", .write = write};

}  // namespace rungproof
