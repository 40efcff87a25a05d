// SARIF 2.1.0, the exchange form of static analysers: rules with their pages, results with regions, related places,
// fixes and stable fingerprints. tests/cli/report_test.cpp checks the requirements of the standard.
#include <fmt/core.h>

#include <map>
#include <ostream>

#include "analysis/rule.hpp"
#include "engine/platform/names.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/explain/rule_page.hpp"
#include "frontend/files/json.hpp"
#include "frontend/linting/fingerprint.hpp"
#include "frontend/report/long_array.hpp"
#include "frontend/report_basis.hpp"
#include "frontend/report_part.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

std::string_view sarifLevel(Severity severity) {
  return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "note";
}

/// A relative reference as RFC 3986 wants it: bytes outside the unreserved set are percent-encoded.
std::string uriOf(std::string_view name) {
  const std::string path = uriPathOfName(std::string(name));
  std::string uri;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return path.starts_with('/') ? "file://" + uri : uri;
}

Json regionOf(const SourceSet& sources, Span span) {
  const SourceFile& file = sources.file(span.file);
  const Position begin = file.position(span.offset);
  const Position end = file.position(span.offset + span.length);
  return {{"startLine", begin.line}, {"startColumn", begin.column}, {"endLine", end.line}, {"endColumn", end.column}};
}

Json physicalLocation(const SourceSet& sources, Span span) {
  return {{"artifactLocation", {{"uri", uriOf(sources.file(span.file).name())}}}, {"region", regionOf(sources, span)}};
}

Json ruleObject(const std::string& id) {
  Json json = {{"id", id}};
  const Rule* rule = ruleNamed(id);
  if (rule == nullptr) return json;
  json["name"] = rule->title;
  json["shortDescription"] = {{"text", rule->title}};
  json["fullDescription"] = {{"text", rule->detects}};
  json["help"] = {{"text", rulePage(*rule, Paint{})}};
  json["defaultConfiguration"] = {{"level", sarifLevel(rule->severity)}, {"enabled", rule->enabledByDefault}};
  return json;
}

Json resultOf(const Finding& finding, const Report& report, std::size_t ruleIndex) {
  const SourceSet& sources = *report.sources;
  Json result = {{"ruleId", finding.rule.view()},
                 {"ruleIndex", ruleIndex},
                 {"level", sarifLevel(finding.severity)},
                 {"message", {{"text", withManualTitles(finding.message)}}}};
  Json location = {{"physicalLocation", physicalLocation(sources, finding.span)}};
  if (!finding.pou.empty()) {
    const std::string name =
        finding.network == 0 ? std::string(finding.pou) : fmt::format("{}/network {}", finding.pou, finding.network);
    location["logicalLocations"] = Json::array({{{"fullyQualifiedName", name}, {"kind", "function"}}});
  }
  result["locations"] = Json::array({location});
  if (!finding.related.empty()) {
    result["relatedLocations"] = Json::array();
    for (const RelatedPlace& related : finding.related) {
      result["relatedLocations"].push_back({{"physicalLocation", physicalLocation(sources, related.span)},
                                            {"message", {{"text", withManualTitles(related.message)}}}});
    }
  }
  if (finding.fix) {
    const Json change = {
        {"artifactLocation", {{"uri", uriOf(sources.file(finding.fix->span.file).name())}}},
        {"replacements", Json::array({{{"deletedRegion", regionOf(sources, finding.fix->span)},
                                       {"insertedContent", {{"text", finding.fix->replacement.view()}}}}})}};
    const std::string what = finding.help.empty() ? "replace the text" : std::string(finding.help);
    const char* const doubt = finding.fix->safe ? "" : " (unsafe: a guess at what was meant)";
    result["fixes"] =
        Json::array({{{"description", {{"text", what + doubt}}}, {"artifactChanges", Json::array({change})}}});
  }
  result["partialFingerprints"] = {{"rungproof/v1", fingerprintOf(finding, sources)}};
  if (finding.confirmation == Confirmation::Unconfirmed) {
    result["message"] = {{"text", withManualTitles(finding.message) + " (unconfirmed)"}};
    result["kind"] = "review";
    result["level"] = "none";
  }
  return result;
}

