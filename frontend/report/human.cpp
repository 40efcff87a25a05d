// The report for people: findings with excerpt, related places and help; verdict lines; the first difference of
// traces with the scans around it; one closing line. Golden tests: tests/golden/lint.
#include <fmt/core.h>

#include <algorithm>
#include <ostream>
#include <sstream>

#include "analysis/rule.hpp"
#include "frontend/input/project_argument.hpp"
#include "frontend/report_basis.hpp"
#include "frontend/testing/test_output.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

using Painter = std::string (Paint::*)(std::string_view) const;

Painter painterOf(Severity severity) {
  return severity == Severity::Error ? &Paint::red : severity == Severity::Warning ? &Paint::yellow : &Paint::cyan;
}

int digits(std::uint32_t number) { return static_cast<int>(std::to_string(number).size()); }

/// As messageText(), with places of the manual by their titles.
std::string manualText(std::string_view text) { return messageText(withManualTitles(text)); }

class HumanWriter {
 public:
  HumanWriter(const Report& report, const ReportStyle& style, std::ostream& out)
      : report_(report), style_(style), paint_{style.color}, out_(out) {}

  void write() {
    writeFindings();
    for (const PropertyResult& property : report_.properties) writeProperty(property);
    std::istringstream blocks(comparedBlocksText(report_.blocks));
    for (std::string line; std::getline(blocks, line);) out_ << messageText(line) << '\n';
    if (report_.comparison) writeComparison(*report_.comparison);
    if (report_.selfCheck) writeSelfCheck(*report_.selfCheck);
    if (report_.tests != nullptr) out_ << testText(*report_.tests, paint_, style_.quiet);
    const bool isOfPrograms = report_.comparison && report_.comparison->isOfPrograms();
    writeBasis();
    for (const std::string& line : report_.coverage.leftOut) out_ << fmt::format("left out: {}\n", messageText(line));
    if (style_.verbose && report_.techniques) writeTechniques(*report_.techniques);
    if (isOfPrograms) out_ << verdictLine(*report_.comparison) << '\n';
    const bool saidAll =
        (report_.comparison || report_.tests != nullptr) && report_.findings.empty() && report_.properties.empty();
    if (!style_.quiet && !saidAll) out_ << closingLine() << '\n';
  }

 private:
  /// Of a project with several programs one program after the other, each below its name.
  void writeFindings() {
    const std::vector<std::string>& programs = report_.files;
    const bool hasHeadings =
        report_.command == "lint" && programs.size() > 1 && std::ranges::all_of(programs, isProjectProgram);
    if (!hasHeadings) {
      for (const Finding& finding : report_.findings) writeFinding(finding);
      return;
    }
    const auto isOf = [&](const Finding& finding, const std::string& program) {
      if (!hasPlace(finding.span)) return false;
      const std::string_view file = report_.sources->file(finding.span.file).name();
      return file.starts_with(program) && (file.size() == program.size() || file[program.size()] == '/');
    };
    for (const Finding& finding : report_.findings) {
      if (std::ranges::none_of(programs, [&](const std::string& program) { return isOf(finding, program); }))
        writeFinding(finding);
    }
    for (const std::string& program : programs) {
      out_ << paint_.bold(messageText(program)) << "\n\n";
      bool isClean = true;
      for (const Finding& finding : report_.findings) {
        if (!isOf(finding, program)) continue;
        writeFinding(finding);
        isClean = false;
      }
      if (isClean) out_ << "no findings\n\n";
    }
  }

  bool hasPlace(Span span) const { return report_.sources != nullptr && span.file < report_.sources->size(); }

  /// Findings are written piece by piece, without formats: there may be a million.
  void paint(std::string& text, Painter painter, std::string_view piece) const {
    if (paint_.on)
      text += (paint_.*painter)(piece);
    else
      text += piece;
  }

