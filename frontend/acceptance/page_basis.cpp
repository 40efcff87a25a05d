// What the verdicts rest on and what else was found: self-check, findings, coverage, assumptions, choices.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "analysis/rule.hpp"
#include "frontend/acceptance/page_writer.hpp"
#include "frontend/linting/fingerprint.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

void PageWriter::selfCheck() {
  if (!report_.selfCheck) return;
  const FaultCounts count = countsOf(*report_.selfCheck);
  section("Self-check");
  out_ << fmt::format(
      "<p>Faults were planted into the program one by one, to see whether a property notices them.</p>\n<p "
      "class=\"{}\">{} of {} planted faults that change the outputs are noticed by a property; "
      "{} change nothing, {} undecided</p>\n",
      count.unnoticed == 0 && count.undecided == 0 ? "good" : "open", count.noticed, count.noticed + count.unnoticed,
      count.withoutEffect, count.undecided);
  if (count.unnoticed + count.undecided == 0) return;
  out_ << "<table class=\"wide cards\"><thead><tr><th>Fate</th><th>Place</th><th>Kind</th><th>Fault</th><th>Other "
          "value</th></tr></thead><tbody>\n";
  for (const PlantedFault& fault : *report_.selfCheck) {
    if (fault.fate != "unnoticed" && fault.fate != "undecided") continue;
    out_ << fmt::format(
        "<tr><td class=\"{}\">{}</td><td>{}:{} in {}, network "
        "{}</td><td>{}</td><td><code>{}</code></td><td>{}</td></tr>\n",
        fault.fate == "unnoticed" ? "bad" : "open", fault.fate, xmlText(fault.file), fault.line, xmlText(fault.pou),
        fault.network, xmlText(fault.kind), xmlText(fault.text), xmlText(fault.differs));
  }
  out_ << "</tbody></table>\n";
}

void PageWriter::findings() {
  if (report_.findings.empty() && report_.lintFindings.empty()) {
    if (report_.programs.empty()) return;
    section("Findings");
    out_ << "<p>None, neither of this run nor of lint.</p>\n";
    return;
  }
  section("Findings");
  PlaceNames fingerprints;
  for (const Finding& one : report_.findings) finding(one, fingerprints);
  if (report_.lintFindings.empty()) return;
  if (!report_.findings.empty()) out_ << "<h3>Of lint</h3>\n";
  out_ << "<p class=\"quiet\">Rules that need no solver looked at the same files; what they say changes no "
          "verdict.</p>\n";
  for (const Finding& one : report_.lintFindings) finding(one, fingerprints);
}

void PageWriter::finding(const Finding& finding, PlaceNames& fingerprints) {
  const AddressNames& names = names_.size() == 1 ? names_.front() : noNames_;
  const Rule* rule = ruleNamed(finding.rule);
  out_ << fmt::format("<article class=\"finding {}\" id=\"finding-{}\"><b>{}[{}]</b>: {}{}<br/>\n",
                      severityName(finding.severity),
                      fingerprints.of(finding.rule + "-" + fingerprintOf(finding, *report_.sources).substr(0, 8)),
                      severityName(finding.severity), finding.rule, names.marked(withManualTitles(finding.message)),
                      finding.confirmation == Confirmation::Unconfirmed ? " (unconfirmed)" : "");
  findingPlace(finding.span, finding.pou.empty()    ? ""
                             : finding.network == 0 ? std::string(finding.pou)
                                                    : fmt::format("{}, network {}", finding.pou, finding.network));
  for (const RelatedPlace& related : finding.related) {
    out_ << fmt::format("note: {}<br/>\n", names.marked(withManualTitles(related.message)));
    findingPlace(related.span, "");
  }
  if (!finding.help.empty()) out_ << fmt::format("<i>help:</i> {}\n", names.marked(withManualTitles(finding.help)));
  if (rule != nullptr) out_ << fmt::format("<p class=\"quiet\">{}: {}</p>\n", finding.rule, xmlText(rule->title));
  out_ << "</article>\n";
}

void PageWriter::findingPlace(Span span, const std::string& context) {
  const SourceFile& file = report_.sources->file(span.file);
  const std::uint32_t number = file.position(span.offset).line;
  const std::string_view line = file.line(number);
  const std::size_t begin = std::min<std::size_t>(span.offset - file.lineStart(number), line.size());
  const std::size_t end = std::min<std::size_t>(begin + span.length, line.size());
  out_ << fmt::format("<span class=\"place\">{}{}{}</span><pre>{} | {}<mark>{}</mark>{}</pre>\n",
                      xmlText(placeText(*report_.sources, span)), context.empty() ? "" : " in ", xmlText(context),
                      number, xmlText(line.substr(0, begin)), xmlText(line.substr(begin, end - begin)),
                      xmlText(line.substr(end)));
}