std::string idOf(const PropertyResult& property) {
  return (property.program.empty() ? "property/" : "property/" + property.program + "/") + property.name;
}

/// A property is a rule of the program's own.
Json ruleObject(const PropertyResult& property) {
  Json rule = {{"id", idOf(property)}, {"name", property.name}};
  rule["shortDescription"] = {{"text", property.statement.empty() ? property.name : property.statement}};
  rule["defaultConfiguration"] = {{"level", "error"}};
  return rule;
}

/// The run that breaks it, scan by scan, as steps of one thread.
Json codeFlowOf(const PropertyResult& property, const Report& report) {
  Json steps = Json::array();
  for (std::size_t i = 1; i < property.run.size(); ++i) {
    Json location = {{"message", {{"text", property.run.front() + " : " + property.run[i]}}}};
    if (property.span) location["physicalLocation"] = physicalLocation(*report.sources, *property.span);
    steps.push_back({{"location", location}});
  }
  return Json::array({{{"threadFlows", Json::array({{{"locations", steps}}})}}});
}

/// Verdicts on properties are results too; proofs have kind "pass".
Json resultOf(const PropertyResult& property, const Report& report, std::size_t ruleIndex) {
  Json result = {{"ruleId", idOf(property)},
                 {"ruleIndex", ruleIndex},
                 {"message",
                  {{"text", fmt::format("{}: {}{}{}", verdictText(property.verdict, property.depth), property.title(),
                                        property.statement.empty() ? "" : ": ", property.statement)}}}};
  const bool good = property.verdict == Outcome::Proved || property.verdict == Outcome::Reachable;
  const bool bad = property.verdict == Outcome::Violated || property.verdict == Outcome::Unreachable ||
                   property.verdict == Outcome::Vacuous;
  result["kind"] = good ? "pass" : bad ? "fail" : "open";
  result["level"] = bad ? "error" : "none";
  if (property.span)
    result["locations"] = Json::array({{{"physicalLocation", physicalLocation(*report.sources, *property.span)}}});
  if (property.run.size() > 1) result["codeFlows"] = codeFlowOf(property, report);
  result["partialFingerprints"] = {{"rungproof/v1", fingerprintOf({idOf(property), property.statement})}};
  if (const std::vector<std::string> remarks = remarksBesideRun(property); !remarks.empty())
    result["properties"] = {{"remarks", remarks}};
  return result;
}

void writeSarifReport(const Report& report, const ReportStyle&, std::ostream& out) {
  std::map<std::string, std::size_t> ruleIndex;
  Json rules = Json::array();
  for (const Finding& finding : report.findings) {
    if (ruleIndex.emplace(finding.rule, rules.size()).second) rules.push_back(ruleObject(std::string(finding.rule)));
  }
  for (const PropertyResult& property : report.properties) {
    if (ruleIndex.emplace(idOf(property), rules.size()).second) rules.push_back(ruleObject(property));
  }
  const std::size_t findings = report.findings.size();
  const auto resultAt = [&](std::size_t i) {
    if (i < findings) {
      const Finding& finding = report.findings[i];
      return resultOf(finding, report, ruleIndex.at(std::string(finding.rule)));
    }
    const PropertyResult& property = report.properties[i - findings];
    return resultOf(property, report, ruleIndex.at(idOf(property)));
  };
  Json run = {{"tool", {{"driver", {{"name", "rungproof"}, {"semanticVersion", programVersion()}, {"rules", rules}}}}},
              {"columnKind", "unicodeCodePoints"},
              {"results", Json::array()}};
  if (const std::vector<std::string> basis = basisOf(report); !basis.empty()) run["properties"]["basis"] = basis;
  if (report.part) run["properties"]["shard"] = partJson(report);
  const Json log = {
      {"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"version", "2.1.0"}, {"runs", Json::array({run})}};
  writeWithItems(out, log, "results", 6, findings + report.properties.size(), resultAt);
}

}  // namespace

extern constexpr Reporter sarifReport = {
    .name = "sarif", .summary = "SARIF 2.1.0 for code scanning", .write = writeSarifReport};

}  // namespace rungproof