  void addPlace(std::string& text, Span span, Position at, int gutter, std::string_view context, char mark,
                Painter painter) const {
    const SourceFile& file = report_.sources->file(span.file);
    const bool isEmpty = file.text().empty();  // a file that could not be read has no lines
    text.append(static_cast<std::size_t>(gutter), ' ');
    paint(text, &Paint::blue, "-->");
    text.append(" ").append(messageText(file.name()));
    if (!isEmpty) text.append(":").append(std::to_string(at.line)).append(":").append(std::to_string(at.column));
    text.append(messageText(context)).append("\n");
    if (!isEmpty) text += drawExcerpt(excerptOf(file, span, at.line), gutter, mark, paint_, painter);
  }
  void writePlace(Span span, int gutter, std::string_view context, char mark, Painter painter) {
    std::string text;
    addPlace(text, span, report_.sources->position(span), gutter, context, mark, painter);
    out_ << text;
  }

  void writeFinding(const Finding& finding) {
    const Painter painter = painterOf(finding.severity);
    std::string& text = text_;
    text.clear();
    std::string head(severityName(finding.severity));
    head.append("[").append(finding.rule.view()).append("]");
    paint(text, painter, head);
    text += ": ";
    paint(text, &Paint::bold, manualText(finding.message));
    text += finding.confirmation == Confirmation::Unconfirmed ? " (unconfirmed)\n" : "\n";
    std::vector<Position> places;
    for (const RelatedPlace& related : finding.related)
      places.push_back(hasPlace(related.span) ? report_.sources->position(related.span) : Position{});
    int gutter = 1;
    if (hasPlace(finding.span)) {
      const Position at = report_.sources->position(finding.span);
      gutter = digits(at.line);
      for (const Position& place : places) gutter = std::max(gutter, digits(place.line));
      addPlace(text, finding.span, at, gutter, contextOf(finding), '^', painter);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      const RelatedPlace& related = finding.related[i];
      if (!hasPlace(related.span)) continue;
      paint(text, &Paint::cyan, "note");
      text.append(": ").append(manualText(related.message)).append("\n");
      addPlace(text, related.span, places[i], gutter, "", '-', &Paint::blue);
    }
    const auto remark = [&](std::string_view what) -> std::string& {
      text.append(static_cast<std::size_t>(gutter) + 1, ' ');
      paint(text, &Paint::blue, "=");
      return text.append(" ").append(what);
    };
    if (!finding.help.empty()) remark("help: ").append(manualText(finding.help)).append("\n");
    if (finding.fix) {
      remark("fix").append(finding.fix->safe ? "" : " (unsafe, with --unsafe-fixes)").append(": ");
      if (finding.fix->replacement.empty())
        text += "remove it\n";
      else
        text.append("write '").append(messageText(finding.fix->replacement)).append("'\n");
    }
    if (!finding.trace.empty()) remark("trace: ").append(messageText(finding.trace)).append("\n");
    text += '\n';
    out_ << text;
  }

  static std::string contextOf(const Finding& finding) {
    if (finding.pou.empty()) return {};
    std::string text = " in " + finding.pou;
    if (finding.network != 0) text.append(", network ").append(std::to_string(finding.network));
    return text;
  }

  void writeProperty(const PropertyResult& property) {
    const bool good = property.verdict == Outcome::Proved || property.verdict == Outcome::Reachable;
    const bool bad = property.verdict == Outcome::Violated || property.verdict == Outcome::Unreachable ||
                     property.verdict == Outcome::Vacuous;
    const Painter painter = good ? &Paint::green : bad ? &Paint::red : &Paint::yellow;
    out_ << fmt::format("{}  {}", (paint_.*painter)(verdictText(property.verdict, property.depth)),
                        paint_.bold(messageText(property.title())));
    if (!property.method.empty()) out_ << fmt::format("  by {}", property.method);
    out_ << fmt::format("  in {:.2f} s\n", property.seconds);
    if (property.span && hasPlace(*property.span)) {
      writePlace(*property.span, digits(report_.sources->position(*property.span).line), "", '^', painter);
    }
    for (const std::string& remark : remarksOf(property))
      out_ << fmt::format("  {} {}\n", paint_.blue("="), manualText(remark));
    if (!property.trace.empty()) out_ << fmt::format("  {} trace: {}\n", paint_.blue("="), messageText(property.trace));
    for (const ShownScan& scan : property.scans) writeScan(scan);
    if (!property.scans.empty() && !property.scans.back().networks.empty() &&
        !property.scans.back().networks.back().text.empty())
      out_ << '\n';
  }

