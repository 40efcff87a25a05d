// The baseline file.
#include "frontend/page/baseline.hpp"

#include <fmt/core.h>

#include <map>
#include <tuple>

#include "analysis/read_errors.hpp"
#include "frontend/json.hpp"
#include "frontend/page/fingerprint.hpp"

namespace rungproof {

namespace {

constexpr unsigned formatVersion = 1;

/// The readers' errors and the tool's own findings are never part of a baseline.
bool belongsIn(const Finding& finding) { return !isReadError(finding) && !finding.rule.starts_with("SUP"); }

using Key = std::pair<std::string, std::string>;  // file, fingerprint

Key keyOf(const Finding& finding, const SourceSet& sources) {
  return {sources.file(finding.span.file).name(), fingerprintOf(finding, sources)};
}

}  // namespace

Baseline baselineOf(const Report& report) {
  std::map<std::tuple<std::string, std::string, std::string>, BaselineEntry> sorted;  // file, rule, fingerprint
  for (const Finding& finding : report.findings) {
    if (!belongsIn(finding)) continue;
    const auto [file, fingerprint] = keyOf(finding, *report.sources);
    const auto [entry, isNew] = sorted.emplace(std::tuple(file, finding.rule, fingerprint),
                                               BaselineEntry{fingerprint, finding.rule, file, finding.message});
    if (!isNew) ++entry->second.count;
  }
  Baseline baseline;
  for (auto& [key, entry] : sorted) baseline.entries.push_back(std::move(entry));
  return baseline;
}

std::string toJson(const Baseline& baseline) {
  std::string text = fmt::format("{{\n  \"rungproof_baseline\": {},\n  \"findings\": [", formatVersion);
  for (std::size_t i = 0; i < baseline.entries.size(); ++i) {
    const BaselineEntry& entry = baseline.entries[i];
    const Json row = {{"fingerprint", entry.fingerprint},
                      {"rule", entry.rule},
                      {"file", entry.file},
                      {"count", entry.count},
                      {"message", entry.message}};
    text += fmt::format("{}\n    {}", i == 0 ? "" : ",", row.dump());
  }
  return text + (baseline.entries.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

std::optional<Failure> readBaseline(const std::string& text, const std::string& name, Baseline& baseline) {
  const Failure damaged = {"the baseline file is damaged", name,
                           "write it again with 'rungproof baseline FILE... > " + name + "'"};
  const std::optional<Json> json = Json::read(text);
  const Json* findings = json ? json->find("findings") : nullptr;
  if (findings == nullptr || findings->kind() != Json::Kind::Array) return damaged;
  const Json* version = json->find("rungproof_baseline");
  if (version == nullptr || version->natural() != formatVersion) {
    return Failure{"the baseline file has a form that this version does not know", name, damaged.help};
  }
  std::size_t from = 0;
  for (const Json& row : findings->items()) {
    const auto textAt = [&row](std::string_view key) {
      const Json* value = row.find(key);
      return value != nullptr && value->kind() == Json::Kind::Text ? std::optional(value->text()) : std::nullopt;
    };
    const auto fingerprint = textAt("fingerprint"), rule = textAt("rule"), ofFile = textAt("file");
    if (!fingerprint || !rule || !ofFile) return damaged;
    BaselineEntry entry{*fingerprint, *rule, *ofFile, textAt("message").value_or("")};
    if (const Json* count = row.find("count"); count != nullptr && count->natural()) entry.count = *count->natural();
    const std::size_t at = text.find(entry.fingerprint, from);
    if (at != std::string::npos) {
      entry.offset = static_cast<std::uint32_t>(at);
      from = at + entry.fingerprint.size();
    }
    baseline.entries.push_back(std::move(entry));
  }
  return std::nullopt;
}

void applyBaseline(const Baseline& baseline, std::uint32_t file, Report& report) {
  std::map<Key, std::size_t> left;
  for (const BaselineEntry& entry : baseline.entries) left[{entry.file, entry.fingerprint}] += entry.count;
  const std::size_t before = report.findings.size();
  std::erase_if(report.findings, [&](const Finding& finding) {
    if (!belongsIn(finding)) return false;
    const auto found = left.find(keyOf(finding, *report.sources));
    if (found == left.end() || found->second == 0) return false;
    --found->second;
    return true;
  });
  report.baselined += before - report.findings.size();
  for (const BaselineEntry& entry : baseline.entries) {
    std::size_t& rest = left[{entry.file, entry.fingerprint}];
    if (rest == 0) continue;
    Finding& stale = report.findings.emplace_back();
    stale.rule = "SUP003";
    stale.severity = Severity::Note;
    stale.span = {file, entry.offset, static_cast<std::uint32_t>(entry.fingerprint.size())};
    stale.message =
        fmt::format("{} in {} is gone{}: {}", entry.rule, entry.file,
                    rest < entry.count ? fmt::format(" in {} of {} places", rest, entry.count) : "", entry.message);
    stale.help = "write the baseline again to remove the entry";
    rest = 0;
  }
}

}  // namespace rungproof
