// Findings as diagnostics.
#include "frontend/editor/diagnostics.hpp"

#include <fmt/format.h>

#include "analysis/rule.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

constexpr int unnecessaryTag = 1;

std::string messageOf(const Finding& finding) {
  std::string message = finding.message;
  if (finding.confirmation == Confirmation::Unconfirmed) message += " (unconfirmed)";
  if (!finding.help.empty()) message += fmt::format("\n{}", finding.help);
  return withManualTitles(message);
}

}  // namespace

int clientSeverity(Severity severity) {
  return severity == Severity::Error ? 1 : severity == Severity::Warning ? 2 : 3;
}

Json diagnosticOf(const CheckedDocument& document, const Finding& finding) {
  Json json{{"range", document.range(finding.span)},
            {"severity", clientSeverity(finding.severity)},
            {"code", finding.rule.view()},
            {"source", "rungproof"},
            {"message", messageOf(finding)}};
  const Rule* const rule = ruleNamed(finding.rule);
  if (rule != nullptr && rule->surplus) json["tags"].push_back(unnecessaryTag);
  for (const RelatedPlace& related : finding.related)
    json["relatedInformation"].push_back(
        {{"location", document.location(related.span)}, {"message", withManualTitles(related.message)}});
  return json;
}

Json diagnosticsOf(const CheckedDocument& document) {
  Json list = Json::array();
  if (const std::optional<Failure>& failure = document.failure()) {
    std::string message = failure->place.empty() ? failure->message : failure->place + ": " + failure->message;
    if (!failure->help.empty()) message += "\n" + failure->help;
    list.push_back({{"range", rangeJson(ClientPlace{}, ClientPlace{})},
                    {"severity", clientSeverity(Severity::Error)},
                    {"source", "rungproof"},
                    {"message", message}});
    return list;
  }
  for (const Finding& finding : document.report().findings) {
    if (document.isHere(finding.span)) list.push_back(diagnosticOf(document, finding));
  }
  return list;
}

}  // namespace rungproof