  void writeScan(const ShownScan& scan) {
    bool isFirst = true;
    for (const ShownNetwork& network : scan.networks) {
      if (network.text.empty()) continue;
      if (isFirst)
        out_ << fmt::format("\n  {}\n",
                            paint_.bold(fmt::format("scan {}, {} ms", scan.scan, plainNumber(scan.timeMs))));
      isFirst = false;
      out_ << fmt::format("  {}\n", messageText(network.heading));
      for (const std::string& line : network.text) out_ << fmt::format("  {}\n", line);
    }
  }

  void writeSelfCheck(const std::vector<PlantedFault>& faults) {
    const FaultCounts count = countsOf(faults);
    const std::size_t noticed = count.noticed, matter = noticed + count.unnoticed;
    out_ << fmt::format("\n{}: {} of {} planted faults that change the outputs are noticed by a property",
                        paint_.bold("self-check"), noticed, matter);
    if (matter > 0)
      out_ << fmt::format(" ({:.0f} %)", 100.0 * static_cast<double>(noticed) / static_cast<double>(matter));
    out_ << fmt::format("; {} change nothing, {} undecided\n", count.withoutEffect, count.undecided);
    for (const std::string_view fate : {"unnoticed", "undecided"}) {
      for (const PlantedFault& fault : faults) {
        if (fault.fate != fate) continue;
        out_ << fmt::format("  {}: {}:{} in {}, network {}: {}: {}{}\n",
                            (paint_.*(fate == "unnoticed" ? &Paint::red : &Paint::yellow))(fate), fault.file,
                            fault.line, messageText(fault.pou), fault.network, fault.kind, messageText(fault.text),
                            fault.differs.empty() ? "" : "; other value of " + fault.differs);
      }
    }
  }

  void writeTechniques(const TechniqueUses& uses) {
    out_ << fmt::format("\n{:<20}{:>8}{:>10}{:>11}\n", "technique", "asked", "settled", "seconds");
    for (const TechniqueInfo& info : techniqueTable()) {
      const TechniqueUse& use = uses[static_cast<std::size_t>(info.id)];
      if (use.asked == 0) continue;
      out_ << fmt::format("{:<20}{:>8}{:>10}{:>11.3f}\n", info.name, use.asked,
                          info.settles ? std::to_string(use.settled) : "-", use.seconds);
    }
  }

  /// What the verdicts rest on.
  void writeBasis() {
    const std::vector<std::string> basis = basisOf(report_);
    if (!report_.properties.empty() || !basis.empty()) out_ << '\n';
    for (const std::string& line : basis) out_ << messageText(line) << '\n';
  }

  /// The last line of a comparison of programs.
  std::string verdictLine(const Comparison& comparison) const {
    const Painter painter = comparison.equal                    ? &Paint::green
                            : comparison.verdict == "DIFFERENT" ? &Paint::red
                                                                : &Paint::yellow;
    std::string text = (paint_.*painter)(comparison.verdict);
    if (!comparison.method.empty()) text += fmt::format("  by {}", comparison.method);
    return text + fmt::format("  in {:.2f} s", comparison.seconds);
  }

  void writeProgramComparison(const Comparison& comparison) {
    if (comparison.verdict == "DIFFERENT")
      out_ << fmt::format("{} {}\n", paint_.red("first difference:"), messageText(differenceText(comparison)));
    for (const std::string& note : comparison.notes)
      out_ << fmt::format("  {} {}\n", paint_.blue("="), messageText(note));
    if (!comparison.trace.empty())
      out_ << fmt::format("  {} trace: {}\n", paint_.blue("="), messageText(comparison.trace));
    for (const ShownScan& scan : comparison.scans) writeScan(scan);
  }

