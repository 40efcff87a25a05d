// The JSON report, a stable contract: schema.json beside this file describes it.
#include "frontend/files/json.hpp"

#include <cmath>
#include <ostream>

#include "analysis/rule.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/report.hpp"
#include "frontend/report/long_array.hpp"
#include "frontend/report_part.hpp"
#include "frontend/testing/test_output.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

Json textOrNull(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }
/// Sentences for people, with places of the manual by their titles.
Json sentences(const std::vector<std::string>& texts) {
  Json rows = Json::array();
  for (const std::string& text : texts) rows.push_back(withManualTitles(text));
  return rows;
}

/// Whole numbers without a decimal point, as traces hold mostly bits and words.
Json number(TraceNumber value) {
  const bool isWhole = std::trunc(value) == value;
  if (isWhole && value >= -0x1p63L && value < 0x1p63L) return Json(static_cast<std::int64_t>(value));
  if (isWhole && value >= 0x1p63L && value < 0x1p64L) return Json(static_cast<std::uint64_t>(value));
  return Json(static_cast<double>(value));
}

Json findingJson(const Finding& finding, const SourceSet& sources) {
  const Position position = sources.position(finding.span);
  const Position end = sources.file(finding.span.file).position(finding.span.offset + finding.span.length);
  Json json = {{"rule", finding.rule.view()},
               {"severity", severityName(finding.severity)},
               {"message", withManualTitles(finding.message)},
               {"file", sources.file(finding.span.file).name()},
               {"line", position.line},
               {"column", position.column},
               {"end_line", end.line},
               {"end_column", end.column},
               {"pou", textOrNull(finding.pou)},
               {"network", finding.network == 0 ? Json(nullptr) : Json(finding.network)},
               {"address", textOrNull(finding.address)},
               {"confirmed", finding.confirmation != Confirmation::Unconfirmed},
               {"trace", textOrNull(finding.trace)},
               {"help", textOrNull(withManualTitles(finding.help))}};
  json["related"] = Json::array();
  for (const RelatedPlace& related : finding.related) {
    const Position place = sources.position(related.span);
    json["related"].push_back({{"message", withManualTitles(related.message)},
                               {"file", sources.file(related.span.file).name()},
                               {"line", place.line},
                               {"column", place.column}});
  }
  return json;
}

Json propertyJson(const PropertyResult& property, const SourceSet* sources) {
  const bool hasPlace = sources != nullptr && property.span.has_value();
  return {{"name", property.name},
          {"program", textOrNull(property.program)},
          {"file", hasPlace ? Json(sources->file(property.span->file).name()) : Json(nullptr)},
          {"line", hasPlace ? Json(sources->position(*property.span).line) : Json(nullptr)},
          {"expression", textOrNull(property.statement)},
          {"kind", resultKindName(property.kind)},
          {"verdict", verdictText(property.verdict, property.depth)},
          {"method", property.method},
          {"depth", property.depth},
          {"seconds", property.seconds},
          {"trace", textOrNull(property.trace)},
          {"certificate", textOrNull(property.certificate)},
          {"assumptions", sentences(property.assumptions)},
          {"networks", textOrNull(property.networks)},
          {"notes", sentences(property.notes)}};
}

Json selfCheckJson(const std::vector<PlantedFault>& faults) {
  const FaultCounts count = countsOf(faults);
  Json rows = Json::array();
  for (const PlantedFault& fault : faults) {
    rows.push_back({{"kind", fault.kind},
                    {"text", fault.text},
                    {"file", fault.file},
                    {"line", fault.line},
                    {"pou", fault.pou},
                    {"network", fault.network},
                    {"fate", fault.fate},
                    {"noticed_by", textOrNull(fault.noticedBy)},
                    {"differs", textOrNull(fault.differs)}});
  }
  return {{"noticed", count.noticed},
          {"unnoticed", count.unnoticed},
          {"without_effect", count.withoutEffect},
          {"undecided", count.undecided},
          {"faults", std::move(rows)}};
}

Json techniquesJson(const TechniqueUses& uses) {
  Json rows = Json::array();
  for (const TechniqueInfo& info : techniqueTable()) {
    const TechniqueUse& use = uses[static_cast<std::size_t>(info.id)];
    if (use.asked == 0) continue;
    rows.push_back({{"name", info.name},
                    {"asked", use.asked},
                    {"settled", info.settles ? Json(use.settled) : Json(nullptr)},
                    {"seconds", use.seconds}});
  }
  return rows;
}

