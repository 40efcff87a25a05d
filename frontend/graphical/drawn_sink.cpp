// Findings about drawings.
#include "frontend/graphical/drawn_sink.hpp"

#include <fmt/format.h>

namespace rungproof {

namespace {

std::string_view kindName(DrawnKind kind) {
  switch (kind) {
    case DrawnKind::LeftRail: return "left power rail";
    case DrawnKind::RightRail: return "right power rail";
    case DrawnKind::Contact: return "contact";
    case DrawnKind::Coil: return "coil";
    case DrawnKind::Block: return "block";
    case DrawnKind::InVariable: return "input";
    case DrawnKind::OutVariable: return "output";
    case DrawnKind::InOutVariable: return "variable";
    case DrawnKind::Connector: return "connector";
    case DrawnKind::Continuation: return "continuation";
    case DrawnKind::Jump: return "jump";
    case DrawnKind::Label: return "label";
    default: return "return";
  }
}

}  // namespace

std::string nameOf(const DrawnElement& element) {
  const std::string text = excerpt(element.text);
  return fmt::format("{}{}{} (element {})", kindName(element.kind), text.empty() ? "" : " ", text, excerpt(element.id));
}

void DrawnSink::add(std::string_view rule, Severity severity, const DrawnElement& element, const std::string& message,
                    std::string_view help) {
  if (severity == Severity::Error) isDamaged_ = true;
  if (++count_ > limit) {
    if (count_ == limit + 1)
      report(Syntax::TooMany, element.span,
             fmt::format("more than {} problems in drawings; the rest is not listed", limit));
    return;
  }
  Finding finding;
  finding.rule = rule;
  finding.severity = severity;
  finding.message = fmt::format("{}: {}", nameOf(element), message);
  finding.span = element.span;
  finding.help = help;
  finding.pou = pou_;
  finding.network = network_;
  pending_.push_back({program_.findings.size(), &element});
  program_.findings.push_back(std::move(finding));
}

void DrawnSink::circuit(const DrawnElement& element, const std::string& message) {
  add("GRF001", Severity::Error, element, message,
      "connect the element so that power flows from the left to the right, then export again");
}

void DrawnSink::idle(const DrawnElement& element, const std::string& message) {
  add("GRF001", Severity::Warning, element, message, "connect it or remove it");
}

void DrawnSink::operand(const DrawnElement& element, const std::string& message) {
  add("GRF002", Severity::Error, element, message, "give the pin an operand of the right type that is declared");
}

void DrawnSink::negation(const DrawnElement& element, const std::string& message) {
  add("GRF003", Severity::Error, element, message, "remove the sign, or invert the number with a box");
}

void DrawnSink::report(Syntax code, Span span, const std::string& message) {
  const SyntaxMessage& row = syntaxMessage(code);
  if (row.severity == Severity::Error) isDamaged_ = true;
  SyntaxSink sink(program_, span.file);
  sink.setPlace(pou_, network_);
  sink.report(code, span, message);
}

}  // namespace rungproof