  void writeComparison(const Comparison& comparison) {
    if (comparison.isOfPrograms()) {
      writeProgramComparison(comparison);
      return;
    }
    if (comparison.equal) {
      out_ << "traces agree\n";
      return;
    }
    out_ << fmt::format("{} {}\n", paint_.red("first difference:"), messageText(differenceText(comparison)));
    if (comparison.around.empty()) return;
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < comparison.signals.size(); ++i) {
      std::size_t width = comparison.signals[i].size();
      for (const ComparedScan& scan : comparison.around)
        width = std::max({width, scan.expected[i].size(), scan.actual[i].size()});
      widths.push_back(width);
    }
    const auto row = [&](std::string_view scan, std::string_view time, std::string_view kind,
                         const std::vector<std::string>& cells) {
      std::string line = fmt::format("  {:>6}  {:>8}  {:<8}", scan, time, kind);
      for (std::size_t i = 0; i < cells.size(); ++i) line += fmt::format("  {:>{}}", cells[i], widths[i]);
      line.erase(line.find_last_not_of(' ') + 1);
      return line + '\n';
    };
    out_ << row("scan", "ms", "", comparison.signals);
    for (const ComparedScan& scan : comparison.around) {
      const bool first = scan.scan == comparison.scan;
      const std::string time = plainNumber(scan.timeMs);
      const std::string number = fmt::format("{}{}", first ? "> " : "", scan.scan);
      out_ << row(number, time, "expected", scan.expected);
      const std::string actual = row("", "", "actual", scan.actual);
      out_ << (first ? paint_.red(actual.substr(0, actual.size() - 1)) + '\n' : actual);
    }
  }

  std::string closingLine() const {
    const Summary summary = summaryOf(report_);
    std::string text;
    const auto add = [&](std::size_t count, std::string_view one, std::string_view many) {
      if (count == 0) return;
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, count == 1 ? one : many);
    };
    if (report_.properties.empty() || !report_.findings.empty()) {
      add(summary.errors, "error", "errors");
      add(summary.warnings, "warning", "warnings");
      add(summary.notes, "note", "notes");
    }
    add(summary.proved, "property proved or reached", "properties proved or reached");
    const auto with = [&](Outcome word) {
      return static_cast<std::size_t>(std::count_if(report_.properties.begin(), report_.properties.end(),
                                                    [&](const PropertyResult& p) { return p.verdict == word; }));
    };
    add(with(Outcome::Violated), "violated", "violated");
    add(with(Outcome::Unreachable), "unreachable", "unreachable");
    add(with(Outcome::Vacuous), "vacuous", "vacuous");
    add(summary.undecided, "undecided", "undecided");
    if (text.empty()) text = "no findings";
    std::string tail;
    if (report_.coverage.instructions > 0) {
      tail = fmt::format(" in {} instruction{}", report_.coverage.instructions,
                         report_.coverage.instructions == 1 ? "" : "s");
      if (report_.coverage.understood < report_.coverage.instructions)
        tail += fmt::format(", {} understood", report_.coverage.understood);
    }
    if (report_.files.size() > 1) tail += fmt::format(" of {} files", report_.files.size());
    if (report_.suppressed > 0) tail += fmt::format("; {} suppressed", report_.suppressed);
    if (report_.baselined > 0) tail += fmt::format("; {} in the baseline", report_.baselined);
    if (const ExitReason reason = exitReasonOf(report_); !reason.text.empty())
      tail += fmt::format("; exit {}: {}", static_cast<int>(reason.exit), reason.text);
    return text + tail;
  }

  const Report& report_;
  const ReportStyle& style_;
  Paint paint_;
  std::ostream& out_;
  std::string text_;  ///< of a finding; its room is used again
};

void writeHumanReport(const Report& report, const ReportStyle& style, std::ostream& out) {
  HumanWriter(report, style, out).write();
}

}  // namespace

extern constexpr Reporter humanReport = {
    .name = "human", .summary = "excerpts and help for people", .write = writeHumanReport};

}  // namespace rungproof