void PageWriter::basis() {
  section("What this rests on");
  const AddressNames& names = names_.size() == 1 ? names_.front() : noNames_;
  out_ << "<ul>\n";
  if (report_.programs.empty()) {
    for (const std::string& file : report_.files) out_ << fmt::format("<li>file {}</li>\n", xmlText(file));
  }
  out_ << fmt::format("<li>{} of {} instructions understood</li>\n", report_.coverage.understood,
                      report_.coverage.instructions);
  for (const std::string& place : report_.coverage.approximated)
    out_ << fmt::format("<li>approximated: {}</li>\n", names.marked(place));
  for (const std::string& line : report_.coverage.leftOut)
    out_ << fmt::format("<li>left out: {}</li>\n", names.marked(line));
  if (!report_.programs.empty() && !report_.assumptions.empty())
    out_ << "<li>the <a href=\"#assumptions\">assumptions</a> on the first page</li>\n";
  for (const std::string& assumption : report_.programs.empty() ? report_.assumptions : std::vector<std::string>())
    out_ << fmt::format("<li>assumes: {}</li>\n", names.marked(assumption));
  if (report_.suppressed > 0)
    out_ << fmt::format("<li>findings that comments in the program silence: {}</li>\n", report_.suppressed);
  if (report_.baselined > 0) out_ << fmt::format("<li>findings that the baseline lists: {}</li>\n", report_.baselined);
  out_ << "</ul>\n";
  for (const ProgramRecord& record : report_.programs) {
    if (record.symbols.empty()) continue;
    section(report_.programs.size() > 1 ? "Names of addresses in " + record.name : "Names of addresses");
    out_ << "<table class=\"wide\"><thead><tr><th>Address</th><th>Name</th><th>Comment</th></tr></thead><tbody>\n";
    for (const NamedAddress& name : record.symbols)
      out_ << fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", xmlText(name.address), xmlText(name.symbol),
                          xmlText(name.comment));
    out_ << "</tbody></table>\n";
  }
}

bool PageWriter::isDependedOn(const ProgramRecord& record, const ChoiceInForce& choice) const {
  return std::ranges::any_of(report_.properties, [&](const PropertyResult& property) {
    if (recordOf(property) != &record) return false;
    // "inactive-scr = skipped" of what was in force, "under inactive-scr = skipped" of what a run needs.
    const auto isOfKey = [&](std::string_view text) { return text.starts_with(choice.key + " = "); };
    const auto isNeeded = [&](std::string_view note) {
      return note.starts_with("under ") && isOfKey(note.substr(std::string_view("under ").size()));
    };
    return std::ranges::any_of(property.assumptions, isOfKey) || std::ranges::any_of(property.notes, isNeeded);
  });
}

void PageWriter::choices() {
  if (report_.programs.empty() || report_.command != "prove") return;
  section("Choices in force");
  out_ << "<p>Points that the manual leaves open and that some verdict depends on. Where nobody chose, a proof covers "
          "every reading; a fact of the plant has one value in proofs too.</p>\n";
  std::vector<std::vector<ChoiceInForce>> shown;
  for (const ProgramRecord& record : report_.programs) {
    std::vector<ChoiceInForce> choices = record.choices;
    std::erase_if(choices, [&](const ChoiceInForce& choice) { return !isDependedOn(record, choice); });
    const auto isSame = [&](const std::vector<ChoiceInForce>& other) {
      return std::ranges::equal(choices, other, [](const ChoiceInForce& a, const ChoiceInForce& b) {
        return a.key == b.key && a.value == b.value && a.origin == b.origin;
      });
    };
    if (std::ranges::any_of(shown, isSame)) continue;
    shown.push_back(choices);
    if (shown.size() > 1) out_ << fmt::format("<h3>Of {}</h3>\n", xmlText(record.name));
    if (choices.empty()) out_ << "<p>No verdict depends on one.</p>\n";
    if (choices.empty()) continue;
    out_ << "<table class=\"wide cards\"><thead><tr><th>Choice</th><th>In this run</th><th>What is "
            "open</th></tr></thead>"
            "<tbody>\n";
    for (const ChoiceInForce& choice : choices) {
      const std::string value = !choice.origin.empty()
                                    ? fmt::format("<b>{}</b>, made: {}", choice.value, xmlText(choice.origin))
                                : choice.isFact ? fmt::format("{}, default", choice.value)
                                                : "every reading";
      out_ << fmt::format("<tr><td><code>{}</code></td><td>{}</td><td>{}</td></tr>\n", choice.key, value,
                          xmlText(choice.why));
    }
    out_ << "</tbody></table>\n";
  }
}

}  // namespace rungproof
