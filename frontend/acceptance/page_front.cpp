// The beginning of a page: heading, summary, what was examined; and its end: signatures.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "frontend/acceptance/page_style.hpp"
#include "frontend/acceptance/page_writer.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/picture/svg_picture.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

/// "3 requirements are proved" or nothing.
void addCount(std::string& text, std::size_t count, std::string_view one, std::string_view several) {
  if (count == 0) return;
  text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, count == 1 ? one : several);
}

std::string_view pageKind(const std::string& command) {
  if (command == "prove") return "Acceptance record";
  if (command == "lint") return "Findings";
  return command == "equiv" ? "Comparison of two programs" : "Comparison of traces";
}

}  // namespace

std::string_view verdictClass(Outcome verdict) {
  switch (verdict) {
    case Outcome::Proved:
    case Outcome::Reachable: return "good";
    case Outcome::Violated:
    case Outcome::Unreachable:
    case Outcome::Vacuous: return "bad";
    default: return "open";
  }
}

PageWriter::PageWriter(const Report& report, std::ostream& out) : report_(report), out_(out) {
  for (const PropertyResult& property : report_.properties)
    propertyPlaces_.push_back(places_.of("property " + property.title()));
  for (const ProgramRecord& record : report_.programs) names_.emplace_back(record.symbols);
}

const ProgramRecord* PageWriter::recordOf(const PropertyResult& property) const {
  for (const ProgramRecord& record : report_.programs) {
    if (property.program.empty() || record.name == property.program) return &record;
  }
  return nullptr;
}

const AddressNames& PageWriter::namesOf(const PropertyResult& property) const {
  const ProgramRecord* record = recordOf(property);
  return record == nullptr ? noNames_ : names_[static_cast<std::size_t>(record - report_.programs.data())];
}

std::string PageWriter::summaryLine() const {
  std::map<Outcome, std::size_t> count;
  for (const PropertyResult& property : report_.properties) ++count[property.verdict];
  std::string text;
  addCount(text, count[Outcome::Violated], "requirement is violated", "requirements are violated");
  addCount(text, count[Outcome::Vacuous], "holds without an occasion", "hold without an occasion");
  addCount(text, count[Outcome::Unreachable], "goal is unreachable", "goals are unreachable");
  addCount(text, count[Outcome::Unknown] + count[Outcome::HoldsToBound] + count[Outcome::NotCovered], "is undecided",
           "are undecided");
  addCount(text, count[Outcome::Proved], "requirement is proved", "requirements are proved");
  addCount(text, count[Outcome::Reachable], "goal is reached", "goals are reached");
  const Summary summary = summaryOf(report_);
  addCount(text, summary.errors, "error", "errors");
  addCount(text, summary.warnings, "warning", "warnings");
  addCount(text, summary.notes, "note", "notes");
  return text;
}

void PageWriter::section(std::string_view title) {
  const std::string id = places_.of(title);
  out_ << fmt::format(
      "<h2 id=\"{0}\">{1}<a class=\"anchor\" href=\"#{0}\" aria-label=\"link to this part\">#</a></h2>\n", id,
      xmlText(title));
}

void PageWriter::program(const ProgramRecord& record) {
  const std::string cpu = record.cpu.empty() ? "" : fmt::format("{}, ", xmlText(record.cpu));
  out_ << fmt::format("<dl class=\"facts\">\n<dt>{}</dt><dd>{}{}</dd>\n", cpu.empty() ? "Language" : "CPU", cpu,
                      xmlText(record.edition));
  for (const OptionInForce& option : record.options)
    out_ << fmt::format("<dt>{}</dt><dd>{} <span class=\"quiet\">({})</span></dd>\n", xmlText(option.name),
                        option.value == "true" ? "yes" : xmlText(option.value), xmlText(option.origin));
  std::string made;
  for (const ChoiceInForce& choice : record.choices) {
    if (choice.origin.empty()) continue;
    made += fmt::format("{}{} = {}{}", made.empty() ? "" : ", ", choice.key, choice.value,
                        isDependedOn(record, choice) ? "" : " (no verdict depends on it)");
  }
  if (report_.command == "prove")
    out_ << fmt::format(
        "<dt>Choices made</dt><dd>{}; see <a href=\"#Choices-in-force\">those that a verdict depends on</a></dd>\n",
        made.empty() ? "none: the proofs cover every reading of what the manual leaves open" : xmlText(made));
  out_ << "</dl>\n<table class=\"wide "
          "cards\"><thead><tr><th>File</th><th>Kind</th><th>Bytes</th><th>SHA-256</th></tr></thead><tbody>\n";
  for (const FileRead& file : record.files)
    out_ << fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"number\" data-label=\"Bytes\">{}</td><td class=\"mono hash\" "
        "data-label=\"SHA-256\">{}</td></tr>\n",
        xmlText(file.name), file.kind, file.bytes, file.sha256);
  out_ << "</tbody></table>\n";
}