/// Two programs: beside the verdict, what a property has too.
Json programsJson(const Comparison& comparison, const std::vector<std::string>& assumptions) {
  Json json = {{"equal", comparison.isUndecided() ? Json(nullptr) : Json(comparison.verdict == "EQUAL")},
               {"verdict", comparison.verdict},
               {"method", comparison.method},
               {"seconds", comparison.seconds},
               {"certificate", comparison.certificate.empty() ? Json(nullptr) : Json(comparison.certificate)},
               {"trace", comparison.trace.empty() ? Json(nullptr) : Json(comparison.trace)},
               {"notes", sentences(comparison.notes)},
               {"assumptions", sentences(assumptions)}};
  return json;
}

Json blocksJson(const std::vector<ComparedBlock>& blocks) {
  Json rows = Json::array();
  for (const ComparedBlock& block : blocks) {
    rows.push_back({{"block", block.name},
                    {"likeness", likenessName(block.likeness)},
                    {"checksum", block.checksum.empty() ? Json(nullptr) : Json(block.checksum)},
                    {"networks", block.networks},
                    {"values", block.values},
                    {"why", block.why.empty() ? Json(nullptr) : Json(block.why)}});
  }
  return rows;
}

Json comparisonJson(const std::optional<Comparison>& comparison, const std::vector<std::string>& assumptions) {
  if (!comparison) return nullptr;
  const bool isOfPrograms = comparison->isOfPrograms();
  Json json = isOfPrograms ? programsJson(*comparison, assumptions) : Json{{"equal", comparison->equal}};
  if (isOfPrograms ? comparison->verdict != "DIFFERENT" : comparison->equal) return json;
  json["scan"] = comparison->scan;
  json["time_ms"] = number(comparison->timeMs);
  json["signal"] = comparison->signal;
  json["expected"] = number(comparison->expected);
  json["actual"] = number(comparison->actual);
  return json;
}

void writeJsonReport(const Report& report, const ReportStyle& style, std::ostream& out) {
  const Summary summary = summaryOf(report);
  Json json = {{"tool", "rungproof"}, {"version", programVersion()}, {"command", report.command}};
  json["findings"] = Json::array();
  json["properties"] = Json::array();
  for (const PropertyResult& property : report.properties) {
    Json row = propertyJson(property, report.sources.get());
    // The assumptions of the run hold for each property; who reads one row must see all of them.
    std::vector<std::string> all = report.assumptions;
    all.insert(all.end(), property.assumptions.begin(), property.assumptions.end());
    row["assumptions"] = sentences(all);
    json["properties"].push_back(std::move(row));
  }
  if (report.part) json["shard"] = partJson(report);
  if (report.selfCheck) json["self_check"] = selfCheckJson(*report.selfCheck);
  if (style.verbose && report.techniques) json["techniques"] = techniquesJson(*report.techniques);
  if (report.tests != nullptr) {
    json["tests"] = testsJson(*report.tests);
    if (report.tests->kills) json["kills"] = selfCheckJson(*report.tests->kills);
  }
  json["comparison"] = comparisonJson(report.comparison, report.assumptions);
  if (!report.blocks.empty()) json["blocks"] = blocksJson(report.blocks);
  json["coverage"] = {{"instructions", report.coverage.instructions},
                      {"understood", report.coverage.understood},
                      {"approximated", report.coverage.approximated}};
  if (!report.coverage.leftOut.empty()) json["coverage"]["left_out"] = report.coverage.leftOut;
  if (report.tests != nullptr && report.tests->coverage) addMeasures(json["coverage"], *report.tests->coverage);
  json["summary"] = {{"errors", summary.errors}, {"warnings", summary.warnings}, {"notes", summary.notes},
                     {"proved", summary.proved}, {"violated", summary.violated}, {"undecided", summary.undecided}};
  writeWithItems(out, json, "findings", 2, report.findings.size(),
                 [&](std::size_t i) { return findingJson(report.findings[i], *report.sources); });
}

}  // namespace

extern constexpr Reporter jsonReport = {
    .name = "json", .summary = "stable form for programs", .write = writeJsonReport};

}  // namespace rungproof
