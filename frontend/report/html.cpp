// One HTML file without outside references: verdicts with their evidence, comparison, findings, what the results rest
// on.
#include <fmt/core.h>

#include <ostream>

#include "frontend/acceptance/page_writer.hpp"
#include "frontend/report.hpp"
#include "frontend/testing/test_output.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

class HtmlWriter {
 public:
  HtmlWriter(const Report& report, std::ostream& out) : page_(report, out), report_(report), out_(out) {}

  void write() {
    page_.begin();
    page_.verdicts();
    page_.properties();
    page_.networks();
    page_.selfCheck();
    if (!report_.blocks.empty()) out_ << "<pre>" << xmlText(comparedBlocksText(report_.blocks)) << "</pre>\n";
    if (report_.comparison) writeComparison(*report_.comparison);
    page_.findings();
    page_.basis();
    page_.choices();
    page_.words();
    page_.signatures();
    page_.end();
  }

 private:
  /// The run with both programs' networks, or why nothing is decided.
  void writeProgramComparison(const Comparison& comparison) {
    const bool isDifferent = !comparison.equal && !comparison.isUndecided();
    out_ << fmt::format("<p class=\"{}\"><b>{}</b> by {}{}</p>\n",
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
    out_ << "<div class=\"run\" id=\"run\" tabindex=\"0\">\n";
    std::vector<ShownScan> both;  // the networks of OLD and NEW in one scan stand together
    for (const ShownScan& scan : comparison.scans) {
      if (both.empty() || both.back().scan != scan.scan)
        both.push_back(scan);
      else
        both.back().networks.insert(both.back().networks.end(), scan.networks.begin(), scan.networks.end());
    }
    page_.scans(both, "run");
    out_ << "</div>\n";
  }

  void writeComparison(const Comparison& comparison) {
    page_.section("Comparison");
    if (comparison.isOfPrograms()) return writeProgramComparison(comparison);
    if (comparison.equal) {
      out_ << "<p class=\"good\">The traces agree.</p>\n";
      return;
    }
    out_ << fmt::format("<p class=\"bad\">First difference: {}</p>\n", xmlText(differenceText(comparison)));
    if (comparison.around.empty()) return;
    out_ << "<div class=\"scroll\"><table><tr><th>scan</th><th>ms</th>";
    for (const std::string& signal : comparison.signals) out_ << fmt::format("<th>{}</th>", xmlText(signal));
    out_ << "</tr>\n";
    for (const ComparedScan& scan : comparison.around) {
      out_ << fmt::format("<tr><td class=\"number\">{}</td><td class=\"number\">{}</td>", scan.scan,
                          plainNumber(scan.timeMs));
      for (std::size_t i = 0; i < comparison.signals.size(); ++i) {
        const bool differs = !scan.expected[i].empty() && scan.expected[i] != scan.actual[i];
        out_ << (differs ? fmt::format("<td class=\"number bad\">{} (expected {})</td>", xmlText(scan.actual[i]),
                                       xmlText(scan.expected[i]))
                         : fmt::format("<td class=\"number\">{}</td>", xmlText(scan.actual[i])));
      }
      out_ << "</tr>\n";
    }
    out_ << "</table></div>\n";
  }

  PageWriter page_;
  const Report& report_;
  std::ostream& out_;
};

void writeHtmlReport(const Report& report, const ReportStyle&, std::ostream& out) {
  if (report.tests != nullptr) return writeTestPage(report, *report.tests, out);
  HtmlWriter(report, out).write();
}

}  // namespace

extern constexpr Reporter htmlReport = {
    .name = "html", .summary = "one page for the browser", .write = writeHtmlReport};

}  // namespace rungproof