void PageWriter::assumptions() {
  if (report_.assumptions.empty() || report_.programs.empty()) return;
  const AddressNames& names = names_.size() == 1 ? names_.front() : noNames_;
  out_ << fmt::format("<h3 id=\"{}\">Assumptions of every verdict</h3>\n<ul>\n", places_.of("assumptions"));
  for (const std::string& assumption : report_.assumptions)
    out_ << fmt::format("<li>assumes: {}</li>\n", names.marked(assumption));
  out_ << "</ul>\n";
}

void PageWriter::begin() {
  std::string title;
  for (const ProgramRecord& record : report_.programs) {
    const std::string name = record.title.empty() || report_.programs.size() > 1 ? record.name : record.title;
    title += (title.empty() ? "" : ", ") + name;
  }
  if (title.empty()) title = "rungproof " + report_.command;
  out_ << fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/><meta name=\"generator\" "
      "content=\"rungproof {}\"/>\n<title>{}{}</title>\n<style>{}{}</style></head><body>\n",
      programVersion(), xmlText(title), report_.programs.empty() ? "" : " - rungproof " + report_.command, pageStyle(),
      svgStyle());
  out_ << fmt::format("<header>\n<p class=\"kind\">{}</p>\n<h1>{}</h1>\n", pageKind(report_.command), xmlText(title));
  if (const std::string line = summaryLine(); !line.empty()) {
    const Summary summary = summaryOf(report_);
    out_ << fmt::format("<p class=\"summary {}\">{}.</p>\n",
                        summary.violated + summary.errors > 0 || exitOf(report_) == Exit::Failed ? "bad"
                        : summary.undecided + summary.warnings > 0                               ? "open"
                                                                                                 : "good",
                        line);
  }
  if (const ExitReason reason = exitReasonOf(report_); reason.exit == Exit::Failed)
    out_ << fmt::format("<p class=\"summary bad\">The job could not be done: {}.</p>\n", xmlText(reason.text));
  out_ << fmt::format("<p class=\"quiet\">Made on {} by rungproof {}.</p>\n</header>\n", pageDate(), programVersion());
  if (report_.programs.empty()) return;
  section("What was examined");
  for (const ProgramRecord& record : report_.programs) {
    if (report_.programs.size() > 1)
      out_ << fmt::format("<h3 id=\"{}\">{}</h3>\n", places_.of("program " + record.name), xmlText(record.name));
    program(record);
  }
  assumptions();
}

void PageWriter::signatures() {
  if (report_.programs.empty()) return;
  section("Signatures");
  out_ << "<p>This record speaks of the files with the SHA-256 values above, of the CPU, options, choices and "
          "assumptions "
          "that it names, and of nothing else.</p>\n"
          "<table class=\"wide "
          "sign\"><thead><tr><th></th><th>Name</th><th>Date</th><th>Signature</th></tr></thead><tbody>\n";
  for (const char* role : {"Programmed by", "Examined by", "Accepted by"})
    out_ << fmt::format("<tr><td class=\"role\">{}</td><td></td><td></td><td></td></tr>\n", role);
  out_ << "</tbody></table>\n";
}

void PageWriter::end() {
  if (hasScans_) out_ << fmt::format("<script>//<![CDATA[{}//]]></script>\n", pageScript());
  out_ << "</body></html>\n";
}

}  // namespace rungproof
